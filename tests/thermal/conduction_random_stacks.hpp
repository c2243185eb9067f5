#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "thermal/conduction/column.hpp"

namespace nadir::thermal::test {

/// A film with natural convection to one temperature and radiation to another: nothing passes
/// beyond the warmer and below the colder of the two.
struct RandomLoad {
  double air_k = 300.0, sky_k = 300.0, film_w_m2_k = 10.0, natural = 1.5, emissivity = 0.9;

  SurfaceFlux operator()(double t) const {
    const double warmer = t - air_k, root = std::cbrt(std::abs(warmer)), t3 = t * t * t;
    const double radiated = emissivity * si::stefan_boltzmann * (t3 * t - std::pow(sky_k, 4));
    return {
        -radiated - (film_w_m2_k + natural * root) * warmer,
        -4.0 * emissivity * si::stefan_boltzmann * t3 - film_w_m2_k - 4.0 / 3.0 * natural * root};
  }
};

/// Stacks from foil to earth, with any back, and what may happen to them.
class RandomStacks {
 public:
  explicit RandomStacks(std::uint64_t seed) : rng_(seed) {}

  double between(double low, double high) { return low + (high - low) * uniform(); }
  double logarithmic(double low, double high) { return low * std::pow(high / low, uniform()); }
  bool chance(double p) { return uniform() < p; }
  double step_s() { return logarithmic(1.0, 7200.0); }

  /// @param heat_w_m2  most that a layer releases
  LayerStack stack(double heat_w_m2, double coldest_k = 250.0, double warmest_k = 320.0) {
    LayerStack result;
    const int count = 1 + static_cast<int>(between(0.0, 4.0));
    for (int i = 0; i < count; ++i) {
      const Substance substance{logarithmic(0.02, 400.0), logarithmic(20.0, 8000.0),
                                logarithmic(400.0, 4200.0)};
      result.layers.push_back(
          {substance, logarithmic(1e-4, 0.5), chance(0.3) ? between(0.0, heat_w_m2) : 0.0});
    }
    result.back = back(coldest_k, warmest_k);
    try {
      check(result);
    } catch (const InputError&) {
      result.back = AdiabaticBack{};  // too thick to be open
    }
    return result;
  }

  RandomLoad load(double coldest_k, double warmest_k) {
    // the extremes themselves now and then
    const auto temperature = [&] {
      return chance(0.1) ? coldest_k : chance(0.1) ? warmest_k : between(coldest_k, warmest_k);
    };
    return {.air_k = temperature(),
            .sky_k = temperature(),
            .film_w_m2_k = logarithmic(0.1, 1000.0),
            .natural = between(0.0, 5.0),
            .emissivity = uniform()};
  }

 private:
  double uniform() { return rng_.next(); }
  Back back(double coldest_k, double warmest_k) {
    switch (static_cast<int>(between(0.0, 5.0))) {
      case 0:
        return FixedBack{Kelvin{between(coldest_k, warmest_k)}};
      case 1:
        return RoomBack{std::nullopt, 0.0, logarithmic(1.0, 50.0)};
      case 2:
        return RoomBack{Kelvin{between(coldest_k, warmest_k)}, 0.0, logarithmic(1.0, 50.0)};
      case 3:
        return OpenBack{};
      default:
        return AdiabaticBack{};
    }
  }

  Rng rng_;
};

}  // namespace nadir::thermal::test
