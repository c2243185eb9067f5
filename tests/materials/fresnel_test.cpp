#include "materials/scattering/fresnel.hpp"

#include <cmath>
#include <complex>

#include "support/catch.hpp"

using namespace nadir;
using materials::fresnel_dielectric;
using materials::fresnel_reflectance;
using spectral::Spectrum;

namespace {

/// The textbook's complex amplitudes, written down as they stand.
double by_amplitudes(double c, std::complex<double> m) {
  const std::complex<double> g = std::sqrt(m * m - (1.0 - c * c));
  const auto s = (c - g) / (c + g);
  const auto p = (m * m * c - g) / (m * m * c + g);
  return 0.5 * (std::norm(s) + std::norm(p));
}

}  // namespace

TEST_CASE("Fresnel's reflectance is that of its complex amplitudes", "[materials][fresnel]") {
  const double n = GENERATE(0.05, 0.3, 1.0, 1.33, 4.0, 60.0);
  const double k = GENERATE(0.0, 1e-6, 0.4, 7.0, 90.0);
  for (const double c : {1e-4, 0.02, 0.3, 0.7, 0.99, 1.0}) {
    CAPTURE(n, k, c);
    // the complex root cancels where n is near the sine; the margin is its rounding
    CHECK(fresnel_reflectance(c, n, k) ==
          Approx(by_amplitudes(c, {n, k})).epsilon(1e-11).margin(1e-12));
    CHECK(fresnel_reflectance(-c, n, k) == fresnel_reflectance(c, n, k));
  }
}

TEST_CASE("Fresnel's limits are met exactly", "[materials][fresnel]") {
  CHECK(fresnel_reflectance(1.0, 1.5, 0.0) == Approx(0.04).epsilon(1e-14));
  CHECK(fresnel_dielectric(1.0, 1.5) == Approx(0.04).epsilon(1e-14));
  CHECK(fresnel_dielectric(1.0, 1.0 / 1.5) == Approx(0.04).epsilon(1e-14));
  CHECK(fresnel_reflectance(0.0, 1.5, 0.3) == 1.0);
  CHECK(fresnel_dielectric(0.0, 1.5) == 1.0);
  const double c = GENERATE(0.0, 0.3, 1.0);  // no face: nothing is reflected
  CHECK(fresnel_reflectance(c, 1.0, 0.0) == 0.0);
  CHECK(fresnel_dielectric(c, 1.0) == 0.0);
}

// At Brewster's angle only R_s = ((1 - n^2) / (1 + n^2))^2 is left.
TEST_CASE("light polarised in the plane passes at Brewster's angle", "[materials][fresnel]") {
  const double n = GENERATE(1.33, 1.5, 4.0);
  const double r_s = std::pow((1.0 - n * n) / (1.0 + n * n), 2);
  const double c = 1.0 / std::sqrt(1.0 + n * n);
  CHECK(fresnel_dielectric(c, n) == Approx(0.5 * r_s).epsilon(1e-12));
  CHECK(fresnel_reflectance(c, n, 0.0) == Approx(0.5 * r_s).epsilon(1e-12));
}

TEST_CASE("a face reflects alike from both sides, and all beyond the critical angle",
          "[materials][fresnel]") {
  const double n = GENERATE(1.1, 1.5, 2.4);
  for (const double c : {0.05, 0.4, 0.9}) {
    const double inside = std::sqrt(1.0 - (1.0 - c * c) / (n * n));
    CHECK(fresnel_dielectric(inside, 1.0 / n) ==
          Approx(fresnel_dielectric(c, n)).epsilon(1e-9));  // `inside` is rounded
  }
  const double critical = std::sqrt(1.0 - 1.0 / (n * n));
  CHECK(fresnel_dielectric(0.999 * critical, 1.0 / n) == 1.0);
  CHECK(fresnel_dielectric(1.001 * critical, 1.0 / n) < 1.0);
  CHECK(fresnel_reflectance(0.999 * critical, 1.0 / n, 0.0) == 1.0);  // the same, n below 1
}

TEST_CASE("lanes are reflected one by one", "[materials][fresnel]") {
  Spectrum n{2, 1.5F}, k{2};
  n[1] = 0.25F;
  k[1] = 7.0F;
  const Spectrum r = fresnel_reflectance(0.4, n, k), d = fresnel_dielectric(0.4, n);
  CHECK(r[0] == static_cast<float>(fresnel_reflectance(0.4, 1.5, 0.0)));
  CHECK(r[1] == static_cast<float>(fresnel_reflectance(0.4, 0.25, 7.0)));
  CHECK(d[0] == static_cast<float>(fresnel_dielectric(0.4, 1.5)));
  CHECK(d[1] == 1.0F);  // total
}
