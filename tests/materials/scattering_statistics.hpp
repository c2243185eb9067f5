#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "materials/scattering.hpp"
#include "support/quadrature.hpp"
#include "support/statistics.hpp"

namespace nadir::support {

/// How well drawn directions follow the density that their model states.
struct SamplingFit {
  double chi_square_p = 0.0;   ///< Pearson's test of the counts in 20 x 40 cells of mu and phi
  double mean_cosine_p = 0.0;  ///< two-sided z-test of the mean cosine
  int below_horizon = 0;       ///< directions drawn below the surface
};

/// Cells of equal solid angle: 20 in the cosine, 40 in azimuth.
struct HemisphereCells {
  static constexpr int mu_count = 20, phi_count = 40;
  static constexpr std::size_t count = mu_count * phi_count;

  [[nodiscard]] static std::size_t index(Vec3 v) {
    const double turn = std::atan2(v.y, v.x) / (2.0 * std::numbers::pi);
    const int row = std::clamp(static_cast<int>(v.z * mu_count), 0, mu_count - 1);
    const int column = static_cast<int>((turn < 0.0 ? turn + 1.0 : turn) * phi_count);
    return static_cast<std::size_t>(row * phi_count + std::min(column, phi_count - 1));
  }
};

/// The model's density, summed into cells, with its moments of the cosine.
struct ExpectedCounts {
  std::vector<double> cells = std::vector<double>(HemisphereCells::count, 0.0);
  double mean = 0.0, mean_square = 0.0;
};

[[nodiscard]] inline ExpectedCounts expected_counts(const materials::Scattering& model, Vec3 wo,
                                                    int draws) {
  constexpr int fine = 5;  // density points per cell and axis
  constexpr int rows = HemisphereCells::mu_count * fine,
                columns = HemisphereCells::phi_count * fine;
  ExpectedCounts expected;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const Vec3 wi = direction((i + 0.5) / rows, 2.0 * std::numbers::pi * (j + 0.5) / columns);
      const double share =
          materials::pdf(model, wi, wo) * 2.0 * std::numbers::pi / (rows * columns);
      expected.cells[HemisphereCells::index(wi)] += share * draws;
      expected.mean += share * wi.z;
      expected.mean_square += share * wi.z * wi.z;
    }
  }
  return expected;
}

[[nodiscard]] inline SamplingFit fit_samples(const materials::Scattering& model, Vec3 wo, int draws,
                                             Rng& rng) {
  SamplingFit fit;
  std::vector<double> drawn(HemisphereCells::count, 0.0);
  double sum = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double u = rng.next(), v = rng.next();
    const auto s = materials::sample(model, wo, {u, v});
    if (!s) continue;  // a lost draw lowers every count: both tests see it
    if (s->wi.z < 0.0) ++fit.below_horizon;
    sum += s->wi.z;
    drawn[HemisphereCells::index(s->wi)] += 1.0;
  }
  const ExpectedCounts expected = expected_counts(model, wo, draws);
  fit.chi_square_p = chi_square_p_value(drawn, expected.cells);
  const double variance = expected.mean_square - expected.mean * expected.mean;
  fit.mean_cosine_p = normal_p_value((sum / draws - expected.mean) / std::sqrt(variance / draws));
  return fit;
}

}  // namespace nadir::support
