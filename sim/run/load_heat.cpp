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

bool band_sees_heat(const sensor::Band& band, const ephemeris::Illumination& bodies,
                    Kelvin warmest) {
  // The emission of what is below 400 K grows with wavelength up to 7 um, that of hotter surfaces
  // counts before it falls again: where it counts at all, it does so at one of these.
  const spectral::Support range = spectral::support(band.response);
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Micrometres wavelength = range.lo + share * (range.hi - range.lo);
    double irradiance = 0.0;
    for (const ephemeris::LightSource& body : bodies) {
      if (body.direction_enu.z <= -std::sin(body.angular_radius.value)) continue;
      const double here = body.irradiance.at(wavelength);
      if (std::isfinite(here)) irradiance += here;
    }
    if (radiometry::emission_counts(warmest, wavelength, SpectralIrradiance{irradiance})) {
      return true;
    }
  }
  return false;
}

Kelvin warmest_of(const HeatBalanceInput& input) {
  constexpr double low_emissivity = 0.1;  // of spectra that nobody has read yet
  thermal::HeatMaterial material;
  material.layers.back = input.back;
  for (const LayerInput& layer : input.layers) material.layers.layers.push_back(layer.layer);
  material.surface.emissivity = input.emissivity.value_or(low_emissivity);
  return thermal::warmest_of(material);
}

/// Turns what the scenario says of temperatures into sources, material by material.
class TemperatureReader {
 public:
  TemperatureReader(const Scenario& scenario, const HeatScene& scene, bool asked,
                    std::uint64_t seed, InputFiles& files, Diagnostics& diagnostics)
      : scenario_{scenario},
        scene_{scene},
        asked_{asked},
        seed_{seed},
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
    std::optional<double> air_k;
    if (!solved_.empty()) {
      auto model = load_heat_model(scenario_, scene_, surroundings_, files_, diagnostics_);
      air_k = model.weather.at(0.0).air_temperature_k;
      solver =
          std::make_shared<const thermal::HeatSolver>(scene_.geometry, std::move(model), seed_);
      const Kelvin warmest = warmest_solved(scenario_);
      for (const std::size_t i : solved_) {
        sources_[i] = thermal::SolvedTemperature{solver, warmest};
      }
    }
    follow_air(air_k);
    return {thermal::TemperatureField{std::move(sources_)}, std::move(solver)};
  }

 private:
  void keep(TemperatureSource source, SurroundingSurface seen) {
    sources_.push_back(std::move(source));
    surroundings_.push_back(seen);
  }
  void keep(Kelvin value) {
    // 0 K says that a surface does not emit, not that its neighbours freeze.
    const bool emits = value > Kelvin{0.0};
    keep(thermal::ConstantTemperature{value},
         {0.2, 0.95,
          emits ? decltype(SurroundingSurface::temperature){value} : thermal::FollowsAir{}});
  }

  void add(const ConstantTemperatureInput& input) { keep(Kelvin{input.kelvin}); }

  void add(const TemperatureTableInput& input) {
    keep(load_temperature_table(input, scenario_.time, files_));
  }

  void add(const AirTemperatureInput& input) {
    if (asked_) following_air_.push_back(sources_.size());
    keep(thermal::UnaskedTemperature{}, {0.2, 0.95, thermal::FollowsAir{input.offset_k}});
  }

  void add(const TemperatureRasterInput& input) {
    auto map =
        load_temperature_raster(input, scenario_.time, {&scene_.frame, &diagnostics_}, files_);
    const double sum = std::accumulate(map.kelvin.begin(), map.kelvin.end(), 0.0);
    const Kelvin mean{sum / static_cast<double>(map.kelvin.size())};
    keep(std::move(map), {0.2, 0.95, mean});
  }

  void add(const VertexTemperatureInput& input) {
    auto source =
        vertex_temperature(input, std::make_shared<const geometry::Scene>(scene_.geometry));
    const auto hottest = scene_.hottest_vertex_k.find(static_cast<std::uint32_t>(sources_.size()));
    source.hottest = Kelvin{hottest != scene_.hottest_vertex_k.end() ? hottest->second : 0.0};
    keep(std::move(source), {});
  }

  void add(const HeatBalanceInput& /*input*/) {
    if (asked_) solved_.push_back(sources_.size());
    keep(thermal::UnaskedTemperature{}, {});
  }

  /// @param air_k  of the weather at the picture, where that has been read already
  void follow_air(std::optional<double> air_k) {
    if (following_air_.empty()) return;
    if (!air_k) {
      air_k =
          load_heat_weather(scenario_, 0.0, files_, diagnostics_).weather.at(0.0).air_temperature_k;
    }
    for (const std::size_t i : following_air_) {
      const auto& input = std::get<AirTemperatureInput>(scenario_.materials[i].temperature);
      sources_[i] = thermal::ConstantTemperature{Kelvin{*air_k + input.offset_k}};
    }
  }

  const Scenario& scenario_;
  const HeatScene& scene_;
  bool asked_;
  std::uint64_t seed_;
  InputFiles& files_;
  Diagnostics& diagnostics_;
  std::vector<TemperatureSource> sources_;
  std::vector<SurroundingSurface> surroundings_;
  std::vector<std::size_t> solved_, following_air_;  // indices of materials
};

}  // namespace

Kelvin warmest_solved(const Scenario& scenario) {
  Kelvin warmest = thermal::warmest_under_the_sun;
  for (const MaterialInput& material : scenario.materials) {
    const auto* input = std::get_if<HeatBalanceInput>(&material.temperature);
    if (input != nullptr) warmest = std::max(warmest, warmest_of(*input));
  }
  return warmest;
}

bool sees_heat(const sensor::DetectorArray& array, const ephemeris::Illumination& bodies,
               Kelvin warmest) {
  return std::any_of(array.bands.begin(), array.bands.end(), [&](const sensor::Band& band) {
    return band_sees_heat(band, bodies, warmest);
  });
}

LoadedTemperatures load_temperatures(const Scenario& scenario, const HeatScene& scene, bool asked,
                                     std::uint64_t seed, InputFiles& files,
                                     Diagnostics& diagnostics) {
  return TemperatureReader{scenario, scene, asked, seed, files, diagnostics}.read();
}

}  // namespace nadir::sim
