#include "sim/study/study_points.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace nadir::sim {
namespace {

using materials::SolverSettings;
using radiometry::Method;

// How much more time than a single sweep's row the rows get that everybody asks for.
constexpr double method_weight = 3.0;
constexpr double known_weight = 2.0;

/// Rows in their order; one that computes the same as an earlier one is left out.
class PointList {
 public:
  void add(StudyPoint point) {
    if (keys_.insert(key_of(point.settings)).second) points_.push_back(std::move(point));
  }
  [[nodiscard]] std::vector<StudyPoint> take() { return std::move(points_); }

 private:
  std::set<std::string> keys_;
  std::vector<StudyPoint> points_;
};

StudySettings generic_with(const StudySettings& base, const SolverSettings& solver) {
  StudySettings settings = base;
  settings.method = Method::generic;
  settings.path_max_bounces = 0;
  settings.generic = solver;
  return settings;
}

StudySettings path_with(const StudySettings& base, int bounces) {
  StudySettings settings = base;
  settings.method = Method::path;
  settings.path_max_bounces = bounces;
  return settings;
}

std::string counted_words(int count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void add_known_good(PointList& points, const StudyScope& scope) {
  const StudySettings& base = scope.scenario;
  const int thin = 1 + scope.lights;
  const auto add = [&](const char* name, const SolverSettings& solver) {
    points.add({name, "known good", generic_with(base, solver), known_weight});
  };
  add("open ground", {8, 2.0, 1, 2, 6, 1});
  add("glossy, streets", {4, 1.5, 5, 2, 6, 0});
  add("thermal", {2, 2.0, 1, 4, 8, 1});
  add("thin and deep", {thin, 1.0, 30, 2, 6, 0});
  add("thin and deep, fine quads", {thin, 1.0, 30, 5, 10, 0});
}

/// One setting of the generic solver varied at a time.
void add_sweeps(PointList& points, const StudySettings& base) {
  const auto vary = [&](const std::string& group, const std::string& name, auto change) {
    SolverSettings solver = base.generic;
    change(solver);
    points.add({name, group, generic_with(base, solver)});
  };
  for (const int bounces : {1, 2, 5, 0, 8}) {
    vary("bounces", counted_words(bounces, "bounce"), [&](auto& s) { s.max_bounces = bounces; });
  }
  vary("top-up", "top-up 0", [](auto& s) { s.min_quad_samples = 0; });
  vary("top-up", "top-up 2", [](auto& s) { s.min_quad_samples = 2; });
  for (const int samples : {4, 16, 2, 1, 32}) {
    vary("samples", counted_words(samples, "sample"),
         [&](auto& s) { s.initial_sample_count = samples; });
  }
  for (const auto& [mu, phi] : {std::pair{1, 1}, {4, 8}, {1, 4}, {6, 12}}) {
    const std::string name = std::to_string(mu) + " x " + std::to_string(phi) + " quads";
    const std::pair quads{mu, phi};
    vary("quads", name, [&](auto& s) {
      s.mu_samples = quads.first;
      s.phi_samples = quads.second;
    });
  }
  for (const int decay : {4, 1, 8}) {
    vary("decay", "decay " + std::to_string(decay), [&](auto& s) { s.sample_decay_rate = decay; });
  }
}

/// All numbers of nodes times a factor, at least 1.
BandNodes scaled_nodes(const BandNodes& nodes, double factor) {
  const auto scale = [&](int count) {
    return std::max(1, static_cast<int>(std::lround(factor * count)));
  };
  BandNodes result{scale(nodes.everywhere)};
  result.by_array = nodes.by_array;
  for (auto& array : result.by_array) {
    for (int& count : array) count = scale(count);
  }
  return result;
}

void add_paired(PointList& points, const StudyScope& scope) {
  const StudySettings base = path_with(scope.scenario, 0);
  StudySettings twice = base, half = base;
  twice.wavelengths = scaled_nodes(base.wavelengths, 2.0);
  half.wavelengths = scaled_nodes(base.wavelengths, 0.5);
  points.add({"twice the wavelengths", "wavelengths", twice, 1.0, true});
  points.add({"half the wavelengths", "wavelengths", half, 1.0, true});
  if (!scope.layered_air) return;
  const auto streams = [&](const char* name, int count) {
    StudySettings settings = base;
    settings.air_streams = count;
    points.add({name, "air", settings, 1.0, true});
  };
  if (scope.streams != 2) streams("air of two streams", 2);
  if (scope.streams == 2) streams("air of 8 streams", 8);
  if (scope.streams > 2) streams("air of twice the streams", 2 * scope.streams);
}

}  // namespace

StudySettings reference_settings(const StudySettings& scenario) { return path_with(scenario, 0); }

std::vector<StudyPoint> study_points(const StudyScope& scope) {
  const StudySettings& base = scope.scenario;
  PointList points;
  // The path solver first, under its own name also where it is the scenario's: paired rows need it.
  points.add({"path solver", "method", path_with(base, 0), method_weight});
  points.add({"scenario", "method", base, method_weight});
  points.add({"generic default", "method", generic_with(base, {}), method_weight});
  add_known_good(points, scope);
  for (const int bounces : {8, 4, 2}) {
    const std::string name = "path, " + counted_words(bounces, "bounce");
    points.add({name, "path bounces", path_with(base, bounces)});
  }
  add_paired(points, scope);
  add_sweeps(points, base);
  return points.take();
}

}  // namespace nadir::sim
