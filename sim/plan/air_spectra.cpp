#include "sim/plan/air_spectra.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "atmosphere/gases/gas_absorption.hpp"
#include "atmosphere/paths/path_measure.hpp"
#include "sim/plan/surface_spectra.hpp"
#include "spectral/planck.hpp"

namespace nadir::sim {
namespace {

using atmosphere::AirTable;
using spectral::Curve;

constexpr double most_air_masses = 6.0;  // as far as terms of absorption are fitted
// Diffuse transmittance is that of a slant path with this secant (Elsasser 1942).
constexpr double diffusivity = 1.66;

AirFunction known_at(SpectralFunction at) { return {std::move(at), false}; }
AirFunction over_intervals(SpectralFunction at) { return {std::move(at), true}; }

AirFunction black_body_at(Kelvin temperature) {
  return known_at([temperature](double lambda_um) {
    return spectral::planck(Micrometres{lambda_um}, temperature).value;
  });
}

SpectralFunction owned(std::vector<double> wavelength_um, std::vector<double> value,
                       std::vector<double>& knots_um) {
  if (wavelength_um.size() < 2) return [v = value.at(0)](double) { return v; };
  const auto curve = std::make_shared<const Curve>(std::move(wavelength_um), std::move(value),
                                                   spectral::Outside::hold);
  return [curve, at = function_of(*curve, knots_um)](double lambda_um) { return at(lambda_um); };
}

SpectralFunction one_minus(SpectralFunction at) {
  return [at = std::move(at)](double x) { return std::max(1.0 - at(x), 0.0); };
}

/// Cosine of a body's zenith angle; 0 where it has set.
double height_of(const ephemeris::LightSource& body) {
  return std::clamp(body.direction_enu.z, 0.0, 1.0);
}

// ---- no air, uniform air ----------------------------------------------------------------------

AirSpectra spectra_of_air(const atmosphere::None& /*air*/, const ephemeris::Illumination& bodies,
                          const AirView& /*view*/, std::vector<double>& knots_um) {
  AirSpectra made;
  for (const auto& body : bodies) {
    made.bodies.push_back({{known_at(function_of(body.irradiance, knots_um))},
                           height_of(body) * std::numbers::inv_pi});
  }
  return made;
}

AirSpectra spectra_of_air(const atmosphere::Uniform& air, const ephemeris::Illumination& bodies,
                          const AirView& /*view*/, std::vector<double>& knots_um) {
  AirSpectra made;
  const SpectralFunction passes = function_of(air.transmittance, knots_um);
  made.view = {known_at(passes)};
  for (const auto& body : bodies) {
    made.bodies.push_back(
        {{known_at(function_of(body.irradiance, knots_um)),
          known_at(function_of(air.solar_transmittance, knots_um)), known_at(passes)},
         height_of(body) * std::numbers::inv_pi});
  }
  made.sky_scattering = {
      {{known_at(function_of(air.sky_radiance, knots_um)), known_at(passes)}, 1.0}};
  made.sky_emission = {{{black_body_at(air.sky_temperature), known_at(passes)}, 1.0}};
  made.path_scattering = {{{known_at(function_of(air.path_radiance, knots_um))}, 1.0}};
  made.path_emission = {{{black_body_at(air.air_temperature), known_at(one_minus(passes))}, 1.0}};
  return made;
}

// ---- a table of plain wavelengths -------------------------------------------------------------

/// Takes rows of a table apart: numbers by lane, of which each wavelength has one.
struct TableRows {
  const AirTable* table;
  std::vector<double>* knots_um;

  /// @param row  which run of lanes of `values`
  [[nodiscard]] SpectralFunction at(const std::vector<float>& values, std::size_t row) const {
    const std::size_t lanes = table->lanes.size();
    std::vector<double> wavelength_um, value;
    for (std::size_t i = 0; i < lanes; ++i) {
      const double one = static_cast<double>(values.at(row * lanes + i)) * table->lanes[i].weight;
      const bool again =
          !wavelength_um.empty() && wavelength_um.back() == table->lanes[i].wavelength_um;
      if (again) {
        value.back() += one;  // terms of one wavelength: their mean
      } else {
        wavelength_um.push_back(table->lanes[i].wavelength_um);
        value.push_back(one);
      }
    }
    return owned(std::move(wavelength_um), std::move(value), *knots_um);
  }
};

SpectralFunction table_view(const AirTable& table, const AirView& view, const TableRows& rows) {
  if (table.views.empty()) return [](double) { return 1.0; };
  const AirTable::View& seen = table.views.front();
  const double height_m = std::min(view.observer_height_m, table.top_m);
  const double up_m = std::abs(height_m - table.ground_m);
  const double measure_m = atmosphere::air_measure_m(height_m, table.ground_m, up_m * view.secant);
  return [measure_m, extinction = rows.at(seen.extinction, seen.places() - 1)](double lambda_um) {
    return std::exp(-measure_m * extinction(lambda_um));
  };
}

void add_table_path(const AirTable& table, const TableRows& rows, const SpectralFunction& passes,
                    AirSpectra& made) {
  if (table.views.empty()) return;
  const AirTable::View& seen = table.views.front();
  const std::size_t places = seen.places();
  const AirFunction lost = known_at(one_minus(passes));
  made.path_emission.push_back({{known_at(rows.at(seen.even, places - 1)), lost}, 1.0});
  for (std::size_t row = 0; row < table.bodies.size() * static_cast<std::size_t>(table.kinds);
       ++row) {
    made.path_scattering.push_back(
        {{known_at(rows.at(seen.first, (row + 1) * places - 1)), lost},
         0.25 * std::numbers::inv_pi});  // a phase function alike in all directions
  }
}

AirSpectra spectra_of_air(const atmosphere::Tabulated& air, const ephemeris::Illumination& bodies,
                          const AirView& view, std::vector<double>& knots_um) {
  const AirTable& table = *air.table;
  const TableRows rows{&table, &knots_um};
  const SpectralFunction passes = table_view(table, view, rows);
  AirSpectra made;
  made.view = {known_at(passes)};
  for (const auto& body : bodies) {  // one each, in their order: a table may have another
    const auto known = std::find_if(table.bodies.begin(), table.bodies.end(),
                                    [&](const auto& one) { return one.name == body.name; });
    AirLight& light = made.bodies.emplace_back();
    light.scale = 0.0;
    if (known == table.bodies.end()) continue;
    light = {{known_at(rows.at(known->ground_irradiance, 0)), known_at(passes)},
             std::numbers::inv_pi};
  }
  if (!table.even_ground_irradiance.empty()) {
    made.sky_emission.push_back(
        {{known_at(rows.at(table.even_ground_irradiance, 0)), known_at(passes)},
         std::numbers::inv_pi});
  }
  add_table_path(table, rows, passes, made);
  return made;
}

// ---- air in layers ----------------------------------------------------------------------------

/// Ten layers, from the top of the air down to the ground: enough for what lets light through.
std::vector<double> coarse_levels(const atmosphere::Profile& profile, double ground_m) {
  const double top_m = std::min(profile.levels.back().height_m, 1e5);
  std::vector<double> levels{top_m};
  for (const double above_m : {50e3, 30e3, 20e3, 13e3, 9e3, 6e3, 4e3, 2.5e3, 1.2e3}) {
    if (ground_m + above_m < top_m) levels.push_back(ground_m + above_m);
  }
  levels.push_back(ground_m);
  return levels;
}

/// How many times its thickness each layer is crossed by a path up to a height.
std::vector<double> crossed(const std::vector<double>& level_m, double secant, double up_to_m) {
  std::vector<double> slant;
  for (std::size_t i = 1; i < level_m.size(); ++i) {
    const double share = (up_to_m - level_m[i]) / (level_m[i - 1] - level_m[i]);
    slant.push_back(secant * std::clamp(share, 0.0, 1.0));
  }
  return slant;
}

/// Transmittance of the gases on a path, and of scattering by molecules.
class LayerPaths {
 public:
  LayerPaths(const atmosphere::Layered& air, const spectral::Support& band,
             std::vector<double>& knots_um)
      : level_m_{coarse_levels(air.profile, air.ground_height_m)},
        gases_{air.gases, air.profile, level_m_},
        band_{band},
        knots_um_{&knots_um} {}

  [[nodiscard]] std::vector<double> path(double secant, double up_to_m) const {
    return crossed(level_m_, std::clamp(secant, 0.0, most_air_masses), up_to_m);
  }
  /// The band model's figures stand 5 cm^-1 apart: finer points than that are not needed.
  [[nodiscard]] SpectralFunction gases(const std::vector<double>& slant) const {
    constexpr double figures_cm1 = 5.0;
    constexpr double most_points = 400.0;
    const double span_cm1 = 1e4 / band_.lo.value - 1e4 / band_.hi.value;
    const int steps = static_cast<int>(std::clamp(span_cm1 / figures_cm1, 2.0, most_points));
    std::vector<double> wavelength_um, passed;
    for (int i = 0; i <= steps; ++i) {
      wavelength_um.push_back(
          std::lerp(band_.lo.value, band_.hi.value, i / static_cast<double>(steps)));
      passed.push_back(gases_.band_transmittance(Micrometres{wavelength_um.back()}, slant));
    }
    return owned(std::move(wavelength_um), std::move(passed), *knots_um_);
  }
  /// Optical depth of molecules that scatter, by the power law that they obey within a band.
  [[nodiscard]] SpectralFunction rayleigh(const std::vector<double>& slant) const {
    const double middle_um = 0.5 * (band_.lo.value + band_.hi.value);
    const auto depths = gases_.rayleigh_depth(Micrometres{middle_um});
    double depth = 0.0;
    for (std::size_t i = 0; i < depths.size(); ++i) depth += depths[i] * slant[i];
    return [depth, middle_um](double lambda_um) {
      return depth * std::pow(middle_um / lambda_um, 4.0);
    };
  }
  [[nodiscard]] AirFunction molecules_pass(const std::vector<double>& slant) const {
    return known_at([depth = rayleigh(slant)](double x) { return std::exp(-depth(x)); });
  }

 private:
  std::vector<double> level_m_;
  atmosphere::GasAbsorption gases_;
  spectral::Support band_;
  std::vector<double>* knots_um_;
};

std::vector<double> added(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

/// A body's light: on the ground, scattered down by the sky, scattered into the line of sight.
void add_body(const ephemeris::LightSource& body, const LayerPaths& paths,
              const std::vector<double>& up, std::vector<double>& knots_um, AirSpectra& made) {
  const double cos_zenith = height_of(body);
  const auto down = paths.path(1.0 / std::max(cos_zenith, 1.0 / most_air_masses), 1e9);
  const auto both = added(down, up);
  const AirFunction outside = over_intervals(function_of(body.irradiance, knots_um));
  const AirFunction gases = over_intervals(paths.gases(both));
  made.bodies.push_back(
      {{outside, gases, paths.molecules_pass(both)}, cos_zenith * std::numbers::inv_pi});
  // Half of what molecules and thin haze scatter goes down; haze is about as much as blue light's
  // molecules, at all wavelengths.
  const AirFunction scattered = known_at([depth = paths.rayleigh(paths.path(1.0, 1e9))](double x) {
    return 1.0 - std::exp(-depth(x) - 0.05);
  });
  made.sky_scattering.push_back({{outside, gases, scattered}, 0.5 * std::numbers::inv_pi});
  const AirFunction on_the_way =
      known_at([depth = paths.rayleigh(up)](double x) { return 1.0 - std::exp(-depth(x)); });
  made.path_scattering.push_back({{outside, gases, on_the_way}, 0.25 * std::numbers::inv_pi});
}

void add_night(const atmosphere::NightSky& night, const AirFunction& view,
               std::vector<double>& knots_um, AirSpectra& made) {
  for (const Curve* curve : {&night.airglow, &night.starlight, &night.urban_glow}) {
    if (!(curve->max_value() > 0.0)) continue;
    made.sky_scattering.push_back({{over_intervals(function_of(*curve, knots_um)), view}, 1.0});
  }
}

}  // namespace

AirSpectra air_spectra(const atmosphere::Atmosphere& air, const ephemeris::Illumination& bodies,
                       const AirView& view, std::vector<double>& knots_um) {
  return std::visit([&](const auto& one) { return spectra_of_air(one, bodies, view, knots_um); },
                    air);
}

AirSpectra air_spectra(const atmosphere::Layered& air, const ephemeris::Illumination& bodies,
                       const AirView& view, const spectral::Support& band,
                       std::vector<double>& knots_um) {
  const LayerPaths paths{air, band, knots_um};
  const auto up = paths.path(view.secant, view.observer_height_m);
  const SpectralFunction seen = paths.gases(up);
  const AirFunction gases = over_intervals(seen);
  AirSpectra made;
  made.view = {gases, paths.molecules_pass(up)};
  for (const auto& body : bodies) add_body(body, paths, up, knots_um, made);
  add_night(air.night, gases, knots_um, made);
  const Kelvin at_ground{level_at(air.profile, air.ground_height_m).temperature_k};
  const SpectralFunction sky = paths.gases(paths.path(diffusivity, 1e9));
  const auto of_sky = [sky, seen](double x) { return (1.0 - sky(x)) * seen(x); };
  made.sky_emission.push_back({{black_body_at(at_ground), over_intervals(of_sky)}, 1.0});
  made.path_emission.push_back({{black_body_at(at_ground), over_intervals(one_minus(seen))}, 1.0});
  return made;
}

}  // namespace nadir::sim
