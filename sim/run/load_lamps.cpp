#include "sim/run/load_lamps.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "core/frame.hpp"
#include "core/quantity.hpp"
#include "radiometry/lamps/lamp_spectrum.hpp"
#include "sim/files/ies_file.hpp"
#include "sim/files/lamp_list.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/read_curves.hpp"

namespace nadir::sim {
namespace {

const Vec3 down{0.0, 0.0, -1.0};

/// Clockwise about up, seen from above.
Vec3 turned(Vec3 v, double yaw_deg) {
  const double s = std::sin(yaw_deg * radians_per_degree),
               c = std::cos(yaw_deg * radians_per_degree);
  return {v.x * c + v.y * s, v.y * c - v.x * s, v.z};
}

/// The level direction of azimuth `yaw_deg`, tilted as straight down is tilted to `axis`: the least
/// rotation that does so (Rodrigues). For an axis straight up it stays level.
Vec3 side_of(Vec3 axis, double yaw_deg) {
  const Vec3 level = direction_enu(yaw_deg * radians_per_degree, 0.0);
  const Vec3 v = cross(down, axis);
  const double one_plus_cos = 1.0 + dot(down, axis);
  if (one_plus_cos < 1e-12) return level;
  const Vec3 tilted = level + cross(v, level) + cross(v, cross(v, level)) / one_plus_cos;
  return normalised(tilted - dot(tilted, axis) * axis);
}

/// A lamp's place in the scene and what a list says of it.
struct Stand {
  Vec3 position;
  Vec3 axis;
  double yaw_deg = 0.0;
  std::optional<double> lumens, colour_temperature_k;
};

struct Photometry {
  std::shared_ptr<const radiometry::IntensityTable> table;
  double lumens = 0.0;
};

class LampReader {
 public:
  LampReader(const Scenario& scenario, const TerrainProbe& terrain, std::uint32_t first_object,
             InputFiles& files)
      : scenario_{&scenario}, terrain_{&terrain}, next_object_{first_object}, files_{&files} {}

  LoadedLamps read() {
    ErrorList errors;
    for (const LampInput& input : scenario_->lamps) {
      errors.attempt([&] {
        if (input.list) {
          add_list(input);
        } else {
          at_place(input.where, input.name, [&] { add(input, stand_of(input), input.name); });
        }
      });
    }
    errors.throw_if_any();
    return std::move(loaded_);
  }

 private:
  /// Gives mistakes without a place that of the lamp.
  template <class F>
  static void at_place(const SourceLocation& where, const std::string& name, F&& part) {
    try {
      part();
    } catch (const InputError& error) {
      std::vector<InputIssue> issues = error.issues();
      for (InputIssue& issue : issues) {
        if (!issue.where.file.empty()) continue;
        issue.where = where;
        issue.message = "lamp " + name + ": " + issue.message;
      }
      throw InputError{std::move(issues)};
    }
  }

  [[nodiscard]] Stand stand_of(const LampInput& input) const {
    Stand stand{input.position_m, input.axis, input.yaw_deg, input.lumens,
                input.colour_temperature_k};
    if (input.on_terrain) stand.position = terrain_->lifted(stand.position);
    if (input.aim_m) stand.axis = aimed(stand.position, *input.aim_m);
    return stand;
  }

  static Vec3 aimed(Vec3 from, Vec3 at) {
    const Vec3 way = at - from;
    if (!(length(way) > 0.0)) throw InputError{"it is aimed at its own place"};
    return normalised(way);
  }

  void add_list(const LampInput& input) {
    ErrorList errors;
    at_place(input.where, input.name, [&] {  // read once: a bad file is not every row's mistake
      (void)photometry_of(input);
      if (input.flux) (void)flux_curve(input);
    });
    for (const ListedLamp& row : read_lamp_list(files_->note(*input.list))) {
      errors.attempt([&] {
        const SourceLocation where{input.list->string(), row.line, 0};
        at_place(where, input.name, [&] {
          add(input, stand_of(input, row), fmt::format("{}, line {}", input.name, row.line), where);
        });
      });
    }
    errors.throw_if_any();
  }

  [[nodiscard]] Stand stand_of(const LampInput& input, const ListedLamp& row) const {
    if (input.flux && (row.lumens || row.colour_temperature_k)) {
      throw InputError{
          "the list gives lumens or a colour temperature, but the lamp has flux_w_per_um"};
    }
    const Vec3 origin = input.on_terrain ? terrain_->lifted(row.position) : row.position;
    Vec3 axis = turned(input.axis, row.yaw_deg);
    if (input.aim_m) axis = aimed({}, turned(*input.aim_m - input.position_m, row.yaw_deg));
    return {origin + turned(input.position_m, row.yaw_deg), axis, input.yaw_deg + row.yaw_deg,
            row.lumens ? row.lumens : input.lumens,
            row.colour_temperature_k ? row.colour_temperature_k : input.colour_temperature_k};
  }

  void add(const LampInput& input, const Stand& stand, const std::string& name) {
    add(input, stand, name, input.where);
  }
  void add(const LampInput& input, const Stand& stand, const std::string& name,
           const SourceLocation& where) {
    const Vec3 side = side_of(stand.axis, stand.yaw_deg);
    const Photometry photometry = photometry_of(input);
    radiometry::Lamp lamp{.name = name, .flux = flux_of(input, stand, photometry), .where = where};
    if (const auto* area = std::get_if<AreaLampInput>(&input.form)) {
      lamp.form = area_lamp(*area, stand, side);
    } else {
      lamp.form =
          radiometry::PointLamp{stand.position, stand.axis, side, shape_of(input, photometry)};
    }
    loaded_.lamps.push_back(std::move(lamp));
  }

  [[nodiscard]] static radiometry::IntensityShape shape_of(const LampInput& input,
                                                           const Photometry& photometry) {
    if (photometry.table) return photometry.table;
    const auto* spot = std::get_if<SpotLampInput>(&input.form);
    if (spot == nullptr) return radiometry::CosinePower{};
    return radiometry::CosinePower{spot->cosine_power, spot->half_angle_deg * radians_per_degree};
  }

  [[nodiscard]] radiometry::AreaLamp area_lamp(const AreaLampInput& input, const Stand& stand,
                                               Vec3 side) {
    const Vec3 across = cross(stand.axis, side);  // side x across is the axis
    const radiometry::AreaLamp lamp{input.surface, stand.position, side, across, next_object_++};
    const geometry::Shape shape =
        std::visit([](const auto& s) { return geometry::Shape{s}; }, input.surface);
    loaded_.surfaces.push_back({{shape, {static_cast<std::uint32_t>(input.material)}},
                                Affine{{side, across, stand.axis}, stand.position},
                                lamp.object});
    return lamp;
  }

  [[nodiscard]] Photometry photometry_of(const LampInput& input) {
    const auto* point = std::get_if<PointLampInput>(&input.form);
    if (point == nullptr || !point->ies) return {};
    auto entry = photometries_.find(*point->ies);
    if (entry == photometries_.end()) {
      IesFile file = read_ies(files_->note(*point->ies));
      auto table = std::make_shared<const radiometry::IntensityTable>(std::move(file.candela));
      entry = photometries_.emplace(*point->ies, Photometry{std::move(table), file.lumens}).first;
    }
    return entry->second;
  }

  [[nodiscard]] std::shared_ptr<const spectral::Curve> flux_curve(const LampInput& input) {
    auto& curve = curves_[&input];
    if (!curve) {
      curve = std::make_shared<const spectral::Curve>(
          curve_of(*input.flux, SpectrumQuantity::flux, spectral::Outside::reject, *files_));
    }
    return curve;
  }

  [[nodiscard]] radiometry::LampFlux flux_of(const LampInput& input, const Stand& stand,
                                             const Photometry& photometry) {
    if (input.flux) return {flux_curve(input), 1.0};
    const auto lumens =
        stand.lumens || !photometry.table ? stand.lumens : std::optional{photometry.lumens};
    if (!lumens) throw InputError{"neither the list nor the lamp gives flux_w_per_um or lumens"};
    if (!stand.colour_temperature_k) {
      throw InputError{"neither the list nor the lamp gives colour_temperature_k"};
    }
    auto& curve = of_one_lumen_[*stand.colour_temperature_k];
    if (!curve) {
      curve = std::make_shared<const spectral::Curve>(
          radiometry::flux_of_one_lumen(Kelvin{*stand.colour_temperature_k}));
    }
    return {curve, *lumens};
  }

  const Scenario* scenario_;
  const TerrainProbe* terrain_;
  std::uint32_t next_object_;
  InputFiles* files_;
  LoadedLamps loaded_;
  std::map<std::filesystem::path, Photometry> photometries_;
  std::map<const LampInput*, std::shared_ptr<const spectral::Curve>> curves_;
  std::map<double, std::shared_ptr<const spectral::Curve>> of_one_lumen_;
};

}  // namespace

LoadedLamps load_lamps(const Scenario& scenario, const TerrainProbe& terrain,
                       std::uint32_t first_object, InputFiles& files) {
  return LampReader{scenario, terrain, first_object, files}.read();
}

}  // namespace nadir::sim
