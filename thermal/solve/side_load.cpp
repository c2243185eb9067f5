#include "thermal/solve/side_load.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::thermal {
namespace {

/// A cavity that absorbs less than this of its own light would hold it for ever.
constexpr double least_absorbed = 0.02;
/// A reference place in the sun gets the direct light of level ground; a patch turned towards the
/// sun may get more, and is taken to be warmer by as much, up to here.
constexpr double most_lit = 1.5;

const SurroundingSurface& surface_of(const HeatModel& model, std::uint32_t material) {
  return material < model.surroundings.size() ? model.surroundings[material] : model.ground_about;
}

/// Sums over the patches' moments.
struct PatchSun {
  double seen = 0.0, possible = 0.0;  ///< cosines, with and without shadows
  double lit = 0.0;                   ///< direct light over that on level ground, as energy
};
PatchSun sun_of(const SharedStages& shared, const SurroundingPatch& patch) {
  PatchSun sum;
  double energy = 0.0, level = 0.0;
  const std::size_t moments = std::min(patch.sun_cosine.size(), shared.patch_direct.size());
  for (std::size_t i = 0; i < moments; ++i) {
    const Vec3 direction = shared.patch_direction[i];
    if (direction.z <= 0.0) continue;
    const double cosine = patch.sun_cosine[i];
    sum.seen += cosine;
    sum.possible += std::max(0.0, dot(direction, patch.normal));
    energy += cosine * shared.patch_direct[i];
    level += direction.z * shared.patch_direct[i];
  }
  if (level > 0.0) sum.lit = std::min(most_lit, energy / level);
  return sum;
}

void add_emission(std::vector<SurroundingsFactors::Emission>& emissions,
                  const SurroundingsFactors::Emission& one) {
  for (auto& known : emissions) {
    if (known.series != one.series) continue;
    known.shaded += one.shaded;
    known.lit += one.lit;
    return;
  }
  emissions.push_back(one);
}

/// The sky and sunlight that place and patches have over what they could have.
double openness(const SharedStages& shared, const SurroundingsSeen& seen, double place_up) {
  double have = seen.sky_fraction, could = 0.5 * (1.0 + place_up);
  for (const SurroundingPatch& patch : seen.patches) {
    const PatchSun sun = sun_of(shared, patch);
    if (sun.possible <= 0.0) continue;
    have += patch.view_factor * std::min(1.0, sun.seen / sun.possible);
    could += patch.view_factor;
  }
  return could > 0.0 ? std::min(1.0, have / could) : 1.0;
}

/// Adds factor f over a run of stages: y += f x.
struct Axpy {
  SharedStages::Run run;

  void operator()(std::vector<double>& y, double factor, const std::vector<double>& x) const {
    for (std::size_t i = run.begin; i < run.end; ++i) y[i] += factor * x[i];
  }
};

void add_run(const SharedStages& shared, const SurroundingsFactors& factors,
             const SharedStages::Run& run, SideLoad& load) {
  const Axpy add{run};
  std::fill(load.sky_fraction.begin() + static_cast<std::ptrdiff_t>(run.begin),
            load.sky_fraction.begin() + static_cast<std::ptrdiff_t>(run.end), factors.sky_fraction);
  add(load.reflected_w_m2, factors.reflected_sky, shared.diffuse);
  add(load.surroundings_w_m2, factors.reflected_long_wave, shared.sky_long_wave);
  for (const auto& emission : factors.emissions) {
    const EmissionSeries& series = shared.surroundings[emission.series];
    if (series.lit.empty()) {
      add(load.surroundings_w_m2, emission.shaded + emission.lit, series.shaded);
    } else {
      add(load.surroundings_w_m2, emission.shaded, series.shaded);
      add(load.surroundings_w_m2, emission.lit, series.lit);
    }
  }
  if (factors.reflected_direct.empty()) return;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    load.reflected_w_m2[i] +=
        interpolated(factors.reflected_direct, shared.patch_sun[i]) * shared.direct_normal[i];
  }
}

}  // namespace

void find_factors(const HeatModel& model, const SharedStages& shared, const SurroundingsSeen& seen,
                  double place_up, SurroundingsFactors& factors) {
  factors.sky_fraction = seen.sky_fraction;
  factors.reflected_sky = factors.reflected_long_wave = 0.0;
  factors.emissions.clear();
  factors.reflected_direct.clear();
  double all = 0.0;
  for (const SurroundingPatch& patch : seen.patches) all += patch.view_factor;
  if (!(all > 0.0)) return;
  const double open = openness(shared, seen, place_up);
  double again_light = 0.0, again_heat = 0.0;  // what the surroundings give one another
  for (const SurroundingPatch& patch : seen.patches) {
    const SurroundingSurface& surface = surface_of(model, patch.material);
    const double factor = patch.view_factor, sky = open * patch.sky_fraction;
    const double mirrors = factor * (1.0 - surface.emissivity);
    const double whitens = factor * surface.solar_reflectance;
    again_light += whitens * (1.0 - sky) / all;
    again_heat += mirrors * (1.0 - sky) / all;
    factors.reflected_sky += whitens * sky;
    factors.reflected_long_wave += mirrors * sky;
    const double lit = sun_of(shared, patch).lit, emits = factor * surface.emissivity;
    add_emission(factors.emissions,
                 {shared.surroundings_index(patch.material), emits * (1.0 - lit), emits * lit});
    const std::size_t moments = std::min(patch.sun_cosine.size(), shared.patch_direct.size());
    if (factors.reflected_direct.size() < moments) factors.reflected_direct.resize(moments, 0.0);
    for (std::size_t i = 0; i < moments; ++i) {
      factors.reflected_direct[i] += whitens * static_cast<double>(patch.sun_cosine[i]);
    }
  }
  const double light = 1.0 / std::max(least_absorbed, 1.0 - again_light);
  const double heat = 1.0 / std::max(least_absorbed, 1.0 - again_heat);
  factors.reflected_sky *= light;
  for (double& direct : factors.reflected_direct) direct *= light;
  factors.reflected_long_wave *= heat;
  for (auto& emission : factors.emissions) {
    emission.shaded *= heat;
    emission.lit *= heat;
  }
}

SurfaceLoad SideLoad::at(std::size_t stage, const SharedStages& shared,
                         const Film& film) const noexcept {
  const WeatherState& weather = shared.weather[stage];
  return {.direct_w_m2 = sun_cosine[stage] * weather.direct_normal_w_m2,
          .diffuse_w_m2 = sky_fraction[stage] * weather.diffuse_horizontal_w_m2,
          .reflected_w_m2 = reflected_w_m2[stage],
          .sky_long_wave_w_m2 = sky_fraction[stage] * weather.sky_long_wave_w_m2,
          .surroundings_long_wave_w_m2 = surroundings_w_m2[stage],
          .air_k = weather.air_temperature_k,
          .vapour_pressure_hpa = weather.vapour_pressure_hpa,
          .pressure_hpa = weather.pressure_hpa,
          .film = film};
}

SurfaceLoad SideLoad::at_long(std::size_t stage, const SharedStages& shared,
                              const Film& film) const noexcept {
  const SharedStages::LongSteps& steps = shared.long_steps;
  const std::vector<double>& weights = steps.weights[stage % 2];
  const std::size_t first = stage / 2 * weights.size();
  double light = 0.0, heat = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const std::size_t at = first + i;
    const double sky = sky_fraction[at];
    light += weights[i] * (sun_cosine[at] * shared.direct_normal[at] + sky * shared.diffuse[at] +
                           reflected_w_m2[at]);
    heat += weights[i] * (sky * shared.sky_long_wave[at] + surroundings_w_m2[at]);
  }
  const WeatherState& weather = steps.weather[stage];
  return {.direct_w_m2 = light,
          .sky_long_wave_w_m2 = heat,
          .air_k = weather.air_temperature_k,
          .vapour_pressure_hpa = weather.vapour_pressure_hpa,
          .pressure_hpa = weather.pressure_hpa,
          .film = film};
}

void find_load(const HeatModel& model, const SharedStages& shared, const Exposure& exposure,
               double place_up, SideLoad& load) {
  const std::size_t stages = shared.grid.stages();
  load.place_up = place_up;
  load.sun_cosine.resize(stages);
  load.sky_fraction.assign(stages, 1.0);
  load.reflected_w_m2.assign(stages, 0.0);
  load.surroundings_w_m2.assign(stages, 0.0);
  for (std::size_t i = 0; i < stages; ++i) {
    load.sun_cosine[i] = interpolated(exposure.sun_cosine, shared.sun[i]);
  }
  if (load.factors.size() < shared.epochs.size()) load.factors.resize(shared.epochs.size());
  for (std::size_t epoch = 0; epoch < shared.epochs.size(); ++epoch) {
    const auto found =
        std::find(exposure.epochs.begin(), exposure.epochs.end(), shared.epochs[epoch]);
    const auto which = static_cast<std::size_t>(found - exposure.epochs.begin());
    if (which >= exposure.seen.size()) continue;
    find_factors(model, shared, exposure.seen[which], place_up, load.factors[epoch]);
  }
  for (const SharedStages::Run& run : shared.runs) {
    add_run(shared, load.factors[run.epoch], run, load);
  }
}

}  // namespace nadir::thermal
