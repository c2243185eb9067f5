#include "materials/scattering/smooth_albedo.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/error.hpp"
#include "materials/scattering/local_direction.hpp"

namespace nadir::materials {
namespace {

constexpr int entry_count = 33;  // 32 steps: linear interpolation errs by 1e-4 or less
constexpr double least_cosine = 1e-6;

/// Two-point Gauss rule in each panel of t = sqrt(mu), which spreads out grazing angles, midpoint
/// rule in the azimuth over half a turn: d(omega) = 2 t dt d(phi), twice for the other half.
/// With 12 panels the edge of one is at 80 degrees, where the empirical models have a kink.
spectral::Spectrum integral(const SmoothAlbedo::Function& f, Vec3 wo, int lanes, int panels) {
  constexpr double node = 0.28867513459481287;  // 1 / sqrt(12)
  const int azimuths = 2 * panels;
  const double cell = 2.0 * std::numbers::pi / (2 * panels * static_cast<double>(azimuths));
  spectral::SpectrumSum sum{lanes};
  for (int i = 0; i < 2 * panels; ++i) {
    const int panel = i / 2;
    const double t = (panel + 0.5 + (i % 2 == 0 ? -node : node)) / panels, mu = t * t;
    for (int j = 0; j < azimuths; ++j) {
      const Vec3 wi = local_direction(mu, std::numbers::pi * (j + 0.5) / azimuths);
      sum.add(f(wi, wo), 2.0 * t * mu * cell);
    }
  }
  return sum.spectrum();
}

}  // namespace

SmoothAlbedo::SmoothAlbedo(int lanes, const Function& f, int panels) {
  entries_.reserve(entry_count);
  for (int i = 0; i < entry_count; ++i) {
    const double t = static_cast<double>(i) / (entry_count - 1);
    const Vec3 wo = local_direction(std::max(t * t, least_cosine), 0.0);
    entries_.push_back(integral(f, wo, lanes, panels));
  }
}

Albedo SmoothAlbedo::at(double mu) const noexcept {
  const double x = std::sqrt(std::min(std::abs(mu), 1.0)) * (entry_count - 1);
  const auto i = std::min(static_cast<std::size_t>(x), entries_.size() - 2);
  const auto share = static_cast<float>(x - static_cast<double>(i));
  spectral::Spectrum rho = entries_[i] * (1.0F - share);
  rho.add_scaled(entries_[i + 1], share);
  return {rho, spectral::Spectrum{rho.count()}};
}

spectral::Spectrum SmoothAlbedo::largest() const noexcept {
  spectral::Spectrum most{entries_.front().count()};
  for (const spectral::Spectrum& entry : entries_) {
    for (int lane = 0; lane < most.count(); ++lane) most[lane] = std::max(most[lane], entry[lane]);
  }
  return most;
}

void SmoothAlbedo::scale(const spectral::Spectrum& factor) noexcept {
  for (spectral::Spectrum& entry : entries_) entry *= factor;
}

void SmoothAlbedo::refuse_above(double limit, const spectral::Lanes& lanes,
                                const std::string& what) const {
  double worst = limit, mu = 0.0;
  int worst_lane = -1;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    for (int lane = 0; lane < lanes.count(); ++lane) {
      const auto found = static_cast<double>(entries_[i][lane]);
      if (found <= worst) continue;
      const double t = static_cast<double>(i) / (entry_count - 1);
      worst = found;
      mu = t * t;
      worst_lane = lane;
    }
  }
  if (worst_lane < 0) return;
  char text[160];
  std::snprintf(text, sizeof text,
                ": it reflects %.4g of the light that comes from %.0f degrees off the normal at "
                "%.4g um: more than it receives",
                worst, std::acos(mu) * 180.0 / std::numbers::pi, lanes[worst_lane].value);
  throw InputError{what + text};
}

}  // namespace nadir::materials
