#include <cmath>
#include <memory>
#include <numbers>

#include "core/random.hpp"
#include "radiometry/lamp_helpers.hpp"
#include "radiometry/lamps/bound_lamps.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;
using namespace nadir::radiometry;
using namespace nadir::test;
using spectral::Curve;

namespace {

/// Flux through a sphere about the origin, W um^-1: by the midpoint rule of both hemispheres.
double flux_through(const BoundLamps& lamps, double radius) {
  const auto outward = [&](Vec3 d) {
    const auto s = lamps.sample(radius * d, {}, 0.5, {0.5, 0.5});
    return s ? static_cast<double>(s->irradiance[0]) * dot(s->direction, -d) : 0.0;
  };
  return radius * radius *
         support::integrate_hemisphere([&](Vec3 d) { return outward(d) + outward(-d); });
}

std::shared_ptr<const IntensityTable> street_table() {
  const double deg = pi / 180.0;
  IntensityTable table{{0.0, 20.0 * deg, 50.0 * deg, 65.0 * deg, 80.0 * deg, 90.0 * deg},
                       {0.0, 45.0 * deg, 120.0 * deg, 180.0 * deg},
                       {}};
  for (int j = 0; j < 4; ++j) {
    for (const double v : {200.0, 220.0, 300.0, 400.0 + 100.0 * j, 60.0, 0.0}) {
      table.value.push_back(v);
    }
  }
  return std::make_shared<const IntensityTable>(table);
}

std::string issues_text(const std::vector<Lamp>& lamps) {
  try {
    const BoundLamps bound{lamps, two_lanes()};
    return "(nothing thrown)";
  } catch (const InputError& error) {
    std::string all;
    for (const InputIssue& issue : error.issues()) {
      all += std::to_string(issue.where.line) + ": " + issue.message + "\n";
    }
    return all;
  }
}

}  // namespace

TEST_CASE("a point lamp lights a plane with I cos / d^2", "[radiometry][lamps]") {
  const BoundLamps lamps{{point_lamp({3.0, 0.0, 4.0}, 4.0 * pi * 7.0)}, two_lanes()};
  const auto s = lamps.sample({}, up, 0.3, {0.1, 0.9});
  REQUIRE(s);
  CHECK(s->distance == Approx(5.0).epsilon(1e-15));
  CHECK(s->pdf == 0.0);
  // Irradiances are floats: 1.2e-7, here and below.
  CHECK(static_cast<double>(s->irradiance[1]) * dot(s->direction, up) ==
        Approx(7.0 * 0.8 / 25.0).epsilon(3e-7));
}

TEST_CASE("a spot's light ends at its edge, and its peak is flux (p + 1) / 2 pi (1 - cos^(p + 1))",
          "[radiometry][lamps]") {
  const double half = 0.4, p = GENERATE(0.0, 0.5, 1.0, 6.0);
  const BoundLamps lamps{{point_lamp({0.0, 0.0, 10.0}, 50.0, {p, half})}, two_lanes()};
  const auto at = [&](double angle) {
    const auto s = lamps.sample({10.0 * std::tan(angle), 0.0, 0.0}, up, 0.5, {});
    return s ? static_cast<double>(s->irradiance[0]) : 0.0;
  };
  const double peak = 50.0 * (p + 1.0) / (2.0 * pi * (1.0 - std::pow(std::cos(half), p + 1.0)));
  CHECK(at(0.0) == Approx(peak / 100.0).epsilon(3e-7));
  const double c = std::cos(0.3999);
  CHECK(at(0.3999) == Approx(peak * std::pow(c, p) * c * c / 100.0).epsilon(3e-7));
  CHECK(at(0.4001) == 0.0);
}

TEST_CASE("the flux through a sphere around a point lamp is its flux", "[radiometry][lamps]") {
  const auto shape = GENERATE(values<CosinePower>({{0.0, pi}, {0.0, 1.0}, {0.3, pi}, {3.0, 1.2}}));
  CAPTURE(shape.power, shape.half_angle_rad);
  const BoundLamps lamps{{point_lamp({0.1, -0.2, 0.3}, 80.0, shape)}, two_lanes()};
  // The midpoint rule has an error of 1e-3 where a spot's edge cuts it.
  CHECK(flux_through(lamps, 2.0) == Approx(80.0).epsilon(1.5e-3));
}

TEST_CASE("the flux of a tabulated intensity is the lamp's, whatever the table's scale",
          "[radiometry][lamps]") {
  const auto table = street_table();
  Lamp lamp = point_lamp({}, 80.0);
  PointLamp& form = std::get<PointLamp>(lamp.form);
  form.shape = table;
  form.axis = normalised({0.2, -0.1, -0.9});
  form.side = normalised(cross(form.axis, {0.0, 1.0, 0.0}));
  const BoundLamps lamps{{lamp}, two_lanes()};
  CHECK(flux_through(lamps, 2.0) == Approx(80.0).epsilon(1e-3));  // kinks under the midpoint rule
}

TEST_CASE("a table's integral is exact for lines: 1 all around is 4 pi, theta is 2 pi^2",
          "[radiometry][lamps]") {
  // int theta sin theta dtheta from 0 to pi is pi.
  CHECK(integral({{0.0, 1.0, pi}, {0.0}, {1.0, 1.0, 1.0}}) == Approx(4.0 * pi).epsilon(1e-14));
  CHECK(integral({{0.0, 2.0, pi}, {0.0, pi / 2}, {0.0, 2.0, pi, 0.0, 2.0, pi}}) ==
        Approx(2.0 * pi * pi).epsilon(1e-14));
}

TEST_CASE("a table is looked up with the symmetry of its horizontal angles",
          "[radiometry][lamps]") {
  const auto shape = [](std::vector<double> horizontal, std::vector<double> around) {
    IntensityTable table{{0.0, pi}, std::move(horizontal), {}};
    for (const double v : around) table.value.insert(table.value.end(), {v, v});
    return BoundShape{std::make_shared<const IntensityTable>(table)};
  };
  const auto at = [](const BoundShape& s, double azimuth_deg) {
    return s(support::direction(0.3, azimuth_deg * pi / 180.0));
  };
  const BoundShape quadrant = shape({0.0, pi / 2}, {1.0, 3.0});
  for (const double a : {150.0, 210.0, 330.0}) {
    CHECK(at(quadrant, a) == Approx(at(quadrant, 30.0)).epsilon(1e-12));
  }
  CHECK(at(quadrant, 90.0) == Approx(3.0 * at(quadrant, 0.0)).epsilon(1e-12));
  const BoundShape half = shape({0.0, pi / 2, pi}, {1.0, 3.0, 7.0});
  CHECK(at(half, 180.0) == Approx(7.0 * at(half, 0.0)).epsilon(1e-12));
  CHECK(at(half, 300.0) == Approx(at(half, 60.0)).epsilon(1e-12));
  const BoundShape full = shape({0.0, pi / 2, pi, 2.0 * pi}, {1.0, 3.0, 7.0, 1.0});
  CHECK(at(full, 270.0) == Approx(4.0 * at(full, 0.0)).epsilon(1e-12));
  CHECK(at(full, -45.0) == Approx(2.5 * at(full, 0.0)).epsilon(1e-12));
  // Below a lamp that shines down, horizontal angles grow counter-clockwise seen from above.
  Lamp lamp = point_lamp({0.0, 0.0, 1.0}, 1.0);
  std::get<PointLamp>(lamp.form).shape = std::make_shared<const IntensityTable>(IntensityTable{
      {0.0, pi}, {0.0, pi / 2, pi, 2.0 * pi}, {1.0, 1.0, 3.0, 3.0, 7.0, 7.0, 1.0, 1.0}});
  const BoundLamps lamps{{lamp}, two_lanes()};
  const auto east = lamps.sample({1.0, 0.0, 0.0}, up, 0.5, {}),
             north = lamps.sample({0.0, 1.0, 0.0}, up, 0.5, {});
  REQUIRE((east && north));
  CHECK(static_cast<double>(north->irradiance[0] / east->irradiance[0]) ==
        Approx(3.0).epsilon(1e-6));
}

TEST_CASE("one draw of 300 lamps of all kinds is unbiased, also at grazing incidence",
          "[radiometry][lamps]") {
  Rng rng{31};
  const auto place_in = [&](double size) {
    const double x = rng.next(), y = rng.next(), z = rng.next();
    return size * Vec3{x - 0.5, y - 0.5, z - 0.5};
  };
  std::vector<Lamp> all;
  const auto table = street_table();
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Vec3 place = place_in(40.0);
    const double flux = std::exp(4.0 * rng.next());
    switch (i % 6) {
      case 0:
        all.push_back(point_lamp(place, flux));
        break;
      case 1:
        all.push_back(point_lamp(place, flux, {1.0, 1.2}));
        break;
      case 2:
        all.push_back(point_lamp(place, flux));
        std::get<PointLamp>(all.back().form).shape = table;
        break;
      case 3:
        all.push_back(area_lamp(geometry::Disc{{}, up, 0.3}, place, flux, i));
        break;
      case 4:
        all.push_back(area_lamp(geometry::Plane{{}, 2.0, 0.2}, place, flux, i));
        break;
      default:
        all.push_back(area_lamp(geometry::Sphere{{}, 0.3}, place, flux, i));
    }
  }
  const BoundLamps lamps{all, two_lanes()};
  for (int k = 0; k < 6; ++k) {
    const Vec3 place = place_in(60.0);
    // The last two look along the ground, so that half of each cluster is below the horizon.
    Vec3 normal = k < 4 ? support::random_on_sphere(rng) : normalised({1.0, 0.3 * k, 1e-3});
    if (dot(normal, place) > 0.0) normal = -normal;  // towards the lamps, which lie about 0
    const auto received = [&](const std::optional<LampSample>& s) {
      return s ? static_cast<double>(s->irradiance[0]) * std::max(0.0, dot(s->direction, normal))
               : 0.0;
    };
    double expected = 0.0;  // lamps are small: 16 places on each leave 1e-4
    for (std::uint32_t i = 0; i < 300; ++i) {
      for (int j = 0; j < 16; ++j) {
        expected +=
            received(lamps.sample_of(i, place, {(j / 4 + 0.5) / 4, (j % 4 + 0.5) / 4})) / 16;
      }
    }
    constexpr int draws = 20'000;
    double sum = 0.0, squares = 0.0;
    for (int j = 0; j < draws; ++j) {
      const double choice = rng.next(), a = rng.next();
      const double e = received(lamps.sample(place, normal, choice, {a, rng.next()}));
      sum += e;
      squares += e * e;
    }
    const double mean = sum / draws;
    const double error = std::sqrt((squares / draws - mean * mean) / draws);
    CAPTURE(k, mean, expected, error);
    CHECK(std::abs(mean - expected) < 4.0 * error + 2e-4 * expected);
    CHECK(error < 0.05 * expected);  // a useless hierarchy would have 0.1 and more
  }
}

TEST_CASE("light stays finite at, in and beside a lamp, however bright", "[radiometry][lamps]") {
  const BoundLamps lamps{
      {point_lamp({}, 1e9), area_lamp(geometry::Sphere{{}, 0.5}, {5, 0, 0}, 1e9, 0),
       area_lamp(geometry::Plane{{}, 1.0, 1.0}, {0, 5, 0}, 1e9, 1),
       area_lamp(geometry::Disc{{}, up, 1.0}, {0, -5, 0}, 1.0, 2)},
      two_lanes()};
  Rng rng{41};
  for (const Vec3 place :
       {Vec3{}, Vec3{1e-300, 0, 0}, Vec3{0, 0, -1e-12}, Vec3{5, 0, 0}, Vec3{5.5, 0, 0},
        Vec3{5.5 + 1e-12, 0, 0}, Vec3{0, 5, 0}, Vec3{0.2, 5, -1e-13}, Vec3{0.5, 5.5, -1e-12},
        Vec3{0, -5, -1e-14}, Vec3{1, -5, -1e-9}, Vec3{1e8, 1e8, 1e8}, Vec3{0.5, 5.5, -1e-5}}) {
    for (int k = 0; k < 200; ++k) {
      const double choice = rng.next(), a = rng.next();
      const auto s = lamps.sample(place, k % 2 ? up : Vec3{}, choice, {a, rng.next()});
      if (!s) continue;
      CAPTURE(place.x, place.y, place.z);
      REQUIRE(std::isfinite(s->irradiance[0]));
      REQUIRE(s->irradiance[0] >= 0.0F);
      REQUIRE(std::isfinite(s->pdf));
      REQUIRE(length(s->direction) == Approx(1.0).epsilon(1e-12));
    }
  }
  // At less than a millimetre a point lamp is as bright as at a millimetre.
  const BoundLamps one{{point_lamp({}, 4.0 * pi)}, two_lanes()};
  CHECK(one.sample({0, 0, -1e-9}, {}, 0.5, {})->irradiance[0] == Approx(1e6F).epsilon(1e-6));
}

TEST_CASE("lamps without flux give nothing, and no lamps at all are no trouble",
          "[radiometry][lamps]") {
  CHECK(BoundLamps{}.empty());
  CHECK(BoundLamps{{point_lamp({0, 0, 1}, 0.0)}, two_lanes()}.empty());
  CHECK_FALSE(BoundLamps{}.sample({}, up, 0.5, {}));
  CHECK_FALSE(BoundLamps{}.radiance({}, {}));
}

TEST_CASE("lamps share a spectrum and scale it each by its own factor", "[radiometry][lamps]") {
  const auto curve = std::make_shared<const Curve>(std::vector{0.4, 0.7}, std::vector{1.0, 4.0},
                                                   spectral::Outside::reject);
  Lamp lamp = point_lamp({0, 0, 1}, 0.0);
  lamp.flux = LampFlux{curve, 4.0 * pi};
  const BoundLamps lamps{{lamp}, two_lanes()};
  const auto s = lamps.sample({}, up, 0.5, {});
  REQUIRE(s);
  CHECK(s->irradiance[0] == Approx(2.0F).epsilon(1e-6));
  CHECK(s->irradiance[1] == Approx(3.0F).epsilon(1e-6));
}

TEST_CASE("bad lamps are refused, each with its place and name", "[radiometry][lamps]") {
  Lamp negative = point_lamp({}, -1.0);
  negative.where = {"a.xml", 3, 1};
  Lamp short_curve = point_lamp({}, 1.0);
  short_curve.name = "blue";
  short_curve.where = {"a.xml", 4, 1};
  short_curve.flux = Curve{{0.4, 0.5}, {1.0, 1.0}, spectral::Outside::reject};
  Lamp long_axis = point_lamp({}, 1.0);
  long_axis.where = {"a.xml", 5, 1};
  std::get<PointLamp>(long_axis.form).axis = {0.0, 0.0, -2.0};
  CHECK(issues_text({negative, short_curve, long_axis}) ==
        "3: lamp point: its flux must not be negative, found -1 W um^-1\n"
        "4: lamp blue: its flux is tabulated from 0.4 to 0.5 um, but the bands need it from 0.5 to "
        "0.6 um\n"
        "5: lamp point: its axis must be a unit vector\n");
  CHECK(issues_text({point_lamp({}, 1.0, {-1.0, 1.0}), point_lamp({}, 1.0, {-1.0, 1.0}),
                     point_lamp({}, 1.0, {0.0, 0.0})}) ==
        "0: lamp point: the power of a lamp's cosine must not be negative, found -1\n"
        "0: lamp point: the power of a lamp's cosine must not be negative, found -1\n"
        "0: lamp point: a lamp's half angle must be above 0 and at most 180 deg, found 0 deg\n");
  CHECK(issues_text({area_lamp(geometry::Sphere{{}, 1.0}, {}, 1.0, 3),
                     area_lamp(geometry::Sphere{{}, 1.0}, {5, 0, 0}, 1.0, 3),
                     area_lamp(geometry::Disc{{}, up, 0.0}, {5, 0, 0}, 1.0, 4)}) ==
        "0: lamp area: its object is another lamp's as well\n"
        "0: lamp area: a disc lamp's radius must be a positive number of metres\n");
  Lamp dark = point_lamp({}, 1.0);
  std::get<PointLamp>(dark.form).shape =
      std::make_shared<const IntensityTable>(IntensityTable{{0.0, 1.0}, {0.0}, {0.0, 0.0}});
  CHECK(issues_text({dark}) == "0: lamp point: a lamp's intensity table holds no light\n");
  std::get<PointLamp>(dark.form).shape =
      std::make_shared<const IntensityTable>(IntensityTable{{0.0, 1.0}, {0.0, 1.0}, {1, 1, 1, 1}});
  CHECK(issues_text({dark}) ==
        "0: lamp point: horizontal angles of an intensity table must reach from 0 to 90, 180 or "
        "360 deg\n");
}
