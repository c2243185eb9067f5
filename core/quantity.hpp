#pragma once

#include <compare>
#include <numbers>

namespace nadir {

/// A double that carries its unit in its type: same size and speed, no implicit conversion.
template <class Unit>
struct Quantity {
  double value = 0.0;

  constexpr Quantity() = default;
  constexpr explicit Quantity(double v) : value{v} {}
  // The check takes the 0 that the compiler compares with for a pointer.
  constexpr auto operator<=>(const Quantity&) const = default;  // NOLINT(modernize-use-nullptr)

  constexpr Quantity& operator+=(Quantity other) {
    value += other.value;
    return *this;
  }
  constexpr Quantity& operator-=(Quantity other) {
    value -= other.value;
    return *this;
  }
  friend constexpr Quantity operator+(Quantity a, Quantity b) {
    return Quantity{a.value + b.value};
  }
  friend constexpr Quantity operator-(Quantity a, Quantity b) {
    return Quantity{a.value - b.value};
  }
  friend constexpr Quantity operator-(Quantity a) { return Quantity{-a.value}; }
  friend constexpr Quantity operator*(Quantity a, double s) { return Quantity{a.value * s}; }
  friend constexpr Quantity operator*(double s, Quantity a) { return Quantity{a.value * s}; }
  friend constexpr Quantity operator/(Quantity a, double s) { return Quantity{a.value / s}; }
  friend constexpr double operator/(Quantity a, Quantity b) { return a.value / b.value; }
};

using Micrometres = Quantity<struct MicrometreTag>;              ///< um, wavelength in vacuum
using Kelvin = Quantity<struct KelvinTag>;                       ///< K
using Metres = Quantity<struct MetreTag>;                        ///< m
using Seconds = Quantity<struct SecondTag>;                      ///< s
using Angle = Quantity<struct RadianTag>;                        ///< rad
using Radiance = Quantity<struct RadianceTag>;                   ///< W m^-2 sr^-1
using SpectralRadiance = Quantity<struct RadiancePerUmTag>;      ///< W m^-2 sr^-1 um^-1
using SpectralIrradiance = Quantity<struct IrradiancePerUmTag>;  ///< W m^-2 um^-1

inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

[[nodiscard]] constexpr Angle degrees(double value_deg) {
  return Angle{value_deg * radians_per_degree};
}
[[nodiscard]] constexpr double to_degrees(Angle angle) {
  return angle.value * (180.0 / std::numbers::pi);
}

inline namespace literals {
constexpr Micrometres operator""_um(long double v) { return Micrometres{static_cast<double>(v)}; }
constexpr Kelvin operator""_K(long double v) { return Kelvin{static_cast<double>(v)}; }
constexpr Metres operator""_m(long double v) { return Metres{static_cast<double>(v)}; }
constexpr Seconds operator""_s(long double v) { return Seconds{static_cast<double>(v)}; }
constexpr Angle operator""_deg(long double v) { return degrees(static_cast<double>(v)); }
constexpr Angle operator""_rad(long double v) { return Angle{static_cast<double>(v)}; }
}  // namespace literals

}  // namespace nadir
