#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "atmosphere/table/air_table.hpp"

// The arrays of a table under their names in the file, for all who walk over them.

namespace nadir::sim {

/// What an array runs over, slowest first.
struct AirAxis {
  const char* name;
  std::size_t size;
};
using AirShape = std::vector<AirAxis>;

/// Values in all; held at 2^40 where a damaged head asks for more than any memory has.
[[nodiscard]] inline std::size_t count_of(const AirShape& shape) {
  constexpr std::size_t most = std::size_t{1} << 40U;
  std::size_t count = 1;
  for (const AirAxis& axis : shape) {
    if (axis.size == 0) return 0;
    count = count > most / axis.size ? most : count * axis.size;
  }
  return count;
}

/// Calls visit(name, vector, shape) for the arrays of a view; `Table` and `View` may be const.
template <class Table, class View, class Visit>
void for_each_view_array(Table& table, View& view, const std::string& prefix, const Visit& visit) {
  const AirAxis lane{"lane", table.lanes.size()}, body{"body", table.bodies.size()};
  const AirAxis kind{"kind", static_cast<std::size_t>(table.kinds)};
  const AirAxis zenith{"zenith", view.zenith_rad.size()}, share{"share", view.share.size()};
  const AirAxis azimuth{"azimuth", view.azimuth_rad.size()};
  visit(prefix + "extinction", view.extinction, AirShape{zenith, share, lane});
  visit(prefix + "first", view.first, AirShape{body, kind, zenith, share, lane});
  visit(prefix + "smooth", view.smooth, AirShape{body, azimuth, zenith, share, lane});
  visit(prefix + "even", view.even, AirShape{zenith, share, lane});
  visit(prefix + "ground", view.ground, AirShape{zenith, share, lane});
  visit(prefix + "night", view.night, AirShape{zenith, share, lane});
}

/// Whether a table may lack an array: then it is 0.
[[nodiscard]] inline bool may_lack(std::string_view array) {
  return array.starts_with("night_") || array.ends_with(".night");
}

/// Calls visit(name, vector, shape) for every array, in the order of the file. The vector is one of
/// float, but for `phase_grid`.
template <class Table, class Visit>
void for_each_array(Table& table, const Visit& visit) {
  const AirAxis lane{"lane", table.lanes.size()};
  const AirAxis angle{"angle", table.phase_grid.size()};
  for (std::size_t i = 0; i < table.bodies.size(); ++i) {
    auto& body = table.bodies[i];
    const std::string prefix = "body." + std::to_string(i) + ".";
    visit(prefix + "irradiance", body.irradiance, AirShape{lane});
    visit(prefix + "transmittance", body.transmittance, AirShape{lane});
    visit(prefix + "ground_irradiance", body.ground_irradiance, AirShape{lane});
  }
  visit("spherical_albedo", table.spherical_albedo, AirShape{lane});
  visit("even_ground_irradiance", table.even_ground_irradiance, AirShape{lane});
  visit("night_ground_irradiance", table.night_ground_irradiance, AirShape{lane});
  visit("night_top", table.night_top, AirShape{lane});
  visit("phase_grid", table.phase_grid, AirShape{angle});
  visit("phase", table.phase,
        AirShape{{"kind", static_cast<std::size_t>(table.kinds)}, angle, lane});
  for_each_view_array(table, table.sky, "sky.", visit);
  for (std::size_t i = 0; i < table.views.size(); ++i) {
    for_each_view_array(table, table.views[i], "view." + std::to_string(i) + ".", visit);
  }
}

}  // namespace nadir::sim
