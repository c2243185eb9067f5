#include <cmath>
#include <numbers>

#include "core/constants.hpp"
#include "support/catch.hpp"
#include "thermal/conduction_runs.hpp"

namespace nadir::thermal::test {
namespace {

constexpr double day_s = 86400.0;
constexpr double omega = 2.0 * std::numbers::pi / day_s;
constexpr double pi = std::numbers::pi;

const Substance asphalt{0.75, 2110.0, 920.0};
const Substance concrete{1.51, 2400.0, 880.0};

/// First harmonic of what is given at even times of a day: mean amplitude and lag behind the
/// cosine.
class Harmonic {
 public:
  void add(double time_s, double value) {
    cosine_ += value * std::cos(omega * time_s);
    sine_ += value * std::sin(omega * time_s);
    ++count_;
  }
  [[nodiscard]] double amplitude() const {
    return 2.0 * std::hypot(cosine_, sine_) / static_cast<double>(count_);
  }
  [[nodiscard]] double lag_s() const { return std::atan2(sine_, cosine_) / omega; }

 private:
  double cosine_ = 0.0, sine_ = 0.0;
  long count_ = 0;
};

struct Wave {
  Harmonic surface, at_5_cm;
};

/// 100 W m^-2 cos(omega t) into a solid eight damping depths thick (the wave is down to 3e-4
/// there), from the exact wave at time 0 on; the second day is looked at. 5 cm lies on a joint.
Wave periodic(const Substance& substance, const GridSettings& grid, double step_s) {
  const double damping = damping_depth(substance, Seconds{day_s}).value;
  const LayerStack stack{{{substance, 0.05, 0.0}, {substance, 8.0 * damping, 0.0}},
                         AdiabaticBack{}};
  Run run(stack, grid, step_s, 300.0);
  const double inertia = std::sqrt(substance.conductivity_w_m_k * substance.heat_capacity_j_m3_k());
  for (std::size_t i = 0; i < run.temperature.size(); ++i) {
    const double z = run.column.grid().depth_m[i] / damping;
    run.temperature[i] +=
        100.0 / (inertia * std::sqrt(omega)) * std::exp(-z) * std::cos(-z - pi / 4.0);
  }
  const std::size_t joint = run.node_at(0.05);
  REQUIRE(run.column.grid().depth_m[joint] == Approx(0.05).epsilon(1e-12));
  const auto flux = [](double time_s, double) {
    return SurfaceFlux{100.0 * std::cos(omega * time_s), 0.0};
  };
  Wave wave;
  while (run.time_s < 2.0 * day_s) {
    run.advance(flux);
    if (run.time_s <= day_s) continue;
    wave.surface.add(run.time_s, run.surface_k());
    wave.at_5_cm.add(run.time_s, run.temperature[joint]);
  }
  return wave;
}

struct Solid {
  const char* name;
  Substance substance;
  double surface_k, at_5_cm_k, lag_5_cm_s;  // computed elsewhere from the formulae
};
const std::array<Solid, 5> solids{{
    {"asphalt", {0.75, 2110.0, 920.0}, 9.718543, 5.983340, 17470.0},
    {"dense concrete", {1.51, 2400.0, 880.0}, 6.566463, 4.597000, 15703.2},
    {"dry sandy soil", {0.3, 1600.0, 800.0}, 18.923494, 10.151560, 19363.8},
    {"fresh snow", {0.08, 100.0, 2090.0}, 90.687786, 55.706702, 17501.2},
    {"aluminium", {237.0, 2702.0, 903.0}, 0.487648, 0.472956, 11220.7},
}};

}  // namespace

// Amplitude Q / (Gamma sqrt(omega)), lag T / 8, decay exp(-z / d) and lag z / (d omega) beneath:
// H. S. Carslaw and J. C. Jaeger, Conduction of Heat in Solids (2nd ed. 1959), sections 2.6
// and 2.9.
TEST_CASE("a daily wave of flux has the amplitude, lag and decay of the closed form",
          "[thermal][conduction]") {
  for (const Solid& solid : solids) {
    CAPTURE(solid.name);
    const double damping = damping_depth(solid.substance, Seconds{day_s}).value;
    const double inertia =
        std::sqrt(solid.substance.conductivity_w_m_k * solid.substance.heat_capacity_j_m3_k());
    const double amplitude = 100.0 / (inertia * std::sqrt(omega));
    CHECK(amplitude == Approx(solid.surface_k).epsilon(1e-6));  // digits printed
    // growth 1.08, 28 to 35 nodes, steps of 600 s: measured 4.7e-4 and 2.2 s at the surface,
    // 7.6e-4 and 10 s at 5 cm, all from the depth
    const Wave fine = periodic(solid.substance, graded(1.08), 600.0);
    CHECK(fine.surface.amplitude() == Approx(solid.surface_k).epsilon(6e-4));
    CHECK(fine.surface.lag_s() == Approx(10800.0).margin(3.0));
    CHECK(fine.at_5_cm.amplitude() == Approx(solid.at_5_cm_k).epsilon(1e-3));
    CHECK(fine.at_5_cm.amplitude() == Approx(amplitude * std::exp(-0.05 / damping)).epsilon(1e-3));
    CHECK(fine.at_5_cm.lag_s() == Approx(solid.lag_5_cm_s).margin(12.0));
    // the default, 1.3: measured 5.4e-3 and 25 s, 7.8e-3 and 88 s
    const Wave coarse = periodic(solid.substance, {}, 600.0);
    CHECK(coarse.surface.amplitude() == Approx(solid.surface_k).epsilon(7e-3));
    CHECK(coarse.surface.lag_s() == Approx(10800.0).margin(30.0));
    CHECK(coarse.at_5_cm.amplitude() == Approx(solid.at_5_cm_k).epsilon(1e-2));
    CHECK(coarse.at_5_cm.lag_s() == Approx(solid.lag_5_cm_s).margin(110.0));
  }
}

// erfc(z / (2 sqrt(alpha t))), Carslaw and Jaeger section 2.5. The surface is held by a film of
// 1e7 W m^-2 K^-1, which leaves it some 1e-5 K away. Measured 1.9e-3 K of 10 K at worst.
TEST_CASE("a step of the surface's temperature goes down as the error function",
          "[thermal][conduction]") {
  Run run({{{asphalt, 1.0, 0.0}}, AdiabaticBack{}}, graded(1.05), 20.0, 300.0);
  run.advance_to(7200.0, FilmFlux{1e7, 310.0});
  const double length = 2.0 * std::sqrt(asphalt.diffusivity_m2_s() * 7200.0);
  for (std::size_t i = 0; i < run.column.nodes(); ++i) {
    const double exact = 300.0 + 10.0 * std::erfc(run.column.grid().depth_m[i] / length);
    CAPTURE(run.column.grid().depth_m[i]);
    CHECK(run.temperature[i] == Approx(exact).margin(0.003));
  }
}

// 2 q sqrt(t / (pi k rho c)), Carslaw and Jaeger section 2.9. Measured 2.9e-4 after an hour,
// 1.9e-4 after twelve.
TEST_CASE("a constant flux warms the surface with the root of time", "[thermal][conduction]") {
  Run run({{{concrete, 1.5, 0.0}}, AdiabaticBack{}}, graded(1.05), 60.0, 280.0);
  for (const double hours : {1.0, 4.0, 12.0}) {
    run.advance_to(3600.0 * hours, [](double, double) { return SurfaceFlux{200.0, 0.0}; });
    const double rise =
        400.0 * std::sqrt(3600.0 * hours /
                          (pi * concrete.conductivity_w_m_k * concrete.heat_capacity_j_m3_k()));
    CAPTURE(hours);
    CHECK(run.surface_k() - 280.0 == Approx(rise).epsilon(4e-4));
  }
}

TEST_CASE("a thin sheet cools as exp(-h t / (rho c L))", "[thermal][conduction]") {
  const Substance steel{45.0, 7800.0, 500.0};
  const double film = 20.0, tau = 7800.0 * 500.0 * 0.002 / film;
  // The scheme's own answer to this equation, (1 + (1 - 2 gamma) z) / (1 - gamma z)^2 each step
  // (Alexander 1977): rounding only. Any wrong weight of a stage shows here.
  const double step_s = GENERATE(10.0, 600.0, 3600.0);
  Run run({{{steel, 0.002, 0.0}}, AdiabaticBack{}}, {}, step_s, 330.0);
  REQUIRE(run.column.nodes() == 1);
  const double z = -step_s / tau, gamma = 1.0 - std::sqrt(0.5);
  const double factor = (1.0 + (1.0 - 2.0 * gamma) * z) / std::pow(1.0 - gamma * z, 2);
  double departure = 40.0;
  for (int i = 0; i < 20; ++i) {
    run.advance(FilmFlux{film, 290.0});
    departure *= factor;
    CHECK(run.surface_k() - 290.0 == Approx(departure).margin(1e-9));
  }
  // and the law: at 10 s, 1/39 of the time constant, 8e-6 of the departure
  if (step_s == 10.0) {
    CHECK(run.surface_k() - 290.0 == Approx(40.0 * std::exp(-200.0 / tau)).margin(40.0 * 1e-5));
  }
}

// Series resistances; the nodal values are exact for layers, so that only rounding and what is
// left of the past (below 1e-12 after these steps) remain.
TEST_CASE("a wall of many layers passes dT over the sum of L / k + 1 / h",
          "[thermal][conduction]") {
  const std::vector<Layer> layers{{{0.77, 1800.0, 840.0}, 0.10, 0.0},
                                  {{0.03, 30.0, 1400.0}, 0.06, 12.0},
                                  {{0.5, 1000.0, 1000.0}, 0.015, 0.0}};
  const double outside = 1.0 / 20.0, inside = 1.0 / 8.3;
  const double above = 0.10 / 0.77, middle = 0.06 / 0.03, below = 0.015 / 0.5;
  const double all = outside + above + middle + below + inside;
  const auto steady = [&](std::vector<Layer> of, const Back& back, std::array<double, 2> back_k) {
    Run run({std::move(of), back}, {}, 1e7, 285.0);
    StepFlux last;
    for (int i = 0; i < 12; ++i) last = run.advance(FilmFlux{20.0, 268.0}, back_k);
    return std::pair{last, run};
  };
  SECTION("between air and a room") {
    std::vector<Layer> plain = layers;
    plain[1].heat_w_m2 = 0.0;
    const bool follows = GENERATE(false, true);
    const auto [flux, run] = follows
                                 ? steady(plain, RoomBack{std::nullopt, 1.0, 8.3}, {294.0, 294.0})
                                 : steady(plain, RoomBack{Kelvin{294.0}, 0.0, 8.3}, {100.0, 100.0});
    CHECK(flux.surface_w_m2 == Approx(-26.0 / all).epsilon(1e-9));
    CHECK(flux.back_w_m2 == Approx(26.0 / all).epsilon(1e-9));
    CHECK(run.surface_k() == Approx(268.0 + 26.0 / all * outside).epsilon(1e-11));
    CHECK(run.temperature[run.node_at(0.16)] ==
          Approx(294.0 - 26.0 / all * (inside + below)).epsilon(1e-11));
  }
  SECTION("with heat released in the middle, which leaves by both ways") {
    const auto [flux, run] = steady(layers, RoomBack{Kelvin{294.0}, 0.0, 8.3}, {});
    const double outwards = (26.0 + 12.0 * (inside + below + 0.5 * middle)) / all;
    CHECK(flux.surface_w_m2 == Approx(-outwards).epsilon(1e-9));
    CHECK(flux.back_w_m2 == Approx(outwards - 12.0).epsilon(1e-9));
    CHECK(run.surface_k() == Approx(268.0 + outwards * outside).epsilon(1e-11));
  }
  SECTION("on a plate of fixed temperature") {
    const auto [flux, run] = steady(layers, FixedBack{Kelvin{294.0}}, {});
    const double outwards = (26.0 + 12.0 * (below + 0.5 * middle)) / (all - inside);
    CHECK(flux.surface_w_m2 == Approx(-outwards).epsilon(1e-9));
    CHECK(flux.back_w_m2 == Approx(outwards - 12.0).epsilon(1e-9));
    CHECK(run.temperature.back() == 294.0);
  }
  SECTION("behind which nothing passes all heat comes out at the surface") {
    const auto [flux, run] = steady(layers, AdiabaticBack{}, {});
    CHECK(flux.surface_w_m2 == Approx(-12.0).epsilon(1e-9));
    CHECK(flux.back_w_m2 == 0.0);
    CHECK(run.surface_k() == Approx(268.0 + 12.0 * outside).epsilon(1e-11));
  }
}

// One node with a room's film: h_out (T_air - T) + h_in (T_room - T) + heat = 0.
TEST_CASE("a metal roof over a room balances both films", "[thermal][conduction]") {
  Run run({{{{45.0, 7800.0, 500.0}, 0.001, 6.0}}, RoomBack{std::nullopt, 0.0, 8.3}}, {}, 1e6,
          280.0);
  REQUIRE(run.column.nodes() == 1);
  StepFlux flux;
  for (int i = 0; i < 8; ++i) flux = run.advance(FilmFlux{20.0, 270.0}, {295.0, 295.0});
  const double exact = (20.0 * 270.0 + 8.3 * 295.0 + 6.0) / 28.3;
  CHECK(run.surface_k() == Approx(exact).epsilon(1e-11));
  CHECK(flux.back_w_m2 == Approx(8.3 * (295.0 - exact)).epsilon(1e-9));
}

// a E = eps sigma (T^4 - T_sky^4); the root's 1e-12 and what is left of the past.
TEST_CASE("in sun and under a sky a surface comes to radiative equilibrium",
          "[thermal][conduction]") {
  const double absorbed = 0.7 * 800.0, emissivity = 0.9, sky = 250.0;
  const double exact =
      std::pow(absorbed / (emissivity * si::stefan_boltzmann) + std::pow(sky, 4), 0.25);
  const auto flux = [&](double, double t) {
    return SurfaceFlux{
        absorbed + emissivity * si::stefan_boltzmann * (std::pow(sky, 4) - std::pow(t, 4)),
        -4.0 * emissivity * si::stefan_boltzmann * t * t * t};
  };
  const double thickness = GENERATE(0.001, 0.5);
  Run run({{{concrete, thickness, 0.0}}, AdiabaticBack{}}, {}, 1e7, 280.0);
  for (int i = 0; i < 15; ++i) run.advance(flux);
  for (const double t : run.temperature) CHECK(t == Approx(exact).epsilon(1e-11));
}

}  // namespace nadir::thermal::test
