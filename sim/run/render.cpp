#include "sim/run/render.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/run/array_job.hpp"
#include "sim/run/strip_renderer.hpp"
#include "sim/run/strips.hpp"
#include "sim/run/time_rounds.hpp"

namespace nadir::sim {
namespace {

/// All that is rendered, strip by strip, and what part of it is still to come.
class WorkLeft {
 public:
  explicit WorkLeft(const Camera& camera) {
    for (const auto& array : camera.arrays) pixels_ += pixels_of(array.samples, array.lines);
  }
  /// When a strip is to be done: it has the share of the time left that it has of the pixels left.
  TimeGoal::Clock::time_point end_of(const TimeGoal& goal, int samples, int lines) {
    const auto now = goal.now ? goal.now() : TimeGoal::Clock::now();
    const double share = pixels_of(samples, lines) / std::max(pixels_, 1.0);
    pixels_ -= pixels_of(samples, lines);
    return now + std::chrono::duration_cast<TimeGoal::Clock::duration>(share * (goal.end - now));
  }

 private:
  static double pixels_of(int samples, int lines) { return static_cast<double>(samples) * lines; }
  double pixels_ = 0.0;
};

std::size_t count_tiles(const Camera& camera, const RenderOptions& options) {
  std::size_t tiles = 0;
  for (const sensor::DetectorArray& array : camera.arrays) {
    for (const Strip& strip : cut_into_strips(array.samples, array.lines, tile_edge)) {
      tiles += tiles_of(array, strip).size();
    }
  }
  return tiles * std::max(1U, options.rounds.end);
}

}  // namespace

RenderTally render_strips(const radiometry::SceneDescription& scene, const Camera& camera,
                          const RenderOptions& options, Diagnostics& diagnostics,
                          const StripSink& sink) {
  const CameraPlan plan = plan_of(camera, options);
  RenderProgress progress;
  progress.all = count_tiles(camera, options);
  WorkLeft left{camera};
  RenderTally tally;
  tally.rounds = std::max(1U, options.rounds.end);
  for (std::size_t i = 0; i < camera.arrays.size(); ++i) {
    const ArrayJob job = array_job(scene, camera, i, plan.arrays[i], options, diagnostics);
    const sensor::DetectorArray& array = camera.arrays[i];
    std::optional<GoalTally> goal;
    if (options.goal != nullptr) goal.emplace(options.goal->bands[i]);
    for (const Strip& part : cut_into_strips(array.samples, array.lines, tile_edge)) {
      StripRenderer strip{job, part, options, progress};
      ArrayImage image =
          options.time != nullptr
              ? render_until(strip, job, options,
                             left.end_of(*options.time, array.samples, part.lines), tally.rounds)
              : strip.render();
      if (goal) goal->take(image);
      sink(i, std::move(image));
    }
    if (goal) tally.outcome.arrays.push_back(goal->outcome());
  }
  tally.counters = progress.counters;
  return tally;
}

RenderResult render(const radiometry::SceneDescription& scene, const Camera& camera,
                    const RenderOptions& options, Diagnostics& diagnostics) {
  RenderResult result;
  RenderTally tally = render_strips(scene, camera, options, diagnostics,
                                    [&](std::size_t array, ArrayImage&& strip) {
                                      if (array == result.images.size()) {
                                        result.images.push_back(std::move(strip));
                                      } else {
                                        append(result.images[array], strip);
                                      }
                                    });
  for (ArrayImage& image : result.images) image.all_lines = 0;
  result.counters = tally.counters;
  result.outcome = std::move(tally.outcome);
  return result;
}

}  // namespace nadir::sim
