#include "sim/run/heat_ahead.hpp"

#include "core/random.hpp"
#include "sensor/camera/path_view.hpp"
#include "sim/run/pixel.hpp"

namespace nadir::sim {
namespace {

/// Hits that are handed over at a time: 10 MB.
constexpr std::size_t batch = 1U << 16;

}  // namespace

void solve_heat_ahead(const World& world, std::uint64_t seed) {
  if (!world.heat) return;
  std::vector<geometry::Hit> hits;
  const auto solve = [&] {
    world.heat->solve_ahead(hits);
    hits.clear();
  };
  hits.reserve(batch);
  for (std::size_t i = 0; i < world.camera.arrays.size(); ++i) {
    const sensor::DetectorArray& array = world.camera.arrays[i];
    if (!world.asks_for_heat[i]) continue;
    for (int line = 0; line < array.lines; ++line) {
      for (int sample = 0; sample < array.samples; ++sample) {
        const Sampler numbers = path_numbers(mix(seed, i), array, {sample, line, 0, 0});
        auto hit = world.scene.geometry.intersect(
            sensor::path_view(array, world.camera.platform, sample, line, numbers).ray);
        if (!hit) continue;
        radiometry::resolve_map(world.scene, *hit, numbers);
        hits.push_back(*hit);
        if (hits.size() == batch) solve();
      }
    }
  }
  solve();
}

void tell_of_heat(const World& world, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const materials::Material& material : world.scene.materials) names.push_back(material.name);
  for (const std::string& caution : world.heat->cautions(names)) diagnostics.warn(caution);
}

ReportValues heat_report(const World& world) {
  constexpr std::size_t cells_for_error = 128;  // rms good to 6 %
  const thermal::HeatError error = world.heat->error(cells_for_error);
  const thermal::HeatCounters counters = world.heat->counters();
  const auto& model = world.heat->model();
  const auto integer = [](auto value) { return static_cast<std::int64_t>(value); };
  return {{"cells_ahead", integer(counters.cells_ahead)},
          {"cells_on_demand", integer(counters.cells_on_demand)},
          {"rays", integer(counters.rays)},
          {"steps", integer(counters.steps)},
          {"longest_spin_up_days", integer(counters.longest_spin_up_days)},
          {"cells_not_repeating", integer(counters.not_repeating)},
          {"cells_held", integer(counters.held)},
          {"error_rms_k", error.rms_k},
          {"error_largest_k", error.largest_k},
          {"error_cells", integer(error.cells)},
          {"step_s", model.settings.step_s},
          {"history_s", model.settings.history_s},
          {"resolution_m", model.settings.resolution_m},
          {"air_temperature_k", model.weather.at(0.0).air_temperature_k}};
}

}  // namespace nadir::sim
