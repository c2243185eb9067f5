#include "radiometry/volumes/passage.hpp"
#include "spectral/exp_minus.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace nadir::radiometry {
namespace {

using spectral::Spectrum;

/// A lane drawn in proportion to its weight, and what is left of the random number.
struct Choice {
  int lane = 0;
  double u = 0.0;
};

Choice choose(const Spectrum& weight, double sum, double u) noexcept {
  double left = u * sum;
  int chosen = 0;
  double width = 0.0;
  for (int lane = 0; lane < weight.count(); ++lane) {
    const double w = static_cast<double>(weight[lane]);
    if (w <= 0.0) continue;
    if (width > 0.0) left -= width;  // past the one before
    chosen = lane;
    width = w;
    if (left < w) break;
  }
  return {chosen, width > 0.0 ? std::clamp(left / width, 0.0, 0x1.fffffffffffffp-1) : 0.0};
}

/// Where exp(-sigma t) on [0, length] is drawn at u: -ln(1 - u (1 - exp(-sigma length))) / sigma.
double distance_of(double sigma, double length, double u) noexcept {
  const double tau = sigma * length;
  if (tau < 1e-9) return u * length;  // the density is even, to that part
  return std::min(-std::log1p(u * std::expm1(-tau)) / sigma, length);
}

}  // namespace

void scale_by(Spectrum& weight, double factor) noexcept {
  for (int lane = 0; lane < weight.count(); ++lane) {
    weight[lane] = static_cast<float>(static_cast<double>(weight[lane]) * factor);
  }
}

Passage passage(const Spectrum& extinction, double length) noexcept {
  Passage passed{extinction, extinction};
  const auto d = static_cast<float>(length);
  for (int lane = 0; lane < extinction.count(); ++lane) {
    const float tau = extinction[lane] * d;
    const float left = spectral::exp_minus(tau);
    // (1 - exp(-tau)) / tau: where 1 - exp(-tau) has lost digits, Taylor to tau^6 / 7!: 2e-7 at
    // 0.5.
    const float series =
        1.0F - tau * (0.5F - tau * (1.0F / 6.0F -
                                    tau * (1.0F / 24.0F - tau * (1.0F / 120.0F -
                                                                 tau * (1.0F / 720.0F -
                                                                        tau * (1.0F / 5040.0F))))));
    const float plain = (1.0F - left) / (tau > 0.5F ? tau : 1.0F);
    passed.transmittance[lane] = left;
    passed.path[lane] = d * (tau > 0.5F ? plain : series);
  }
  return passed;
}

Scattered place_in_constant(const Step& step, const geometry::Interval& part,
                            const Spectrum& weight, const Spectrum& share, Vec2 u) noexcept {
  const double sum = total(share);
  const Choice lane = choose(share, sum, u.x);
  const double along =
      distance_of(static_cast<double>(step.extinction[lane.lane]), part.end - part.begin, u.y);
  Scattered scattered{part.begin + along, nullptr, weight};
  const auto t = static_cast<float>(along);
  for (int i = 0; i < weight.count(); ++i) {
    scattered.weight[i] *= spectral::exp_minus(step.extinction[i] * t);
  }
  std::array<double, most_overlapping> chance{};
  double all = 0.0;
  for (int i = 0; i < step.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const ActiveVolume& active = step.active[k];
    if (active.lo <= 0.0F || !active.volume->scatters) continue;
    chance[k] =
        static_cast<double>(active.lo) * total(scattered.weight * active.volume->scattering);
    all += chance[k];
  }
  double left = lane.u * all;
  std::size_t chosen = 0;
  for (int i = 0; i < step.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (chance[k] <= 0.0) continue;
    chosen = k;
    if (left < chance[k]) break;
    left -= chance[k];
  }
  const ActiveVolume& active = step.active[chosen];
  scattered.volume = active.volume;
  // Only rounding can have left nothing: a place whose light is below the smallest float.
  const double scale =
      chance[chosen] > 0.0 ? sum / chance[chosen] * static_cast<double>(active.lo) : 0.0;
  scattered.weight *= active.volume->scattering;
  scale_by(scattered.weight, scale);
  return scattered;
}

}  // namespace nadir::radiometry
