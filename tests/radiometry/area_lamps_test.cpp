#include <cmath>
#include <set>
#include <vector>

#include "core/random.hpp"
#include "radiometry/lamp_helpers.hpp"
#include "radiometry/lamps/bound_lamps.hpp"
#include "radiometry/lamps/spherical_rectangle.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::radiometry;
using namespace nadir::test;

TEST_CASE("a disc lights its axis with pi L sin^2 of its half angle", "[radiometry][lamps]") {
  const double radius = 2.0, flux = 30.0, height = GENERATE(0.5, 3.0, 500.0);
  const BoundLamps lamps{{area_lamp(geometry::Disc{{}, up, radius}, {0.0, 0.0, height}, flux)},
                         two_lanes()};
  const double sin2 = radius * radius / (radius * radius + height * height);
  const double radiance = flux / (pi * pi * radius * radius);
  // The midpoint rule over 64 x 64 points leaves 1.4e-3 at height 0.5, over 256 x 256 9e-5.
  CHECK(irradiance(lamps, {}, up, 256) == Approx(pi * radiance * sin2).epsilon(3e-4));
  CHECK(irradiance(lamps, {0.0, 0.0, 2.0 * height}, -up) == 0.0);  // behind it
}

TEST_CASE("a sphere lights a plane with E = L pi (r / d)^2 cos, from near and far",
          "[radiometry][lamps]") {
  const double radius = 0.5, flux = 30.0, distance = GENERATE(0.5001, 0.7, 3.0, 1e6);
  const BoundLamps lamps{{area_lamp(geometry::Sphere{{}, radius}, {0.0, 0.0, distance}, flux)},
                         two_lanes()};
  const double radiance = flux / (4.0 * pi * pi * radius * radius);
  // A sphere wholly above the plane: Lambert's formula, exact for any distance.
  const double ratio = radius / distance;
  CHECK(irradiance(lamps, {}, up) == Approx(pi * radiance * ratio * ratio).epsilon(3e-4));
  const auto s = lamps.sample({}, up, 0.5, {0.0, 0.0});
  REQUIRE(s);
  CHECK(s->distance == Approx(distance - radius).epsilon(1e-9));
}

TEST_CASE("rectangles exchange light as their published view factors say", "[radiometry][lamps]") {
  // F12 of equal parallel rectangles a x b at a distance c. Source: J. R. Howell, A Catalog of
  // Radiation Heat Transfer Configuration Factors, C-11 (closed form, evaluated to 8 digits).
  struct Case {
    double a, b, c, factor;
  };
  const auto pair = GENERATE(values<Case>(
      {{1.0, 1.0, 1.0, 0.19982490}, {1.0, 1.5, 0.5, 0.47557644}, {2.0, 2.0, 1.0, 0.41525328}}));
  const BoundLamps lamps{{area_lamp(geometry::Plane{{}, pair.a, pair.b}, {0.0, 0.0, pair.c}, 1.0)},
                         two_lanes()};
  constexpr int n = 24;
  double received = 0.0;  // W um^-1: of a flux of 1 the part that arrives is the view factor
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      received += irradiance(
          lamps, {pair.a * ((i + 0.5) / n - 0.5), pair.b * ((j + 0.5) / n - 0.5), 0.0}, up, 24);
    }
  }
  received *= pair.a * pair.b / (n * n);
  // The midpoint rule over 24 x 24 places, as many points on the lamp, leaves 1e-3 in the worst of
  // these.
  CHECK(received == Approx(pair.factor).epsilon(1.5e-3));
}

TEST_CASE("a square's corner sees E / pi L as the closed form, sampled by solid angle or area",
          "[radiometry][lamps]") {
  // Point below the corner of an a x b rectangle at height c: F = (1 / 2 pi) (A / sqrt(1 + A^2)
  // atan(B / sqrt(1 + A^2)) + B / sqrt(1 + B^2) atan(A / sqrt(1 + B^2))), A = a / c, B = b / c.
  // Source: Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3.
  const double c = GENERATE(0.05, 1.0, 30.0);
  const double a = 1.5, b = 2.5, A = a / c, B = b / c;
  const double ra = std::sqrt(1.0 + A * A), rb = std::sqrt(1.0 + B * B);
  const double factor = (A / ra * std::atan(B / ra) + B / rb * std::atan(A / rb)) / (2.0 * pi);
  const BoundLamps lamps{{area_lamp(geometry::Plane{{}, a, b}, {a / 2, b / 2, c}, 9.0)},
                         two_lanes()};
  CHECK(irradiance(lamps, {}, up) == Approx(9.0 / (a * b) * factor).epsilon(5e-4));
}

TEST_CASE("a spherical rectangle's solid angle is the closed form, its points uniform in it",
          "[radiometry][lamps]") {
  // Above the centre: 4 asin(a b / sqrt((a^2 + z^2) (b^2 + z^2))), a and b half sides.
  const double a = 1.2, b = 0.7, z = GENERATE(0.02, 0.5, 6.0);
  const SphericalRectangle whole{{-a, a, -b, b, z}};
  const double expected = 4.0 * std::asin(a * b / std::sqrt((a * a + z * z) * (b * b + z * z)));
  CHECK(whole.solid_angle() == Approx(expected).epsilon(1e-10));
  // A quarter of it holds a quarter of the points; and a corner as much as its solid angle says.
  const double of_corner = SphericalRectangle{{0.3, a, -b, 0.1, z}}.solid_angle() / expected;
  constexpr int n = 200;
  int in_corner = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Vec2 p = whole.point({(i + 0.5) / n, (j + 0.5) / n});
      if (p.x > 0.3 && p.y < 0.1) ++in_corner;
    }
  }
  // Only cells that the corner's edges cut can be counted wrongly: 400 of 40000.
  CHECK(static_cast<double>(in_corner) / (n * n) == Approx(of_corner).margin(5e-3));
}

TEST_CASE("radiance and density of a hit are those of the sample that leads there",
          "[radiometry][lamps]") {
  const std::vector<Lamp> all{area_lamp(geometry::Disc{{}, up, 0.8}, {0.0, 0.0, 3.0}, 10.0, 4),
                              area_lamp(geometry::Plane{{}, 1.0, 2.0}, {2.0, 0.0, 2.0}, 20.0, 6),
                              area_lamp(geometry::Plane{{}, 0.1, 0.1}, {-2.0, 9.0, 4.0}, 20.0, 7),
                              area_lamp(geometry::Sphere{{}, 0.4}, {-2.0, 1.0, 2.0}, 30.0, 9)};
  const BoundLamps lamps{all, two_lanes()};
  Rng rng{21};
  std::set<std::uint32_t> seen;
  for (int k = 0; k < 400; ++k) {
    const double x = rng.next(), y = rng.next(), choice = rng.next(), a = rng.next();
    const Vec3 place{2.0 * x - 1.0, 2.0 * y - 1.0, 0.0};
    const auto s = lamps.sample(place, up, choice, {a, rng.next()});
    if (!s) continue;
    const geometry::Ray ray{place, s->direction};
    geometry::Hit hit;
    hit.position = place + s->distance * s->direction;
    hit.distance = s->distance;
    // Which lamp it was: the one whose radiance makes the sample consistent.
    bool found = false;
    for (const std::uint32_t object : {4U, 6U, 7U, 9U}) {
      hit.object = object;
      const double pdf = lamps.pdf(place, up, ray, hit);
      const auto radiance = lamps.radiance(ray, hit);
      REQUIRE(radiance);
      if (std::abs(pdf / s->pdf - 1.0) > 1e-9) continue;
      // irradiance = radiance / density, floats
      CHECK(static_cast<double>(s->irradiance[0]) * pdf ==
            Approx(static_cast<double>((*radiance)[0])).epsilon(1e-6));
      found = true;
      seen.insert(object);
    }
    CHECK(found);
  }
  CHECK(seen.size() == 4);
  geometry::Hit hit;
  hit.object = 5;
  CHECK_FALSE(lamps.radiance({}, hit));
  CHECK(lamps.pdf({}, up, {}, hit) == 0.0);
  hit.object = 1000;
  CHECK_FALSE(lamps.radiance({}, hit));
  hit.object = 4;  // the disc from above: its back
  hit.position = {0.0, 0.0, 3.0};
  const geometry::Ray from_above{{0.0, 0.0, 9.0}, -up};
  CHECK(lamps.radiance(from_above, hit).value()[0] == 0.0F);
  CHECK(lamps.pdf(from_above.origin, -up, from_above, hit) == 0.0);
}

TEST_CASE("a disc's surface has its own centre and normal within the lamp's axes",
          "[radiometry][lamps]") {
  Lamp lamp = area_lamp(geometry::Disc{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 0.001}, {}, pi);
  auto& form = std::get<AreaLamp>(lamp.form);
  form.centre = {10.0, 0.0, 0.0};
  form.axis_x = {0.0, 1.0, 0.0};  // so the disc faces y, and its centre is one along y x z = x
  form.axis_y = {0.0, 0.0, 1.0};
  const BoundLamps lamps{{lamp}, two_lanes()};
  const auto s = lamps.sample({11.0, 50.0, 0.0}, {}, 0.5, {0.5, 0.5});
  REQUIRE(s);
  CHECK(s->direction.y == Approx(-1.0).epsilon(1e-9));
  CHECK(s->distance == Approx(50.0).epsilon(1e-9));
  CHECK(static_cast<double>(s->irradiance[0]) == Approx(1.0 / 2500.0).epsilon(1e-6));
}
