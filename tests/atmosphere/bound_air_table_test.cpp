#include "atmosphere/table/bound_air_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "atmosphere/synthetic_air.hpp"
#include "atmosphere/table/lane_kernels.hpp"
#include "core/error.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::atmosphere;

using std::numbers::pi;

double d(float value) { return static_cast<double>(value); }

/// Air that thins out with exp(-w / H) and shines alike everywhere: extinction * measure is its
/// optical depth exactly.
SyntheticAir even_air() {
  SyntheticAir air;
  air.extinction = constant(2e-5);
  air.even = constant(3.0);
  return air;
}

/// 1 - T of a whole way from the ground through air with 1e-4 per metre of measure: skies that are
/// as deep as the air is are interpolated exactly.
double lost(const Place& p) {
  const double way = way_to_end_m(100e3, 0.0, 0.0, std::cos(p.zenith_rad));
  return -std::expm1(-1e-4 * air_measure_m(0.0, 100e3, way));
}
double lost(Vec3 direction) { return lost(Place{.zenith_rad = std::acos(direction.z)}); }

}  // namespace

// Taylor series and float rounding; std::exp in double is the truth.
TEST_CASE("light decays as the exponential says", "[atmosphere][table]") {
  for (double x = 1e-9; x < 87.0; x *= 1.03) {
    CAPTURE(x);
    const Decay decayed = decay(static_cast<float>(x));
    const double exact = d(static_cast<float>(x));
    CHECK(d(decayed.left) == Approx(std::exp(-exact)).epsilon(3e-7));
    CHECK(d(decayed.lost) == Approx(-std::expm1(-exact)).epsilon(3e-7));
  }
  CHECK(decay(0.0F).left == 1.0F);
  CHECK(decay(0.0F).lost == 0.0F);
  CHECK(decay(std::numeric_limits<float>::infinity()).left < 2e-38F);
  CHECK(decay(3e38F).lost == 1.0F);
}

// T = exp(-k int exp(-w / H) ds), L = S (1 - T), from any eye. The integral is in the measure's own
// test. Float rounding of the depth: 3e-7 (1 + depth).
TEST_CASE("a path through even air obeys Beer's law", "[atmosphere][table]") {
  SyntheticAir air = even_air();
  air.ground_m = -400.0;  // by the Dead Sea
  const BoundAirTable table = bound(air.table());
  for (const double height_m : {-400.0, -430.0, 0.0, 1500.0, 7e3, 99e3}) {
    for (const double mu : {-1.0, -0.5, -0.01, 0.0, 0.02, 1.0}) {
      for (const double length_m : {1e-3, 1.0, 500.0, 4e4}) {
        const PathPoint end = advanced({height_m, mu}, length_m);
        if (end.height_m < -450.0 || end.height_m > 100e3) continue;
        CAPTURE(height_m, mu, length_m);
        const double depth = 2e-5 * air_measure_m(height_m, end.height_m, length_m);
        const PathTerms terms =
            table.path({0.0, 0.0, height_m + 400.0}, towards(std::acos(mu), 1.0), length_m);
        CHECK(d(terms.transmittance[0]) == Approx(std::exp(-depth)).epsilon(3e-7 * (1.0 + depth)));
        CHECK(d(terms.radiance[0]) == Approx(-3.0 * std::expm1(-depth)).epsilon(2e-6));
      }
    }
  }
}

// The scene's axes are flat: 100 km from the origin its plane lies 785 m above the sphere.
TEST_CASE("the earth curves away below the scene's axes", "[atmosphere][table]") {
  const BoundAirTable table = bound(even_air().table());
  const double height = 1e10 / (earth_radius_m + std::hypot(earth_radius_m, 1e5));
  const double depth = 2e-5 * air_measure_m(0.0, height, 1e5);
  const PathTerms out = table.path({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1e5);
  const PathTerms back = table.path({1e5, 0.0, 0.0}, {-1.0, 0.0, 0.0}, 1e5);
  CHECK(d(out.transmittance[0]) == Approx(std::exp(-depth)).epsilon(1e-6));
  CHECK(d(back.transmittance[0]) == Approx(std::exp(-depth)).epsilon(1e-6));
}

TEST_CASE("an eye above the air looks from where its ray enters", "[atmosphere][table]") {
  const BoundAirTable table = bound(even_air().table());
  const PathTerms top = table.path({0.0, 0.0, 100e3}, {0.0, 0.0, -1.0}, 99e3);
  const PathTerms far = table.path({0.0, 0.0, 36e6}, {0.0, 0.0, -1.0}, 36e6 - 1e3);
  CHECK(far.transmittance[0] == Approx(top.transmittance[0]).epsilon(1e-7));
  CHECK(far.radiance[0] == Approx(top.radiance[0]).epsilon(1e-7));
  // up, beside the earth, or not yet in the air
  for (const auto& [direction, length] : {std::pair{Vec3{0.0, 0.0, 1.0}, 1e9},
                                          {Vec3{1.0, 0.0, 0.0}, 1e9},
                                          {Vec3{0.0, 0.0, -1.0}, 1e6}}) {
    const PathTerms none = table.path({0.0, 0.0, 36e6}, direction, length);
    CHECK(none.transmittance[0] == 1.0F);
    CHECK(none.radiance[0] == 0.0F);
  }
  CHECK(table.beyond({0.0, 0.0, 36e6}, {0.0, 0.0, 1.0})[0] == 0.0F);
}

TEST_CASE("a path out of the air ends at the top", "[atmosphere][table]") {
  const BoundAirTable table = bound(even_air().table());
  const double depth = 2e-5 * air_measure_m(50.0, 100e3, 100e3 - 50.0);
  for (const double length : {2e5, 1e12, std::numeric_limits<double>::infinity()}) {
    const PathTerms out = table.path({0.0, 0.0, 50.0}, {0.0, 0.0, 1.0}, length);
    CHECK(d(out.transmittance[0]) == Approx(std::exp(-depth)).epsilon(1e-6));
  }
  CHECK(table.path({}, {0.0, 0.0, 1.0}, 0.0).transmittance[0] == 1.0F);
}

// G = (rho E / pi + emission) / (1 - rho S) = (0.5 (0.75 + 0.25) / pi + 2) / (1 - 0.05)
TEST_CASE("the ground about shines through what is beyond the scene", "[atmosphere][table]") {
  SyntheticAir air = even_air();
  air.ground = constant(0.2);
  const BoundAirTable table = bound(air.table(), 0.5F, 2.0F);
  const double g = (0.5 / pi + 2.0) / 0.95;
  CHECK(d(table.ground_radiance()[0]) == Approx(g).epsilon(1e-6));
  const double source = 3.0 + 0.2 * g;
  const double down = 2e-5 * air_measure_m(0.0, 1500.0, 1500.0);
  const double up = 2e-5 * air_measure_m(1500.0, 100e3, 98.5e3);
  const Vec3 eye{0.0, 0.0, 1500.0};
  CHECK(d(table.beyond(eye, {0.0, 0.0, -1.0})[0]) ==
        Approx(-std::expm1(-down) * source + std::exp(-down) * g).epsilon(1e-6));
  CHECK(d(table.beyond(eye, {0.0, 0.0, 1.0})[0]) ==
        Approx(-std::expm1(-up) * source).epsilon(1e-6));
  CHECK(d(table.sky({0.0, 0.0, -1.0})[0]) == Approx(g).epsilon(1e-6));
  CHECK(d(table.sky({0.6, 0.0, -0.8})[0]) == Approx(g).epsilon(1e-6));
}

TEST_CASE("the horizon parts what is above from what is below", "[atmosphere][table]") {
  SyntheticAir air = even_air();
  air.even = [](const Place& p) { return p.below ? 1.0 : 5.0; };
  const BoundAirTable table = bound(air.table());
  // at the height of the view, and at others: the horizon is the eye's own
  for (const double height : {1.0, 1500.0, 9000.0}) {
    CAPTURE(height);
    const Vec3 eye{0.0, 0.0, height};
    const double horizon = std::acos(horizon_mu(0.0, height));
    const auto source = [&](double zenith) {
      const PathTerms terms = table.path(eye, towards(zenith, 0.4), 100.0);
      return d(terms.radiance[0]) / (1.0 - d(terms.transmittance[0]));
    };
    // 1 - T in float: 2e-3 of it, less its rounding of 6e-8
    CHECK(source(horizon - 1e-7) == Approx(5.0).epsilon(2e-4));
    CHECK(source(horizon + 1e-7) == Approx(1.0).epsilon(2e-4));
    CHECK(source(0.0) == Approx(5.0).epsilon(2e-4));
  }
}

TEST_CASE("eyes between two heights get a blend of both", "[atmosphere][table]") {
  SyntheticAir air = even_air();
  air.view_heights_m = {1000.0, 3000.0};
  air.even = [](const Place& p) { return p.height_m; };
  const BoundAirTable table = bound(air.table());
  const auto source = [&](double height) {
    const PathTerms terms = table.path({0.0, 0.0, height}, {0.0, 0.0, 1.0}, 1e6);
    return d(terms.radiance[0]) / (1.0 - d(terms.transmittance[0]));
  };
  // 1 - T is 0.1; float rounding of T
  CHECK(source(0.0) == Approx(1000.0).epsilon(3e-6));
  CHECK(source(1000.0) == Approx(1000.0).epsilon(3e-6));
  CHECK(source(1500.0) == Approx(1500.0).epsilon(3e-6));
  CHECK(source(2750.0) == Approx(2750.0).epsilon(3e-6));
  CHECK(source(8000.0) == Approx(3000.0).epsilon(3e-6));
}

// A formula linear in the share and in the height's own axis is met exactly between nodes.
TEST_CASE("sources run linearly over the share of the way", "[atmosphere][table]") {
  SyntheticAir air = even_air();
  air.even = [](const Place& p) { return 1.0 + p.share; };
  const BoundAirTable table = bound(air.table());
  const double whole = air_measure_m(1500.0, 0.0, 1500.0);
  for (const double length : {200.0, 700.0, 1111.0, 1499.0}) {
    const double measure = air_measure_m(1500.0, 1500.0 - length, length);
    const double share = std::max(0.1, measure / whole);  // before the first node as there
    const PathTerms terms = table.path({0.0, 0.0, 1500.0}, {0.0, 0.0, -1.0}, length);
    CAPTURE(length);
    CHECK(d(terms.radiance[0]) ==
          Approx(-std::expm1(-2e-5 * measure) * (1.0 + share)).epsilon(2e-6));
  }
}

TEST_CASE("the sky at the table's nodes is the table's", "[atmosphere][table]") {
  SyntheticAir air;
  air.extinction = constant(1e-4);
  air.wavelengths_um = {0.4, 0.5, 0.6, 0.7, 0.8};
  air.smooth = [](const Place& p) {
    return (2.0 + std::cos(p.azimuth_rad)) * (1.0 + p.zenith_rad) * (1.0 + d(float(p.lane)));
  };
  air.body_azimuth_rad = 350.0 * pi / 180.0;
  const AirTable of = air.table();
  const BoundAirTable table = bound(of);
  for (std::size_t i = 0; i < of.sky.zenith_rad.size(); ++i) {
    const double zenith = of.sky.zenith_rad[i];
    for (const double from_body : {0.0, 0.5 * pi, pi, -0.5 * pi, -pi}) {
      CAPTURE(zenith, from_body);
      const auto sky = table.sky(towards(zenith, air.body_azimuth_rad + from_body));
      if (zenith < 1e-9) continue;  // there azimuth has no meaning
      for (int lane = 0; lane < 5; ++lane) {
        const double expected =
            (2.0 + std::cos(from_body)) * (1.0 + zenith) * (1.0 + static_cast<double>(lane));
        // at the horizon 1e-9 rad of rounding tip the ray to the other side
        if (i + 1 < of.sky.zenith_rad.size()) CHECK(d(sky[lane]) == Approx(expected).epsilon(2e-5));
      }
    }
  }
}

TEST_CASE("azimuths wrap about the body", "[atmosphere][table]") {
  SyntheticAir air;
  air.extinction = constant(1e-4);
  air.smooth = [](const Place& p) { return (1.0 + p.azimuth_rad) * lost(p); };
  for (const double body : {0.0, 3.0, 350.0 * pi / 180.0, -2.0}) {
    air.body_azimuth_rad = body;
    const BoundAirTable table = bound(air.table());
    for (const double apart : {0.1, 1.0, 2.5, 3.1}) {
      CAPTURE(body, apart);
      const double right = d(table.sky(towards(0.9, body + apart))[0]);
      const double left = d(table.sky(towards(0.9, body - apart))[0]);
      const double expected = (1.0 + apart) * lost(towards(0.9, 0.0));
      CHECK(right == Approx(expected).epsilon(1e-5));
      CHECK(left == Approx(expected).epsilon(1e-5));
    }
  }
}

// First scattering alone: L = P(Theta) A. The phase function lies on an even grid of 180 steps in
// u = sqrt(sin(Theta / 2)). Rayleigh's is 1 + (1 - 2 u^4)^2, which bends most at u = 1, by 176
// where it is 2: off by at most h^2 176 / 16 = 3.4e-4 between nodes.
TEST_CASE("first scattering follows the angle from the body", "[atmosphere][table]") {
  SyntheticAir air;
  air.extinction = constant(1e-4);
  air.kinds = 2;
  air.phase_steps = 180;
  air.first = [](const Place& p) {  // a source in the view, whole in the sky
    return p.kind == 1 ? 0.0 : p.height_m > 0.0 ? 40.0 : 40.0 * lost(p);
  };
  const auto rayleigh = [](double c) { return 3.0 / (16.0 * pi) * (1.0 + c * c); };
  air.phase = [&](std::size_t, double c) { return rayleigh(c); };
  const BoundAirTable table = bound(air.table());
  const Vec3 sun = towards(air.body_zenith_rad, air.body_azimuth_rad);
  for (double zenith = 0.0; zenith < 1.55; zenith += 0.05) {
    for (double azimuth = 0.0; azimuth < 6.3; azimuth += 0.3) {
      const Vec3 direction = towards(zenith, azimuth);
      CAPTURE(zenith, azimuth);
      CHECK(d(table.sky(direction)[0]) ==
            Approx(40.0 * rayleigh(dot(direction, sun)) * lost(direction)).epsilon(5e-4));
    }
  }
  // at the body itself and opposite to it
  CHECK(d(table.sky(sun)[0]) == Approx(40.0 * rayleigh(1.0) * lost(sun)).epsilon(1e-5));
  const PathTerms away = table.path({0.0, 0.0, 1500.0}, -sun, 100.0);
  const double depth = 1e-4 * air_measure_m(1500.0, 1500.0 - 100.0 * sun.z, 100.0);
  CHECK(d(away.radiance[0]) == Approx(-std::expm1(-depth) * 40.0 * rayleigh(-1.0)).epsilon(1e-4));
}

// A peak 100 times as narrow as Rayleigh's: Henyey & Greenstein, g = 0.75, and 0.9. Linear between
// nodes the error is h^2 f'' / 8 of the peak.
TEST_CASE("narrow phase functions keep their peak", "[atmosphere][table]") {
  SyntheticAir air;
  air.extinction = constant(1e-4);
  air.kinds = 1;
  air.first = [](const Place& p) { return lost(p); };
  const auto peak = [](double g, double c) {
    return (1.0 - g * g) / (4.0 * pi * std::pow(1.0 + g * g - 2.0 * g * c, 1.5));
  };
  const Vec3 sun = towards(air.body_zenith_rad, air.body_azimuth_rad);
  const auto worst = [&](double g) {
    air.phase = [&, g](std::size_t, double c) { return peak(g, c); };
    air.phase_steps = 180;
    const BoundAirTable table = bound(air.table());
    double most = 0.0;
    for (double zenith = 0.0; zenith < 1.55; zenith += 0.013) {
      const Vec3 direction = towards(zenith, 2.2);
      const double expected = peak(g, dot(direction, sun)) * lost(direction);
      most = std::max(most, std::abs(d(table.sky(direction)[0]) / expected - 1.0));
    }
    return most;
  };
  CHECK(worst(0.75) < 1e-3);
  CHECK(worst(0.9) < 2e-3);
}

TEST_CASE("the zenith and the nadir have no azimuth", "[atmosphere][table]") {
  SyntheticAir air = even_air();
  air.smooth = [](const Place& p) { return 1.0 + p.zenith_rad; };
  const BoundAirTable table = bound(air.table());
  for (const Vec3 direction : {Vec3{0.0, 0.0, 1.0}, Vec3{0.0, 0.0, -1.0}, Vec3{-0.0, 0.0, 1.0}}) {
    CHECK(std::isfinite(table.sky(direction)[0]));
    CHECK(std::isfinite(table.path({0.0, 0.0, 1e3}, direction, 10.0).radiance[0]));
    CHECK(std::isfinite(table.beyond({0.0, 0.0, 1e3}, direction)[0]));
  }
  // rounding just past 1
  CHECK(std::isfinite(table.sky({0.0, 0.0, 1.0 + 1e-15})[0]));
}

// Single scattering in a column, conservative, over a black ground (Chandrasekhar 1950, section
// 59): A = F mu0 / (mu - mu0) (exp(-t / mu) - exp(-t / mu0)), with 1 / mu the air mass of the
// sphere so that it holds down to the horizon. 12 nodes, squared towards the horizon.
TEST_CASE("between nodes a clear sky is met within its stated error", "[atmosphere][table]") {
  constexpr double mu0 = 0.6;
  const double vertical = air_measure_m(0.0, 100e3, 100e3);
  const auto radiance = [&](double depth, double zenith) {
    const double way = way_to_end_m(100e3, 0.0, 0.0, std::max(0.0, std::cos(zenith)));
    double mu = vertical / air_measure_m(0.0, 100e3, way);
    if (std::abs(mu - mu0) < 1e-6) mu += 2e-6;
    return mu0 / (mu - mu0) * (std::exp(-depth / mu) - std::exp(-depth / mu0));
  };
  const auto worst = [&](double depth, int nodes) {
    SyntheticAir air;
    air.zenith_nodes = nodes;
    air.extinction = constant(depth / vertical);
    air.even = [&](const Place& p) { return radiance(depth, p.zenith_rad); };
    const BoundAirTable table = bound(air.table());
    double most = 0.0;
    for (double zenith = 0.0; zenith < 0.5 * pi; zenith += 0.002) {
      const double seen = d(table.sky(towards(zenith, 0.0))[0]);
      most = std::max(most, std::abs(seen / radiance(depth, zenith) - 1.0));
    }
    return most;
  };
  // Measured 4.6e-5, 1.4e-3, 5.1e-3; linear in the zenith angle, so twice the nodes give a quarter.
  CHECK(worst(0.01, 12) < 7e-5);
  CHECK(worst(0.1, 12) < 1.8e-3);
  CHECK(worst(0.4, 12) < 6e-3);
  CHECK(worst(0.4, 24) < 1.5e-3);
}

TEST_CASE("radiance is never negative", "[atmosphere][table]") {
  SyntheticAir air = even_air();
  air.smooth = constant(-4.0);
  const BoundAirTable table = bound(air.table());
  CHECK(table.sky({0.0, 0.6, 0.8})[0] == 0.0F);
  CHECK(table.path({0.0, 0.0, 1e3}, {0.0, 0.6, 0.8}, 1e3).radiance[0] == 0.0F);
}

TEST_CASE("a table without views changes nothing on paths", "[atmosphere][table]") {
  SyntheticAir air = even_air();
  air.view_heights_m.clear();
  const BoundAirTable table = bound(air.table());
  const PathTerms none = table.path({0.0, 0.0, 1e3}, {0.0, 0.0, -1.0}, 1e3);
  CHECK(none.transmittance[0] == 1.0F);
  CHECK(none.radiance[0] == 0.0F);
  CHECK(table.beyond({0.0, 0.0, 1e3}, {0.0, 0.0, 1.0})[0] == table.sky({0.0, 0.0, 1.0})[0]);
}

TEST_CASE("air that does nothing leaves the sky as it is", "[atmosphere][table]") {
  SyntheticAir air;  // no extinction: the sky is starlight alone
  air.even = [](const Place& p) { return 1e-6 * (1.0 + p.zenith_rad); };
  const BoundAirTable table = bound(air.table());
  for (const double zenith : {0.0, 0.5, 1.2}) {
    CHECK(d(table.sky(towards(zenith, 1.0))[0]) == Approx(1e-6 * (1.0 + zenith)).epsilon(1e-5));
  }
}

TEST_CASE("a way that runs on through the earth stays finite", "[atmosphere][table]") {
  const BoundAirTable table = bound(even_air().table());
  for (const double length_m : {2e3, 1e5, 6e6, 1e8, 1e300}) {
    const PathTerms terms = table.path({0.0, 0.0, 1e3}, {0.0, 0.0, -1.0}, length_m);
    CHECK(std::isfinite(terms.transmittance[0]));
    CHECK(std::isfinite(terms.radiance[0]));
  }
}

TEST_CASE("bodies shine through the transmittance of the table", "[atmosphere][table]") {
  const SyntheticAir air = even_air();
  const BoundAirTable table = bound(air.table());
  const double z = air.body_zenith_rad, a = air.body_azimuth_rad;
  CHECK(table.direct_transmittance(towards(z, a))[0] == 0.8F);
  CHECK(table.direct_transmittance(towards(z + 0.03, a))[0] == 0.8F);
  // more than 2 degrees away: the air's own
  const double way = way_to_end_m(100e3, 0.0, 0.0, std::cos(z + 0.05));
  const double depth = 2e-5 * air_measure_m(0.0, 100e3, way);
  CHECK(d(table.direct_transmittance(towards(z + 0.05, a))[0]) ==
        Approx(std::exp(-depth)).epsilon(1e-5));
  CHECK(table.direct_transmittance(towards(0.5 * pi + 0.01, a))[0] > 0.0F);
  CHECK(table.direct_transmittance(towards(0.5 * pi + 0.03, a))[0] == 0.0F);
}
