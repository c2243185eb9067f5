#pragma once
// Private to this folder: what sun and moon do to an orbit of 225 minutes or longer.

#include <array>

#include "sensor/orbit/sgp4_elements.hpp"

namespace nadir::sensor::sgp4 {

/// Changes of the elements that a third body works, or their rates: `perigee_node` is that of the
/// argument of perigee plus cos i times `node`'s, `node` that of the node times sin i.
struct ThirdBodyChange {
  double eccentricity = 0.0, inclination = 0.0, mean_anomaly = 0.0;
  double perigee_node = 0.0, node = 0.0;
};

/// Secular and long-period perturbations by sun and moon on circular, regressing orbits.
/// Source: F. R. Hoots, P. W. Schumacher, R. A. Glover, "History of analytical orbit modeling in
/// the U.S. space surveillance system", J. Guid. Control Dyn. 27, 174 (2004), appendix;
/// Spacetrack Report 3, section 7. Names of the quantities (a, X, Z, s) as there.
class SunAndMoonPull {
 public:
  /// @param at_epoch        with Brouwer's mean motion
  /// @param days_from_1950  of the epoch, from 1949 December 31 0 h UTC
  SunAndMoonPull(const Elements& at_epoch, double days_from_1950) noexcept;

  /// Rates of the elements, per minute; the mean motion's is 0.
  [[nodiscard]] const Elements& rates() const noexcept { return rates_; }
  /// The elements with what sun and moon add at a moment. The inclination may come out negative.
  [[nodiscard]] Elements with_periods(const Elements& mean, double minutes) const noexcept;

 private:
  /// Amplitudes over the two functions of the body's true anomaly f, sin^2 f / 2 - 1/4 and
  /// -sin f cos f / 2, and over sin f.
  struct Amplitudes {
    double rate = 0.0, eccentricity = 0.0, anomaly = 0.0;  // of the body's own orbit
    ThirdBodyChange second, third;
    double mean_anomaly_first = 0.0, perigee_node_first = 0.0;
  };
  struct Body;
  struct Coupling;

  [[nodiscard]] static Coupling coupling(const Elements& orbit, const Body& body) noexcept;
  [[nodiscard]] static Amplitudes amplitudes(const Elements& orbit, const Body& body,
                                             const Coupling& c) noexcept;
  void add_rates(const Elements& orbit, const Body& body, const Coupling& c) noexcept;

  std::array<Amplitudes, 2> bodies_;
  Elements rates_;
};

}  // namespace nadir::sensor::sgp4
