#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/random.hpp"
#include "core/statistics.hpp"
#include "sim/study/conduct.hpp"

namespace nadir::sim::support {

/// A scene that costs nothing: pixel i of a band has a known radiance, every row a known bias and
/// noise, and a clock that moves only while it is sampled.
struct SyntheticScene {
  double clock_s = 0.0;     ///< seconds since the study began
  double path_s = 1e-6;     ///< of the path solver; the generic takes ten times as long
  double rate = 0.5;        ///< noise falls by samples^-rate
  double path_noise = 0.5;  ///< of one path, relative
  double generic_noise = 0.1;
  double bounce_bias = 0.03;  ///< lost by each bounce fewer than four of the generic solver
  int calls = 0;
  int die_after = -1;  ///< throws on this call, as a kill would

  struct Killed {};

  [[nodiscard]] static double radiance(std::size_t pixel) {
    return 50.0 + 10.0 * static_cast<double>(pixel % 7);
  }

  [[nodiscard]] double bias(const StudySettings& settings) const {
    if (settings.method == radiometry::Method::path) return 0.0;
    return -bounce_bias * std::max(0, 4 - settings.generic.max_bounces);
  }
  [[nodiscard]] double cost_s(const StudySettings& settings) const {
    return settings.method == radiometry::Method::path ? path_s : 10.0 * path_s;
  }

  /// Normal deviate. Source: Box and Muller, Ann. Math. Stat. 29, 610 (1958).
  [[nodiscard]] static double normal(Rng& random) {
    constexpr double two_pi = 6.283185307179586;
    const double radius = std::sqrt(-2.0 * std::log(1.0 - random.next()));
    return radius * std::cos(two_pi * random.next());
  }

  StudySample sample(const StudyHeader& header, const StudySettings& settings,
                     const SamplingRequest& request) {
    if (calls++ == die_after) throw Killed{};
    const bool path = settings.method == radiometry::Method::path;
    const double sigma = (path ? path_noise : generic_noise) * std::pow(request.samples, -rate);
    StudySample made;
    made.request = request;
    const int all = header.pixels_of_array.at(0);
    const int pixels = request.pixels > 0 ? std::min(request.pixels, all) : all;
    for (std::size_t b = 0; b < header.bands.size(); ++b) {
      Rng random{request.seed, b};
      made.mean.emplace_back();
      made.variance.emplace_back();
      for (std::size_t i = 0; i < static_cast<std::size_t>(pixels); ++i) {
        Welford replicates;
        for (int r = 0; r < request.replicates; ++r) {
          replicates.add(radiance(i) * (1.0 + bias(settings) + sigma * normal(random)));
        }
        made.mean.back().push_back(replicates.mean());
        made.variance.back().push_back(replicates.variance());
      }
    }
    const double paths = made.paths() * pixels;
    clock_s += paths * cost_s(settings);
    made.cost.path_cpu_s = made.cost.path_wall_s = cost_s(settings);
    made.cost.picture_cpu_s = cost_s(settings) * static_cast<double>(header.image_pixels.at(0));
    made.cost.rays_per_path = path ? 3.0 : 30.0;
    made.cost.wall_s = paths * cost_s(settings);
    return made;
  }
};

inline StudyHeader synthetic_header(int pixels = 64, int bands = 2) {
  StudyHeader header;
  header.version = "1";
  header.scenario = "made up.xml";
  header.title = "Made up, <b> & \"quoted\"";
  header.time_utc = "2026-06-21T16:00:00Z";
  header.inputs = {{"made up.xml", "00"}};
  for (int b = 0; b < bands; ++b) {
    header.bands.push_back(
        {"array", "band " + std::to_string(b), 0, static_cast<std::size_t>(b), 0.5 + 0.1 * b, 0.0});
  }
  header.pixels_of_array = {pixels};
  header.image_pixels = {10000};
  header.reference_samples = 16;
  header.scope.scenario.method = radiometry::Method::generic;
  return header;
}

/// Conducts a study of the scene; what there is of it in the journal is not measured again.
inline void conduct_synthetic(SyntheticScene& scene, StudyJournal& journal, double budget_s) {
  const StudyHeader header = journal.record().header;
  StudyConduct conduct;
  conduct.probe = [&](const StudySettings& settings, const SamplingRequest& request) {
    return scene.sample(header, settings, request);
  };
  conduct.time = [&] { return scene.clock_s; };
  conduct.schedule = schedule_of(0.0, budget_s);
  conduct.run(journal);
}

}  // namespace nadir::sim::support
