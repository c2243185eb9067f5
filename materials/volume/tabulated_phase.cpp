#include "materials/volume/tabulated_phase.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::materials {
namespace {

constexpr std::size_t guide_size = 512;

void require(bool good, const std::string& message) {
  if (!good) throw InputError{"phase table: " + message};
}

/// To a millionth of a degree, as the user's file has it.
std::string degrees_text(double angle_rad) {
  return number_text(std::round(to_degrees(Angle{angle_rad}) * 1e6) / 1e6);
}

void check_axes(const TabulatedPhase& phase) {
  const auto& angle = phase.angle_rad;
  require(angle.size() >= 2, "at least two angles are needed");
  for (std::size_t i = 1; i < angle.size(); ++i) {
    require(angle[i] > angle[i - 1], "angles must ascend, found " + degrees_text(angle[i]) +
                                         " deg after " + degrees_text(angle[i - 1]) + " deg");
  }
  // A file's degrees have three decimals or more.
  constexpr double near = 1e-5;
  require(std::abs(angle.front()) < near && std::abs(angle.back() - std::numbers::pi) < near,
          "angles must reach from 0 to 180 deg, found " + degrees_text(angle.front()) + " to " +
              degrees_text(angle.back()) + " deg");
  require(!phase.wavelength_um.empty(), "there is no wavelength");
  for (std::size_t i = 1; i < phase.wavelength_um.size(); ++i) {
    require(phase.wavelength_um[i] > phase.wavelength_um[i - 1], "wavelengths must ascend");
  }
  const std::size_t expected = angle.size() * phase.wavelength_um.size();
  require(phase.value.size() == expected, "expected " + std::to_string(expected) +
                                              " values, found " +
                                              std::to_string(phase.value.size()));
}

/// The rows, each scaled to integrate to 1 over the sphere.
std::vector<double> normalised_rows(const TabulatedPhase& phase, const std::vector<double>& x) {
  std::vector<double> rows = phase.value;
  const std::size_t n = x.size();
  for (std::size_t row = 0; row < phase.wavelength_um.size(); ++row) {
    double* const value = rows.data() + row * n;
    double integral = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      require(std::isfinite(value[i]) && value[i] >= 0.0,
              "the value at " + degrees_text(phase.angle_rad[i]) + " deg and " +
                  number_text(phase.wavelength_um[row]) + " um is " + number_text(value[i]) +
                  "; it must be finite and not negative");
      if (i > 0) integral += std::numbers::pi * (x[i] - x[i - 1]) * (value[i] + value[i - 1]);
    }
    require(integral > 0.0 && std::isfinite(integral),
            "the values at " + number_text(phase.wavelength_um[row]) + " um cannot be normalised");
    std::for_each(value, value + n, [&](double& v) { v /= integral; });
  }
  return rows;
}

/// Where a wavelength lies between two rows.
struct Between {
  std::size_t row = 0, next = 0;
  double share = 0.0;
};

Between between(const std::vector<double>& wavelength_um, Micrometres at) {
  if (wavelength_um.size() == 1) return {};
  require(at.value >= wavelength_um.front() && at.value <= wavelength_um.back(),
          "it is tabulated from " + number_text(wavelength_um.front()) + " to " +
              number_text(wavelength_um.back()) + " um, " + number_text(at.value) +
              " um is simulated");
  const auto after = std::upper_bound(wavelength_um.begin() + 1, wavelength_um.end() - 1, at.value);
  const auto next = static_cast<std::size_t>(after - wavelength_um.begin());
  const double lo = wavelength_um[next - 1], hi = wavelength_um[next];
  return {next - 1, next, (at.value - lo) / (hi - lo)};
}

}  // namespace

BoundTabulatedPhase::BoundTabulatedPhase(const TabulatedPhase& phase, const spectral::Lanes& lanes)
    : lanes_{lanes.count()} {
  check_axes(phase);
  for (const double angle : phase.angle_rad) {
    const double half = std::sin(0.5 * angle);
    x_.push_back(2.0 * half * half);
  }
  x_.front() = 0.0;
  x_.back() = 2.0;
  const std::vector<double> rows = normalised_rows(phase, x_);
  const std::size_t n = x_.size(), count = static_cast<std::size_t>(lanes_);
  value_.resize(n * count);
  mean_.assign(n, 0.0);
  for (std::size_t lane = 0; lane < count; ++lane) {
    const Between at = between(phase.wavelength_um, lanes[static_cast<int>(lane)]);
    for (std::size_t i = 0; i < n; ++i) {
      const double p = (1.0 - at.share) * rows[at.row * n + i] + at.share * rows[at.next * n + i];
      value_[i * count + lane] = static_cast<float>(p);
      mean_[i] += p / static_cast<double>(count);
    }
  }
  tabulate_sampling();
}

void BoundTabulatedPhase::tabulate_sampling() {
  cumulative_.assign(x_.size(), 0.0);
  for (std::size_t i = 1; i < x_.size(); ++i) {
    cumulative_[i] =
        cumulative_[i - 1] + std::numbers::pi * (x_[i] - x_[i - 1]) * (mean_[i] + mean_[i - 1]);
  }
  for (double& c : cumulative_) c /= cumulative_.back();
  // In sqrt(x / 2), the sine of half the angle, tables of even angles have even nodes.
  std::uint32_t at = 0;
  for (std::size_t part = 0; part < guide_size; ++part) {
    const double sine = static_cast<double>(part) / static_cast<double>(guide_size);
    while (at + 2 < x_.size() && x_[at + 1] <= 2.0 * sine * sine) ++at;
    guide_.push_back(at);
  }
}

std::size_t BoundTabulatedPhase::interval(double x) const noexcept {
  const auto part = static_cast<std::size_t>(std::sqrt(0.5 * x) * static_cast<double>(guide_size));
  std::size_t i = guide_[std::min(part, guide_size - 1)];
  while (i + 2 < x_.size() && x_[i + 1] <= x) ++i;
  return i;
}

spectral::Spectrum BoundTabulatedPhase::eval(double x) const noexcept {
  const std::size_t i = interval(x), count = static_cast<std::size_t>(lanes_);
  const auto share = static_cast<float>(std::clamp((x - x_[i]) / (x_[i + 1] - x_[i]), 0.0, 1.0));
  const float* const lo = value_.data() + i * count;
  const float* const hi = lo + count;
  spectral::Spectrum p{lanes_};
  for (int lane = 0; lane < lanes_; ++lane) {
    p[lane] = (1.0F - share) * lo[lane] + share * hi[lane];
  }
  return p;
}

double BoundTabulatedPhase::sample(double choice) const noexcept {
  const auto after = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, choice);
  const auto i = static_cast<std::size_t>(after - cumulative_.begin()) - 1;
  const double mass = cumulative_[i + 1] - cumulative_[i];
  if (!(mass > 0.0)) return x_[i];
  // Inverts the quadratic a s + (b - a) s^2 / 2 = u (a + b) / 2 without cancellation.
  const double u = std::clamp((choice - cumulative_[i]) / mass, 0.0, 1.0);
  const double a = mean_[i], b = mean_[i + 1];
  const double root = std::sqrt(std::max(0.0, a * a + u * (b - a) * (b + a)));
  const double s = u * (a + b) / (a + root);
  return x_[i] + std::clamp(s, 0.0, 1.0) * (x_[i + 1] - x_[i]);
}

}  // namespace nadir::materials
