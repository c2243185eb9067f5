#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "support/catch.hpp"
#include "thermal/conduction_random_stacks.hpp"
#include "thermal/conduction_runs.hpp"

namespace nadir::thermal::test {

// R(z) of SDIRK2 falls to -(sqrt(2) - 1) / 2 at z = -2 (3 + 2 sqrt(2)) / sqrt(2): a sheet whose
// load jumps goes beyond its new equilibrium by at most that share of the jump, once, and comes
// back.
TEST_CASE("a jump of the load is overshot by a fifth of it at most", "[thermal][conduction]") {
  const double most = 0.5 * (std::sqrt(2.0) - 1.0);
  const double capacity = 7800.0 * 500.0 * 0.001, step_s = 600.0;
  double worst = 0.0;
  for (double film = 0.1; film < 1e5; film *= 1.05) {
    Run run({{{{45.0, 7800.0, 500.0}, 0.001, 0.0}}, AdiabaticBack{}}, {}, step_s, 300.0);
    double departure = 10.0;
    for (int i = 0; i < 4; ++i) {
      run.advance(FilmFlux{film, 310.0});
      const double now = std::abs(310.0 - run.surface_k());
      CHECK(now <= departure + 1e-9);  // never farther than before
      departure = now;
      if (i == 0) worst = std::max(worst, run.surface_k() - 310.0);
    }
  }
  CHECK(worst <= 10.0 * most * (1.0 + 1e-9));
  CHECK(worst > 10.0 * most * 0.999);  // the films of this sweep come near the worst
  // and that is where film gamma step / capacity = 1 + sqrt(2)
  const double film = (1.0 + std::sqrt(2.0)) * capacity / (Column::gamma * step_s);
  Run run({{{{45.0, 7800.0, 500.0}, 0.001, 0.0}}, AdiabaticBack{}}, {}, step_s, 300.0);
  run.advance(FilmFlux{film, 310.0});
  CHECK(run.surface_k() - 310.0 == Approx(10.0 * most).epsilon(1e-9));
}

// 390 J m^-2 K^-1 against films of 6 W m^-2 K^-1 and more: the step is 55 time constants and more.
TEST_CASE("a foil of 0.1 mm bears steps of an hour under loads that jump",
          "[thermal][conduction]") {
  const Substance steel{45.0, 7800.0, 500.0};
  RandomStacks random(7);
  Run run({{{steel, 1e-4, 0.0}}, AdiabaticBack{}}, {}, 3600.0, 290.0);
  double worst_share = 0.0;
  for (int i = 0; i < 2000; ++i) {
    RandomLoad load = random.load(220.0, 400.0);
    load.film_w_m2_k += 6.0;
    const double from = run.surface_k();
    run.advance([&](double, double t) { return load(t); });
    // the equilibrium lies between air and sky
    const double low = std::min({from, load.air_k, load.sky_k});
    const double high = std::max({from, load.air_k, load.sky_k});
    const double beyond = std::max(low - run.surface_k(), run.surface_k() - high);
    worst_share = std::max(worst_share, beyond / (high - low));
  }
  // (sqrt(2) x - 1) / (1 + x)^2 of the jump, x = gamma step film / C: 7.5 % at 55 time constants,
  // x = 16; measured 5.7 % of the span of temperatures
  CHECK(worst_share < 0.08);
}

TEST_CASE("temperatures stay within 2.7 and 2000 K whatever happens", "[thermal][conduction]") {
  RandomStacks random(2718);
  for (int i = 0; i < 2000; ++i) {
    const LayerStack stack = random.stack(0.0, 2.7, 2000.0);
    Run run(stack, {}, random.step_s(), 300.0);
    for (double& t : run.temperature) t = random.between(2.7, 2000.0);
    double least = 2000.0, greatest = 2.7;
    for (int step = 0; step < 12; ++step) {
      const RandomLoad first = random.load(2.7, 2000.0), second = random.load(2.7, 2000.0);
      const double middle_s = run.time_s + 0.5 * run.column.step().value;
      run.advance([&](double time_s, double t) { return time_s < middle_s ? first(t) : second(t); },
                  {random.between(2.7, 2000.0), random.between(2.7, 2000.0)});
      for (const double t : run.temperature) {
        REQUIRE(std::isfinite(t));
        least = std::min(least, t);
        greatest = std::max(greatest, t);
      }
    }
    CAPTURE(i, run.column.nodes(), run.column.step().value);
    // rounding of the root and of sums of some hundred terms
    REQUIRE(least >= 2.7 * (1.0 - 1e-10));
    REQUIRE(greatest <= 2000.0 * (1.0 + 1e-10));
  }
}

TEST_CASE("a column refuses steps that are not positive", "[thermal][conduction]") {
  const LayerStack stack{{{{1.0, 2000.0, 1000.0}, 0.3, 0.0}}, AdiabaticBack{}};
  CHECK_THROWS_AS(Column(stack, {}, Seconds{0.0}), InputError);
  CHECK_THROWS_AS(Column(stack, {}, Seconds{-600.0}), InputError);
  CHECK_THROWS_AS(Column(stack, {}, Seconds{std::nan("")}), InputError);
  CHECK_THROWS_AS(Column({{}, AdiabaticBack{}}, {}, Seconds{600.0}), InputError);
}

// Odd and even numbers of nodes take different ways through the sweeps: any grid must give the
// tridiagonal system's solution. Checked by its own equations: a stage of a step so long that
// capacities do not count leaves the same flux through every interval.
TEST_CASE("every number of nodes solves its equations", "[thermal][conduction]") {
  for (int intervals = 1; intervals <= 127; ++intervals) {
    const GridSettings grid{.first_fraction = 1e3, .growth = 1.02, .least_per_layer = intervals};
    const LayerStack stack{{{{1.3, 2000.0, 900.0}, 0.6, 0.0}}, RoomBack{Kelvin{310.0}, 0.0, 5.0}};
    Run run(stack, grid, 1e13, 300.0);
    REQUIRE(run.column.nodes() == static_cast<std::size_t>(intervals) + 1);
    const StepFlux done = run.advance(FilmFlux{20.0, 280.0});
    const double exact = 30.0 / (1.0 / 20.0 + 0.6 / 1.3 + 1.0 / 5.0);
    CAPTURE(intervals);
    CHECK(done.back_w_m2 == Approx(exact).epsilon(1e-5));  // 1e-6 of the past is left
    for (std::size_t i = 0; i + 1 < run.column.nodes(); ++i) {
      CHECK(run.column.grid().conductance_w_m2_k[i] *
                (run.temperature[i + 1] - run.temperature[i]) ==
            Approx(exact).epsilon(1e-5));
    }
  }
}

}  // namespace nadir::thermal::test
