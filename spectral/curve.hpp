#pragma once

#include <vector>

#include "core/quantity.hpp"
#include "spectral/lanes.hpp"

namespace nadir::spectral {

/// What a curve is worth outside its table.
enum class Outside {
  reject,  ///< NaN: the caller has checked `covers` and reports what is missing
  zero,    ///< 0, for responses and other quantities that vanish there
  hold,    ///< the value at the nearer end; whoever binds the curve reports it in Diagnostics
};

/// A spectral quantity, tabulated over vacuum wavelength and interpolated linearly.
class Curve {
 public:
  /// The same value at every wavelength.
  [[nodiscard]] static Curve constant(double value);

  /// @param wavelength_um  strictly ascending, positive, finite; at least two
  /// @param value          as many, finite; the unit is the owner's to state
  /// @throws InputError    for any of these not kept
  Curve(std::vector<double> wavelength_um, std::vector<double> value, Outside outside);

  /// Value at a wavelength; NaN outside the table where `Outside::reject` holds.
  [[nodiscard]] double at(Micrometres wavelength) const noexcept;
  /// Value at each lane.
  [[nodiscard]] Spectrum at(const Lanes& lanes) const;
  /// Mean over [lo, hi], exact for the piecewise linear curve.
  [[nodiscard]] double mean(Micrometres lo, Micrometres hi) const;

  [[nodiscard]] bool covers(Micrometres lo, Micrometres hi) const noexcept;
  [[nodiscard]] Micrometres first() const noexcept;  ///< 0 for a constant
  [[nodiscard]] Micrometres last() const noexcept;   ///< infinity for a constant
  [[nodiscard]] double min_value() const noexcept;
  [[nodiscard]] double max_value() const noexcept;
  [[nodiscard]] bool is_constant() const noexcept { return wavelength_um_.empty(); }
  [[nodiscard]] const std::vector<double>& wavelengths_um() const noexcept {
    return wavelength_um_;
  }
  [[nodiscard]] const std::vector<double>& values() const noexcept { return value_; }

 private:
  Curve() = default;
  std::vector<double> wavelength_um_;  // empty for a constant
  std::vector<double> value_;
  Outside outside_ = Outside::hold;
};

}  // namespace nadir::spectral
