#include "radiometry/quad_hemisphere.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "support/catch.hpp"
#include "support/directions.hpp"
#include "support/statistics.hpp"

using namespace nadir;
using radiometry::QuadHemisphere;

TEST_CASE("quads cover their hemisphere evenly, above and below", "[radiometry][quads]") {
  const QuadHemisphere quads{4, 6};
  CHECK(quads.count() == 24);
  CHECK(quads.count_of_both_sides() == 48);
  CHECK(quads.solid_angle() * quads.count() == Approx(2.0 * std::numbers::pi).epsilon(1e-15));
  Rng rng{support::test_seed(), 0};
  std::vector<double> found(48), expected(48, 1000.0);
  for (int i = 0; i < 48'000; ++i) {
    ++found[static_cast<std::size_t>(quads.place(support::random_on_sphere(rng)).quad)];
  }
  CHECK(support::chi_square_p_value(found, expected) > 1e-4);
}

TEST_CASE("a quad below the surface is the mirror image of the one above", "[radiometry][quads]") {
  const QuadHemisphere quads{10, 20};
  for (const int quad : {0, 17, 199}) {
    const Vec2 u{0.3, 0.8};
    const Vec3 above = quads.direction(quad, u);
    CHECK(above.z > 0.0);
    CHECK_FALSE(quads.is_below(quad));
    CHECK(quads.is_below(quad + 200));
    CHECK(quads.direction(quad + 200, u) == Vec3{above.x, above.y, -above.z});
  }
}

TEST_CASE("the place of a direction leads back to it", "[radiometry][quads]") {
  const QuadHemisphere quads{10, 20};
  for (int quad = 0; quad < quads.count_of_both_sides(); ++quad) {
    for (const Vec2 u : {Vec2{0.25, 0.5}, Vec2{0.999, 0.001}, Vec2{0.001, 0.999}}) {
      const QuadHemisphere::Place place = quads.place(quads.direction(quad, u));
      CAPTURE(quad, u.x, u.y);
      CHECK(place.quad == quad);
      // Rounding of 1 - mu^2 next to the pole: sqrt(1e-16) at worst there, far less elsewhere.
      CHECK(place.u.x == Approx(u.x).epsilon(0).margin(1e-12));
      CHECK(place.u.y == Approx(u.y).epsilon(0).margin(1e-12));
    }
  }
}

TEST_CASE("directions on the edges of quads have a place", "[radiometry][quads]") {
  const QuadHemisphere quads{10, 20};
  CHECK(quads.place({0.0, 0.0, 1.0}).quad == 180);
  CHECK(quads.place({0.0, 0.0, -1.0}).quad == 380);
  CHECK(quads.place({1.0, 0.0, 0.0}).quad == 0);
  CHECK(quads.place({1.0, -1e-300, 0.0}).quad == 19);  // azimuth rounds to a full turn
  CHECK(quads.place({1.0, 0.0, 0.0}).u.x < 1.0);
  // In the top ring mu = 0.9 belongs to the ring below: rings are closed above.
  CHECK(quads.place({std::sqrt(1.0 - 0.81), 0.0, 0.9 - 1e-12}).quad == 160);
}
