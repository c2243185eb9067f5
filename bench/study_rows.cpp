#include "study_rows.hpp"

#include <utility>

namespace nadir::bench {

using materials::SolverSettings;

std::vector<StudyRow> study_rows(int lights) {
  std::vector<StudyRow> all;
  const auto add = [&](const std::string& label, auto change) {
    StudyRow row{label, {}};
    change(row.settings);
    all.push_back(std::move(row));
  };
  add("default: 8 samples, decay 2, 3 bounces, 2 x 6 quads, top-up 1", [](SolverSettings&) {});
  for (const int n : {1, 2, 4, 16, 32}) {
    add(std::to_string(n) + (n == 1 ? " sample" : " samples"),
        [n](SolverSettings& s) { s.initial_sample_count = n; });
  }
  for (const int n : {1, 4, 8}) {
    add("decay " + std::to_string(n), [n](SolverSettings& s) { s.sample_decay_rate = n; });
  }
  for (const int n : {0, 1, 2, 5, 8}) {
    add(std::to_string(n) + (n == 1 ? " bounce" : " bounces"),
        [n](SolverSettings& s) { s.max_bounces = n; });
  }
  for (const auto& [mu, phi] : {std::pair{1, 1}, {1, 4}, {4, 8}, {6, 12}}) {
    add(std::to_string(mu) + " x " + std::to_string(phi) + " quads",
        [m = mu, p = phi](SolverSettings& s) { s.mu_samples = m, s.phi_samples = p; });
  }
  for (const int n : {0, 2}) {
    add("top-up " + std::to_string(n), [n](SolverSettings& s) { s.min_quad_samples = n; });
  }
  // What is left of the budget when the lights have had theirs: one ray, which goes on and on.
  const SolverSettings thin{.initial_sample_count = lights + 1,
                            .sample_decay_rate = 1.0,
                            .max_bounces = 30,
                            .min_quad_samples = 0};
  add("thin and deep: 1 + lights samples, decay 1, 30 bounces, top-up 0",
      [&](SolverSettings& s) { s = thin; });
  add("the same with top-up 1", [&](SolverSettings& s) {
    s = thin;
    s.min_quad_samples = 1;
  });
  // Found good for one scene or other.
  add("thin and deep with 5 x 10 quads", [&](SolverSettings& s) {
    s = thin;
    s.mu_samples = 5, s.phi_samples = 10;
  });
  add("4 samples, decay 1.5, 5 bounces, top-up 0", [](SolverSettings& s) {
    s = {.initial_sample_count = 4, .sample_decay_rate = 1.5, .max_bounces = 5};
    s.min_quad_samples = 0;
  });
  add("2 samples, 1 bounce, 4 x 8 quads", [](SolverSettings& s) {
    s = {.initial_sample_count = 2, .max_bounces = 1, .mu_samples = 4, .phi_samples = 8};
  });
  return all;
}

}  // namespace nadir::bench
