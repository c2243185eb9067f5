#include "atmosphere/night/night_sky.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"

using namespace nadir;
using atmosphere::urban_glow_shape;
using atmosphere::van_rhijn;

namespace {

/// Irradiance of a level surface over pi times the zenith's radiance, midpoint rule in mu^2.
double flux_over_zenith(double (*shape)(double) noexcept) {
  const int steps = 20000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) sum += shape(std::sqrt((i + 0.5) / steps));
  return sum / steps;  // 2 int mu L dmu = int L d(mu^2)
}

}  // namespace

TEST_CASE("airglow is a thin shell's: 1 in the zenith, 5 at the horizon", "[atmosphere][night]") {
  CHECK(van_rhijn(1.0) == 1.0);
  CHECK(van_rhijn(0.0) == Approx(5.0).epsilon(1e-12));
  CHECK(van_rhijn(0.5) == Approx(1.0 / std::sqrt(0.28)).epsilon(1e-12));
  CHECK(van_rhijn(1.0 + 1e-15) == 1.0);
  // int d(mu^2) / sqrt(0.04 + 0.96 mu^2) = 2 (1 - 0.2) / 0.96; 1e-6: the midpoint rule
  CHECK(flux_over_zenith(van_rhijn) == Approx(1.6 / 0.96).epsilon(1e-6));
}

TEST_CASE("airglow follows the slant path through a shell 130 km up", "[atmosphere][night]") {
  const double inner_km = 6371.0, outer_km = 6371.0 + 130.0;
  for (const double zenith_deg : {10.0, 40.0, 60.0, 75.0, 85.0}) {
    const double sine = std::sin(zenith_deg * std::numbers::pi / 180.0) * inner_km / outer_km;
    // 2 %: 0.96 rounded from 0.9604, most felt near the horizon
    CHECK(van_rhijn(std::cos(zenith_deg * std::numbers::pi / 180.0)) ==
          Approx(1.0 / std::sqrt(1.0 - sine * sine)).epsilon(0.02));
  }
}

TEST_CASE("a town's glow is that of evenly lit air", "[atmosphere][night]") {
  CHECK(urban_glow_shape(1.0) == 1.0);
  CHECK(urban_glow_shape(0.5) ==
        Approx((1.0 - std::exp(-0.8)) / (1.0 - std::exp(-0.4))).epsilon(1e-12));
  CHECK(urban_glow_shape(0.0) == Approx(1.0 / (1.0 - std::exp(-0.4))).epsilon(1e-12));
  CHECK(urban_glow_shape(-0.2) == urban_glow_shape(0.0));
  double last = urban_glow_shape(0.0);
  for (double cosine = 0.02; cosine <= 1.0; cosine += 0.02) {
    CHECK(urban_glow_shape(cosine) < last);
    last = urban_glow_shape(cosine);
  }
  // 1 - 2 E3(0.4) over 1 - exp(-0.4), E3(0.4) = 0.257286 (Abramowitz & Stegun, table 5.4)
  CHECK(flux_over_zenith(urban_glow_shape) ==
        Approx((1.0 - 2.0 * 0.257286) / (1.0 - std::exp(-0.4))).epsilon(1e-4));
}
