#include <fmt/format.h>

#include <algorithm>

#include "radiometry/effect.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/run_key.hpp"
#include "sim/scenario/source_text.hpp"

namespace nadir::sim {
namespace {

void add_version_and_files(const PreparedRun& run, std::vector<KeyPart>& parts) {
  const auto text = read_source_text(run.scenario.file);
  parts.emplace_back("version of nadir", NADIR_VERSION);
  parts.emplace_back("scenario", scenario_digest(std::string{text.text()}));
  std::vector<KeyPart> files;
  for (const FileRecord& file : run.inputs) {
    if (file.path == run.scenario.file) continue;
    files.emplace_back(fmt::format("file \"{}\"", file.path.filename().string()), file.sha256);
  }
  std::sort(files.begin(), files.end());  // by name: folders may lie elsewhere
  parts.insert(parts.end(), files.begin(), files.end());
}

/// The detectors' noise is made after the samples.
std::string simulated_effects(const radiometry::EffectSet& effects) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < radiometry::effect_count; ++i) {
    const auto effect = static_cast<radiometry::Effect>(i);
    if (effect != radiometry::Effect::detector_noise && effects.has(effect)) {
      names.push_back(radiometry::name_of(effect));
    }
  }
  return fmt::format("{}", fmt::join(names, " "));
}

void add_arrays(const PreparedRun& run, std::vector<KeyPart>& parts) {
  const auto& arrays = run.world.camera.arrays;
  const auto& effects = run.world.effects.by_array;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    if (i < effects.size()) {
      parts.emplace_back(fmt::format("effects of array \"{}\"", arrays[i].name),
                         simulated_effects(effects[i]));
    }
    std::vector<int> nodes;
    for (std::size_t band = 0; band < arrays[i].bands.size(); ++band) {
      nodes.push_back(run.sampling.wavelengths_per_band.of(i, band));
    }
    parts.emplace_back(fmt::format("wavelengths of array \"{}\"", arrays[i].name),
                       fmt::format("{}", fmt::join(nodes, " ")));
  }
}

void add_solver(const PreparedRun& run, bool chosen, std::vector<KeyPart>& parts) {
  const radiometry::SceneDescription& scene = run.world.scene;
  const materials::SolverSettings& s = scene.solver;
  const bool path = scene.method == radiometry::Method::path;
  parts.emplace_back(
      "solver",
      path ? fmt::format("path {}", scene.path_max_bounces)
           : fmt::format("generic {} {} {} {} {} {}", s.initial_sample_count, s.sample_decay_rate,
                         s.max_bounces, s.mu_samples, s.phi_samples, s.min_quad_samples));
  parts.emplace_back("solver settings of materials", chosen ? "set aside" : "as stated");
}

/// What tiles hold beside radiance.
std::string planes_of(const ProductsInput& wanted) {
  return fmt::format("truth {:d} temperature {:d} sky {:d} fractions {:d} shares {:d}",
                     wanted.truth, wanted.truth_temperature, wanted.sky_view, wanted.fractions,
                     wanted.statistics);
}

std::vector<KeyPart> sampling_parts(const PreparedRun& run, const RunRequest& request) {
  if (!run.goal) {
    return {{"samples",
             fmt::format("{} x {}", run.sampling.replicates, run.sampling.samples_per_replicate)}};
  }
  const SamplingGoal& goal = *run.goal;
  std::vector<KeyPart> parts{{"samples", fmt::format("{} x {} to {}", goal.replicates,
                                                     goal.first_samples, goal.most_samples)}};
  if (request.accuracy) parts.emplace_back("accuracy", fmt::format("{}", *request.accuracy));
  // Rounds do not depend on how much time there is for them, only their number.
  if (request.time_s) parts.emplace_back("time", "limited");
  for (const auto& array : goal.bands) {
    for (const BandGoal& band : array) {
      parts.emplace_back("goal of a band",
                         fmt::format("{} of {}", band.relative, band.floor_radiance));
    }
  }
  return parts;
}

}  // namespace

RunKey run_key(const PreparedRun& run, const RunRequest& request) {
  RunKey key;
  add_version_and_files(run, key.physics);
  add_arrays(run, key.physics);
  add_solver(run, request.has_goal(), key.physics);
  key.physics.emplace_back("planes", planes_of(run.scenario.products));
  key.sampling = sampling_parts(run, request);
  key.seed = request.seed;
  key.scenario = std::filesystem::absolute(run.scenario.file);
  key.accuracy = request.accuracy;
  key.time_s = request.time_s;
  return key;
}

}  // namespace nadir::sim
