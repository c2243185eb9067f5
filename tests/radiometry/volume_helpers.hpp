#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/random.hpp"
#include "core/sampler.hpp"
#include "core/statistics.hpp"
#include "radiometry/volumes/bound_volumes.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"
#include "support/statistics.hpp"

// What the tests of volumes share: small media, random walks, and tests of means.

namespace nadir::radiometry::volume_test {

inline spectral::Lanes lanes() {
  return spectral::Lanes{{Micrometres{0.6}, Micrometres{4.0}, Micrometres{10.0}}};
}

/// A curve with these values at the three lanes.
inline spectral::Curve per_lane(const std::array<double, 3>& value) {
  return {{0.6, 4.0, 10.0}, {value[0], value[1], value[2]}, spectral::Outside::reject};
}
/// 1 : 0.5 : 0.1 over the lanes.
struct Coloured {};
inline Coloured coloured() { return {}; }
inline double share_of(int lane) {
  return std::array{1.0, 0.5, 0.1}[static_cast<std::size_t>(lane)];
}
inline spectral::Curve operator*(double scale, Coloured /*shares*/) {
  return per_lane({scale * share_of(0), scale * share_of(1), scale * share_of(2)});
}

/// From z = 0 to 10 m, a thousand kilometres wide.
inline Volume slab(spectral::Curve absorption, spectral::Curve scattering) {
  return {"slab",
          geometry::Region{geometry::Box{{-1e3, -1e3, 0.0}, {1e3, 1e3, 10.0}}, Affine{}},
          {std::move(absorption), std::move(scattering), materials::HenyeyGreenstein{}},
          nullptr,
          Kelvin{0.0},
          {}};
}
inline geometry::Ray downwards() { return {{0.3, 0.2, 20.0}, {0.0, 0.0, -1.0}}; }

/// Values that depend on the height of the cell's centre alone, in [0, 1].
template <class F>
std::shared_ptr<const ScalarGrid> grid(const std::array<int, 3>& size, F&& value_at) {
  ScalarGrid grid{size[0], size[1], size[2], {}};
  for (int z = 0; z < size[2]; ++z) {
    for (int i = 0; i < size[0] * size[1]; ++i) {
      grid.value.push_back(static_cast<float>(value_at((z + 0.5) / size[2])));
    }
  }
  return std::make_shared<const ScalarGrid>(std::move(grid));
}

/// Independent numbers for every sample, so that the error of a mean is that of plain sampling.
inline Sampler numbers(std::uint32_t sample) {
  return Sampler{mix(support::test_seed(), sample), 0};
}

/// Whether a mean agrees with the exact value; `tests` of them together raise a false alarm once in
/// a thousand. 2e-6: what float lanes may be off where there is no noise.
inline bool within_error(const Welford& found, double exact, int tests) {
  const double off = std::abs(found.mean() - exact);
  if (!std::isfinite(found.mean())) return false;
  if (off <= 2e-6 * std::abs(exact)) return true;
  return support::normal_p_value(off / found.estimate().standard_error) >
         support::sidak(0.001, tests);
}

/// A random walk: what arrives at the ray's origin per lane from surroundings of that radiance (1
/// where null), with Russian roulette on the mean throughput.
inline spectral::SpectrumSum walk(geometry::Ray ray, const BoundVolumes& volumes, Sampler random,
                                  const spectral::Spectrum* surroundings = nullptr) {
  spectral::Spectrum throughput{lanes().count(), 1.0F};
  spectral::SpectrumSum radiance{lanes().count()};
  for (int bounce = 0;; ++bounce) {
    const auto event = volumes.fly(ray, std::numeric_limits<double>::infinity(), random.child(0),
                                   throughput, radiance);
    if (!event) break;
    const auto scattered = event->phase->sample(-ray.direction, random.number(1), random.point(2));
    throughput *= scattered.weight;
    ray = {event->position, scattered.direction};
    const double survival = std::min(1.0, static_cast<double>(throughput.mean()));
    if (bounce > 2) {
      if (random.number(3) >= survival) return radiance;
      throughput *= static_cast<float>(1.0 / survival);
    }
    random = random.child(1);
  }
  radiance.add(surroundings == nullptr ? throughput : throughput * *surroundings);
  return radiance;
}

/// Chandrasekhar's H for isotropic scattering, by iterating
/// 1 / H(mu) = sqrt(1 - w) + w / 2 int mu' H(mu') / (mu + mu') dmu'. Error about 1e-5.
inline double h_function(double w, double mu) {
  constexpr int n = 120;
  std::vector<double> h(n, 1.0);
  const auto node = [](int i) { return (i + 0.5) / n; };
  const auto next = [&](double at) {
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
      sum += node(i) * h[static_cast<std::size_t>(i)] / (at + node(i)) / n;
    }
    return 1.0 / (std::sqrt(1.0 - w) + 0.5 * w * sum);
  };
  for (int iteration = 0; iteration < 30; ++iteration) {
    std::vector<double> better;
    for (int i = 0; i < n; ++i) better.push_back(next(node(i)));
    h = better;
  }
  return next(mu);
}

}  // namespace nadir::radiometry::volume_test
