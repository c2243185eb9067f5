#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "sensor/orbit/earth_frames.hpp"

namespace nadir::sensor {

/// Mean elements of a two-line element set, as they stand in it.
struct TwoLineElements {
  std::string designator;  ///< international, as 98067A; may be empty
  int catalogue_number = 0;
  int epoch_year = 2000;   ///< four digits
  double epoch_day = 1.0;  ///< of the year, UTC, 1.0 = 1 January 0 h
  double drag_term = 0.0;  ///< B*, per earth radius
  double inclination_deg = 0.0, ascending_node_deg = 0.0, eccentricity = 0.0;
  double argument_of_perigee_deg = 0.0, mean_anomaly_deg = 0.0;
  double mean_motion_rev_day = 0.0;
};

/// SGP4 cannot say where the satellite is: decayed, eccentricity out of range, ...
class PropagationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Where a satellite is by its two-line elements: SGP4/SDP4 with WGS-72 constants.
/// Accuracy: reproduces the verification set of the source to 1e-6 km.
/// Source: Vallado, Crawford, Hujsak, Kelso, "Revisiting Spacetrack Report #3", AIAA 2006-6753.
class Sgp4 {
 public:
  /// @throws PropagationError where the elements describe no orbit
  explicit Sgp4(const TwoLineElements& elements);
  ~Sgp4();
  Sgp4(Sgp4&&) noexcept;
  Sgp4& operator=(Sgp4&&) noexcept;

  /// @param minutes  after the epoch
  /// @return         TEME, km and km/s
  /// @throws PropagationError with what is wrong
  [[nodiscard]] StateVector teme_km(double minutes) const;
  [[nodiscard]] const ephemeris::Instant& epoch() const;

 private:
  struct Model;
  std::unique_ptr<const Model> model_;
};

/// The same at a moment, whose UT1 - UTC counts.
/// @return ECEF, m and m/s over the turning earth
/// @throws PropagationError as `teme_km`
[[nodiscard]] StateVector orbit_state(const Sgp4& orbit, const ephemeris::Instant& time);

}  // namespace nadir::sensor
