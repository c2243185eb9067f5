#pragma once
// Private to this folder: orbits that see the same side of the earth again and again.

#include <array>

#include "sensor/orbit/sgp4_elements.hpp"

namespace nadir::sensor::sgp4 {

/// An orbit of 24 h, or an eccentric one of 12 h, whose period the tesseral harmonics pull about.
/// Mean motion and resonant longitude are integrated in steps of 720 min from the epoch by a series
/// of second order.
/// Source: Hoots, Schumacher and Glover (2004), appendix; Spacetrack Report 3, section 7.
class Resonance {
 public:
  struct Orbit {
    Elements at_epoch;            ///< with Brouwer's mean motion
    AngleRates zonal;             ///< drift by J2 and J4
    Elements third_body;          ///< drift by sun and moon
    double sidereal_angle = 0.0;  ///< Greenwich mean sidereal time at the epoch
  };
  /// Where the orbit is not in resonance it does nothing.
  explicit Resonance(const Orbit& orbit) noexcept;

  /// Mean motion and mean anomaly of a moment.
  /// @param secular  all elements with their secular change until then
  [[nodiscard]] Elements applied(const Elements& secular, double minutes) const noexcept;

 private:
  enum class Kind { none, one_day, half_day };
  /// amplitude sin(perigees w + longitudes lambda - phase)
  struct Term {
    double amplitude = 0.0, phase = 0.0;
    int perigees = 0, longitudes = 1;
  };
  struct State {
    double longitude = 0.0, mean_motion = 0.0;
  };
  struct Slope {
    double longitude = 0.0, mean_motion = 0.0, mean_motion_bend = 0.0;
  };
  void set_one_day(const Orbit& orbit) noexcept;
  void set_half_day(const Orbit& orbit) noexcept;
  [[nodiscard]] Slope slope(const State& state, double minutes) const noexcept;

  Kind kind_ = Kind::none;
  std::array<Term, 10> terms_;
  State start_;
  double drift_ = 0.0;  // of the resonant longitude over the mean motion
  double perigee_ = 0.0, perigee_rate_ = 0.0;
  double sidereal_angle_ = 0.0;
};

}  // namespace nadir::sensor::sgp4
