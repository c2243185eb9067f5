#include "sensor/detector/line_noise.hpp"

#include <cmath>

#include "core/random.hpp"
#include "sensor/detector/shot_noise.hpp"

namespace nadir::sensor {
namespace {

/// A step of a stationary autoregression; the first has no former state.
double relaxed(double former, double memory, double innovation) {
  return memory * former + std::sqrt(1.0 - memory * memory) * innovation;
}

}  // namespace

double LineNoise::next(std::uint64_t key) noexcept {
  double sum = 0.0;
  if (rms_.stripe > 0.0) {
    const double z = normal_pair(mix(key, 0), mix(key, 1)).x;
    stripe_ = relaxed(stripe_, first_ ? 0.0 : rms_.memory, rms_.stripe * z);
    sum += stripe_;
  }
  if (rms_.flicker > 0.0) {
    const double each = rms_.flicker / std::sqrt(static_cast<double>(relaxations_.size()));
    double lines = 0.5;  // memory of the shortest
    std::uint64_t number = 2;
    for (double& state : relaxations_) {
      const double z = normal_pair(mix(key, number), mix(key, number + 1)).x;
      state = relaxed(state, first_ ? 0.0 : std::exp(-1.0 / lines), each * z);
      sum += state;
      lines *= 2.0;
      number += 2;
    }
  }
  first_ = false;
  return sum;
}

}  // namespace nadir::sensor
