#include "sensor/orbit/sgp4_resonance.hpp"

#include <cmath>

namespace nadir::sensor::sgp4 {
namespace {

constexpr double earth_rate_rad_min = 4.37526908801129966e-3;

/// a + b e + c e^2 + d e^3.
struct Cubic {
  double a, b, c, d;
  [[nodiscard]] double at(double e) const { return a + e * (b + e * (c + e * d)); }
};

/// Hansen coefficients G_lpq(e) of the 12 h terms, fitted in e, which is 0.5 at least.
struct Eccentricities {
  double g201, g211, g310, g322, g410, g422, g520, g521, g532, g533;
};

Eccentricities eccentricity_functions(double e) {
  Eccentricities g{};
  g.g201 = -0.306 - (e - 0.64) * 0.440;
  if (e <= 0.65) {
    g.g211 = Cubic{3.616, -13.2470, 16.2900, 0.0}.at(e);
    g.g310 = Cubic{-19.302, 117.3900, -228.4190, 156.5910}.at(e);
    g.g322 = Cubic{-18.9068, 109.7927, -214.6334, 146.5816}.at(e);
    g.g410 = Cubic{-41.122, 242.6940, -471.0940, 313.9530}.at(e);
    g.g422 = Cubic{-146.407, 841.8800, -1629.014, 1083.4350}.at(e);
    g.g520 = Cubic{-532.114, 3017.977, -5740.032, 3708.2760}.at(e);
  } else {
    g.g211 = Cubic{-72.099, 331.819, -508.738, 266.724}.at(e);
    g.g310 = Cubic{-346.844, 1582.851, -2415.925, 1246.113}.at(e);
    g.g322 = Cubic{-342.585, 1554.908, -2366.899, 1215.972}.at(e);
    g.g410 = Cubic{-1052.797, 4758.686, -7193.992, 3651.957}.at(e);
    g.g422 = Cubic{-3581.690, 16178.110, -24462.770, 12422.520}.at(e);
    g.g520 = e > 0.715 ? Cubic{-5149.66, 29936.92, -54087.36, 31324.56}.at(e)
                       : Cubic{1464.74, -4664.75, 3763.64, 0.0}.at(e);
  }
  if (e < 0.7) {
    g.g533 = Cubic{-919.22770, 4988.6100, -9064.7700, 5542.21}.at(e);
    g.g521 = Cubic{-822.71072, 4568.6173, -8491.4146, 5337.524}.at(e);
    g.g532 = Cubic{-853.66600, 4690.2500, -8624.7700, 5341.4}.at(e);
  } else {
    g.g533 = Cubic{-37995.780, 161616.52, -229838.20, 109377.94}.at(e);
    g.g521 = Cubic{-51752.104, 218913.95, -309468.16, 146349.42}.at(e);
    g.g532 = Cubic{-40023.880, 170470.89, -242699.48, 115605.82}.at(e);
  }
  return g;
}

/// Inclination functions F_lmp(i) of the 12 h terms.
struct Inclinations {
  double f220, f221, f321, f322, f441, f442, f522, f523, f542, f543;
};

Inclinations inclination_functions(double inclination) {
  const double s = std::sin(inclination), c = std::cos(inclination), s2 = s * s, c2 = c * c;
  Inclinations f{};
  f.f220 = 0.75 * (1.0 + 2.0 * c + c2);
  f.f221 = 1.5 * s2;
  f.f321 = 1.875 * s * (1.0 - 2.0 * c - 3.0 * c2);
  f.f322 = -1.875 * s * (1.0 + 2.0 * c - 3.0 * c2);
  f.f441 = 35.0 * s2 * f.f220;
  f.f442 = 39.3750 * s2 * s2;
  f.f522 =
      9.84375 * s * (s2 * (1.0 - 2.0 * c - 5.0 * c2) + 0.33333333 * (-2.0 + 4.0 * c + 6.0 * c2));
  f.f523 = s * (4.92187512 * s2 * (-2.0 - 4.0 * c + 10.0 * c2) +
                6.56250012 * (1.0 + 2.0 * c - 3.0 * c2));
  f.f542 = 29.53125 * s * (2.0 - 8.0 * c + c2 * (-12.0 + 8.0 * c + 10.0 * c2));
  f.f543 = 29.53125 * s * (-2.0 - 8.0 * c + c2 * (12.0 + 8.0 * c - 10.0 * c2));
  return f;
}

}  // namespace

Resonance::Resonance(const Orbit& orbit) noexcept {
  const double n = orbit.at_epoch.mean_motion;
  start_.mean_motion = n;
  perigee_ = orbit.at_epoch.perigee;
  perigee_rate_ = orbit.zonal.perigee;
  sidereal_angle_ = orbit.sidereal_angle;
  if (n > 0.0034906585 && n < 0.0052359877) {
    set_one_day(orbit);
  } else if (n >= 8.26e-3 && n <= 9.24e-3 && orbit.at_epoch.eccentricity >= 0.5) {
    set_half_day(orbit);
  }
}

void Resonance::set_one_day(const Orbit& orbit) noexcept {
  constexpr double q22 = 1.7891679e-6, q31 = 2.1460748e-6, q33 = 2.2123015e-7;
  const Elements& o = orbit.at_epoch;
  const double e2 = o.eccentricity * o.eccentricity;
  const double c = std::cos(o.inclination), s = std::sin(o.inclination), plus = 1.0 + c;
  const double g200 = 1.0 + e2 * (-2.5 + 0.8125 * e2), g310 = 1.0 + 2.0 * e2;
  const double g300 = 1.0 + e2 * (-6.0 + 6.60937 * e2);
  const double f220 = 0.75 * plus * plus;
  const double f311 = 0.9375 * s * s * (1.0 + 3.0 * c) - 0.75 * plus;
  const double f330 = 1.875 * plus * plus * plus;
  const double per_a = std::pow(o.mean_motion / root_mu(), 2.0 / 3.0);
  const double common = 3.0 * o.mean_motion * o.mean_motion * per_a * per_a;

  kind_ = Kind::one_day;
  terms_[0] = {common * f311 * g310 * q31 * per_a, 0.13130908, 0, 1};
  terms_[1] = {2.0 * common * f220 * g200 * q22, 2.0 * 2.8843198, 0, 2};
  terms_[2] = {3.0 * common * f330 * g300 * q33 * per_a, 3.0 * 0.37448087, 0, 3};
  start_.longitude = std::fmod(o.mean_anomaly + o.node + o.perigee - orbit.sidereal_angle, two_pi);
  const Elements& pull = orbit.third_body;
  drift_ = orbit.zonal.mean_anomaly + orbit.zonal.perigee + orbit.zonal.node - earth_rate_rad_min +
           pull.mean_anomaly + pull.perigee + pull.node - o.mean_motion;
}

void Resonance::set_half_day(const Orbit& orbit) noexcept {
  constexpr double root22 = 1.7891679e-6, root32 = 3.7393792e-7, root44 = 7.3636953e-9;
  constexpr double root52 = 1.1428639e-7, root54 = 2.1765803e-9;
  constexpr double phase22 = 5.7686396, phase32 = 0.95240898, phase44 = 1.8014998;
  constexpr double phase52 = 1.0508330, phase54 = 4.4108898;
  const Elements& o = orbit.at_epoch;
  const Eccentricities g = eccentricity_functions(o.eccentricity);
  const Inclinations f = inclination_functions(o.inclination);
  const double per_a = std::pow(o.mean_motion / root_mu(), 2.0 / 3.0);
  const double degree2 = 3.0 * o.mean_motion * o.mean_motion * per_a * per_a;
  const double degree3 = degree2 * per_a, degree4 = degree3 * per_a, degree5 = degree4 * per_a;

  kind_ = Kind::half_day;
  terms_ = {Term{degree2 * root22 * f.f220 * g.g201, phase22, 2, 1},
            Term{degree2 * root22 * f.f221 * g.g211, phase22, 0, 1},
            Term{degree3 * root32 * f.f321 * g.g310, phase32, 1, 1},
            Term{degree3 * root32 * f.f322 * g.g322, phase32, -1, 1},
            Term{2.0 * degree4 * root44 * f.f441 * g.g410, phase44, 2, 2},
            Term{2.0 * degree4 * root44 * f.f442 * g.g422, phase44, 0, 2},
            Term{degree5 * root52 * f.f522 * g.g520, phase52, 1, 1},
            Term{degree5 * root52 * f.f523 * g.g532, phase52, -1, 1},
            Term{2.0 * degree5 * root54 * f.f542 * g.g521, phase54, 1, 2},
            Term{2.0 * degree5 * root54 * f.f543 * g.g533, phase54, -1, 2}};
  start_.longitude = std::fmod(o.mean_anomaly + 2.0 * (o.node - orbit.sidereal_angle), two_pi);
  drift_ = orbit.zonal.mean_anomaly + orbit.third_body.mean_anomaly +
           2.0 * (orbit.zonal.node + orbit.third_body.node - earth_rate_rad_min) - o.mean_motion;
}

Resonance::Slope Resonance::slope(const State& state, double minutes) const noexcept {
  const double perigee = perigee_ + perigee_rate_ * minutes;
  Slope result{state.mean_motion + drift_, 0.0, 0.0};
  for (const Term& term : terms_) {
    const double angle = term.perigees * perigee + term.longitudes * state.longitude - term.phase;
    result.mean_motion += term.amplitude * std::sin(angle);
    result.mean_motion_bend += term.longitudes * term.amplitude * std::cos(angle);
  }
  result.mean_motion_bend *= result.longitude;
  return result;
}

Elements Resonance::applied(const Elements& secular, double minutes) const noexcept {
  if (kind_ == Kind::none) return secular;
  const auto moved = [](const State& from, const Slope& by, double t) {
    return State{from.longitude + t * (by.longitude + 0.5 * t * by.mean_motion),
                 from.mean_motion + t * (by.mean_motion + 0.5 * t * by.mean_motion_bend)};
  };
  const double step = minutes < 0.0 ? -720.0 : 720.0;
  State state = start_;
  double time = 0.0;
  Slope slope_now = slope(state, time);
  while (std::abs(minutes - time) >= 720.0) {
    state = moved(state, slope_now, step);
    time += step;
    slope_now = slope(state, time);
  }
  state = moved(state, slope_now, minutes - time);

  const double turned = std::fmod(sidereal_angle_ + minutes * earth_rate_rad_min, two_pi);
  Elements now = secular;
  now.mean_motion = state.mean_motion;
  now.mean_anomaly = kind_ == Kind::one_day
                         ? state.longitude - secular.node - secular.perigee + turned
                         : state.longitude - 2.0 * secular.node + 2.0 * turned;
  return now;
}

}  // namespace nadir::sensor::sgp4
