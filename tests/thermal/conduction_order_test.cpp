#include <cmath>
#include <numbers>

#include "core/constants.hpp"
#include "support/catch.hpp"
#include "thermal/conduction_runs.hpp"

namespace nadir::thermal::test {
namespace {

constexpr double day_s = 86400.0;
const Substance asphalt{0.75, 2110.0, 920.0};
const Substance soil{1.0, 1700.0, 1200.0};

double damping(const Substance& substance) {
  return damping_depth(substance, Seconds{day_s}).value;
}

/// Smooth, and nothing at time 0 for a column at 290 K: sun, sky, radiation and wind.
SurfaceFlux smooth(double time_s, double t) {
  const double sun = 350.0 * (1.0 - std::cos(2.0 * std::numbers::pi * time_s / day_s));
  const double radiated = 0.95 * si::stefan_boltzmann * (std::pow(t, 4) - std::pow(290.0, 4));
  return {sun - radiated - 12.0 * (t - 290.0),
          -4.0 * 0.95 * si::stefan_boltzmann * t * t * t - 12.0};
}

/// Two layers that `first` and `growth` cut into 6 and 10 intervals without rounding: the stack
/// is the same for all grids that share it, and halving intervals gives twice as many.
LayerStack cut_without_rounding(double first, double growth) {
  const auto span = [&](int intervals) {
    return (std::pow(growth, intervals) - 1.0) / (growth - 1.0);
  };
  const double less = 1.0 - 1e-9;  // so that rounding does not add an interval
  const double upper = first * span(6), lower = first * (span(16) - span(6));
  return {{{asphalt, less * upper * damping(asphalt), 0.0},
           {soil, less * less * lower * damping(soil), 0.0}},
          AdiabaticBack{}};
}

/// Surface and joint at every full hour of a day.
std::array<std::vector<double>, 2> through_the_day(const LayerStack& stack,
                                                   const GridSettings& grid, double step_s) {
  Run run(stack, grid, step_s, 290.0);
  const std::size_t joint = run.node_at(stack.layers[0].thickness_m);
  std::array<std::vector<double>, 2> result;
  for (int hour = 1; hour <= 24; ++hour) {
    run.advance_to(3600.0 * hour, smooth);
    result[0].push_back(run.surface_k());
    result[1].push_back(run.temperature[joint]);
  }
  return result;
}

double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace

// Orders from three runs: log2 of the ratio of successive differences. No reference is needed.
// Measured 1.94 at the surface and 2.00 at the joint.
TEST_CASE("halving the step divides the error by four", "[thermal][conduction]") {
  const LayerStack stack{{{asphalt, 0.1, 0.0}, {soil, 0.8, 0.0}}, AdiabaticBack{}};
  const auto at = [&](double step_s) { return through_the_day(stack, {}, step_s); };
  const auto a = at(300.0), b = at(150.0), c = at(75.0);
  for (std::size_t place = 0; place < 2; ++place) {
    const double first = rms_difference(a[place], b[place]);
    const double second = rms_difference(b[place], c[place]);
    CAPTURE(place, first, second);
    const double order = std::log2(first / second);
    CHECK(order > 1.9);
    CHECK(order < 2.2);
  }
}

// Measured 2.00 at the surface and 2.02 at the joint of the layers.
TEST_CASE("halving the intervals divides the error by four", "[thermal][conduction]") {
  const double widest = 0.12, growth = 1.4;
  const LayerStack stack = cut_without_rounding(widest, growth);
  GridSettings grid{.first_fraction = widest, .growth = growth, .least_per_layer = 1};
  std::vector<std::array<std::vector<double>, 2>> at;
  for (std::size_t nodes = 17; nodes < 129; nodes = 2 * nodes - 1) {
    REQUIRE(make_grid(stack, grid).nodes() == nodes);
    at.push_back(through_the_day(stack, grid, 600.0));
    const double half = std::sqrt(grid.growth);  // each interval in two that grow alike
    grid.first_fraction *= 1.0 / (1.0 + half);
    grid.growth = half;
  }
  for (std::size_t place = 0; place < 2; ++place) {
    const double first = rms_difference(at[0][place], at[1][place]);
    const double second = rms_difference(at[1][place], at[2][place]);
    CAPTURE(place, first, second);
    const double order = std::log2(first / second);
    CHECK(order > 1.9);
    CHECK(order < 2.2);
  }
}

}  // namespace nadir::thermal::test
