#include "sensor/optics/annular_aperture.hpp"

#include <math.h>  // j0 and j1 of POSIX

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/quadrature.hpp"

namespace nadir::sensor {
namespace {

constexpr double pi = std::numbers::pi;

// O'Neill's transfer function as it is tabulated in books, rho in cycles per cut-off: three terms
// with an angle phi, where the code has overlaps of circles.
// Source: E. L. O'Neill, J. Opt. Soc. Am. 46, 285 (1956), with the erratum ibid. 1096.
double published_mtf(double e, double rho) {
  const auto chat = [](double q) {
    return q >= 1.0 ? 0.0 : (2.0 / pi) * (std::acos(q) - q * std::sqrt(1.0 - q * q));
  };
  const double a = chat(rho);
  if (e == 0.0) return a;
  const double b = e * e * chat(rho / e);
  double c = 0.0;
  if (rho < 0.5 * (1.0 - e)) {
    c = -2.0 * e * e;
  } else if (rho <= 0.5 * (1.0 + e)) {
    const double phi = std::acos((1.0 + e * e - 4.0 * rho * rho) / (2.0 * e));
    c = (2.0 * e / pi) * std::sin(phi) + ((1.0 + e * e) / pi) * phi -
        (2.0 * (1.0 - e * e) / pi) * std::atan((1.0 + e) / (1.0 - e) * std::tan(0.5 * phi)) -
        2.0 * e * e;
  }
  return (a + b + c) / (1.0 - e * e);
}

// Where the amplitude 2 J1(x)/x - e^2 2 J1(e x)/(e x) first vanishes.
double first_dark_ring(double e) {
  const auto amplitude = [e](double x) {
    return ::j1(x) / x - (e > 0.0 ? e * ::j1(e * x) / x : 0.0);
  };
  double lo = 1.0, hi = 3.9;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (lo + hi);
    (amplitude(middle) > 0.0 ? lo : hi) = middle;
  }
  return lo;
}

// 1 - J0^2 at the zeros of J1 (Abramowitz & Stegun, table 9.5). Born & Wolf, Principles of Optics,
// 7th ed., section 8.5.2, print 83.8 % and 91.0 %.
TEST_CASE("Airy's dark rings hold 83.8 and 91.0 % of the light", "[sensor][diffraction]") {
  const AnnularAperture clear{0.0};
  CHECK(clear.encircled(3.83170597) == Approx(1.0 - 0.4027594 * 0.4027594).margin(1e-5));
  CHECK(clear.encircled(7.01558667) == Approx(1.0 - 0.3001157 * 0.3001157).margin(1e-5));
  CHECK(clear.encircled(10.1734681) == Approx(1.0 - 0.2497049 * 0.2497049).margin(1e-5));
}

// Central spot of annular apertures: radius in lambda N, and share. Source: D. J. Schroeder,
// Astronomical Optics, 2nd ed. (2000), table 10.2.
TEST_CASE("an obscuration takes light from the central spot as published",
          "[sensor][diffraction]") {
  struct Row {
    double e, radius, share;
  };
  for (const Row row : {Row{0.0, 1.22, 0.838},
                        {0.2, 1.17, 0.764},
                        {0.33, 1.10, 0.654},
                        {0.4, 1.06, 0.584},
                        {0.5, 1.00, 0.479}}) {
    CAPTURE(row.e);
    const double ring = first_dark_ring(row.e);
    CHECK(ring / pi == Approx(row.radius).margin(0.0051));  // two decimals
    CHECK(AnnularAperture{row.e}.encircled(ring) == Approx(row.share).margin(0.00051));  // three
  }
}

TEST_CASE("encircled light is the integral of the density", "[sensor][diffraction]") {
  for (const double e : {0.0, 0.3, 0.7, 0.95}) {
    const AnnularAperture aperture{e};
    double integral = 0.0, x = 0.0;
    const double step = 1.0 / 64.0;
    for (const double to : {1.0, 3.0, 10.0, 50.0, 300.0, 900.0, 1600.0}) {
      for (; x < to - 1e-9; x += step) {
        integral += 2.0 * pi * (x + 0.5 * step) * aperture.density(x + 0.5 * step) * step;
      }
      CAPTURE(e, to);
      // The table's linear steps of 1/16 against curvature 1/2 in the middle: 1e-4 of the light.
      CHECK(aperture.encircled(to) == Approx(integral).margin(2e-4));
    }
  }
}

TEST_CASE("encircled light follows the double integral of the amplitude", "[sensor][diffraction]") {
  for (const double e : {0.0, 0.5, 0.9}) {
    const AnnularAperture aperture{e};
    for (const double to : {0.3, 2.0, 7.3, 20.0}) {
      const auto ring = [e](long double t) {
        const auto x = static_cast<double>(t);
        const double amplitude = 2.0 * (::j1(x) - e * ::j1(e * x)) / x;
        return static_cast<long double>(amplitude * amplitude / (2.0 * (1.0 - e * e)) * x);
      };
      CAPTURE(e, to);
      // Between the table's places the light goes with the area: 2e-5 at most.
      CHECK(aperture.encircled(to) ==
            Approx(static_cast<double>(support::integrate(ring, 0.0L, to, 16))).margin(2e-5));
    }
  }
}

// Averaged over rings, what lies beyond x is 2 / (pi (1 - e) x): perimeter over area.
TEST_CASE("what lies far out falls with the aperture's edges", "[sensor][diffraction]") {
  for (const double e : {0.0, 0.33, 0.7}) {
    const AnnularAperture aperture{e};
    CAPTURE(e);
    for (const double x : {100.0, 400.0, 799.0}) {
      CHECK((1.0 - aperture.encircled(x)) * x == Approx(2.0 / (pi * (1.0 - e))).epsilon(0.03));
    }
    CHECK(aperture.encircled(AnnularAperture::reach) == 1.0);
    CHECK(aperture.encircled(1e9) == 1.0);
    CHECK(aperture.density(AnnularAperture::reach) == 0.0);
  }
}

TEST_CASE("the distance of a share undoes the share within a distance", "[sensor][diffraction]") {
  for (const double e : {0.0, 0.5, 0.95}) {
    const AnnularAperture aperture{e};
    CHECK(aperture.distance(0.0) == 0.0);
    CHECK(aperture.distance(1.0 - 0x1p-53) <= AnnularAperture::reach);
    double former = 0.0;
    for (int i = 0; i < 5000; ++i) {
      const double share = (i + 0.37) / 5000.0, x = aperture.distance(share);
      REQUIRE(x >= former);
      REQUIRE(aperture.encircled(x) == Approx(share).margin(1e-9));
      former = x;
    }
  }
}

TEST_CASE("the transfer function is the published one", "[sensor][diffraction]") {
  for (const double e : {0.0, 0.05, 0.33, 0.5, 0.7, 0.95}) {
    const AnnularAperture aperture{e};
    CAPTURE(e);
    CHECK(aperture.mtf(0.0) == Approx(1.0).margin(1e-14));
    for (int i = 0; i < 997; ++i) {
      const double rho = (i + 0.5) / 997.0;
      REQUIRE(aperture.mtf(rho) == Approx(published_mtf(e, rho)).margin(1e-12));
    }
    CHECK(aperture.mtf(1.0) == 0.0);
    CHECK(aperture.mtf(1.7) == 0.0);
  }
}

// int 2 pi x p(x) J0(2 rho x) dx: spread and transfer function are each other's transform, so that
// one cannot have another scale than the other.
TEST_CASE("the transform of the spread is the transfer function", "[sensor][diffraction]") {
  for (const double e : {0.0, 0.4, 0.7, 0.95}) {
    const AnnularAperture aperture{e};
    for (const double rho : {0.02, 0.1, 0.25, 0.5, 0.8, 0.97, 1.1}) {
      double sum = 0.0;
      constexpr int rings = 40'000;
      for (int i = 0; i < rings; ++i) {
        const double share = (i + 0.5) / rings;
        sum += ::j0(2.0 * rho * aperture.distance(share));
      }
      CAPTURE(e, rho);
      // Rings of equal light grow wide far out, where J0 is small: 3e-4 at most.
      CHECK(sum / rings == Approx(aperture.mtf(rho)).margin(3e-4));
    }
  }
}

}  // namespace
}  // namespace nadir::sensor
