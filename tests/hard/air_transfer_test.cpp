#include <cmath>
#include <numbers>

#include "atmosphere/slab.hpp"
#include "atmosphere/transfer/two_stream.hpp"
#include "support/catch.hpp"

// Transfer of light through air that is hardly there and through air that is opaque, with a sun
// that grazes it: what goes in comes out, but for what is absorbed.

namespace nadir::atmosphere::test {
namespace {

using std::numbers::pi;

struct Balance {
  double up = 0.0, down = 0.0, direct = 0.0;
};

/// By two streams (streams = 2) or discrete ordinates.
TransferSolution solved(const ScaledColumn& scaled, const TransferProblem& problem, int streams) {
  return streams == 2 ? two_stream(scaled, problem, {-1.0, -1e-3, 1e-3, 1.0})
                      : discrete_ordinates(scaled, problem, streams, {-1.0, -1e-3, 1e-3, 1.0});
}
TransferProblem lit(const ScaledColumn& scaled, double mu0) {
  TransferProblem problem;
  problem.beams = {plane_beam(scaled.column, mu0)};
  problem.thermal = true;
  problem.planck.assign(static_cast<std::size_t>(scaled.column.layers()) + 1, 1.0);
  problem.sky = true;
  return problem;
}
void check_sane(const ScatteredSource& source, double most) {
  // A hundredth of the light: what Legendre series of a peak may swing below zero.
  for (const double j : source.value) {
    CHECK(std::isfinite(j));
    CHECK(std::abs(j) <= most);
  }
  CHECK(std::isfinite(source.fluxes.down_at_ground));
  CHECK(std::isfinite(source.fluxes.up_at_top));
}

TEST_CASE("air that absorbs nothing gives back all light, depth 0 to 1e3, sun to the horizon",
          "[hard][air]") {
  const int streams = GENERATE(2, 4, 8, 16);
  const double depth = GENERATE(0.0, 1e-300, 1e-8, 1.0, 1e3);
  const double g = GENERATE(0.0, 0.85);
  const ScaledColumn scaled = delta_scaled(
      column_of({0.3 * depth, 0.7 * depth}, 1.0, PhaseFunction::henyey_greenstein(g)), streams);
  for (const double mu0 : {1.0, 0.1, 1.7e-5, 1e-9}) {  // 0, 84.3, 89.999 and 90 - 6e-8 degrees
    const TransferProblem problem = lit(scaled, mu0);
    const TransferSolution s = solved(scaled, problem, streams);
    CAPTURE(streams, depth, g, mu0);
    check_sane(s.beams[0], 10.0);
    check_sane(s.sky, 2.0);
    const FieldFluxes& beam = s.beams[0].fluxes;
    CHECK(beam.up_at_top >= 0.0);
    CHECK(beam.down_at_ground >= 0.0);
    CHECK(beam.up_at_top + beam.down_at_ground + mu0 * problem.beams[0].transmittance.back() ==
          Approx(mu0).epsilon(1e-8));
    CHECK(s.sky.fluxes.up_at_top + s.sky.fluxes.down_at_ground == Approx(pi).epsilon(1e-8));
  }
}

TEST_CASE("warm air in a warm enclosure is a black body, depth 0 to 1e3", "[hard][air]") {
  const int streams = GENERATE(2, 8);
  const double depth = GENERATE(0.0, 1e-8, 1.0, 1e3);
  const double omega = GENERATE(0.0, 0.5, 0.999999, 1.0);
  const ScaledColumn scaled = delta_scaled(
      column_of({0.5 * depth, 0.5 * depth}, omega, PhaseFunction::henyey_greenstein(0.7)), streams);
  const TransferSolution s = solved(scaled, lit(scaled, 0.5), streams);
  CAPTURE(streams, depth, omega);
  check_sane(s.thermal, 2.0);
  CHECK(s.thermal.fluxes.up_at_top >= 0.0);
  CHECK(s.thermal.fluxes.up_at_top + s.sky.fluxes.up_at_top + s.ground.fluxes.up_at_top ==
        Approx(pi).epsilon(1e-8));
  CHECK(s.thermal.fluxes.down_at_ground + s.sky.fluxes.down_at_ground +
            s.ground.fluxes.down_at_ground ==
        Approx(pi).epsilon(1e-8));
}

TEST_CASE("air of depth 0 has neither light nor shadow of its own", "[hard][air]") {
  const int streams = GENERATE(2, 8);
  const ScaledColumn scaled =
      delta_scaled(column_of({0.0, 0.0}, 1.0, PhaseFunction::rayleigh(0.0)), streams);
  const TransferSolution s = solved(scaled, lit(scaled, 0.5), streams);
  CHECK(s.beams[0].fluxes.up_at_top == 0.0);
  CHECK(s.beams[0].fluxes.down_at_ground == 0.0);
  CHECK(s.thermal.fluxes.up_at_top == 0.0);
  CHECK(s.sky.fluxes.down_at_ground == Approx(pi).epsilon(1e-12));
}

TEST_CASE("air of depth 1e-8 scatters once: half of tau of Rayleigh's light goes up",
          "[hard][air]") {
  const double depth = 1e-8, mu0 = 0.6;
  const ScaledColumn scaled =
      delta_scaled(column_of({0.5 * depth, 0.5 * depth}, 1.0, PhaseFunction::rayleigh(0.0)), 8);
  const TransferSolution s = solved(scaled, lit(scaled, mu0), 8);
  // Symmetric forwards and backwards, so half up; the second scattering is 1e-8 of it. Stream
  // quadrature is exact for Rayleigh's phase function; digits: 1e-16 of the unscattered light.
  CHECK(s.beams[0].fluxes.up_at_top == Approx(0.5 * depth).epsilon(1e-6));
  CHECK(s.beams[0].fluxes.down_at_ground == Approx(0.5 * depth).epsilon(1e-6));
}

}  // namespace
}  // namespace nadir::atmosphere::test
