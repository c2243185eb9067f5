#include "sim/run/air_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "atmosphere/make/lane_fields.hpp"
#include "radiometry/air_effects.hpp"
#include "sim/files/hash.hpp"
#include "sim/run/air_memory.hpp"

namespace nadir::sim {
namespace {

using atmosphere::AirParts;
using atmosphere::AirTable;
using spectral::AbsorptionLane;

std::int64_t whole(std::size_t count) { return static_cast<std::int64_t>(count); }

/// One digest for several files.
std::string digest_of(const std::vector<std::filesystem::path>& files) {
  std::string all;
  for (const auto& file : files) all += digest_file(file).sha256;
  return digest_bytes(all).sha256;
}

std::string notes_text(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += (text.empty() ? "" : "; ") + note;
  return text;
}

/// The wavelengths at which the ground is asked for. A table from elsewhere may reach far beyond
/// the camera's bands, where no spectrum need be known: there it is as at the bands' edge.
std::vector<Micrometres> ground_wavelengths(const AirTable& table, const CameraPlan& plan) {
  const auto [lo, hi] = wavelength_range(plan);
  std::vector<Micrometres> wavelengths;
  for (const AirTable::Lane& lane : table.lanes) {
    wavelengths.push_back(std::clamp(Micrometres{lane.wavelength_um}, lo, hi));
  }
  return wavelengths;
}

void describe_table(const AirTable& table, ReportValues& values) {
  values.emplace_back("lanes", whole(table.lanes.size()));
  values.emplace_back("bodies", whole(table.bodies.size()));
  values.emplace_back("interpolation_error", table.interpolation_error);
  values.emplace_back("made_by", table.made_by);
  values.emplace_back("notes", notes_text(table.notes));
}

// Less than that is not told from the model's own errors.
constexpr double noticeable_error = 0.05;

void warn_of_error(const AirTable& table, const SourceLocation& where, Diagnostics& diagnostics) {
  if (!(table.interpolation_error > noticeable_error)) return;
  warn_at(where,
          fmt::format("the light of the air is interpolated to within {:.0f} % at worst",
                      100.0 * table.interpolation_error),
          diagnostics);
}

/// What the air is to serve.
struct AirWanted {
  const BandNodes& per_band;
  std::span<const radiometry::EffectSet> effects;  // by array
};

/// Lanes of the camera's nodes, each with what is wanted there.
AirLanes lanes_wanted(const LayeredTask& task, const World& world, const AirWanted& want,
                      const std::vector<AirParts>& wanted) {
  AirLanes air = plan_camera(world.camera.arrays, want.per_band, task.air, task.settings).air;
  for (atmosphere::SplitLane& lane : air.lanes) {
    lane.wanted = wanted[static_cast<std::size_t>(lane.source)];
  }
  return air;
}

/// Computes the table of air in layers, or finds it in the cache.
AirTable solve(const LayeredTask& task, const World& world, const AirWanted& want,
               const AirCacheOptions& cache, ReportValues& values, Diagnostics& diagnostics) {
  const ephemeris::Illumination& bodies = world.scene.illumination;
  const std::vector<sensor::DetectorArray>& arrays = world.camera.arrays;
  const AirLanes nodes = air_nodes(arrays, want.per_band);
  const std::vector<AirParts> wanted = wanted_of_air(arrays, want.per_band, want.effects);
  const std::string key =
      air_key(task.air, task.settings, nodes, bodies, digest_of(task.figures), wanted);
  atmosphere::SolveCounts counts;  // stay 0 where the cache has the table
  const auto make = [&] {          // a kept table knows its lanes: only here are they split
    const AirLanes air = lanes_wanted(task, world, want, wanted);
    check_memory(world.camera,
                 {air.lanes.size(), air_table_memory(task, air.lanes.size(), bodies.size())});
    return atmosphere::make_air_table(task.air, task.settings, air.lanes, air.wavelengths, bodies,
                                      &counts);
  };
  CacheOutcome outcome;
  AirTable table = cached_air_table(key, make, diagnostics, outcome, cache);
  const bool fast = task.settings.mode == atmosphere::AirMode::fast;
  values = {{"model", std::string{"layered"}},
            {"profile", task.air.profile.name},
            {"mode", std::string{fast ? "fast" : "accurate"}},
            {"streams", static_cast<std::int64_t>(fast ? 2 : task.settings.streams)},
            {"observer_height_m", task.settings.observer_height_m},
            {"ground_height_m", task.air.ground_height_m},
            {"wavelengths", whole(nodes.wavelengths.size())},
            {"beam_solves", static_cast<std::int64_t>(counts.beam_solves)},
            {"thermal_solves", static_cast<std::int64_t>(counts.thermal_solves)},
            {"from_cache", outcome.hit},
            {"cache_file", outcome.file.string()}};
  return table;
}

Micrometres mean_wavelength(const std::vector<sensor::DetectorArray>& arrays) {
  double sum = 0.0, count = 0.0;
  for (const sensor::DetectorArray& array : arrays) {
    for (const sensor::Band& band : array.bands) {
      sum += spectral::centre(band.response).value;
      count += 1.0;
    }
  }
  return Micrometres{sum / count};
}

/// The bending of the camera's rays and what it does: none where the scenario does not ask for it.
struct BendingShift {
  RayBending bending;
  double pixels = 0.0;  ///< the worst of all arrays
  [[nodiscard]] bool noticeable() const { return pixels >= 0.1; }
};

std::optional<BendingShift> bending_shift(const World& world) {
  if (!world.air || !world.air->layered || !world.air->layered->refraction) return std::nullopt;
  const atmosphere::Layered& air = world.air->layered->air;
  BendingShift shift{{atmosphere::Refractivity{air.profile, mean_wavelength(world.camera.arrays)},
                      air.ground_height_m}};
  for (const sensor::DetectorArray& array : world.camera.arrays) {
    shift.pixels = std::max(shift.pixels, bending_in_pixels(world.scene.geometry, shift.bending,
                                                            array, world.camera.platform));
  }
  return shift;
}

/// Geolocation has no air: what it says is off from what the image shows.
void warn_of_bending(const World& world, Diagnostics& diagnostics) {
  const std::optional<BendingShift> shift = bending_shift(world);
  if (!shift || !shift->noticeable()) return;
  warn_at(world.air->where,
          fmt::format("refraction bends the camera's rays: the image and its truth show it, but "
                      "what places the image on the earth (GeoTIFF, NetCDF, sidecars, nadir "
                      "project) holds straight lines of sight, up to {:.1f} pixels off",
                      shift->pixels),
          diagnostics);
}

/// The nodes of one of the camera's arrays.
AirLanes nodes_of_array(const sensor::DetectorArray& array, const BandNodes& per_band,
                        std::size_t number) {
  BandNodes own = per_band.everywhere;
  if (!per_band.by_array.empty()) own.by_array = {per_band.by_array.at(number)};
  return air_nodes({array}, own);
}

}  // namespace

std::vector<AirParts> wanted_of_air(const std::vector<sensor::DetectorArray>& arrays,
                                    const BandNodes& per_band,
                                    std::span<const radiometry::EffectSet> effects) {
  const AirLanes all = air_nodes(arrays, per_band);
  if (effects.empty()) return std::vector<AirParts>(all.wavelengths.size());
  using Node = std::pair<Micrometres, AbsorptionLane>;
  std::map<Node, AirParts> of_node;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const AirLanes own = nodes_of_array(arrays[i], per_band, i);
    const AirParts parts = radiometry::air_parts(effects[i]);
    for (std::size_t n = 0; n < own.wavelengths.size(); ++n) {
      const auto [at, first] = of_node.try_emplace({own.wavelengths[n], own.intervals[n]}, parts);
      if (!first) at->second = at->second | parts;
    }
  }
  std::vector<AirParts> wanted;
  for (std::size_t n = 0; n < all.wavelengths.size(); ++n) {
    wanted.push_back(of_node.at({all.wavelengths[n], all.intervals[n]}));
  }
  return wanted;
}

std::optional<RayBending> camera_bending(const World& world, ReportValues& report) {
  const std::optional<BendingShift> shift = bending_shift(world);
  if (!shift) return std::nullopt;
  report.emplace_back("refraction_shift_pixels", shift->pixels);
  const auto& decision =
      world.effects.decisions[radiometry::index_of(radiometry::Effect::refraction)];
  const bool bend = shift->noticeable() || decision.asked == EffectState::on;
  report.emplace_back("rays_bend", bend);
  if (!bend) return std::nullopt;
  return shift->bending;
}

ReportValues finish_air(World& world, const SamplingInput& sampling, Diagnostics& diagnostics,
                        const AirCacheOptions& cache,
                        std::span<const radiometry::EffectSet> effects) {
  if (!world.air) return {};
  if (!effects.empty() && std::none_of(effects.begin(), effects.end(), radiometry::needs_air)) {
    world.scene.atmosphere = atmosphere::None{};
    return {{"model", std::string{"none: no effect that is simulated needs the air"}}};
  }
  return at_element(world.air->where, [&] {
    const AirTask& task = *world.air;
    ReportValues values{{"model", std::string{"table"}}};
    std::shared_ptr<const AirTable> table;
    if (task.layered) {
      table = std::make_shared<const AirTable>(solve(*task.layered, world,
                                                     {sampling.wavelengths_per_band, effects},
                                                     cache, values, diagnostics));
    } else {
      table = std::get<atmosphere::Tabulated>(world.scene.atmosphere).table;
    }
    describe_table(*table, values);
    warn_of_error(*table, task.where, diagnostics);
    warn_of_bending(world, diagnostics);
    const CameraPlan plan = plan_camera(world.camera.arrays, sampling.wavelengths_per_band);
    auto ground =
        ground_light(world.scene, task.ground, ground_wavelengths(*table, plan), diagnostics);
    world.scene.atmosphere = atmosphere::Tabulated{std::move(table), std::move(ground)};
    return values;
  });
}

}  // namespace nadir::sim
