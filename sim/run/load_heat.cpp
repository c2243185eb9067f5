#include "sim/run/load_heat.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "radiometry/emission_rule.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/heat_model.hpp"
#include "sim/run/load_air.hpp"
#include "sim/run/load_temperature.hpp"
#include "spectral/coverage.hpp"

namespace nadir::sim {
namespace {

using thermal::SurroundingSurface;
using thermal::TemperatureSource;

bool band_sees_heat(const sensor::Band& band, const ephemeris::Illumination& bodies) {
  // The emission of what is below 400 K grows with wavelength up to 7 um and more: where it counts
  // at all, it does so at one of these.
  const spectral::Support range = spectral::support(band.response);
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Micrometres wavelength = range.lo + share * (range.hi - range.lo);
    double irradiance = 0.0;
    for (const ephemeris::LightSource& body : bodies) {
      if (body.direction_enu.z <= -std::sin(body.angular_radius.value)) continue;
      const double here = body.irradiance.at(wavelength);
      if (std::isfinite(here)) irradiance += here;
    }
    if (radiometry::emission_counts(radiometry::warmest_under_the_sun, wavelength,
                                    SpectralIrradiance{irradiance})) {
      return true;
    }
  }
  return false;
}

/// Turns what the scenario says of temperatures into sources, material by material.
class TemperatureReader {
 public:
  TemperatureReader(const Scenario& scenario, const HeatScene& scene, bool asked, InputFiles& files,
                    Diagnostics& diagnostics)
      : scenario_{scenario},
        scene_{scene},
        asked_{asked},
        files_{files},
        diagnostics_{diagnostics} {}

  LoadedTemperatures read() {
    ErrorList errors;
    for (const MaterialInput& material : scenario_.materials) {
      errors.attempt("material " + material.name, scenario_.file.string(), [&] {
        std::visit([&](const auto& input) { add(input); }, material.temperature);
      });
    }
    errors.throw_if_any();
    std::shared_ptr<const thermal::HeatSolver> solver;
    if (!solved_.empty()) {
      solver = std::make_shared<const thermal::HeatSolver>(
          scene_.geometry, load_heat_model(scenario_, scene_, surroundings_, files_, diagnostics_));
      for (const std::size_t i : solved_) sources_[i] = thermal::SolvedTemperature{solver};
    }
    return {thermal::TemperatureField{std::move(sources_)}, std::move(solver)};
  }

 private:
  void keep(TemperatureSource source, SurroundingSurface seen) {
    sources_.push_back(std::move(source));
    surroundings_.push_back(seen);
  }
  void keep(Kelvin value) { keep(thermal::ConstantTemperature{value}, {0.2, 0.95, value}); }

  void add(const ConstantTemperatureInput& input) { keep(Kelvin{input.kelvin}); }

  void add(const TemperatureTableInput& input) {
    keep(load_temperature_table(input, scenario_.time, files_));
  }

  void add(const AirTemperatureInput& input) {
    if (!asked_) return keep(thermal::UnaskedTemperature{}, {});
    if (!air_) {
      air_ = load_heat_weather(scenario_, files_, diagnostics_).weather.at(0.0).air_temperature_k;
    }
    keep(thermal::ConstantTemperature{Kelvin{*air_ + input.offset_k}},
         {0.2, 0.95, thermal::FollowsAir{input.offset_k}});
  }

  void add(const TemperatureRasterInput& input) {
    if (!asked_) return keep(thermal::UnaskedTemperature{}, {});
    auto map =
        load_temperature_raster(input, scenario_.time, {&scene_.frame, &diagnostics_}, files_);
    const double sum = std::accumulate(map.kelvin.begin(), map.kelvin.end(), 0.0);
    const Kelvin mean{sum / static_cast<double>(map.kelvin.size())};
    keep(std::move(map), {0.2, 0.95, mean});
  }

  void add(const VertexTemperatureInput& input) {
    keep(vertex_temperature(input, std::make_shared<const geometry::Scene>(scene_.geometry)), {});
  }

  void add(const HeatBalanceInput& /*input*/) {
    if (asked_) solved_.push_back(sources_.size());
    keep(thermal::UnaskedTemperature{}, {});
  }

  const Scenario& scenario_;
  const HeatScene& scene_;
  bool asked_;
  InputFiles& files_;
  Diagnostics& diagnostics_;
  std::optional<double> air_;
  std::vector<TemperatureSource> sources_;
  std::vector<SurroundingSurface> surroundings_;
  std::vector<std::size_t> solved_;
};

}  // namespace

bool sees_heat(const sensor::DetectorArray& array, const ephemeris::Illumination& bodies) {
  return std::any_of(array.bands.begin(), array.bands.end(),
                     [&](const sensor::Band& band) { return band_sees_heat(band, bodies); });
}

LoadedTemperatures load_temperatures(const Scenario& scenario, const HeatScene& scene, bool asked,
                                     InputFiles& files, Diagnostics& diagnostics) {
  return TemperatureReader{scenario, scene, asked, files, diagnostics}.read();
}

}  // namespace nadir::sim
