#include "sensor/orbit/sgp4_periodics.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "sensor/orbit/sgp4.hpp"

namespace nadir::sensor::sgp4 {
namespace {

/// The orbit in its plane by elements without a singularity at the circle: e cos w, e sin w and the
/// longitude from the node.
struct PlaneOrbit {
  double axis = 0.0;
  double axn = 0.0, ayn = 0.0;
  double longitude = 0.0;
};

PlaneOrbit with_long_periods(const Elements& mean, double axis, const InclinationTerms& terms) {
  constexpr double half_ratio = -0.5 * wgs72::j3 / wgs72::j2;
  constexpr double least = 1.5e-12;  // where the orbit is retrograde in the equator's plane
  const double divisor = std::abs(1.0 + terms.cosine) > least ? 1.0 + terms.cosine : least;
  const double per_p = 1.0 / (axis * (1.0 - mean.eccentricity * mean.eccentricity));
  PlaneOrbit orbit{axis, mean.eccentricity * std::cos(mean.perigee),
                   mean.eccentricity * std::sin(mean.perigee), mean.mean_anomaly + mean.perigee};
  orbit.longitude +=
      per_p * 0.5 * half_ratio * terms.sine * (3.0 + 5.0 * terms.cosine) / divisor * orbit.axn;
  orbit.ayn += per_p * half_ratio * terms.sine;
  return orbit;
}

/// U = F - axn sin F + ayn cos F solved for F = E + w by Newton's rule, its step held below 0.95.
double eccentric_longitude(const PlaneOrbit& orbit) {
  constexpr int most_steps = 10;  // those of the source; the last ones matter where e is near 1
  const double u = std::fmod(orbit.longitude, two_pi);
  double f = u;
  for (int i = 0; i < most_steps; ++i) {
    const double sine = std::sin(f), cosine = std::cos(f);
    const double step = (u - orbit.ayn * cosine + orbit.axn * sine - f) /
                        (1.0 - cosine * orbit.axn - sine * orbit.ayn);
    f += std::clamp(step, -0.95, 0.95);
    if (std::abs(step) < 1e-12) break;
  }
  return f;
}

/// Where in its plane and how fast, earth radii and earth radii per minute.
struct PlaneState {
  double radius = 0.0, radius_rate = 0.0;
  double latitude_argument = 0.0, transverse_rate = 0.0;
  double p = 0.0;  ///< semi-latus rectum
  double beta = 0.0;
};

PlaneState on_ellipse(const PlaneOrbit& orbit) {
  const double f = eccentric_longitude(orbit), sine = std::sin(f), cosine = std::cos(f);
  const double e_cos = orbit.axn * cosine + orbit.ayn * sine;
  const double e_sin = orbit.axn * sine - orbit.ayn * cosine;
  const double e2 = orbit.axn * orbit.axn + orbit.ayn * orbit.ayn;
  PlaneState state;
  state.p = orbit.axis * (1.0 - e2);
  if (state.p < 0.0) {
    throw PropagationError{"SGP4: the semi-latus rectum is negative, " + number_text(state.p) +
                           " earth radii: the elements describe no closed orbit there"};
  }
  state.radius = orbit.axis * (1.0 - e_cos);
  state.radius_rate = root_mu() * std::sqrt(orbit.axis) * e_sin / state.radius;
  state.transverse_rate = root_mu() * std::sqrt(state.p) / state.radius;
  state.beta = std::sqrt(1.0 - e2);
  const double share = e_sin / (1.0 + state.beta), scale = orbit.axis / state.radius;
  state.latitude_argument = std::atan2(scale * (sine - orbit.ayn - orbit.axn * share),
                                       scale * (cosine - orbit.axn + orbit.ayn * share));
  return state;
}

/// Unit vectors along the radius and the way, km and km/s.
StateVector in_space(const PlaneState& state, double node, double inclination) {
  const double su = std::sin(state.latitude_argument), cu = std::cos(state.latitude_argument);
  const double sn = std::sin(node), cn = std::cos(node);
  const double si = std::sin(inclination), ci = std::cos(inclination);
  const Vec3 towards_node{cn, sn, 0.0}, across{-sn * ci, cn * ci, si};
  const Vec3 out = cu * towards_node + su * across, along = -su * towards_node + cu * across;
  constexpr double km = wgs72::radius_km, km_s = wgs72::radius_km / 60.0;
  return {km * state.radius * out,
          km_s * (state.radius_rate * out + state.transverse_rate * along)};
}

}  // namespace

StateVector osculating_state(const Elements& mean, const InclinationTerms& terms) {
  const double n = mean.mean_motion, axis = std::pow(root_mu() / n, 2.0 / 3.0);
  PlaneState state = on_ellipse(with_long_periods(mean, axis, terms));

  const double sin_2u = std::sin(2.0 * state.latitude_argument);
  const double cos_2u = std::cos(2.0 * state.latitude_argument);
  const double first = 0.5 * wgs72::j2 / state.p, second = first / state.p;
  state.radius = state.radius * (1.0 - 1.5 * second * state.beta * terms.x3thm1) +
                 0.5 * first * terms.x1mth2 * cos_2u;
  state.latitude_argument -= 0.25 * second * terms.x7thm1 * sin_2u;
  state.radius_rate -= n * first * terms.x1mth2 * sin_2u;
  state.transverse_rate += n * first * (terms.x1mth2 * cos_2u + 1.5 * terms.x3thm1);
  const double node = mean.node + 1.5 * second * terms.cosine * sin_2u;
  const double inclination = mean.inclination + 1.5 * second * terms.cosine * terms.sine * cos_2u;
  if (state.radius < 1.0) {
    throw PropagationError{"SGP4: the satellite has decayed: it would be " +
                           number_text(std::round(state.radius * wgs72::radius_km)) +
                           " km from the earth's centre"};
  }
  return in_space(state, node, inclination);
}

}  // namespace nadir::sensor::sgp4
