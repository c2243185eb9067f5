#include "thermal/conduction/surface_root.hpp"

#include <cmath>
#include <limits>

#include "core/constants.hpp"
#include "support/catch.hpp"

namespace nadir::thermal {
namespace {

constexpr double sigma = si::stefan_boltzmann;

/// Radiation, a film, natural convection and evaporation: smooth but for the kink at the air's
/// temperature.
struct FullFlux {
  double load_w_m2 = 600.0, air_k = 290.0, natural = 2.0, wet = 0.0;
  SurfaceFlux operator()(double t) const {
    const double warmer = t - air_k, root = std::cbrt(std::abs(warmer));
    const double from = std::max(t - 30.0, 1.0);
    const double pressure = t > 150.0 ? 6.112 * std::exp(17.62 * (t - 273.15) / from) : 0.0;
    const double wetter = t > 150.0 ? pressure * 17.62 * 243.15 / (from * from) : 0.0;
    return {load_w_m2 - sigma * t * t * t * t - natural * root * warmer - wet * pressure,
            -4.0 * sigma * t * t * t - 4.0 / 3.0 * natural * root - wet * wetter};
  }
};

/// Excess left over at the root in K of the demand's conductance and the flux's slope.
template <class Flux>
double residual_k(const SurfaceDemand& demand, double root, const Flux& flux) {
  const SurfaceFlux at = flux(root);
  return std::abs(demand.flux_w_m2(root) - at.w_m2) / (demand.conductance_w_m2_k - at.per_k_w_m2_k);
}

}  // namespace

// Measured 1e-12 of the temperature at worst.
TEST_CASE("flux and demand meet to eleven digits from any start", "[thermal][conduction]") {
  const double start = GENERATE(2.7, 200.0, 289.9999, 290.0, 300.0, 900.0, 2000.0);
  const double conductance = GENERATE(0.01, 3.0, 80.0, 1e4);
  const double wet = GENERATE(0.0, 1.0, 300.0);
  const SurfaceDemand demand{conductance, 295.0};
  const FullFlux flux{600.0, 290.0, 2.0, wet};
  const SurfaceRoot root = surface_root(demand, start, flux);
  CAPTURE(start, conductance, wet, root.temperature_k);
  CHECK(residual_k(demand, root.temperature_k, flux) < 3e-12 * root.temperature_k);
}

// The kink lies at the root itself: Newton converges with order 4/3 only; measured 2e-12.
TEST_CASE("a root at the kink of natural convection is found", "[thermal][conduction]") {
  const double air = 290.0;
  const FullFlux flux{sigma * std::pow(air, 4), air, 5.0, 0.0};
  const SurfaceDemand demand{0.5, air};
  CHECK(surface_root(demand, 330.0, flux).temperature_k == Approx(air).epsilon(1e-11));
  CHECK(surface_root(demand, 250.0, flux).temperature_k == Approx(air).epsilon(1e-11));
}

TEST_CASE("jumps, wrong derivatives and walls do not lead it astray", "[thermal][conduction]") {
  const SurfaceDemand demand{2.0, 300.0};
  // bisection ends at 1e-9 of the temperature
  SECTION("a jump through zero") {
    const auto jump = [](double t) { return SurfaceFlux{t < 321.0 ? 500.0 : -500.0, 0.0}; };
    CHECK(surface_root(demand, 300.0, jump).temperature_k == Approx(321.0).epsilon(1e-9));
    CHECK(surface_root(demand, 1999.0, jump).temperature_k == Approx(321.0).epsilon(1e-9));
  }
  SECTION("a derivative a thousand times too steep") {
    const auto steep = [](double t) { return SurfaceFlux{10.0 * (350.0 - t), -10000.0}; };
    CHECK(surface_root(demand, 300.0, steep).temperature_k ==
          Approx((600.0 + 3500.0) / 12.0).epsilon(2e-6));  // the moves end a thousand times early
  }
  SECTION("a derivative of the wrong sign counts as none") {
    const auto wrong = [](double t) { return SurfaceFlux{10.0 * (350.0 - t), 10.0}; };
    CHECK(surface_root(demand, 300.0, wrong).temperature_k ==
          Approx((600.0 + 3500.0) / 12.0).epsilon(1e-9));
  }
  SECTION("a film that pins the surface") {
    const auto film = [](double t) { return SurfaceFlux{1e12 * (350.0 - t), -1e12}; };
    CHECK(surface_root(demand, 300.0, film).temperature_k == Approx(350.0).epsilon(1e-12));
  }
}

TEST_CASE("the flux is asked for within 2.7 and 2000 K and is constant beyond",
          "[thermal][conduction]") {
  double least = 1e9, greatest = 0.0;
  const auto watched = [&](double t) {
    least = std::min(least, t);
    greatest = std::max(greatest, t);
    return SurfaceFlux{t < 100.0 ? 40.0 : -40.0, 0.0};
  };
  // 40 W m^-2 at 2.7 K through 2 W m^-2 K^-1: 20 K above the adiabatic -100 K
  CHECK(surface_root({2.0, -100.0}, 300.0, watched).temperature_k == Approx(-80.0).epsilon(1e-12));
  CHECK(surface_root({2.0, 2500.0}, 300.0, watched).temperature_k == Approx(2480.0).epsilon(1e-12));
  CHECK(least == 2.7);
  CHECK(greatest == 2000.0);
}

TEST_CASE("few looks at the flux are needed, and a flux that is no number ends the search",
          "[thermal][conduction]") {
  int looks = 0;
  const FullFlux full{600.0, 290.0, 2.0, 1.0};
  const auto counted = [&](double t) {
    ++looks;
    return full(t);
  };
  const SurfaceDemand demand{60.0, 300.0};
  const double root = surface_root(demand, 300.0, counted).temperature_k;
  looks = 0;
  (void)surface_root(demand, root + 0.3, counted);  // as far as a step of ten minutes goes
  CHECK(looks <= 3);
  looks = 0;
  (void)surface_root(demand, 2000.0, counted);
  CHECK(looks <= 20);
  looks = 0;
  const auto nothing = [&](double) {
    ++looks;
    return SurfaceFlux{std::numeric_limits<double>::quiet_NaN(), 0.0};
  };
  CHECK(std::isnan(surface_root(demand, 300.0, nothing).temperature_k));
  CHECK(looks <= 2);
}

// The old flux run on linearly: exact for a flux that is linear.
TEST_CASE("a root is a good guess for the next demand", "[thermal][conduction]") {
  const auto film = [](double t) { return SurfaceFlux{12.0 * (310.0 - t), -12.0}; };
  const SurfaceDemand now{40.0, 290.0}, then{25.0, 302.0};
  CHECK(surface_root(now, 280.0, film).guess(now, then) ==
        Approx(surface_root(then, 280.0, film).temperature_k).epsilon(1e-13));
}

}  // namespace nadir::thermal
