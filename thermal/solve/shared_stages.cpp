#include "thermal/solve/shared_stages.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace nadir::thermal {
namespace {

std::size_t index_of_epoch(std::vector<std::uint32_t>& epochs, std::uint32_t bit) {
  const auto found = std::find(epochs.begin(), epochs.end(), bit);
  if (found != epochs.end()) return static_cast<std::size_t>(found - epochs.begin());
  epochs.push_back(bit);
  return epochs.size() - 1;
}

void add_weather(const Weather& weather, SharedStages& shared) {
  for (std::size_t stage = 0; stage < shared.grid.stages(); ++stage) {
    const WeatherState state = weather.at(shared.grid.stage_s(stage));
    shared.weather.push_back(state);
    shared.direct_normal.push_back(state.direct_normal_w_m2);
    shared.diffuse.push_back(state.diffuse_horizontal_w_m2);
    shared.sky_long_wave.push_back(state.sky_long_wave_w_m2);
  }
}

void add_sun(const SunTrack& track, SharedStages& shared) {
  const EvenMoments moments = moments_of(track);
  for (const Vec3& direction : track.direction) {
    shared.level_cosine.push_back(std::max(0.0, direction.z));
  }
  for (const std::uint32_t bit : track.epoch) index_of_epoch(shared.epochs, bit);
  for (std::size_t stage = 0; stage < shared.grid.stages(); ++stage) {
    const Between place = moments.find(shared.grid.stage_s(stage));
    shared.sun.push_back(place);
    const std::size_t nearest = place.index + (place.share >= 0.5F ? 1U : 0U);
    const std::size_t epoch = index_of_epoch(shared.epochs, track.epoch[nearest]);
    if (shared.runs.empty() || shared.runs.back().epoch != epoch) {
      shared.runs.push_back({stage, stage, epoch});
    }
    shared.runs.back().end = stage + 1;
  }
}

void add_patch_moments(const HeatModel& model, SharedStages& shared) {
  const EvenMoments moments = moments_of(model.sun);
  const EvenMoments patches =
      patch_moments(model.sun, model.settings.exposure.surroundings_interval_s);
  for (std::size_t stage = 0; stage < shared.grid.stages(); ++stage) {
    shared.patch_sun.push_back(patches.find(shared.grid.stage_s(stage)));
  }
  for (std::size_t i = 0; i < patches.count; ++i) {
    const Between place = moments.find(patches.at(i));
    const Vec3 before = model.sun.direction[place.index],
               after = model.sun.direction[place.index + 1];
    const Vec3 direction = normalised(before + static_cast<double>(place.share) * (after - before));
    shared.patch_direction.push_back(direction);
    shared.level_patch_cosine.push_back(static_cast<float>(std::max(0.0, direction.z)));
    shared.patch_direct.push_back(
        direction.z > 0.0 ? model.weather.at(patches.at(i)).direct_normal_w_m2 : 0.0);
  }
}

/// Of a load q that runs linearly through a long step, at times x from -1/2 to 1/2 of it with the
/// scheme's weights w: mean sum w q, trend sum w x q / sum w x^2.
void add_long_steps(SharedStages& shared) {
  const TimeGrid& grid = shared.grid;
  SharedStages::LongSteps& steps = shared.long_steps;
  const auto count = static_cast<double>(grid.in_long_step);
  std::vector<double> place;
  double spread = 0.0;
  for (std::size_t stage = 0; stage < 2 * grid.in_long_step; ++stage) {
    const bool end = stage % 2 != 0;
    const double within = static_cast<double>(stage >> 1U) + (end ? 1.0 : Column::gamma);
    place.push_back(within / count - 0.5);
    steps.mean.push_back((end ? Column::gamma : 1.0 - Column::gamma) / count);
    spread += steps.mean.back() * place.back() * place.back();
  }
  for (std::size_t i = 0; i < place.size(); ++i) {
    const double trend = steps.mean[i] * place[i] / spread;
    steps.weights[0].push_back(steps.mean[i] + (Column::gamma - 0.5) * trend);
    steps.weights[1].push_back(steps.mean[i] + 0.5 * trend);
  }
  for (std::size_t stage = 0; stage < 2 * grid.long_steps(); ++stage) {
    WeatherState sum{};
    sum.air_temperature_k = sum.vapour_pressure_hpa = sum.pressure_hpa = 0.0;
    for (std::size_t i = 0; i < place.size(); ++i) {
      const WeatherState& one = shared.weather[stage / 2 * place.size() + i];
      const double weight = steps.weights[stage % 2][i];
      sum.air_temperature_k += weight * one.air_temperature_k;
      sum.vapour_pressure_hpa += weight * one.vapour_pressure_hpa;
      sum.pressure_hpa += steps.mean[i] * one.pressure_hpa;
    }
    steps.weather.push_back(sum);
  }
}

double black_body(double temperature_k) {
  const double t2 = temperature_k * temperature_k;
  return si::stefan_boltzmann * t2 * t2;
}

EmissionSeries emission_of(const SurroundingSurface& surface, const SharedStages& shared) {
  EmissionSeries series;
  if (const auto* fixed = std::get_if<Kelvin>(&surface.temperature)) {
    series.shaded.assign(shared.grid.stages(), black_body(fixed->value));
  }
  if (const auto* air = std::get_if<FollowsAir>(&surface.temperature)) {
    for (const WeatherState& state : shared.weather) {
      series.shaded.push_back(black_body(std::max(0.0, state.air_temperature_k + air->offset_k)));
    }
  }
  return series;
}

}  // namespace

SharedStages make_shared_stages(const HeatModel& model) {
  SharedStages shared;
  shared.grid = make_time_grid(model.settings);
  add_weather(model.weather, shared);
  add_long_steps(shared);
  add_sun(model.sun, shared);
  add_patch_moments(model, shared);
  for (const SurroundingSurface& surface : model.surroundings) {
    shared.surroundings.push_back(emission_of(surface, shared));
  }
  shared.surroundings.push_back(emission_of(model.ground_about, shared));
  return shared;
}

}  // namespace nadir::thermal
