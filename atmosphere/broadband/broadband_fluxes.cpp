#include "atmosphere/broadband/broadband_fluxes.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "atmosphere/broadband/column_fluxes.hpp"
#include "atmosphere/make/columns.hpp"
#include "core/error.hpp"
#include "spectral/planck.hpp"

namespace nadir::atmosphere {
namespace {

/// A piece of the spectrum, and what comes of it.
struct SpectralPiece {
  double lo_um = 0.0, hi_um = 0.0;
  double outside_w_m2 = 0.0;   ///< sunlight outside the air
  bool emits = false;          ///< long-wave
  double emits_to_um = 0.0;    ///< its emission counts as far as here
  std::vector<double> direct;  ///< by height of the sun
  std::vector<double> diffuse;
  double emitted = 0.0;
  int columns = 0;
};

void expect(bool holds, const char* what) {
  if (!holds) throw InputError{std::string{"broadband light: "} + what};
}

void check_interval_edges(const std::vector<double>& edges) {
  expect(edges.size() != 1, "expected two edges of intervals at least");
  for (std::size_t i = 0; i < edges.size(); ++i) {
    expect(edges[i] >= 0.2 && edges[i] <= 200.0, "expected intervals within 0.2 to 200 um");
    expect(i == 0 || edges[i] > edges[i - 1], "expected the edges of intervals to ascend");
  }
}

void check_broadband(const BroadbandSettings& settings, const spectral::Curve& sun) {
  check_interval_edges(settings.solar_edges_um);
  check_interval_edges(settings.long_wave_edges_um);
  const auto in_unit = [](double v) { return v >= 0.0 && v <= 1.0; };
  expect(in_unit(settings.ground_reflectance), "expected a reflectance of the ground of 0 to 1");
  expect(in_unit(settings.spectrum_cos_zenith) &&
             std::all_of(settings.cos_zenith.begin(), settings.cos_zenith.end(), in_unit),
         "expected cosines of the sun's zenith angle of 0 to 1");
  const auto& edges = settings.solar_edges_um;
  expect(edges.empty() || sun.covers(Micrometres{edges.front()}, Micrometres{edges.back()}),
         "the sun's irradiance does not cover the solar intervals");
}

std::vector<SpectralPiece> pieces_of(const BroadbandSettings& settings,
                                     const spectral::Curve& sun) {
  std::vector<SpectralPiece> pieces;
  const auto& solar = settings.solar_edges_um;
  for (std::size_t i = 1; i < solar.size(); ++i) {
    SpectralPiece piece{solar[i - 1], solar[i], 0.0, false, 0.0, {}, {}, 0.0, 0};
    piece.outside_w_m2 =
        sun.mean(Micrometres{piece.lo_um}, Micrometres{piece.hi_um}) * (piece.hi_um - piece.lo_um);
    pieces.push_back(piece);
  }
  const auto& heat = settings.long_wave_edges_um;
  for (std::size_t i = 1; i < heat.size(); ++i) {
    const bool last = i + 1 == heat.size();
    pieces.push_back({heat[i - 1],
                      heat[i],
                      0.0,
                      true,
                      last ? std::numeric_limits<double>::infinity() : heat[i],
                      {},
                      {},
                      0.0,
                      0});
  }
  return pieces;
}

std::vector<double> planck_at_levels(const SpectralPiece& piece, const OpticalColumn& column) {
  std::vector<double> planck;
  for (const double t : column.level_temperature_k) {
    planck.push_back(
        spectral::planck_band(Micrometres{piece.lo_um}, Micrometres{piece.emits_to_um}, Kelvin{t})
            .value);
  }
  return planck;
}

/// Heights of the sun, that of the spectrum last.
std::vector<double> all_cosines(const BroadbandSettings& settings) {
  std::vector<double> mu = settings.cos_zenith;
  mu.push_back(settings.spectrum_cos_zenith);
  return mu;
}

void solve_piece(SpectralPiece& piece, const ColumnMaker& maker,
                 const BroadbandSettings& settings) {
  const Micrometres middle{0.5 * (piece.lo_um + piece.hi_um)};
  const auto terms = maker.terms({piece.lo_um, piece.hi_um, 0}, middle, settings.term_tolerance);
  const std::size_t layers = maker.levels_m().size() - 1;
  const OpticalColumn clean = maker.column(middle, std::vector<double>(layers, 0.0));
  const auto mu = piece.emits ? std::vector<double>{} : all_cosines(settings);
  const auto planck = piece.emits ? planck_at_levels(piece, clean) : std::vector<double>{};
  piece.direct.assign(mu.size(), 0.0);
  piece.diffuse.assign(mu.size(), 0.0);
  for (const AbsorptionTerm& term : terms) {
    OpticalColumn column = clean;
    for (std::size_t k = 0; k < layers; ++k) column.absorption[k] += term.depth[k];
    const ColumnFluxes fluxes = column_fluxes(column, mu, planck, settings.streams);
    piece.emitted += term.weight * fluxes.emitted;
    const double back = settings.ground_reflectance * fluxes.spherical_albedo;
    for (std::size_t i = 0; i < mu.size(); ++i) {
      const double straight = mu[i] * fluxes.direct[i];
      const double all = (straight + fluxes.diffuse[i]) / (1.0 - back);
      piece.direct[i] += term.weight * piece.outside_w_m2 * fluxes.direct[i];
      piece.diffuse[i] += term.weight * piece.outside_w_m2 * (all - straight);
    }
    ++piece.columns;
  }
}

spectral::Curve spectrum_of(const std::vector<SpectralPiece>& pieces, double mu) {
  std::vector<double> wavelength_um, value;
  const auto put = [&](double at_um, double irradiance) {
    wavelength_um.push_back(at_um);
    value.push_back(irradiance);
  };
  for (const SpectralPiece& piece : pieces) {
    if (piece.emits) break;
    const double width_um = piece.hi_um - piece.lo_um;
    const double mean = (mu * piece.direct.back() + piece.diffuse.back()) / width_um;
    if (value.empty()) put(piece.lo_um, mean);
    put(0.5 * (piece.lo_um + piece.hi_um), mean);
    if (&piece == &pieces.back() || (&piece + 1)->emits) put(piece.hi_um, mean);
  }
  if (value.empty()) return spectral::Curve::constant(0.0);
  return {std::move(wavelength_um), std::move(value), spectral::Outside::reject};
}

}  // namespace

std::vector<double> BroadbandSettings::default_solar_edges() {
  return {0.28, 0.30, 0.31,  0.32,  0.34, 0.36, 0.40, 0.45, 0.50, 0.55, 0.60, 0.65, 0.685,
          0.70, 0.74, 0.757, 0.771, 0.80, 0.84, 0.89, 0.99, 1.07, 1.10, 1.16, 1.25, 1.30,
          1.34, 1.48, 1.55,  1.77,  1.98, 2.08, 2.32, 2.50, 2.90, 3.30, 4.00};
}

std::vector<double> BroadbandSettings::default_long_wave_edges() {
  return {4.0,  4.5,  5.0,  5.5,  6.0,  6.5,  7.0,  7.5,   8.0,  8.5,  9.0,
          9.4,  9.8,  10.2, 10.8, 11.5, 12.2, 13.0, 13.5,  14.2, 15.8, 16.5,
          17.5, 19.0, 21.0, 24.0, 28.0, 35.0, 50.0, 100.0, 200.0};
}

std::vector<double> BroadbandSettings::default_cos_zenith() {
  return {0.0,  0.02, 0.05,  0.1,  0.15,  0.2, 0.25, 0.3, 0.35,
          0.42, 0.5,  0.575, 0.65, 0.725, 0.8, 0.9,  1.0};
}

ClearSkyFluxes broadband_fluxes(const Layered& air, const BroadbandSettings& settings,
                                const spectral::Curve& solar_irradiance) {
  check_broadband(settings, solar_irradiance);
  std::vector<SpectralPiece> pieces = pieces_of(settings, solar_irradiance);
  std::vector<Micrometres> middles;
  for (const SpectralPiece& piece : pieces) middles.emplace_back(0.5 * (piece.lo_um + piece.hi_um));
  const ColumnMaker maker{air, middles};
  tbb::parallel_for(std::size_t{0}, pieces.size(),
                    [&](std::size_t i) { solve_piece(pieces[i], maker, settings); });

  ClearSkyFluxes fluxes;
  const std::size_t heights = settings.cos_zenith.size();
  fluxes.cos_zenith = settings.cos_zenith;
  fluxes.direct_normal_w_m2.assign(heights, 0.0);
  fluxes.diffuse_horizontal_w_m2.assign(heights, 0.0);
  fluxes.air_k = level_at(air.profile, air.ground_height_m).temperature_k;
  for (const SpectralPiece& piece : pieces) {
    fluxes.columns += piece.columns;
    fluxes.sky_long_wave_w_m2 += piece.emitted;
    for (std::size_t i = 0; i < heights && !piece.emits; ++i) {
      fluxes.direct_normal_w_m2[i] += piece.direct[i];
      fluxes.diffuse_horizontal_w_m2[i] += piece.diffuse[i];
    }
  }
  fluxes.spectrum = spectrum_of(pieces, settings.spectrum_cos_zenith);
  return fluxes;
}

}  // namespace nadir::atmosphere
