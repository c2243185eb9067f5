#include <cmath>
#include <numbers>

#include "core/constants.hpp"
#include "support/catch.hpp"
#include "thermal/conduction_random_stacks.hpp"
#include "thermal/conduction_runs.hpp"

namespace nadir::thermal::test {

// Heat gained is what came in, whatever the back, the step and the load: by construction of the
// scheme, so that only rounding is left. Measured 5e-11 of the heat exchanged, for steps of a
// second on foil; most are below 1e-13.
TEST_CASE("heat gained is heat received under random loads", "[thermal][conduction]") {
  RandomStacks random(101);
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const LayerStack stack = random.stack(20.0);
    Run run(stack, {}, random.step_s(), random.between(250.0, 320.0));
    const double before = run.heat_j_m2();
    for (int step = 0; step < 50; ++step) {
      const RandomLoad first = random.load(200.0, 350.0), second = random.load(200.0, 350.0);
      const double middle_s = run.time_s + 0.5 * run.column.step().value;
      run.advance([&](double time_s, double t) { return time_s < middle_s ? first(t) : second(t); },
                  {random.between(250.0, 320.0), random.between(250.0, 320.0)});
    }
    worst = std::max(worst,
                     std::abs(run.heat_j_m2() - before - run.received_j_m2) / run.exchanged_j_m2);
  }
  CAPTURE(worst);
  CHECK(worst < 1e-10);
}

// What backward Euler did is booked as well: loads that throw the second-order result out of range.
TEST_CASE("heat is kept where the step falls back to backward Euler", "[thermal][conduction]") {
  const Substance steel{45.0, 7800.0, 500.0};
  const double step_s = 600.0, capacity = 7800.0 * 500.0 * 0.001, film = 60.0,
               gamma = Column::gamma;
  Run run({{{steel, 0.001, 0.0}}, AdiabaticBack{}}, {}, step_s, 300.0);
  const double before = run.heat_j_m2();
  run.advance(FilmFlux{film, 2.7});
  const double middle =
      (300.0 + film * gamma * step_s / capacity * 2.7) / (1.0 + film * gamma * step_s / capacity);
  const double end = (middle + film * (1.0 - gamma) * step_s / capacity * 2.7) /
                     (1.0 + film * (1.0 - gamma) * step_s / capacity);
  CHECK(run.surface_k() == Approx(end).epsilon(1e-12));  // backward Euler's closed form
  CHECK(run.heat_j_m2() - before == Approx(run.received_j_m2).epsilon(1e-12));
}

TEST_CASE("over a day that repeats a column gains nothing", "[thermal][conduction]") {
  Run run({{{{1.51, 2400.0, 880.0}, 0.10, 0.0}}, RoomBack{Kelvin{293.0}, 0.0, 8.3}}, {}, 1200.0,
          290.0);
  const auto flux = [](double time_s, double t) {
    const double sun = std::max(0.0, -700.0 * std::cos(2.0 * std::numbers::pi * time_s / 86400.0));
    return SurfaceFlux{sun + 310.0 - si::stefan_boltzmann * std::pow(t, 4) - 15.0 * (t - 288.0),
                       -4.0 * si::stefan_boltzmann * std::pow(t, 3) - 15.0};
  };
  run.advance_to(20.0 * 86400.0, flux);  // the past decays with 5 hours: nothing is left of it
  const double received = run.received_j_m2, exchanged = run.exchanged_j_m2;
  run.advance_to(21.0 * 86400.0, flux);
  const double of_the_day = run.exchanged_j_m2 - exchanged;
  CHECK(of_the_day > 1e6);
  // rounding of the sums over 21 days
  CHECK(run.received_j_m2 - received == Approx(0.0).margin(1e-10 * of_the_day));
}

}  // namespace nadir::thermal::test
