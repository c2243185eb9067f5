#pragma once
// Private to this folder: what the parts of SGP4 share.

#include <numbers>

namespace nadir::sensor::sgp4 {

/// WGS-72, the constants with which two-line elements are made. Lengths in earth radii, times in
/// minutes within the model. Source: AIAA 2006-6753, table 1.
namespace wgs72 {
inline constexpr double radius_km = 6378.135;
inline constexpr double mu_km3_s2 = 398600.8;
inline constexpr double j2 = 0.001082616;
inline constexpr double j3 = -0.00000253881;
inline constexpr double j4 = -0.00000165597;
}  // namespace wgs72

/// sqrt(mu), earth radii^1.5 per minute: 60 / sqrt(radius^3 / mu).
[[nodiscard]] double root_mu() noexcept;

inline constexpr double two_pi = 2.0 * std::numbers::pi;
inline constexpr double minutes_per_day = 1440.0;

/// An orbit by its elements, rad and rad/min.
struct Elements {
  double mean_motion = 0.0;
  double eccentricity = 0.0;
  double inclination = 0.0;
  double node = 0.0;
  double perigee = 0.0;  ///< argument of
  double mean_anomaly = 0.0;
};

/// How fast the angles drift, rad/min. `mean_anomaly` with the mean motion in it.
struct AngleRates {
  double mean_anomaly = 0.0, perigee = 0.0, node = 0.0;
};

/// The functions of the inclination that the short periods ask for.
struct InclinationTerms {
  double sine = 0.0, cosine = 0.0;
  double x3thm1 = 0.0;  ///< 3 cos^2 i - 1
  double x1mth2 = 0.0;  ///< 1 - cos^2 i
  double x7thm1 = 0.0;  ///< 7 cos^2 i - 1
};
[[nodiscard]] InclinationTerms inclination_terms(double inclination) noexcept;

}  // namespace nadir::sensor::sgp4
