#include "ephemeris/rise_set.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::ephemeris {
namespace {

constexpr double day_s = 86400.0;
constexpr int steps = 144;  // ten minutes: the moon moves 2.5 degrees
constexpr double step_s = day_s / steps;
constexpr double search_s = 0.01;

const BodyPosition& of(const SunAndMoon& seen, SkyBody body) {
  return body == SkyBody::sun ? seen.sun : seen.moon;
}

double rise_height(const SunAndMoon& seen, SkyBody body) {
  constexpr Angle horizontal_refraction = degrees(34.0 / 60.0), sun_radius = degrees(16.0 / 60.0);
  const BodyPosition& position = of(seen, body);
  const Angle radius = body == SkyBody::sun ? sun_radius : position.angular_radius;
  return (position.elevation + horizontal_refraction + radius).value;
}

// West positive. Of a topocentric direction: parallax acts within the meridian's plane there.
double hour_angle(const BodyPosition& body, const Site& site) {
  const double latitude = degrees(site.latitude_deg).value;
  const Vec3 v = body.direction_enu;
  return std::atan2(-v.x, v.z * std::cos(latitude) - v.y * std::sin(latitude));
}

struct Bracket {
  double a, b;    // seconds
  double fa, fb;  // of different sign
};

// Illinois' false position: where the same end stays twice, its value counts half.
template <class F>
double root(F&& f, Bracket r) {
  for (int round = 0; round < 100; ++round) {
    const double t = r.b - r.fb * (r.b - r.a) / (r.fb - r.fa);
    const double value = f(t), moved = std::abs(t - r.b);
    if ((value > 0.0) != (r.fb > 0.0)) {
      r.a = r.b;
      r.fa = r.fb;
    } else {
      r.fa *= 0.5;
    }
    r.b = t;
    r.fb = value;
    if (value == 0.0 || moved < 0.1 * search_s || std::abs(r.b - r.a) < search_s) break;
  }
  return r.b;
}

// The extreme nearest to 0 of f within [a, b], by golden section; sign = +1 looks for a maximum.
template <class F>
double extreme(F&& f, double a, double b, double sign) {
  constexpr double golden = 0.3819660112501051;
  double x = a + golden * (b - a), y = b - golden * (b - a), fx = sign * f(x), fy = sign * f(y);
  while (b - a > 0.5) {
    if (fx > fy) {
      b = y;
      y = x;
      fy = fx;
      x = a + golden * (b - a);
      fx = sign * f(x);
    } else {
      a = x;
      x = y;
      fx = fy;
      y = b - golden * (b - a);
      fy = sign * f(y);
    }
  }
  return 0.5 * (a + b);
}

}  // namespace

SkyDay::SkyDay(const Instant& start, const Site& site)
    : start_{start},
      site_{checked(site)},
      pole_{celestial_pole((start + Seconds{0.5 * day_s}).tt())} {
  samples_.reserve(steps + 1);
  for (int i = 0; i <= steps; ++i) samples_.push_back(at(i * step_s));
}

SunAndMoon SkyDay::at(double second) const {
  return sun_and_moon(start_ + Seconds{second}, site_, {}, pole_);
}

template <class Height>
std::vector<double> SkyDay::roots(Height&& height) const {
  const auto f = [&](double second) { return height(at(second)); };
  std::vector<double> values, found;
  for (const SunAndMoon& sample : samples_) values.push_back(height(sample));
  for (int i = 0; i < steps; ++i) {
    const double a = i * step_s, b = a + step_s;
    const double fa = values[static_cast<std::size_t>(i)];
    const double fb = values[static_cast<std::size_t>(i) + 1];
    if ((fa > 0.0) != (fb > 0.0)) {
      found.push_back(root(f, {a, b, fa, fb}));
      continue;
    }
    // Both ends on one side: the body may touch the height between them, if it turns there, which
    // the neighbours tell, and if it comes near: 2.5 degrees at most in a step, with room to spare.
    constexpr double near = 0.06;
    if (std::min(std::abs(fa), std::abs(fb)) > near) continue;
    const double sign = fa > 0.0 ? -1.0 : 1.0;
    if (sign * f(a + 0.5) <= sign * fa || sign * f(b - 0.5) <= sign * fb) continue;
    const double turn = extreme(f, a, b, sign);
    const double ft = f(turn);
    if ((ft > 0.0) == (fa > 0.0)) continue;
    found.push_back(root(f, {a, turn, fa, ft}));
    found.push_back(root(f, {turn, b, ft, fb}));
  }
  return found;
}

template <class Height>
Crossings SkyDay::crossings(SkyBody body, Height&& height) const {
  Crossings result;
  result.above_at_start = height(samples_.front()) > 0.0;
  bool above = result.above_at_start;
  for (const double second : roots(height)) {
    above = !above;
    result.events.push_back({start_ + Seconds{second}, above, of(at(second), body).azimuth});
  }
  return result;
}

Crossings SkyDay::rise_and_set(SkyBody body) const {
  return crossings(body, [body](const SunAndMoon& seen) { return rise_height(seen, body); });
}

Crossings SkyDay::sun_through(Angle elevation) const {
  return crossings(SkyBody::sun, [elevation](const SunAndMoon& seen) {
    return (seen.sun.elevation - elevation).value;
  });
}

std::vector<Transit> SkyDay::transits(SkyBody body) const {
  std::vector<Transit> result;
  const auto angle = [&](const SunAndMoon& seen) { return hour_angle(of(seen, body), site_); };
  for (int i = 0; i < steps; ++i) {
    const double fa = angle(samples_[static_cast<std::size_t>(i)]);
    const double fb = angle(samples_[static_cast<std::size_t>(i) + 1]);
    // upwards through 0; the jump from pi to -pi is downwards
    if (!(fa <= 0.0 && fb > 0.0) || fb - fa > std::numbers::pi) continue;
    const double a = i * step_s;
    const double second = root([&](double t) { return angle(at(t)); }, {a, a + step_s, fa, fb});
    result.push_back({start_ + Seconds{second}, of(at(second), body).elevation});
  }
  return result;
}

}  // namespace nadir::ephemeris
