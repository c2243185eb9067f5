#include "sensor/orbit/sgp4_near_earth.hpp"

#include <cmath>

namespace nadir::sensor::sgp4 {
namespace {

constexpr double j3_over_j2 = wgs72::j3 / wgs72::j2;
/// Below this eccentricity the terms that divide by it are left out (AIAA 2006-6753, section IV).
constexpr double nearly_circular = 1e-4;

double to_radii(double height_km) { return height_km / wgs72::radius_km; }
double fourth_power(double x) { return x * x * x * x; }

}  // namespace

double root_mu() noexcept {
  static const double value =
      60.0 / std::sqrt(wgs72::radius_km * wgs72::radius_km * wgs72::radius_km / wgs72::mu_km3_s2);
  return value;
}

InclinationTerms inclination_terms(double inclination) noexcept {
  const double cosine = std::cos(inclination), squared = cosine * cosine;
  return {std::sin(inclination), cosine, 3.0 * squared - 1.0, 1.0 - squared, 7.0 * squared - 1.0};
}

Elements with_brouwer_motion(Elements kozai) noexcept {
  const double cosine = std::cos(kozai.inclination);
  const double beta2 = 1.0 - kozai.eccentricity * kozai.eccentricity;
  const double oblateness =
      0.75 * wgs72::j2 * (3.0 * cosine * cosine - 1.0) / (std::sqrt(beta2) * beta2);
  const double a1 = std::pow(root_mu() / kozai.mean_motion, 2.0 / 3.0);
  const double d1 = oblateness / (a1 * a1);
  const double a0 = a1 * (1.0 - d1 * d1 - d1 * (1.0 / 3.0 + 134.0 * d1 * d1 / 81.0));
  kozai.mean_motion /= 1.0 + oblateness / (a0 * a0);
  return kozai;
}

NearEarth::NearEarth(const Elements& at_epoch, double drag_term, bool simple) noexcept
    : epoch_{at_epoch}, drag_term_{drag_term} {
  const double axis = std::pow(root_mu() / epoch_.mean_motion, 2.0 / 3.0);
  const double perigee = axis * (1.0 - epoch_.eccentricity);
  const InclinationTerms terms = inclination_terms(epoch_.inclination);
  const Drag drag = drag_of(perigee, axis, epoch_.eccentricity);
  simple_ = simple || perigee < 1.0 + to_radii(220.0);
  set_rates(axis, terms);
  set_drag(drag, axis, terms);
  if (!simple_) set_higher_drag(drag, axis);
}

// The edge lies 78 km high, lower for perigees below 156 km, but never below 20 km.
NearEarth::Drag NearEarth::drag_of(double perigee, double axis, double eccentricity) noexcept {
  const double perigee_km = (perigee - 1.0) * wgs72::radius_km;
  double edge_km = 78.0;
  if (perigee_km < 156.0) edge_km = perigee_km < 98.0 ? 20.0 : perigee_km - 78.0;
  Drag drag;
  drag.s = 1.0 + to_radii(edge_km);
  drag.xi = 1.0 / (axis - drag.s);
  drag.eta = axis * eccentricity * drag.xi;
  drag.density = fourth_power(to_radii(120.0 - edge_km)) * fourth_power(drag.xi);
  drag.weighted = drag.density / std::pow(std::abs(1.0 - drag.eta * drag.eta), 3.5);
  return drag;
}

void NearEarth::set_rates(double axis, const InclinationTerms& terms) noexcept {
  const double beta2 = 1.0 - epoch_.eccentricity * epoch_.eccentricity;
  const double per_p2 = 1.0 / (axis * beta2 * axis * beta2), n = epoch_.mean_motion;
  const double theta2 = terms.cosine * terms.cosine, theta4 = theta2 * theta2;
  const double first = 1.5 * wgs72::j2 * per_p2 * n;
  const double second = 0.5 * first * wgs72::j2 * per_p2;
  const double fourth = -0.46875 * wgs72::j4 * per_p2 * per_p2 * n;
  rates_.mean_anomaly =
      n + 0.5 * first * std::sqrt(beta2) * terms.x3thm1 +
      0.0625 * second * std::sqrt(beta2) * (13.0 - 78.0 * theta2 + 137.0 * theta4);
  rates_.perigee = -0.5 * first * (1.0 - 5.0 * theta2) +
                   0.0625 * second * (7.0 - 114.0 * theta2 + 395.0 * theta4) +
                   fourth * (3.0 - 36.0 * theta2 + 49.0 * theta4);
  rates_.node = terms.cosine * (-first + 0.5 * second * (4.0 - 19.0 * theta2) +
                                2.0 * fourth * (3.0 - 7.0 * theta2));
}

void NearEarth::set_drag(const Drag& drag, double axis, const InclinationTerms& terms) noexcept {
  const double e = epoch_.eccentricity, n = epoch_.mean_motion, beta2 = 1.0 - e * e;
  const double eta = drag.eta, eta2 = eta * eta, e_eta = e * eta, psi2 = std::abs(1.0 - eta2);
  eta_ = eta;
  const double c2 =
      drag.weighted * n *
      (axis * (1.0 + 1.5 * eta2 + e_eta * (4.0 + eta2)) +
       0.375 * wgs72::j2 * drag.xi / psi2 * terms.x3thm1 * (8.0 + 3.0 * eta2 * (8.0 + eta2)));
  c1_ = drag_term_ * c2;
  const double oblate =
      -3.0 * terms.x3thm1 * (1.0 - 2.0 * e_eta + eta2 * (1.5 - 0.5 * e_eta)) +
      0.75 * terms.x1mth2 * (2.0 * eta2 - e_eta * (1.0 + eta2)) * std::cos(2.0 * epoch_.perigee);
  c4_ = 2.0 * n * drag.weighted * axis * beta2 *
        (eta * (2.0 + 0.5 * eta2) + e * (0.5 + 2.0 * eta2) -
         wgs72::j2 * drag.xi / (axis * psi2) * oblate);
  c5_ = 2.0 * drag.weighted * axis * beta2 * (1.0 + 2.75 * (eta2 + e_eta) + e_eta * eta2);
  const double per_p2 = 1.0 / (axis * beta2 * axis * beta2);
  node_drag_ = -5.25 * beta2 * wgs72::j2 * per_p2 * n * terms.cosine * c1_;
  if (e <= nearly_circular) return;
  const double c3 = -2.0 * drag.density * drag.xi * j3_over_j2 * n * terms.sine / e;
  perigee_drag_ = drag_term_ * c3 * std::cos(epoch_.perigee);
  anomaly_drag_ = -2.0 / 3.0 * drag.density * drag_term_ / e_eta;
}

void NearEarth::set_higher_drag(const Drag& drag, double axis) noexcept {
  const double c1_squared = c1_ * c1_;
  d2_ = 4.0 * axis * drag.xi * c1_squared;
  const double third = d2_ * drag.xi * c1_ / 3.0;
  d3_ = (17.0 * axis + drag.s) * third;
  d4_ = 0.5 * third * axis * drag.xi * (221.0 * axis + 31.0 * drag.s) * c1_;
  t3_ = d2_ + 2.0 * c1_squared;
  t4_ = 0.25 * (3.0 * d3_ + c1_ * (12.0 * d2_ + 10.0 * c1_squared));
  t5_ = 0.2 * (3.0 * d4_ + 12.0 * c1_ * d3_ + 6.0 * d2_ * d2_ +
               15.0 * c1_squared * (2.0 * d2_ + c1_squared));
}

Drifted NearEarth::at(double t) const noexcept {
  Drifted now{epoch_, 1.0 - c1_ * t, drag_term_ * c4_ * t, 1.5 * c1_ * t * t};
  now.elements.mean_anomaly += rates_.mean_anomaly * t;
  now.elements.perigee += rates_.perigee * t;
  now.elements.node += rates_.node * t + node_drag_ * t * t;
  if (simple_) return now;
  const auto swell = [&](double anomaly) {
    const double base = 1.0 + eta_ * std::cos(anomaly);
    return base * base * base;
  };
  const double shift = perigee_drag_ * t + anomaly_drag_ * (swell(now.elements.mean_anomaly) -
                                                            swell(epoch_.mean_anomaly));
  now.elements.mean_anomaly += shift;
  now.elements.perigee -= shift;
  now.axis_factor -= t * t * (d2_ + t * (d3_ + t * d4_));
  now.eccentricity_loss +=
      drag_term_ * c5_ * (std::sin(now.elements.mean_anomaly) - std::sin(epoch_.mean_anomaly));
  now.longitude_gain += t * t * t * (t3_ + t * (t4_ + t * t5_));
  return now;
}

}  // namespace nadir::sensor::sgp4
