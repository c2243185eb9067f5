#include "sensor/orbit/sgp4_sun_moon.hpp"

#include <cmath>

namespace nadir::sensor::sgp4 {

/// A third body on its orbit about the earth: how strongly it pulls, how it moves, how its orbit
/// lies. Angles against the equator; the node is counted from that of the satellite.
struct SunAndMoonPull::Body {
  double pull = 0.0;  ///< C, rad/min
  double rate = 0.0;  ///< of its mean anomaly, rad/min
  double eccentricity = 0.0;
  double anomaly = 0.0;  ///< mean, at the epoch
  double cos_g = 0.0, sin_g = 0.0, cos_i = 0.0, sin_i = 0.0, cos_h = 0.0, sin_h = 0.0;
};

/// How a body's orbit lies to the satellite's.
struct SunAndMoonPull::Coupling {
  double s1 = 0.0, s2 = 0.0, s3 = 0.0, s4 = 0.0, s5 = 0.0, s6 = 0.0, s7 = 0.0;
  double z1 = 0.0, z2 = 0.0, z3 = 0.0;
  double z11 = 0.0, z12 = 0.0, z13 = 0.0;
  double z21 = 0.0, z22 = 0.0, z23 = 0.0;
  double z31 = 0.0, z32 = 0.0, z33 = 0.0;
};

namespace {

/// Below 3 degrees, or as near to 180, the node's secular change by third bodies is left out.
constexpr double near_equator = 5.2359877e-2;
/// Below this inclination the periods are added by Lyddane's way, without dividing by sin i.
constexpr double lyddane_below = 0.2;

bool node_is_free(double inclination) {
  return inclination >= near_equator && inclination <= std::numbers::pi - near_equator;
}

/// Both changes together.
ThirdBodyChange sum(const ThirdBodyChange& a, const ThirdBodyChange& b) {
  return {a.eccentricity + b.eccentricity, a.inclination + b.inclination,
          a.mean_anomaly + b.mean_anomaly, a.perigee_node + b.perigee_node, a.node + b.node};
}
ThirdBodyChange scaled(const ThirdBodyChange& a, double s) {
  return {s * a.eccentricity, s * a.inclination, s * a.mean_anomaly, s * a.perigee_node,
          s * a.node};
}

/// Adds periods to node and perigee through sin i sin h and sin i cos h, which stay regular near
/// the equator (Lyddane, Astron. J. 68, 555, 1963).
/// @param orbit  inclination and mean anomaly are those with their periods
void add_by_lyddane(Elements& orbit, const ThirdBodyChange& change) {
  const double sine = std::sin(orbit.inclination), cosine = std::cos(orbit.inclination);
  const double sin_h = std::sin(orbit.node), cos_h = std::cos(orbit.node);
  const double alpha = sine * sin_h + change.node * cos_h + change.inclination * cosine * sin_h;
  const double beta = sine * cos_h - change.node * sin_h + change.inclination * cosine * cos_h;
  const double before = std::fmod(orbit.node, two_pi);
  // The sum M + w + cos i h, which has no singularity, tells the argument of perigee.
  const double regular = orbit.mean_anomaly + orbit.perigee + cosine * before +
                         change.perigee_node - change.inclination * before * sine;
  orbit.node = std::atan2(alpha, beta);
  if (std::abs(before - orbit.node) > std::numbers::pi) {
    orbit.node += orbit.node < before ? two_pi : -two_pi;
  }
  orbit.perigee = regular - orbit.mean_anomaly - cosine * orbit.node;
}

}  // namespace

SunAndMoonPull::SunAndMoonPull(const Elements& at_epoch, double days_from_1950) noexcept {
  const double day = days_from_1950 + 18261.5;  // from 1900 January 0, 12 h
  const double sin_node = std::sin(at_epoch.node), cos_node = std::cos(at_epoch.node);

  const Body sun{
      2.9864797e-6, 1.19459e-5,  0.01675,    std::fmod(6.2565837 + 0.017201977 * day, two_pi),
      0.1945905,    -0.98088458, 0.91744867, 0.39785416,
      cos_node,     sin_node};

  // The moon's orbit regresses on the ecliptic: its inclination, node and perigee to the equator.
  const double node = std::fmod(4.5236020 - 9.2422029e-4 * day, two_pi);
  const double cos_i = 0.91375164 - 0.03568096 * std::cos(node);
  const double sin_i = std::sqrt(1.0 - cos_i * cos_i);
  const double sin_h = 0.089683511 * std::sin(node) / sin_i;
  const double cos_h = std::sqrt(1.0 - sin_h * sin_h);
  const double longitude = 5.8351514 + 0.0019443680 * day;  // of the perigee
  const double x = cos_h * std::cos(node) + 0.91744867 * sin_h * std::sin(node);
  const double g = longitude - node + std::atan2(0.39785416 * std::sin(node) / sin_i, x);
  const Body moon{4.7968065e-7,
                  1.5835218e-4,
                  0.05490,
                  std::fmod(4.7199672 + 0.22997150 * day - longitude, two_pi),
                  std::cos(g),
                  std::sin(g),
                  cos_i,
                  sin_i,
                  cos_h * cos_node + sin_h * sin_node,
                  cos_h * sin_node - sin_h * cos_node};

  const std::array<Body, 2> both{sun, moon};
  for (std::size_t i = 0; i < both.size(); ++i) {
    const Coupling c = coupling(at_epoch, both[i]);
    bodies_[i] = amplitudes(at_epoch, both[i], c);
    add_rates(at_epoch, both[i], c);
  }
}

SunAndMoonPull::Coupling SunAndMoonPull::coupling(const Elements& orbit, const Body& b) noexcept {
  const double ci = std::cos(orbit.inclination), si = std::sin(orbit.inclination);
  const double cw = std::cos(orbit.perigee), sw = std::sin(orbit.perigee);
  const double e = orbit.eccentricity, e2 = e * e, beta2 = 1.0 - e2;
  const double a1 = b.cos_g * b.cos_h + b.sin_g * b.cos_i * b.sin_h;
  const double a3 = -b.sin_g * b.cos_h + b.cos_g * b.cos_i * b.sin_h;
  const double a7 = -b.cos_g * b.sin_h + b.sin_g * b.cos_i * b.cos_h;
  const double a8 = b.sin_g * b.sin_i;
  const double a9 = b.sin_g * b.sin_h + b.cos_g * b.cos_i * b.cos_h;
  const double a10 = b.cos_g * b.sin_i;
  const double a2 = ci * a7 + si * a8, a4 = ci * a9 + si * a10;
  const double a5 = -si * a7 + ci * a8, a6 = -si * a9 + ci * a10;
  const double x1 = a1 * cw + a2 * sw, x2 = a3 * cw + a4 * sw;
  const double x3 = -a1 * sw + a2 * cw, x4 = -a3 * sw + a4 * cw;
  const double x5 = a5 * sw, x6 = a6 * sw, x7 = a5 * cw, x8 = a6 * cw;

  Coupling c;
  c.z31 = 12.0 * x1 * x1 - 3.0 * x3 * x3;
  c.z32 = 24.0 * x1 * x2 - 6.0 * x3 * x4;
  c.z33 = 12.0 * x2 * x2 - 3.0 * x4 * x4;
  c.z11 = -6.0 * a1 * a5 + e2 * (-24.0 * x1 * x7 - 6.0 * x3 * x5);
  c.z12 =
      -6.0 * (a1 * a6 + a3 * a5) + e2 * (-24.0 * (x2 * x7 + x1 * x8) - 6.0 * (x3 * x6 + x4 * x5));
  c.z13 = -6.0 * a3 * a6 + e2 * (-24.0 * x2 * x8 - 6.0 * x4 * x6);
  c.z21 = 6.0 * a2 * a5 + e2 * (24.0 * x1 * x5 - 6.0 * x3 * x7);
  c.z22 = 6.0 * (a4 * a5 + a2 * a6) + e2 * (24.0 * (x2 * x5 + x1 * x6) - 6.0 * (x4 * x7 + x3 * x8));
  c.z23 = 6.0 * a4 * a6 + e2 * (24.0 * x2 * x6 - 6.0 * x4 * x8);
  c.z1 = 6.0 * (a1 * a1 + a2 * a2) + (1.0 + e2) * c.z31;
  c.z2 = 12.0 * (a1 * a3 + a2 * a4) + (1.0 + e2) * c.z32;
  c.z3 = 6.0 * (a3 * a3 + a4 * a4) + (1.0 + e2) * c.z33;
  c.s3 = b.pull / orbit.mean_motion;
  c.s2 = -0.5 * c.s3 / std::sqrt(beta2);
  c.s4 = c.s3 * std::sqrt(beta2);
  c.s1 = -15.0 * e * c.s4;
  c.s5 = x1 * x3 + x2 * x4;
  c.s6 = x2 * x3 + x1 * x4;
  c.s7 = x2 * x4 - x1 * x3;
  return c;
}

SunAndMoonPull::Amplitudes SunAndMoonPull::amplitudes(const Elements& orbit, const Body& body,
                                                      const Coupling& c) noexcept {
  const double e2 = orbit.eccentricity * orbit.eccentricity;
  Amplitudes a;
  a.rate = body.rate;
  a.eccentricity = body.eccentricity;
  a.anomaly = body.anomaly;
  a.second = {2.0 * c.s1 * c.s6, 2.0 * c.s2 * c.z12, -2.0 * c.s3 * c.z2, 2.0 * c.s4 * c.z32,
              -2.0 * c.s2 * c.z22};
  a.third = {2.0 * c.s1 * c.s7, 2.0 * c.s2 * (c.z13 - c.z11), -2.0 * c.s3 * (c.z3 - c.z1),
             2.0 * c.s4 * (c.z33 - c.z31), -2.0 * c.s2 * (c.z23 - c.z21)};
  a.mean_anomaly_first = -2.0 * c.s3 * (-21.0 - 9.0 * e2) * body.eccentricity;
  a.perigee_node_first = -18.0 * c.s4 * body.eccentricity;
  return a;
}

void SunAndMoonPull::add_rates(const Elements& orbit, const Body& body,
                               const Coupling& c) noexcept {
  const double e2 = orbit.eccentricity * orbit.eccentricity, n = body.rate;
  rates_.eccentricity += c.s1 * n * c.s5;
  rates_.inclination += c.s2 * n * (c.z11 + c.z13);
  rates_.mean_anomaly -= n * c.s3 * (c.z1 + c.z3 - 14.0 - 6.0 * e2);
  rates_.perigee += c.s4 * n * (c.z31 + c.z33 - 6.0);
  if (!node_is_free(orbit.inclination)) return;
  const double node = -n * c.s2 * (c.z21 + c.z23) / std::sin(orbit.inclination);
  rates_.node += node;
  rates_.perigee -= std::cos(orbit.inclination) * node;
}

Elements SunAndMoonPull::with_periods(const Elements& mean, double minutes) const noexcept {
  ThirdBodyChange change;
  for (const Amplitudes& body : bodies_) {
    const double anomaly = body.anomaly + body.rate * minutes;
    const double f = anomaly + 2.0 * body.eccentricity * std::sin(anomaly), sine = std::sin(f);
    change = sum(change, scaled(body.second, 0.5 * sine * sine - 0.25));
    change = sum(change, scaled(body.third, -0.5 * sine * std::cos(f)));
    change.mean_anomaly += body.mean_anomaly_first * sine;
    change.perigee_node += body.perigee_node_first * sine;
  }
  Elements now = mean;
  now.eccentricity += change.eccentricity;
  now.inclination += change.inclination;
  now.mean_anomaly += change.mean_anomaly;
  if (now.inclination < lyddane_below) {
    add_by_lyddane(now, change);
    return now;
  }
  const double node = change.node / std::sin(now.inclination);
  now.node += node;
  now.perigee += change.perigee_node - std::cos(now.inclination) * node;
  return now;
}

}  // namespace nadir::sensor::sgp4
