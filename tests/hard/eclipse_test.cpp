#include "ephemeris/eclipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hard/hard_case.hpp"

// The moon before the sun: as a share of the disc, and as two targets at one place of a scene's
// sky.

namespace nadir::radiometry::test {
namespace {

using ephemeris::visible_share;
using ephemeris::VisibleShare;

VisibleShare share(double cover, double separation) {
  return visible_share({Angle{0.00465}, Angle{0.00465 * cover}, Angle{0.00465 * separation}});
}

TEST_CASE("total: nothing of the sun is left, from a moon just as wide to one that fills the sky",
          "[hard][eclipse]") {
  for (const double cover : {1.0, 1.0 + 1e-15, 1.0001, 1.08, 100.0}) {
    const VisibleShare left = share(cover, 0.0);
    CAPTURE(cover);
    CHECK(left.area == 0.0);
    CHECK(left.by_cosine == 0.0);
  }
  CHECK(share(1.08, 0.08 - 1e-12).area == Approx(0.0).margin(1e-9));
}

TEST_CASE("annular: a ring of area 1 - k^2 is left, weighted by cosine (1 - k^2)^(3/2)",
          "[hard][eclipse]") {
  for (const double cover : {1e-9, 0.1, 0.5, 0.94, 0.9999}) {
    const VisibleShare left = share(cover, 0.0);
    const double ring = 1.0 - cover * cover;
    CAPTURE(cover);
    CHECK(left.area == Approx(ring).margin(1e-9));  // its stated error
    // int over the covered part of sqrt(1 - r^2), over that of the whole disc: 1 - (1 - k^2)^(3/2)
    CHECK(left.by_cosine == Approx(std::pow(ring, 1.5)).margin(1e-6));
  }
}

TEST_CASE("partial: what is left falls without a step from first contact to the middle",
          "[hard][eclipse]") {
  const double cover = GENERATE(0.94, 1.0, 1.06);
  VisibleShare before;
  double largest_step = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    const VisibleShare now = share(cover, (1.0 + cover) * (1.0 + 1e-6) * (1.0 - i / 4000.0));
    CHECK(now.area >= 0.0);
    CHECK(now.by_cosine >= 0.0);
    CHECK(now.area <= before.area + 1e-12);
    CHECK(now.by_cosine <= before.by_cosine + 2e-6);  // of the midpoint rule
    largest_step = std::max(largest_step, before.area - now.area);
    before = now;
  }
  CHECK(largest_step < 2e-3);  // 2 / 4000 of the way uncovers at most 2 / pi of that in area
  CHECK(share(1.0, 1.0).area ==
        Approx(1.0 / 3.0 + std::sqrt(3.0) / (2.0 * std::numbers::pi)).epsilon(1e-9));  // lens
}

TEST_CASE("an eclipse leaves between nothing and all of the light at every wavelength",
          "[hard][eclipse]") {
  for (const double separation : {0.0, 1e-12, 0.03, 0.5, 2.0, 2.1, 300.0}) {
    for (const double wavelength : {0.3, 0.55, 2.0, 14.0, 1000.0}) {
      ephemeris::Eclipse eclipse;
      eclipse.sunlight = share(0.97, separation);
      const double left = eclipse.factor(Micrometres{wavelength});
      CAPTURE(separation, wavelength);
      CHECK(left >= 0.0);
      CHECK(left <= 1.0);
      if (separation >= 2.0) CHECK(left == 1.0);
    }
  }
}

TEST_CASE("sun and moon at one place of the sky are two lights, however their discs overlap",
          "[hard][eclipse]") {
  const double moon_radius_deg = GENERATE(0.25, 0.266, 0.28);  // annular, equal, total
  const double apart_deg = GENERATE(0.0, 0.1, 0.52);
  const spectral::Lanes visible{{0.45_um, 0.65_um}};
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 1000.0, 1000.0}, scene.material(grey(0.5), Kelvin{0.0}));
    scene.add_body(120.0, 90.0, 0.266, 1000.0);  // what its eclipse left of it is its irradiance
    scene.add_body(120.0, 90.0 - apart_deg, moon_radius_deg, 1e-3);
    scene.solver = {.initial_sample_count = 0, .min_quad_samples = 0};
    const auto seen = hard_measure(scene.build(), visible, downward(), 8, 64);
    CAPTURE(name_of(method), moon_radius_deg, apart_deg);
    // Of the path solver's walks one in 46,000 meets a disc by itself and brings what balances the
    // 2.2e-5 that their shadow rays leave to it: none in these few.
    check_right(seen, 0.5 / std::numbers::pi * (1000.0 + 1e-3), 3e-5);
  }
}

TEST_CASE("a camera that looks into the overlap of two discs sees the radiance of both",
          "[hard][eclipse]") {
  const spectral::Lanes visible{{0.45_um, 0.65_um}};
  const auto solid_angle = [](double radius_deg) {
    const double half = std::sin(0.5 * degrees(radius_deg).value);
    return 4.0 * std::numbers::pi * half * half;
  };
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{0.0, 0.0, -5.0}, 1.0, 1.0}, scene.material(grey(0.5), Kelvin{0.0}));
    scene.add_body(0.0, 50.0, 0.266, 1000.0);
    scene.add_body(0.0, 50.1, 0.25, 10.0);
    const double sun = 1000.0 / solid_angle(0.266), moon = 10.0 / solid_angle(0.25);
    const auto at = [&](double elevation_deg) {
      const Vec3 up = direction_enu(0.0, degrees(elevation_deg).value);
      return hard_measure(scene.build(), visible, {{}, up}, 4, 1);
    };
    CAPTURE(name_of(method));
    check_right(at(50.05), sun + moon);
    check_right(at(49.78), sun);
    check_right(at(50.34), moon);
    check_right(at(50.40), 0.0);
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
