#include "sim/study/picture_plan.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::sim {
namespace {

constexpr double most_shown = 40'000.0;    // pixels: more the page would only make heavier
constexpr double wanted_shown = 10'000.0;  // rather fewer paths than fewer pixels than that
constexpr double least_shown = 400.0;
constexpr double preferred_target = 0.01;
constexpr int few_paths = 4;  // a replicate
constexpr int best_replicates = 8;
constexpr int most_reference_samples = 1024;
// Of the pictures' time; one path and a few cost next to nothing beside these.
constexpr double recommended_share = 0.25, reference_share_of_pictures = 0.4;

const RowFigures* row_named(const StudyResult& result, const std::string& name) {
  for (const RowFigures& row : result.rows) {
    if (row.point.name == name) return &row;
  }
  return nullptr;
}

/// The recommendation nearest to 1 % that was reached.
const Recommendation* preferred(const StudyResult& result) {
  const Recommendation* best = nullptr;
  for (const Recommendation& advice : result.recommendations) {
    if (!advice.reached) continue;
    const auto distance = [](const Recommendation& a) {
      return std::abs(std::log(a.target / preferred_target));
    };
    if (best == nullptr || distance(advice) < distance(*best)) best = &advice;
  }
  return best;
}

PictureShot shot_of(const std::string& label, const RowFigures& row) {
  return {label, row.point.settings, 1, 1, row.path_wall_s, row.setup_s};
}

/// The least step by which a picture has no more than so many pixels.
int step_for(const ImageSize& image, double most) {
  int step = 1;
  const auto shown = [&] {
    return std::ceil(static_cast<double>(image.samples) / step) *
           std::ceil(static_cast<double>(image.lines) / step);
  };
  while (shown() > most) ++step;
  return step;
}

double pixels_shown(const ImageSize& image, int step) {
  return std::ceil(static_cast<double>(image.samples) / step) *
         std::ceil(static_cast<double>(image.lines) / step);
}

/// Samples of a replicate that so much time allows.
int affordable(const PictureShot& shot, double pixels, double seconds, int replicates) {
  const double paths = (seconds - shot.setup_s) / (pixels * shot.path_wall_s);
  return std::max(1, static_cast<int>(std::min(1e6, paths / replicates)));
}

}  // namespace

PicturePlan plan_pictures(const StudyResult& result, const StudyHeader& header,
                          const ImageSize& image, double seconds) {
  PicturePlan plan;
  const RowFigures* path = row_named(result, "path solver");
  if (path == nullptr || !(seconds > 0.0)) return plan;
  const Recommendation* advice = preferred(result);
  const RowFigures* best = advice != nullptr ? row_named(result, advice->row) : path;
  plan.shots = {shot_of("One path", *best), shot_of("A few paths", *best),
                shot_of("Recommended", *best), shot_of("Near the reference", *path)};
  plan.shots[1].replicates = header.replicates;
  plan.shots[1].samples = few_paths;
  PictureShot &wanted = plan.shots[2], &reference = plan.shots[3];
  wanted.replicates = header.replicates;
  wanted.samples = advice != nullptr ? advice->samples : 4 * few_paths;
  reference.replicates = best_replicates;
  // As many pixels as the recommended number of paths allows, but a picture rather than a stamp.
  const double by_paths =
      (recommended_share * seconds - wanted.setup_s) / (wanted.path_wall_s * wanted.paths());
  double most = std::clamp(by_paths, wanted_shown, most_shown);
  const double by_few = 0.1 * seconds / (wanted.path_wall_s * plan.shots[1].paths());
  most = std::min(most, by_few);
  plan.affordable = most >= std::min(least_shown, static_cast<double>(image.pixels()));
  if (!plan.affordable) return plan;
  plan.step = step_for(image, most);
  const double pixels = pixels_shown(image, plan.step);
  const int most_wanted =
      affordable(wanted, pixels, recommended_share * seconds, wanted.replicates);
  if (advice == nullptr || wanted.samples > most_wanted) {
    wanted.samples = std::min(wanted.samples, most_wanted);
    wanted.label = "As many as there was time for";
  } else {
    wanted.label = "Recommended for " +
                   std::to_string(static_cast<int>(std::lround(100.0 * advice->target))) + " %";
    if (advice->target < preferred_target) wanted.label = "Recommended for 0.5 %";
  }
  reference.samples = std::min(
      most_reference_samples,
      affordable(reference, pixels, reference_share_of_pictures * seconds, reference.replicates));
  return plan;
}

}  // namespace nadir::sim
