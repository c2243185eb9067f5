#include "atmosphere/make/lane_fields.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "atmosphere/make/twilight.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/transfer/discrete_ordinates.hpp"
#include "atmosphere/transfer/two_stream.hpp"
#include "spectral/planck.hpp"

namespace nadir::atmosphere {
namespace {

using std::numbers::pi;

// What is left out, and by how much it would have shown:
constexpr double emission_share = 1e-9;   // of the light from outside: no thermal solve
constexpr double emission_floor = 1e-15;  // W m^-2 sr^-1 um^-1: some thousand photons a second
constexpr double night_share = 1e-6;      // of other light: the night sky's is not scattered
constexpr double beam_share = 1e-4;       // of the air's emission: scattered once, not again

/// Mean of van Rhijn's factor over a level surface's hemisphere, 2 int mu dmu / sqrt(0.04 +
/// 0.96 mu^2).
constexpr double van_rhijn_mean = 5.0 / 3.0;

double sum_of(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

double warmest_k(const OpticalColumn& column) {
  return *std::max_element(column.level_temperature_k.begin(), column.level_temperature_k.end());
}

/// What is to be solved at a lane.
struct Wanted {
  bool thermal = false, sky = false;
  std::vector<bool> beam;  // by body
};

Wanted wanted(const LaneInput& in, const ScaledColumn& scaled,
              const std::vector<BodyPlace>& bodies) {
  const double warm = spectral::planck(in.wavelength, Kelvin{warmest_k(in.column)}).value;
  const double emission = warm * -std::expm1(-sum_of(in.column.absorption));
  double scattering = 0.0;
  for (const auto& kind : scaled.column.kinds) scattering += sum_of(kind.scattering);
  const double twice = std::min(1.0, scattering * scattering);
  double light = 0.0;
  Wanted want;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double strength = in.irradiance[b] * light_share(bodies[b].mu0) / pi;
    want.beam.push_back(in.irradiance[b] > 0.0 && strength * twice > beam_share * emission);
    light += strength;
  }
  const double night = in.airglow + in.starlight;
  want.sky = in.scattering && night > night_share * (light + emission);
  want.thermal = in.emission && warm > std::max(emission_floor, emission_share * (light + night));
  return want;
}

/// Adds a solved source, times a strength, to a component and those after it.
void add_to(LaneFields& fields, const ScatteredSource& solved, std::size_t component,
            double strength) {
  const std::size_t places = 2 * fields.depth.size();
  for (std::size_t p = 0; p < places; ++p) {
    for (int m = 0; m < solved.modes; ++m) {
      for (std::size_t i = 0; i < fields.directions; ++i) {
        fields.source[(p * fields.directions + i) * fields.components + component +
                      static_cast<std::size_t>(m)] +=
            strength * solved.at(static_cast<int>(p), m, static_cast<int>(i));
      }
    }
  }
}

void add_emission(LaneFields& fields, const OpticalColumn& scaled,
                  const std::vector<double>& planck) {
  for (std::size_t k = 0; k < fields.depth.size(); ++k) {
    if (fields.scaled_depth[k] <= 0.0) continue;
    const double share = scaled.absorption[k] / fields.scaled_depth[k];
    for (std::size_t edge = 0; edge < 2; ++edge) {
      double* row = fields.source.data() + (2 * k + edge) * fields.directions * fields.components +
                    LaneFields::even;
      for (std::size_t i = 0; i < fields.directions; ++i) {
        row[i * fields.components] += share * planck[k + edge];
      }
    }
  }
}

std::vector<double> planck_at(const std::vector<double>& temperatures_k, Micrometres wavelength) {
  std::vector<double> planck;
  for (const double t : temperatures_k) {
    planck.push_back(spectral::planck(wavelength, Kelvin{t}).value);
  }
  return planck;
}

LaneFields::Beam make_beam(std::size_t body, double irradiance, const BodyPlace& place,
                           const Shells& shells, const std::vector<double>& scaled_depth) {
  LaneFields::Beam beam;
  beam.body = body;
  beam.irradiance = irradiance;
  beam.place = place;
  for (const double depth : slant_depths(shells.level_m, scaled_depth, place.mu0)) {
    beam.transmittance.push_back(std::exp(-depth));
  }
  beam.local_share = local_share(place.mu0);
  if (beam.local_share > 0.0) beam.local = LocalBody{shells, scaled_depth, place.mu0};
  return beam;
}

void take_column(LaneFields& fields, const LaneInput& in, const OpticalColumn& scaled) {
  for (int k = 0; k < in.column.layers(); ++k) {
    fields.depth.push_back(in.column.depth(k));
    fields.scaled_depth.push_back(scaled.depth(k));
  }
  for (const auto& kind : in.column.kinds) {
    fields.scattering.push_back(kind.scattering);
    fields.phases.push_back(kind.phase);
  }
  fields.airglow = in.airglow;
  fields.starlight = in.starlight;
  fields.urban_glow = in.urban_glow;
}

void take_solution(LaneFields& fields, const TransferSolution& solved,
                   const TransferProblem& problem, const OpticalColumn& scaled) {
  for (std::size_t i = 0, s = 0; i < fields.beams.size(); ++i) {
    LaneFields::Beam& beam = fields.beams[i];
    if (beam.modes == 0) continue;
    beam.modes = solved.beams[s].modes;
    beam.fluxes = solved.beams[s++].fluxes;
    beam.first_component = fields.components;
    fields.components += static_cast<std::size_t>(beam.modes);
  }
  if (problem.thermal && problem.sky) fields.night = fields.components++;
  fields.night_alone = !problem.thermal || fields.night != LaneFields::even;
  fields.source.assign(2 * fields.depth.size() * fields.directions * fields.components, 0.0);
  if (problem.ground) {
    add_to(fields, solved.ground, LaneFields::ground, 1.0);
    fields.from_ground = solved.ground.fluxes;
  }
  for (std::size_t i = 0, s = 0; i < fields.beams.size(); ++i) {
    const LaneFields::Beam& beam = fields.beams[i];
    if (beam.modes > 0) add_to(fields, solved.beams[s++], beam.first_component, beam.irradiance);
  }
  if (problem.thermal) {
    add_to(fields, solved.thermal, LaneFields::even, 1.0);
    add_emission(fields, scaled, problem.planck);
    fields.thermal = solved.thermal.fluxes;
  }
  if (problem.sky) {
    fields.night_scattered = fields.starlight + van_rhijn_mean * fields.airglow;
    add_to(fields, solved.sky, fields.night, fields.night_scattered);
    fields.sky = solved.sky.fluxes;
  }
}

}  // namespace

double BodyPlace::sine() const { return std::sqrt(std::max(0.0, 1.0 - mu0 * mu0)); }

SolveCounts& SolveCounts::operator+=(const SolveCounts& b) {
  columns += b.columns;
  beam_solves += b.beam_solves;
  thermal_solves += b.thermal_solves;
  sky_solves += b.sky_solves;
  return *this;
}

double light_share(double mu0) noexcept {
  constexpr double outside_lux = 133e3;  // 1 au, mean
  const double elevation = std::asin(std::clamp(mu0, -1.0, 1.0)) * 180.0 / pi;
  if (elevation < -18.0) return 0.0;
  return ground_illuminance_lux(elevation) / outside_lux;
}

void LaneFields::add_source(int layer, const StepEnd& end,
                            std::vector<double>& into) const noexcept {
  const std::size_t place = 2 * static_cast<std::size_t>(layer);
  for (std::size_t edge = 0; edge < 2; ++edge) {
    const double share = edge == 0 ? end.top : 1.0 - end.top;
    const double* row =
        source.data() + ((place + edge) * directions + end.travel.first) * components;
    for (std::size_t j = 0; j < 4; ++j, row += components) {
      const double w = share * end.travel.weight[j];
      for (std::size_t c = 0; c < components; ++c) into[c] += w * row[c];
    }
  }
}

LaneFields lane_fields(const LaneInput& input, const Shells& shells,
                       const std::vector<BodyPlace>& bodies, const AirSettings& settings,
                       SolveCounts& counts) {
  const bool fast = settings.mode == AirMode::fast;
  const ScaledColumn scaled = delta_scaled(input.column, fast ? 2 : settings.streams);
  const Wanted want = wanted(input, scaled, bodies);
  LaneFields fields;
  fields.directions = shells.directions.mu().size();
  take_column(fields, input, scaled.column);

  TransferProblem problem;
  problem.ground = input.scattering || input.emission;
  problem.thermal = want.thermal;
  problem.sky = want.sky;
  if (want.thermal) {
    problem.planck = planck_at(input.column.level_temperature_k, input.wavelength);
  }
  for (std::size_t b = 0; b < bodies.size() && input.scattering; ++b) {
    if (input.irradiance[b] <= 0.0) continue;
    fields.beams.push_back(
        make_beam(b, input.irradiance[b], bodies[b], shells, fields.scaled_depth));
    if (!want.beam[b]) continue;
    fields.beams.back().modes = 1;
    problem.beams.push_back({bodies[b].mu0, fields.beams.back().transmittance});
  }
  const auto& mu = shells.directions.mu();
  TransferSolution solved;  // of nothing where no light is wanted
  if (problem.ground) {
    solved = fast ? two_stream(scaled, problem, mu)
                  : discrete_ordinates(scaled, problem, settings.streams, mu);
  }
  take_solution(fields, solved, problem, scaled.column);
  counts += {1, static_cast<int>(problem.beams.size()), want.thermal ? 1 : 0, want.sky ? 1 : 0};
  return fields;
}

}  // namespace nadir::atmosphere
