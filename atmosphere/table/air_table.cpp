#include "atmosphere/table/air_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "atmosphere/paths/spherical_path.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::atmosphere {
namespace {

[[noreturn]] void refuse(const std::string& part, const std::string& message) {
  throw InputError{"air table: " + part + ": " + message};
}

/// What values of an array may be.
struct Allowed {
  float least, most;
};
constexpr float largest = 3e38F;
constexpr Allowed any{-largest, largest}, zero_or_more{0.0F, largest}, share_of_one{0.0F, 1.0F};
constexpr Allowed below_one{0.0F, 0.999999F};  // light between air and a white ground must die out

void check_values(const std::string& part, const std::vector<float>& values, std::size_t count,
                  Allowed allowed) {
  if (values.size() != count) {
    refuse(part,
           "expected " + std::to_string(count) + " values, found " + std::to_string(values.size()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const float v = values[i];
    const char* wrong = nullptr;
    if (!std::isfinite(v))
      wrong = "expected finite values, found ";
    else if (v < allowed.least)
      wrong = "expected no negative values, found ";
    else if (v > allowed.most)
      wrong =
          allowed.most < 1.0F ? "expected values below 1, found " : "expected at most 1, found ";
    if (wrong != nullptr) {
      refuse(part, wrong + number_text(static_cast<double>(v)) + " at " + std::to_string(i));
    }
  }
}

/// Nodes within [lo, hi]; each above the one before, or not below it where twins may be.
void check_axis(const std::string& part, const std::vector<double>& nodes, double lo, double hi,
                bool twins = false) {
  if (nodes.empty()) refuse(part, "expected at least one node");
  constexpr double slack = 1e-6;  // of ends such as pi that went through a file
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!(nodes[i] >= lo - slack && nodes[i] <= hi + slack)) {
      refuse(part, "expected nodes from " + number_text(lo) + " to " + number_text(hi) +
                       ", found " + number_text(nodes[i]));
    }
    if (i > 0 && !(twins ? nodes[i] >= nodes[i - 1] : nodes[i] > nodes[i - 1])) {
      refuse(part, "expected ascending nodes, found " + number_text(nodes[i]) + " after " +
                       number_text(nodes[i - 1]));
    }
  }
}

/// The horizon twice, and nothing else twice.
void check_horizon(const std::string& part, const AirTable& table, const AirTable::View& view) {
  constexpr double slack_rad = 1e-6;
  const double horizon = std::acos(horizon_mu(table.ground_m, view.height_m));
  const auto& z = view.zenith_rad;
  int twins = 0;
  for (std::size_t i = 1; i < z.size(); ++i) {
    if (z[i] > z[i - 1]) continue;
    ++twins;
    if (std::abs(z[i] - horizon) > slack_rad) {
      refuse(part, "only the horizon, " + number_text(horizon) + ", may appear twice, found " +
                       number_text(z[i]));
    }
  }
  const bool both = z.front() < horizon - slack_rad && z.back() > horizon + slack_rad;
  if (twins > 1 || (both && twins == 0)) {
    refuse(part, "expected the horizon, " + number_text(horizon) + ", twice");
  }
}

void check_view(const std::string& name, const AirTable& table, const AirTable::View& view) {
  const std::size_t lanes = table.lanes.size(), all = view.places() * lanes;
  const std::size_t bodies = table.bodies.size(), kinds = static_cast<std::size_t>(table.kinds);
  if (!(view.height_m >= table.ground_m && view.height_m <= table.top_m)) {
    refuse(name + " height",
           "expected one within the air, found " + number_text(view.height_m) + " m");
  }
  check_axis(name + " zenith", view.zenith_rad, 0.0, std::numbers::pi, true);
  check_horizon(name + " zenith", table, view);
  check_axis(name + " azimuth", view.azimuth_rad, 0.0, std::numbers::pi);
  check_axis(name + " share", view.share, 0.0, 1.0);
  if (std::abs(view.share.back() - 1.0) > 1e-9) refuse(name + " share", "expected 1 as the last");
  check_values(name + " extinction", view.extinction, all, zero_or_more);
  check_values(name + " first", view.first, bodies * kinds * all, zero_or_more);
  check_values(name + " smooth", view.smooth, bodies * view.azimuth_rad.size() * all, any);
  check_values(name + " even", view.even, all, zero_or_more);
  check_values(name + " ground", view.ground, all, zero_or_more);
  check_values(name + " night", view.night, view.night.empty() ? 0 : all, zero_or_more);
}

void check_lanes(const std::vector<AirTable::Lane>& lanes) {
  if (lanes.empty()) refuse("lanes", "expected at least one");
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const AirTable::Lane& lane = lanes[i];
    if (!(lane.wavelength_um > 0.0) || !std::isfinite(lane.wavelength_um)) {
      refuse("lanes", "expected positive wavelengths, found " + number_text(lane.wavelength_um));
    }
    if (!(lane.weight >= 0.0 && lane.weight <= 1.0 + 1e-9)) {
      refuse("lanes", "expected weights of 0 to 1, found " + number_text(lane.weight));
    }
    if (i == 0) continue;
    const AirTable::Lane& before = lanes[i - 1];
    const auto order = [](const AirTable::Lane& l) {
      return std::tuple{l.wavelength_um, l.absorption.lo_um, l.absorption.hi_um, l.absorption.term};
    };
    if (!(order(before) < order(lane))) {
      refuse("lanes", "expected ascending wavelengths, found " + number_text(lane.wavelength_um) +
                          " um after " + number_text(before.wavelength_um) + " um");
    }
  }
}

void check_bodies(const AirTable& table) {
  const std::size_t lanes = table.lanes.size();
  for (const AirTable::Body& body : table.bodies) {
    check_axis(body.name + " zenith", {body.zenith_rad}, 0.0, std::numbers::pi);
    if (!std::isfinite(body.azimuth_rad)) refuse(body.name + " azimuth", "expected a number");
    check_values(body.name + " irradiance", body.irradiance, lanes, zero_or_more);
    check_values(body.name + " transmittance", body.transmittance, lanes, share_of_one);
    check_values(body.name + " ground irradiance", body.ground_irradiance, lanes, zero_or_more);
  }
}

void check_phase(const AirTable& table) {
  if (table.kinds < 0) refuse("kinds", "expected 0 or more");
  if (table.kinds > 0) {
    const auto& grid = table.phase_grid;
    check_axis("phase grid", grid, 0.0, 1.0);
    if (grid.size() < 2) refuse("phase grid", "expected at least two nodes");
    const double step = 1.0 / static_cast<double>(grid.size() - 1);
    for (std::size_t i = 0; i < grid.size(); ++i) {
      if (std::abs(grid[i] - static_cast<double>(i) * step) > 1e-3 * step) {
        refuse("phase grid", "expected even steps from 0 to 1");
      }
    }
  }
  const std::size_t kinds = static_cast<std::size_t>(table.kinds);
  check_values("phase", table.phase, kinds * table.phase_grid.size() * table.lanes.size(),
               zero_or_more);
}

}  // namespace

void check(const AirTable& table) {
  check_lanes(table.lanes);
  const std::size_t lanes = table.lanes.size();
  if (!(table.ground_m < table.top_m) || !std::isfinite(table.top_m - table.ground_m)) {
    refuse("top", "expected one above the ground, found " + number_text(table.top_m) + " m over " +
                      number_text(table.ground_m) + " m");
  }
  check_bodies(table);
  check_phase(table);
  check_view("sky", table, table.sky);
  if (table.sky.share.size() != 1) refuse("sky share", "expected 1 alone");
  for (std::size_t i = 0; i < table.views.size(); ++i) {
    check_view("view " + std::to_string(i + 1), table, table.views[i]);
    if (i > 0 && !(table.views[i].height_m > table.views[i - 1].height_m)) {
      refuse("views", "expected ascending heights");
    }
  }
  check_values("spherical albedo", table.spherical_albedo, lanes, below_one);
  check_values("even ground irradiance", table.even_ground_irradiance, lanes, zero_or_more);
  check_values("night ground irradiance", table.night_ground_irradiance,
               table.night_ground_irradiance.empty() ? 0 : lanes, zero_or_more);
  check_values("night top", table.night_top, table.night_top.empty() ? 0 : lanes, zero_or_more);
}

}  // namespace nadir::atmosphere
