// What do the generic solver's settings cost and buy? Bias and noise, apart from each other,
// against the path solver. docs/solver-settings.md says how to read the rows and shows a run.

#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/statistics.hpp"
#include "radiometry/generic_solver.hpp"
#include "radiometry/path_solver.hpp"
#include "study_rows.hpp"
#include "study_scenes.hpp"

namespace nadir::bench {
namespace {

using radiometry::GenericSolver;
using radiometry::LitScene;
using radiometry::PathSolver;
using spectral::Spectrum;

/// How much is computed. The reference has 64 times the paths of a row, or more: expensive rows end
/// after `rays_per_row` rays, whatever the clock says, so that runs repeat bit by bit.
struct Effort {
  int paths_per_round = 2;  ///< and view: a round times both solvers in turn
  int rounds = 512;
  int reference_factor = 64;
  double rays_per_row = 2.5e6;
};
constexpr Effort quick_effort{2, 2, 8, 2e5};
constexpr int fewest_rounds = 2;
constexpr double significant = 3.0;  // standard errors; one of 370 rows without bias exceeds it

// ---- measuring --------------------------------------------------------------------------------

/// Processor time of this thread, s: what other programs take does not count.
double thread_time_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Radiances of independent paths of every view.
class Tally {
 public:
  Tally(const StudyScene& scene, const std::vector<double>& lane_weights)
      : scene_{&scene}, weights_{lane_weights}, lanes_(scene.views.size() * lane_count()) {
    groups_.resize(scene.views.size() * scene.groups.size());
  }

  void add(std::size_t view, const Spectrum& radiance) {
    const std::size_t first = view * lane_count();
    for (std::size_t lane = 0; lane < lane_count(); ++lane) {
      lanes_[first + lane].add(weights_[lane] *
                               static_cast<double>(radiance[static_cast<int>(lane)]));
    }
    for (std::size_t g = 0; g < scene_->groups.size(); ++g) {
      const LaneGroup& group = scene_->groups[g];
      double sum = 0.0;
      for (int lane = group.first; lane < group.first + group.count; ++lane) {
        sum += weights_[static_cast<std::size_t>(lane)] * static_cast<double>(radiance[lane]);
      }
      groups_[view * scene_->groups.size() + g].add(sum / group.count);
    }
  }
  /// Means over the views. Lanes of one path err together: only the path's own mean over a group
  /// tells the standard error of that.
  [[nodiscard]] Estimate lane(int l) const {
    return mean(lanes_, static_cast<std::size_t>(l), lane_count());
  }
  [[nodiscard]] Estimate group(std::size_t g) const {
    return mean(groups_, g, scene_->groups.size());
  }
  /// Mean over the views of the variance of one path.
  [[nodiscard]] double variance(int l) const {
    double sum = 0.0;
    for (std::size_t i = static_cast<std::size_t>(l); i < lanes_.size(); i += lane_count()) {
      sum += lanes_[i].variance();
    }
    return sum / static_cast<double>(scene_->views.size());
  }

 private:
  [[nodiscard]] std::size_t lane_count() const {
    return static_cast<std::size_t>(scene_->lanes.count());
  }
  /// The views are fixed: how they differ among each other is no error.
  static Estimate mean(const std::vector<Welford>& all, std::size_t first, std::size_t step) {
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = first; i < all.size(); i += step) {
      const Estimate one = all[i].estimate();
      sum += one.mean;
      squares += one.standard_error * one.standard_error;
    }
    const std::size_t views = all.size() / step;
    const auto count = static_cast<double>(views);
    return {sum / count, std::sqrt(squares) / count};
  }

  const StudyScene* scene_;
  std::vector<double> weights_;  // by lane
  std::vector<Welford> lanes_, groups_;
};

/// One solver at work on all views; what it took.
template <class Solver>
class Course {
 public:
  Course(const LitScene& lit, const StudyScene& scene, std::uint64_t seed)
      : solver_{lit}, scene_{&scene}, seed_{seed} {
    for (const geometry::Ray& ray : scene.views) {
      hits_.push_back(lit.intersect(ray, Sampler{seed, 0}));
    }
  }
  /// So many more paths of each view. A path's numbers depend on nothing but its own number.
  void go(int paths, Tally* tally) {
    std::vector<Spectrum> radiance(static_cast<std::size_t>(paths));
    for (std::size_t view = 0; view < hits_.size(); ++view) {
      const double start = thread_time_s();
      for (int i = 0; i < paths; ++i) {
        const std::uint64_t key = mix(mix(seed_, view), done_ + static_cast<std::uint64_t>(i));
        radiance[static_cast<std::size_t>(i)] =
            solver_.aperture_radiance(scene_->views[view], hits_[view], Sampler{key, 0});
      }
      taken_s_ += thread_time_s() - start;
      if (tally == nullptr) continue;
      for (const Spectrum& one : radiance) tally->add(view, one);
    }
    done_ += static_cast<std::uint64_t>(paths);
  }
  [[nodiscard]] double taken_s() const { return taken_s_; }
  [[nodiscard]] double rays() const { return static_cast<double>(solver_.counters().rays()); }
  [[nodiscard]] double paths() const {
    return static_cast<double>(done_) * static_cast<double>(hits_.size());
  }
  [[nodiscard]] double us_per_path() const { return 1e6 * taken_s_ / paths(); }

 private:
  Solver solver_;
  const StudyScene* scene_;
  std::uint64_t seed_;
  std::vector<std::optional<geometry::Hit>> hits_;
  std::uint64_t done_ = 0;
  double taken_s_ = 0.0;
};

struct Result {
  std::string label;
  Tally tally;
  double rays = 0.0;     ///< per path
  double us = 0.0;       ///< per path
  double path_us = 0.0;  ///< of the path solver, in between
};

Result measure_row(const StudyRow& row, const StudyScene& scene, const std::vector<double>& weights,
                   const Effort& effort, std::uint64_t seed) {
  radiometry::SceneDescription description = scene.description;
  description.solver = row.settings;
  Diagnostics diagnostics;
  const LitScene lit{description, scene.lanes, diagnostics};
  Result result{row.label, Tally{scene, weights}};
  Course<GenericSolver> generic{lit, scene, seed};
  Course<PathSolver> path{lit, scene, seed};
  for (int round = 0; round < effort.rounds; ++round) {
    if (round >= fewest_rounds && generic.rays() > effort.rays_per_row) break;
    generic.go(effort.paths_per_round, &result.tally);
    if (path.taken_s() < 0.25 * generic.taken_s()) path.go(effort.paths_per_round, nullptr);
  }
  result.rays = generic.rays() / generic.paths();
  result.us = generic.us_per_path();
  result.path_us = path.us_per_path();
  return result;
}

/// 1 / radiance of each lane, mean over the views, so that lanes of a group count alike. A rough
/// value will do, as long as all tallies take the same.
std::vector<double> lane_weights(const StudyScene& scene, const LitScene& lit) {
  constexpr int paths = 64;
  Tally tally{scene, std::vector<double>(static_cast<std::size_t>(scene.lanes.count()), 1.0)};
  Course<PathSolver>{lit, scene, 7}.go(paths, &tally);
  std::vector<double> weights;
  for (int lane = 0; lane < scene.lanes.count(); ++lane) {
    weights.push_back(1.0 / tally.lane(lane).mean);
  }
  return weights;
}

Result measure_reference(const StudyScene& scene, const LitScene& lit,
                         const std::vector<double>& weights, const Effort& effort) {
  Result result{"path solver", Tally{scene, weights}};
  Course<PathSolver> path{lit, scene, 1};
  for (int i = 0; i < effort.reference_factor * effort.rounds; ++i) {
    path.go(effort.paths_per_round, &result.tally);
  }
  result.rays = path.rays() / path.paths();
  result.us = result.path_us = path.us_per_path();
  return result;
}

// ---- printing ---------------------------------------------------------------------------------

template <class... Values>
std::string text(const char* format, Values... values) {
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

/// (a - b) / b in per cent.
Estimate relative_percent(const Estimate& a, const Estimate& b) {
  const double scale = 100.0 / b.mean;
  return {(a.mean - b.mean) * scale, std::hypot(a.standard_error, b.standard_error) * scale};
}

std::string shown(const Estimate& bias) {
  const bool real = std::abs(bias.mean) > significant * bias.standard_error;
  const int digits = bias.standard_error < 0.01 ? 3 : 2;
  return text(real ? "**%+.*f** ± %.*f" : "%+.*f ± %.*f", digits, bias.mean, digits,
              bias.standard_error);
}

double noise_percent(const Tally& tally, const Tally& reference, const LaneGroup& group) {
  double sum = 0.0;
  for (int lane = group.first; lane < group.first + group.count; ++lane) {
    const double mean = reference.lane(lane).mean;
    sum += tally.variance(lane) / (mean * mean);
  }
  return 100.0 * std::sqrt(sum / group.count);
}

std::string worst_lane(const StudyScene& scene, const LaneGroup& group, const Tally& tally,
                       const Tally& reference) {
  Estimate worst{0.0, 0.0};
  int at = group.first;
  for (int lane = group.first; lane < group.first + group.count; ++lane) {
    const Estimate bias = relative_percent(tally.lane(lane), reference.lane(lane));
    if (std::abs(bias.mean) < std::abs(worst.mean)) continue;
    worst = bias;
    at = lane;
  }
  return shown(worst) + text(" at %.2f", scene.lanes[at].value);
}

/// @param with_us  print microseconds as well, which belong to the machine
void print_group(std::ostream& out, const StudyScene& scene, std::size_t number,
                 const std::vector<Result>& results, bool with_us) {
  const LaneGroup& group = scene.groups[number];
  const Result& reference = results.front();
  const double path_noise = noise_percent(reference.tally, reference.tally, group);
  const Estimate truth = reference.tally.group(number);
  if (!group.name.empty()) out << group.name << "\n\n";
  out << "| settings | bias, % | bias of the worst lane, % (um) | noise of one path, % | rays per "
         "path | time | efficiency |"
      << (with_us ? " us per path |" : "") << "\n|---|---|---|---|---|---|---|"
      << (with_us ? "---|" : "") << "\n";
  for (const Result& r : results) {
    const bool is_reference = &r == &reference;
    const double noise = noise_percent(r.tally, reference.tally, group);
    const double time = r.us / r.path_us;
    const double gain = path_noise * path_noise / (noise * noise * time);
    out << "| " << r.label << " | "
        << (is_reference ? text("± %.3f", 100.0 * truth.standard_error / truth.mean)
                         : shown(relative_percent(r.tally.group(number), truth)))
        << " | " << (is_reference ? "" : worst_lane(scene, group, r.tally, reference.tally))
        << text(" | %.2f | %.1f | %.2f | %.3g |", noise, r.rays, time, gain)
        << (with_us ? text(" %.2f |", r.us) : "") << "\n";
  }
  out << "\n";
}

void print_scene(std::ostream& out, const StudyScene& scene, const std::vector<Result>& results,
                 bool with_us) {
  out << "### " << scene.title << "\n\n";
  for (std::size_t group = 0; group < scene.groups.size(); ++group) {
    print_group(out, scene, group, results, with_us);
  }
  out << std::flush;
}

// ---- the program ------------------------------------------------------------------------------

struct Options {
  Effort effort;
  std::vector<std::string> scenes = study_scene_names();
  std::string markdown;
};

Options read_options(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& name = arguments[i];
    if (name == "--quick") {
      options.effort = quick_effort;
      continue;
    }
    if (name != "--scene" && name != "--markdown") {
      throw InputError{"unknown argument \"" + name +
                       "\"; there are --quick, --scene NAME, --markdown FILE"};
    }
    if (++i == arguments.size()) throw InputError{name + " lacks its value"};
    if (name == "--scene") options.scenes = {arguments[i]};
    if (name == "--markdown") options.markdown = arguments[i];
  }
  return options;
}

std::vector<Result> study(const StudyScene& scene, const Effort& effort) {
  Diagnostics diagnostics;
  const LitScene lit{scene.description, scene.lanes, diagnostics};
  const std::vector<double> weights = lane_weights(scene, lit);
  std::vector<Result> results{measure_reference(scene, lit, weights, effort)};
  const int lights = static_cast<int>(lit.targets().size()) + (lit.lamps().empty() ? 0 : 1);
  std::uint64_t seed = 1000;
  for (const StudyRow& row : study_rows(lights)) {
    std::cerr << scene.name << ": " << row.label << "\n";
    results.push_back(measure_row(row, scene, weights, effort, seed++));
  }
  return results;
}

void run(const Options& options) {
  std::ofstream file;
  if (!options.markdown.empty()) {
    file.open(options.markdown);
    if (!file) throw InputError{"cannot write " + options.markdown};
  }
  for (const std::string& name : options.scenes) {
    const StudyScene scene = study_scene(name);
    const std::vector<Result> results = study(scene, options.effort);
    print_scene(std::cout, scene, results, true);
    if (file.is_open()) print_scene(file, scene, results, false);
  }
}

}  // namespace
}  // namespace nadir::bench

int main(int argc, char** argv) {
  try {
    nadir::bench::run(nadir::bench::read_options({argv + 1, argv + argc}));
    return 0;
  } catch (const std::exception& error) {  // an InputError says itself that it is one
    std::cerr << error.what() << "\n";
    return 1;
  }
}
