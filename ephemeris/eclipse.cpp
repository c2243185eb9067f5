#include "ephemeris/eclipse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/constants.hpp"

namespace nadir::ephemeris {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double earth_radius_m = 6'378'137.0;    // WGS84, equator
constexpr double shadow_radius = 1.01 * 0.99834;  // of the equator's: Danjon's enlargement
constexpr double sun_temperature_k = 5740.0;      // as in the law of limb darkening
constexpr double two_to_a_quarter = 1.189207115002721;

/// Two circles about points `separation` apart, in any one unit.
struct Circles {
  double inner, separation;  // inner: the circle whose arcs count
};

// Half the angle of the arc, of a circle of radius r about the other centre, that lies within the
// inner circle.
double half_arc(const Circles& c, double r) {
  if (r <= c.inner - c.separation) return pi;
  if (r >= c.inner + c.separation || r <= c.separation - c.inner) return 0.0;
  const double cosine =
      (r * r + c.separation * c.separation - c.inner * c.inner) / (2.0 * r * c.separation);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

// Integral of f(r) 2 half_arc(r) r dr from a to b. With r = middle - half cos(theta) the square
// roots at both ends become smooth, and the midpoint rule converges fast.
template <class F>
double over_arcs(const Circles& c, double a, double b, F&& f) {
  if (!(b > a)) return 0.0;
  constexpr int points = 64;
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double theta = pi * (i + 0.5) / points;
    const double r = middle - half * std::cos(theta);
    sum += f(r) * 2.0 * half_arc(c, r) * r * half * std::sin(theta);
  }
  return sum * pi / points;
}

// Area that two discs of radius 1 and m, d apart, share.
double shared_area(double m, double d) {
  if (d >= 1.0 + m) return 0.0;
  if (d <= std::abs(m - 1.0)) return pi * std::min(1.0, m * m);
  const double a = std::acos(std::clamp((d * d + 1.0 - m * m) / (2.0 * d), -1.0, 1.0));
  const double b = std::acos(std::clamp((d * d + m * m - 1.0) / (2.0 * d * m), -1.0, 1.0));
  const double kite = (1.0 + m - d) * (d + 1.0 - m) * (d - 1.0 + m) * (d + 1.0 + m);
  return a + m * m * b - 0.5 * std::sqrt(std::max(0.0, kite));
}

double separation_of(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

// The earth before the sun as a point of the moon sees them, `offset` from the shadow's axis.
DiscPair earth_before_sun(const ShadowGeometry& shadow, double offset) {
  const double from_moon = shadow.sun_distance.value + shadow.moon_distance.value;
  return {Angle{std::asin(astro::solar_radius_m / from_moon)},
          Angle{std::asin(shadow_radius * earth_radius_m / shadow.moon_distance.value)},
          Angle{offset * shadow.sun_distance.value / from_moon}};
}

// The offset from the axis at which the earth's limb and the sun's touch.
double contact(const ShadowGeometry& shadow, double sign) {
  const DiscPair discs = earth_before_sun(shadow, 1.0);
  return (discs.cover.value + sign * discs.radius.value) / discs.separation.value;
}

}  // namespace

VisibleShare visible_share(const DiscPair& discs) noexcept {
  const double m = discs.cover / discs.radius, d = discs.separation / discs.radius;
  if (d >= 1.0 + m) return {};
  if (d <= m - 1.0) return {0.0, 0.0};
  const Circles circles{m, d};
  const auto cosine = [](double r) { return std::sqrt(std::max(0.0, 1.0 - r * r)); };
  const double whole = std::clamp(m - d, 0.0, 1.0);  // within this radius all is covered
  const double covered = 2.0 * pi / 3.0 * (1.0 - std::pow(1.0 - whole * whole, 1.5)) +
                         over_arcs(circles, std::abs(m - d), std::min(1.0, m + d), cosine);
  return {std::max(0.0, 1.0 - shared_area(m, d) / pi),
          std::max(0.0, 1.0 - covered / (2.0 * pi / 3.0))};
}

double limb_darkening(Micrometres wavelength) noexcept {
  const double beta =
      3.0 * si::radiation_c2 * two_to_a_quarter / (8.0 * wavelength.value * sun_temperature_k);
  return beta / (1.0 + beta);
}

double umbral_light(Micrometres wavelength) noexcept {
  return 8e-5 * std::exp(1.0 - std::pow(0.55 / wavelength.value, 4.08));
}

double Eclipse::factor(Micrometres wavelength) const noexcept {
  if (!any()) return 1.0;
  const double u = limb_darkening(wavelength);
  // 1 - u + u mu over the disc: pi (1 - u) of its area, 2/3 pi u of the cosine's share
  const double direct =
      ((1.0 - u) * sunlight.area + 2.0 / 3.0 * u * sunlight.by_cosine) / (1.0 - u + 2.0 / 3.0 * u);
  return direct + (in_umbra > 0.0 ? in_umbra * umbral_light(wavelength) : 0.0);
}

Eclipse solar_eclipse(const SunAndMoon& seen) noexcept {
  const Angle separation{separation_of(seen.sun.direction_enu, seen.moon.direction_enu)};
  const double sun = seen.sun.angular_radius.value, moon = seen.moon.angular_radius.value;
  const double overlap = sun + moon - separation.value;
  if (!(overlap > 0.0)) return {};
  // Where one disc holds the other the magnitude is the ratio of the diameters.
  const bool central = separation.value <= std::abs(moon - sun);
  return {visible_share({seen.sun.angular_radius, seen.moon.angular_radius, separation}), 0.0,
          central ? moon / sun : overlap / (2.0 * sun)};
}

Eclipse lunar_eclipse(const ShadowGeometry& shadow) noexcept {
  const double moon = std::asin(astro::lunar_radius_m / shadow.moon_distance.value);
  const double offset = shadow.offset.value;
  const double umbra = contact(shadow, -1.0), penumbra = contact(shadow, 1.0);
  if (offset - moon >= penumbra) return {};
  // The moon's disc in rings about the shadow's axis; their kinks lie where shadows and disc touch.
  const Circles circles{moon, offset};
  Eclipse eclipse{{0.0, 0.0}, 0.0, std::max(0.0, (umbra + moon - offset) / (2.0 * moon))};
  const double disc = pi * moon * moon;
  const auto add_rings = [&](double from, double to) {
    const auto share = [&](double r) { return visible_share(earth_before_sun(shadow, r)); };
    eclipse.sunlight.area += over_arcs(circles, from, to, [&](double r) { return share(r).area; });
    eclipse.sunlight.by_cosine +=
        over_arcs(circles, from, to, [&](double r) { return share(r).by_cosine; });
    if (to <= umbra) eclipse.in_umbra += over_arcs(circles, from, to, [](double) { return 1.0; });
  };
  double from = std::max(0.0, offset - moon);
  const double last = offset + moon;
  std::array<double, 4> edges{std::abs(moon - offset), umbra, penumbra, last};
  std::sort(edges.begin(), edges.end());
  for (const double to : edges) {
    add_rings(from, std::clamp(to, from, last));
    from = std::clamp(to, from, last);
  }
  eclipse.sunlight.area = std::min(1.0, eclipse.sunlight.area / disc);
  eclipse.sunlight.by_cosine = std::min(1.0, eclipse.sunlight.by_cosine / disc);
  eclipse.in_umbra = std::min(1.0, eclipse.in_umbra / disc);
  return eclipse;
}

}  // namespace nadir::ephemeris
