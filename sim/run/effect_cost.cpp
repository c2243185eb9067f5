#include <algorithm>
#include <cmath>

#include "sim/run/prediction.hpp"
#include "sim/run/tiles.hpp"

namespace nadir::sim {
namespace {

using radiometry::Effect;

// What a look into the air's tables costs a line of sight, and what bending it costs, in units of
// an average ray; a scattering in a volume likewise. Round figures: the model is one of shares.
constexpr double air_look = 0.5, bend = 4.0, volume_event = 1.0;
constexpr double noise_s = 30e-9;       // a detector's number
constexpr double heat_cell_s = 200e-6;  // docs/exposure.md and docs/heat-solver.md
constexpr double air_lane_s = 0.05;     // of one lane of air in layers, 8 streams, both sources

/// The render's processor time by what its rays are for.
struct RayTimes {
  double ray_s = 0.0;  ///< of all such rays of the picture, were there one a path
  double targets = 0.0, lamps = 0.0, walks = 0.0, air = 0.0, volumes = 0.0, bent = 0.0;
};

RayTimes ray_times(const PredictionBasis& basis, const Pilot& pilot, const Prediction& prediction) {
  const radiometry::Counters& c = pilot.counters;
  const radiometry::EffectSet on = basis.run.world.effects.any;
  const auto count = [](auto n) { return static_cast<double>(n); };
  const bool air = on.has(Effect::path_scattering) || on.has(Effect::path_emission) ||
                   on.has(Effect::path_transmittance);
  const double primary = count(c.primary_rays);
  const double air_units = air ? air_look * primary : 0.0;
  const double bent_units = basis.run.bending ? bend * primary : 0.0;
  const double volume_units = volume_event * count(c.volume_events);
  const double all = count(c.rays()) - count(c.truth_rays) + air_units + bent_units + volume_units;
  if (!(all > 0.0)) return {};
  const double unit_s = prediction.render_s / all;
  return {unit_s * primary,
          unit_s * count(c.target_rays),
          unit_s * count(c.lamp_rays),
          unit_s * count(c.path_rays + c.full_samples + c.direct_only_samples),
          unit_s * air_units,
          unit_s * volume_units,
          unit_s * bent_units};
}

/// Spreads seconds evenly over those of the effects that are on.
class CostBook {
 public:
  CostBook(radiometry::EffectSet on, std::vector<EffectSheet>& effects)
      : on_{on}, effects_{effects} {}

  void share(double seconds, std::initializer_list<Effect> among) {
    const auto count = std::count_if(among.begin(), among.end(),
                                     [this](Effect effect) { return on_.has(effect); });
    if (count == 0) return;
    for (const Effect effect : among) {
      if (on_.has(effect)) sheet(effect).seconds += seconds / static_cast<double>(count);
    }
  }
  /// What an effect that is off would cost.
  void would_cost(Effect effect, double seconds) {
    if (!on_.has(effect)) sheet(effect).seconds_if_on += seconds;
  }
  void finish() {
    for (std::size_t i = 0; i < effects_.size(); ++i) {
      const bool absent = effects_[i].state == "off (absent)";
      if (on_.has(static_cast<Effect>(i))) effects_[i].seconds_if_on = effects_[i].seconds;
      if (absent) effects_[i].seconds_if_on = 0.0;
    }
  }

 private:
  EffectSheet& sheet(Effect effect) { return effects_.at(radiometry::index_of(effect)); }
  radiometry::EffectSet on_;
  std::vector<EffectSheet>& effects_;
};

double pixels_of(const World& world) {
  double pixels = 0.0;
  for (const sensor::DetectorArray& array : world.camera.arrays) {
    pixels += static_cast<double>(array.samples) * static_cast<double>(array.lines);
  }
  return pixels;
}

double detector_bands(const World& world) {
  double planes = 0.0;
  for (const sensor::DetectorArray& array : world.camera.arrays) {
    planes += static_cast<double>(array.samples) * static_cast<double>(array.lines) *
              static_cast<double>(array.bands.size());
  }
  return planes;
}

double air_seconds_unsolved(const PreparedRun& run) {
  if (!run.world.air || !run.world.air->layered) return 0.0;
  double lanes = 0.0;
  for (const ArrayPlan& array : run.plan.arrays) {
    for (const auto& block : array.lanes.blocks) lanes += block.count();
  }
  return lanes * air_lane_s;
}

}  // namespace

void cost_effects(const PredictionBasis& basis, const Pilot& pilot, const Prediction& prediction,
                  std::vector<EffectSheet>& effects) {
  const PreparedRun& run = basis.run;
  const radiometry::EffectSet on = run.world.effects.any;
  const RayTimes t = ray_times(basis, pilot, prediction);
  CostBook book{on, effects};
  // A ray to a light costs half for the light, half for whether it is in shadow.
  const double lit = on.has(Effect::shadows) ? 0.5 : 1.0;
  book.share(lit * t.targets, {Effect::solar_reflection, Effect::lunar_reflection});
  book.share(lit * t.lamps, {Effect::lamps});
  book.share((1.0 - lit) * (t.targets + t.lamps), {Effect::shadows});
  book.share(t.walks, {Effect::sky_scattering, Effect::sky_emission, Effect::interreflection,
                       Effect::leaf_transmission});
  book.share(t.air, {Effect::path_scattering, Effect::path_emission, Effect::path_transmittance});
  book.share(t.volumes, {Effect::volumes});
  book.share(t.bent, {Effect::refraction});
  book.share(prediction.air_s,
             {Effect::sky_scattering, Effect::sky_emission, Effect::path_scattering,
              Effect::path_emission, Effect::path_transmittance});
  book.share(prediction.heat_s, {Effect::thermal_solve});
  book.share(noise_s * detector_bands(run.world), {Effect::detector_noise});

  for (const Effect light : {Effect::solar_reflection, Effect::lunar_reflection, Effect::lamps,
                             Effect::sky_scattering, Effect::sky_emission, Effect::interreflection,
                             Effect::leaf_transmission, Effect::volumes}) {
    book.would_cost(light, t.ray_s);  // a ray a path
  }
  book.would_cost(Effect::shadows, lit * (t.targets + t.lamps));
  book.would_cost(Effect::refraction, bend * t.ray_s);
  for (const Effect air :
       {Effect::path_scattering, Effect::path_emission, Effect::path_transmittance}) {
    book.would_cost(air, air_look * t.ray_s);
  }
  if (!(prediction.air_s > 0.0)) {  // the first of them would have the air solved
    const double solve_s = air_seconds_unsolved(run);
    for (const Effect air : {Effect::sky_scattering, Effect::sky_emission, Effect::path_scattering,
                             Effect::path_emission, Effect::path_transmittance}) {
      book.would_cost(air, solve_s);
    }
  }
  const int threads = basis.threads > 0 ? basis.threads : available_threads();
  book.would_cost(Effect::thermal_solve, heat_cell_s * pixels_of(run.world) / threads);
  book.would_cost(Effect::detector_noise, noise_s * detector_bands(run.world));
  book.finish();
}

}  // namespace nadir::sim
