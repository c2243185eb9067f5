#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "core/sampler.hpp"
#include "materials/scattering/bound_scattering.hpp"
#include "materials/scattering_cases.hpp"
#include "support/quadrature.hpp"
#include "support/statistics.hpp"

namespace nadir::support {

/// The direction with this cosine (negative: below) and azimuth.
[[nodiscard]] inline Vec3 view(double mu, double azimuth = 0.3) { return direction(mu, azimuth); }

/// Calls f(direction, solid angle) over the sphere: a midpoint rule in the square root of |mu|
/// (dense toward grazing, where lobes are narrowest) and in azimuth. Relative error below 1e-3 for
/// lobes wider than about ten degrees.
template <class F>
void over_sphere(F&& f) {
  constexpr int rows = 80, columns = 120;
  for (int i = 0; i < rows; ++i) {
    const double t = (i + 0.5) / rows, mu = t * t * (3.0 - 2.0 * t);
    const double solid_angle = 6.0 * t * (1.0 - t) / rows * 2.0 * std::numbers::pi / columns;
    for (int j = 0; j < columns; ++j) {
      const double azimuth = 2.0 * std::numbers::pi * (j + 0.5) / columns;
      f(direction(mu, azimuth), solid_angle);
      f(direction(-mu, azimuth), solid_angle);
    }
  }
}

/// Calls f(wi, solid angle) over half vectors between wi and wo: slopes q / (1 - q) times `scale`,
/// which resolves a lobe of that width about the mirror direction, and everything else too.
template <class F>
void over_half_vectors(Vec3 wo, double scale, F&& f) {
  constexpr int rows = 240, columns = 120;
  for (int i = 0; i < rows; ++i) {
    const double q = (i + 0.5) / rows, slope = scale * q / (1.0 - q);
    const double d_slope = scale / ((1.0 - q) * (1.0 - q)) / rows;
    const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
    // d omega_h = sin d theta d phi = slope cos^3 d slope d phi
    const double ring =
        slope * cosine * cosine * cosine * d_slope * 2.0 * std::numbers::pi / columns;
    for (int j = 0; j < columns; ++j) {
      const double azimuth = 2.0 * std::numbers::pi * (j + 0.5) / columns;
      const Vec3 h{slope * cosine * std::cos(azimuth), slope * cosine * std::sin(azimuth),
                   std::copysign(cosine, wo.z)};
      const double along = dot(h, wo);
      if (along > 0.0) f(h * (2.0 * along) - wo, 4.0 * along * ring);
    }
  }
}

template <class F>
void over_directions(const ScatteringCase& c, Vec3 wo, F&& f) {
  if (c.traits.narrow > 0.0) {
    over_half_vectors(wo, c.traits.narrow, f);
  } else {
    over_sphere(f);
  }
}

/// What radiance from `from` gains on its way to `to` by refraction alone: (n_to / n_from)^2.
[[nodiscard]] inline double compression(const ScatteringCase& c, Vec3 from, Vec3 to) {
  const double n_from = from.z > 0.0 ? 1.0 : c.traits.index_below;
  const double n_to = to.z > 0.0 ? 1.0 : c.traits.index_below;
  return n_to * n_to / (n_from * n_from);
}

/// Reflectance and transmittance per lane, without and with deltas, by quadrature or by samples.
struct Estimate {
  std::vector<double> reflectance, transmittance;
  double density = 0.0;  ///< integral of pdf
  double least = 0.0;    ///< smallest f seen

  explicit Estimate(int lanes)
      : reflectance(static_cast<std::size_t>(lanes)), transmittance(reflectance) {}
  void add(const spectral::Spectrum& share, bool reflected, double factor) {
    for (int lane = 0; lane < share.count(); ++lane) {
      (reflected ? reflectance : transmittance)[static_cast<std::size_t>(lane)] +=
          factor * static_cast<double>(share[lane]);
    }
  }
};

[[nodiscard]] inline Estimate by_quadrature(const ScatteringCase& c, Vec3 wo) {
  const auto& model = c.material.scattering;
  Estimate e{c.material.own_emissivity.count()};
  over_directions(c, wo, [&](Vec3 wi, double solid_angle) {
    const spectral::Spectrum f = materials::eval(model, wi, wo);
    e.add(f, wi.z * wo.z > 0.0, std::abs(wi.z) * solid_angle / compression(c, wi, wo));
    e.density += materials::pdf(model, wi, wo) * solid_angle;
    for (int lane = 0; lane < f.count(); ++lane) {
      e.least = std::min(e.least, static_cast<double>(f[lane]));
    }
  });
  return e;
}

/// Means of the weights, of deltas only or of all.
[[nodiscard]] inline Estimate by_samples(const ScatteringCase& c, Vec3 wo, bool only_deltas) {
  constexpr std::uint32_t draws = 4096;
  Estimate e{c.material.own_emissivity.count()};
  for (std::uint32_t i = 0; i < draws; ++i) {
    const Sampler numbers{7, i};
    const auto s =
        materials::sample(c.material.scattering, wo, {numbers.number(0), numbers.point(1)});
    if (!s || (only_deltas && !s->delta)) continue;
    e.add(s->weight, s->wi.z * wo.z > 0.0, 1.0 / (draws * compression(c, s->wi, wo)));
  }
  return e;
}

/// How well drawn directions follow the density that their model states.
struct SamplingFit {
  double chi_square_p = 1.0;  ///< Pearson's test of the counts in cells; 1 where lobes are narrow
  std::array<double, 3> mean_p{1.0, 1.0, 1.0};  ///< two-sided z-tests of the means of x, y, z
};

/// Cells of equal solid angle over the sphere: 40 in the cosine, 40 in azimuth; and one for draws
/// that are lost or deltas.
struct SphereCells {
  static constexpr int mu_count = 40, phi_count = 40;
  static constexpr std::size_t lost = mu_count * phi_count, count = lost + 1;

  [[nodiscard]] static std::size_t index(Vec3 v) {
    const double turn = std::atan2(v.y, v.x) / (2.0 * std::numbers::pi);
    const int row = std::clamp(static_cast<int>(0.5 * (v.z + 1.0) * mu_count), 0, mu_count - 1);
    const int column = static_cast<int>((turn < 0.0 ? turn + 1.0 : turn) * phi_count);
    return static_cast<std::size_t>(row * phi_count + std::min(column, phi_count - 1));
  }
};

/// A sum over directions with its squares, for a z-test.
struct Moments {
  std::array<double, 3> mean{}, square{};
  void add(Vec3 v, double share) {
    const std::array<double, 3> parts{v.x, v.y, v.z};
    for (std::size_t i = 0; i < 3; ++i) {
      mean[i] += share * parts[i];
      square[i] += share * parts[i] * parts[i];
    }
  }
};

/// The density summed into cells, ten by four points each, six times as many at the poles: the lobe
/// into glass is a few degrees wide there.
[[nodiscard]] inline std::vector<double> expected_counts(const materials::BoundScattering& model,
                                                         Vec3 wo, int draws, bool may_lose) {
  constexpr int columns = SphereCells::phi_count * 4;
  std::vector<double> cells(SphereCells::count, 0.0);
  double rest = draws;
  for (int row = 0; row < SphereCells::mu_count; ++row) {
    const int fine = row == 0 || row == SphereCells::mu_count - 1 ? 60 : 10;
    for (int i = 0; i < fine * columns; ++i) {
      const double mu = 2.0 * (row + (i / columns + 0.5) / fine) / SphereCells::mu_count - 1.0;
      const Vec3 wi = direction(mu, 2.0 * std::numbers::pi * (i % columns + 0.5) / columns);
      const double solid_angle = 4.0 * std::numbers::pi / (SphereCells::mu_count * fine * columns);
      const double share = draws * materials::pdf(model, wi, wo) * solid_angle;
      cells[SphereCells::index(wi)] += share;
      rest -= share;
    }
  }
  cells[SphereCells::lost] = may_lose ? std::max(rest, 0.0) : 0.0;
  return cells;
}

/// Draws that are lost count as the vector 0, in the draws and (by having no density) in what is
/// expected of them.
[[nodiscard]] inline SamplingFit fit_samples(const ScatteringCase& c, Vec3 wo, int draws,
                                             Rng& rng) {
  const auto& model = c.material.scattering;
  std::vector<double> drawn(SphereCells::count, 0.0);
  Moments seen, expected;
  for (int i = 0; i < draws; ++i) {
    const double choice = rng.next(), u = rng.next(), v = rng.next();
    const auto s = materials::sample(model, wo, {choice, {u, v}});
    const bool counts = s && !s->delta;
    drawn[counts ? SphereCells::index(s->wi) : SphereCells::lost] += 1.0;
    if (counts) seen.add(s->wi, 1.0 / draws);
  }
  over_directions(c, wo, [&](Vec3 wi, double solid_angle) {
    expected.add(wi, materials::pdf(model, wi, wo) * solid_angle);
  });
  SamplingFit fit;
  for (std::size_t i = 0; i < 3; ++i) {
    const double variance = expected.square[i] - expected.mean[i] * expected.mean[i];
    if (variance < 1e-12) continue;  // a delta: nothing is drawn from a density
    fit.mean_p[i] = normal_p_value((seen.mean[i] - expected.mean[i]) / std::sqrt(variance / draws));
  }
  const bool may_lose = c.traits.lossy || c.material.traits.has_delta;
  if (c.traits.narrow == 0.0) {
    fit.chi_square_p = chi_square_p_value(drawn, expected_counts(model, wo, draws, may_lose));
  }
  return fit;
}

}  // namespace nadir::support
