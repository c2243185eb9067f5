#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <compare>
#include <cstddef>
#include <vector>

#include "core/quantity.hpp"

namespace nadir::spectral {

/// Wavelengths that one ray can carry. More are simulated in blocks.
inline constexpr int lane_capacity = 128;

/// How the gases of the air are met at a lane. Lines of absorption are far narrower than any band:
/// a lane stands for an interval about its wavelength, and shares it with others of the same
/// wavelength, one for each term of the sum of exponentials that is the interval's transmittance.
/// Along each of them light then obeys Beer's law.
struct AbsorptionLane {
  double lo_um = 0.0, hi_um = 0.0;  ///< the interval; lo = hi = 0: the wavelength alone
  int term = 0;                     ///< which term of that sum

  [[nodiscard]] auto operator<=>(const AbsorptionLane&) const = default;  // interval, then term
};

/// The wavelengths that the lanes of a block stand for, ascending; lanes of the same wavelength
/// ascend in their interval, then in their term. At most lane_capacity of them.
class Lanes {
 public:
  Lanes() = default;
  /// @param absorption  one a lane, or empty where none is split into terms
  /// @throws InputError for none, too many, not ascending, or not positive wavelengths.
  explicit Lanes(std::vector<Micrometres> wavelengths, std::vector<AbsorptionLane> absorption = {});

  [[nodiscard]] int count() const noexcept { return static_cast<int>(wavelengths_.size()); }
  [[nodiscard]] Micrometres operator[](int lane) const {
    return wavelengths_[static_cast<std::size_t>(lane)];
  }
  [[nodiscard]] AbsorptionLane absorption(int lane) const {
    return absorption_.empty() ? AbsorptionLane{} : absorption_[static_cast<std::size_t>(lane)];
  }
  [[nodiscard]] auto begin() const noexcept { return wavelengths_.begin(); }
  [[nodiscard]] auto end() const noexcept { return wavelengths_.end(); }

 private:
  std::vector<Micrometres> wavelengths_;
  std::vector<AbsorptionLane> absorption_;  // one a lane, or none at all
};

/// One number per lane, in float, without heap. The loops run over whole groups of eight lanes so
/// that they vectorise without a remainder; the lanes that pad the last group start at 0 and stay
/// there under every operation with finite scalars, so that they never overflow, trap or slow down.
class Spectrum {
 public:
  Spectrum() noexcept = default;
  explicit Spectrum(int count, float value = 0.0F) noexcept : count_{count} {
    assert(count >= 0 && count <= lane_capacity);
    const auto end = std::fill_n(values_.begin(), static_cast<std::size_t>(count), value);
    std::fill(end, values_.begin() + static_cast<std::ptrdiff_t>(padded()), 0.0F);
  }
  Spectrum(const Spectrum& other) noexcept : count_{other.count_} { copy(other); }
  Spectrum& operator=(const Spectrum& other) noexcept {
    count_ = other.count_;
    copy(other);
    return *this;
  }
  ~Spectrum() = default;

  [[nodiscard]] int count() const noexcept { return count_; }
  [[nodiscard]] float operator[](int lane) const noexcept {
    assert(lane >= 0 && lane < count_);
    return values_[static_cast<std::size_t>(lane)];
  }
  [[nodiscard]] float& operator[](int lane) noexcept {
    assert(lane >= 0 && lane < count_);
    return values_[static_cast<std::size_t>(lane)];
  }

  Spectrum& operator+=(const Spectrum& b) noexcept {
    return zip(b, [](float x, float y) { return x + y; });
  }
  Spectrum& operator-=(const Spectrum& b) noexcept {
    return zip(b, [](float x, float y) { return x - y; });
  }
  Spectrum& operator*=(const Spectrum& b) noexcept {
    return zip(b, [](float x, float y) { return x * y; });
  }
  Spectrum& operator*=(float s) noexcept {
    for (std::size_t i = 0, n = padded(); i < n; ++i) values_[i] *= s;
    return *this;
  }
  /// this += a * s
  Spectrum& add_scaled(const Spectrum& a, float s) noexcept {
    return zip(a, [s](float x, float y) { return x + y * s; });
  }
  /// this += a * b
  Spectrum& add_product(const Spectrum& a, const Spectrum& b) noexcept {
    assert(a.count_ == count_ && b.count_ == count_);
    for (std::size_t i = 0, n = padded(); i < n; ++i) values_[i] += a.values_[i] * b.values_[i];
    return *this;
  }
  friend Spectrum operator+(Spectrum a, const Spectrum& b) noexcept { return a += b; }
  friend Spectrum operator-(Spectrum a, const Spectrum& b) noexcept { return a -= b; }
  friend Spectrum operator*(Spectrum a, const Spectrum& b) noexcept { return a *= b; }
  friend Spectrum operator*(Spectrum a, float s) noexcept { return a *= s; }

  [[nodiscard]] float max() const noexcept {
    float m = count_ > 0 ? values_[0] : 0.0F;
    for (int i = 1; i < count_; ++i) m = std::max(m, (*this)[i]);
    return m;
  }
  [[nodiscard]] float mean() const noexcept {
    double sum = 0.0;
    for (int i = 0; i < count_; ++i) sum += static_cast<double>((*this)[i]);
    return count_ > 0 ? static_cast<float>(sum / count_) : 0.0F;
  }

 private:
  friend class SpectrumSum;
  static constexpr std::size_t group = 8;
  [[nodiscard]] std::size_t padded() const noexcept {
    return (static_cast<std::size_t>(count_) + group - 1) / group * group;
  }
  void copy(const Spectrum& other) noexcept {
    std::copy_n(other.values_.begin(), padded(), values_.begin());
  }
  template <class F>
  Spectrum& zip(const Spectrum& b, F f) noexcept {
    assert(b.count_ == count_);
    for (std::size_t i = 0, n = padded(); i < n; ++i) values_[i] = f(values_[i], b.values_[i]);
    return *this;
  }

  alignas(64) std::array<float, lane_capacity> values_;
  int count_ = 0;
};

/// A sum of spectra, kept in double.
class SpectrumSum {
 public:
  explicit SpectrumSum(int count) noexcept : count_{count} {
    assert(count >= 0 && count <= lane_capacity);
    std::fill_n(values_.begin(), count, 0.0);
  }
  void add(const Spectrum& s, double weight = 1.0) noexcept {
    assert(s.count() == count_);
    for (std::size_t i = 0, n = static_cast<std::size_t>(count_); i < n; ++i) {
      values_[i] += weight * static_cast<double>(s.values_[i]);
    }
  }
  void add_product(const Spectrum& a, const Spectrum& b, double weight) noexcept {
    assert(a.count() == count_ && b.count() == count_);
    for (std::size_t i = 0, n = static_cast<std::size_t>(count_); i < n; ++i) {
      values_[i] += weight * static_cast<double>(a.values_[i]) * static_cast<double>(b.values_[i]);
    }
  }
  [[nodiscard]] int count() const noexcept { return count_; }
  [[nodiscard]] double operator[](int lane) const noexcept {
    return values_[static_cast<std::size_t>(lane)];
  }
  /// The sum times `scale`, as float lanes.
  [[nodiscard]] Spectrum spectrum(double scale = 1.0) const noexcept {
    Spectrum s{count_};
    for (int i = 0; i < count_; ++i) s[i] = static_cast<float>((*this)[i] * scale);
    return s;
  }

 private:
  alignas(64) std::array<double, lane_capacity> values_;
  int count_ = 0;
};

}  // namespace nadir::spectral
