#include "materials/scattering/albedo_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/sampler.hpp"

namespace nadir::materials {
namespace {

using spectral::Spectrum;
using spectral::SpectrumSum;

constexpr std::size_t mu_count = 24, azimuth_count = 8;  // over half a turn
// The first node stands just above the horizon, where models still have a value.
constexpr double least_mu = 1e-6;

double node_mu(std::size_t row) {
  const double root = static_cast<double>(row) / (mu_count - 1);
  return std::max(root * root, least_mu);
}

double node_azimuth(std::size_t column) {
  return std::numbers::pi * static_cast<double>(column) / azimuth_count;
}

Vec3 node(double mu, double azimuth) {
  const double sine = std::sqrt((1.0 - mu) * (1.0 + mu));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), mu};
}

}  // namespace

std::size_t AlbedoTable::columns() const noexcept { return shape_.anisotropic ? azimuth_count : 1; }

AlbedoTable::AlbedoTable(const Shape& shape, const Sampling& sample) : shape_{shape} {
  const std::size_t sides = shape.two_sided ? 2 : 1;
  values_.resize(sides * mu_count * columns() * 2 * static_cast<std::size_t>(shape.lanes));
  std::size_t entry = 0;
  for (std::size_t side = 0; side < sides; ++side) {
    for (std::size_t row = 0; row < mu_count; ++row) {
      for (std::size_t column = 0; column < columns(); ++column) {
        Vec3 wo = node(node_mu(row), node_azimuth(column));
        if (side == 1) wo.z = -wo.z;
        fill(entry++, wo, sample);
      }
    }
  }
}

void AlbedoTable::fill(std::size_t entry, Vec3 wo, const Sampling& sample) {
  // An anisotropic table has neighbours in azimuth that share the noise: fewer draws for each.
  const std::uint32_t draws = shape_.anisotropic ? 256 : 512;
  SpectrumSum reflected{shape_.lanes}, transmitted{shape_.lanes};
  for (std::uint32_t i = 0; i < draws; ++i) {
    const Sampler numbers{entry, i};
    const auto s = sample(wo, {numbers.number(0), numbers.point(1)});
    if (!s) continue;
    (s->wi.z * wo.z > 0.0 ? reflected : transmitted).add(s->weight);
  }
  const auto lanes = static_cast<std::size_t>(shape_.lanes);
  float* const out = values_.data() + entry * 2 * lanes;
  for (int lane = 0; lane < shape_.lanes; ++lane) {
    const double r = reflected[lane] / draws, t = transmitted[lane] / draws;
    const double excess = std::max(1.0, r + t);  // noise must not create energy
    out[lane] = static_cast<float>(r / excess);
    out[lanes + static_cast<std::size_t>(lane)] = static_cast<float>(t / excess);
  }
}

AlbedoTable::Corners AlbedoTable::corners(Vec3 wo) const noexcept {
  const double mu = std::min(std::abs(wo.z), 1.0);
  const double y = std::sqrt(mu) * (mu_count - 1);
  const auto row = std::min(static_cast<std::size_t>(y), mu_count - 2);
  const auto up = static_cast<float>(y - static_cast<double>(row));

  std::size_t left = 0, right = 0;
  float across = 0.0F;
  if (shape_.anisotropic) {
    const double turn = std::atan2(wo.y, wo.x) * std::numbers::inv_pi;  // in half turns
    const double x = (turn < 0.0 ? turn + 1.0 : turn) * azimuth_count;
    left = static_cast<std::size_t>(x) % azimuth_count;
    right = (left + 1) % azimuth_count;
    across = static_cast<float>(x - std::floor(x));
  }
  const std::size_t side = shape_.two_sided && wo.z < 0.0 ? mu_count : 0;
  const std::size_t low = (side + row) * columns(), high = low + columns();
  return {{low + left, low + right, high + left, high + right},
          {(1.0F - up) * (1.0F - across), (1.0F - up) * across, up * (1.0F - across), up * across}};
}

Albedo AlbedoTable::at(Vec3 wo) const noexcept {
  const Corners c = corners(wo);
  const auto lanes = static_cast<std::size_t>(shape_.lanes);
  Albedo result{Spectrum{shape_.lanes}, Spectrum{shape_.lanes}};
  for (std::size_t i = 0; i < 4; ++i) {
    if (c.weight[i] <= 0.0F) continue;
    const float* const entry = values_.data() + c.entry[i] * 2 * lanes;
    for (int lane = 0; lane < shape_.lanes; ++lane) {
      result.reflectance[lane] += c.weight[i] * entry[lane];
      result.transmittance[lane] += c.weight[i] * entry[lanes + static_cast<std::size_t>(lane)];
    }
  }
  return result;
}

double AlbedoTable::reflectance_at(Vec3 wo) const noexcept {
  const Corners c = corners(wo);
  const auto stride = 2 * static_cast<std::size_t>(shape_.lanes);
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    sum += static_cast<double>(c.weight[i] * values_[c.entry[i] * stride]);
  }
  return sum;
}

}  // namespace nadir::materials
