#pragma once
// Private to this folder: SGP4's gravity and drag, which every orbit has.

#include "sensor/orbit/sgp4_elements.hpp"

namespace nadir::sensor::sgp4 {

/// Kozai's mean motion, as it stands in a two-line set, into Brouwer's, in which the theory is
/// written. Source: Hoots and Roehrich, Spacetrack Report 3 (1980), section 6, the first equations.
[[nodiscard]] Elements with_brouwer_motion(Elements kozai) noexcept;

/// Elements after the earth's zonal harmonics and, without its share of size and shape, drag.
struct Drifted {
  Elements elements;
  double axis_factor = 1.0;        ///< of the square root of the semi-major axis' factor
  double eccentricity_loss = 0.0;  ///< by drag
  double longitude_gain = 0.0;     ///< by drag, over the mean motion, min
};

/// Secular change by J2, J4 and J2^2, and by drag in a static atmosphere whose density falls with
/// the fourth power of the height over s.
/// Source: Spacetrack Report 3, section 6; names of the quantities as there.
class NearEarth {
 public:
  /// @param at_epoch   with Brouwer's mean motion
  /// @param drag_term  B*, per earth radius
  /// @param simple     drag with the lowest terms only, as for deep space; so too below 220 km
  NearEarth(const Elements& at_epoch, double drag_term, bool simple) noexcept;

  [[nodiscard]] Drifted at(double minutes) const noexcept;
  [[nodiscard]] const AngleRates& rates() const noexcept { return rates_; }

 private:
  /// The atmosphere's lower edge s and what of the orbit lies in it.
  struct Drag {
    double s = 0.0, xi = 0.0, eta = 0.0;
    double density = 0.0;   ///< (q0 - s)^4 xi^4
    double weighted = 0.0;  ///< the same / |1 - eta^2|^3.5
  };
  [[nodiscard]] static Drag drag_of(double perigee, double axis, double eccentricity) noexcept;
  void set_rates(double axis, const InclinationTerms& terms) noexcept;
  void set_drag(const Drag& drag, double axis, const InclinationTerms& terms) noexcept;
  void set_higher_drag(const Drag& drag, double axis) noexcept;

  Elements epoch_;
  AngleRates rates_;
  double drag_term_;
  bool simple_ = false;
  double eta_ = 0.0;
  double c1_ = 0.0, c4_ = 0.0, c5_ = 0.0;
  double d2_ = 0.0, d3_ = 0.0, d4_ = 0.0;
  double t3_ = 0.0, t4_ = 0.0, t5_ = 0.0;  // of the longitude's powers of time
  double node_drag_ = 0.0, perigee_drag_ = 0.0, anomaly_drag_ = 0.0;
};

}  // namespace nadir::sensor::sgp4
