#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "atmosphere/gases/gas_absorption.hpp"
#include "atmosphere/gases/grid_point.hpp"
#include "atmosphere/gases/nonnegative_fit.hpp"
#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere {
namespace {

/// Isothermal air at p0 and T0 at the ground, scale height 8 km, 0 to 40 km.
Profile isothermal(double co2_ppmv, double o3_ppmv) {
  Profile profile{"isothermal", {}, 0.0};
  for (int km = 0; km <= 40; km += 4) {
    Level level{km * 1e3, standard_pressure_hpa * std::exp(-km / 8.0), 273.15, {}};
    level.mixing(Gas::co2) = co2_ppmv;
    level.mixing(Gas::o3) = o3_ppmv;
    profile.levels.push_back(level);
  }
  return profile;
}

/// A band of a gas over the whole grid, log10 C the same everywhere but for a slope.
void add_band(BandTables& tables, Gas gas, double n, double log10_c, double slope) {
  BandSet set{gas, static_cast<int>(tables.sets.size()), 1.0, n, 0.0, {}, {}};
  for (std::size_t j = 0; j < set.k.size(); ++j) {
    set.k[j] = std::pow(2.5, static_cast<double>(j) - 4.0);
    set.weight[j] = 0.1;
  }
  BandRun run{static_cast<int>(tables.sets.size()), {0.0, 5.0, {}}};
  for (int i = 0; i <= 10'000; ++i) run.log10_c.values.push_back(log10_c + slope * i);
  tables.sets.push_back(set);
  tables.bands.push_back(run);
}

BandTables without_bands() {
  BandTables tables;
  for (EvenRun* run :
       {&tables.self_296, &tables.self_260, &tables.foreign, &tables.nitrogen, &tables.oxygen,
        &tables.oxygen_per_k, &tables.oxygen_per_k2, &tables.ozone_visible, &tables.ozone_far,
        &tables.ozone_c0, &tables.ozone_c1, &tables.ozone_c2}) {
    *run = {0.0, 100.0, {0.0, 0.0}};
  }
  return tables;
}

std::shared_ptr<const BandTables> two_gases(bool swapped = false) {
  BandTables tables = without_bands();
  if (!swapped) add_band(tables, Gas::co2, 0.7, -1.5, 0.002);
  add_band(tables, Gas::o3, 0.4, 0.5, -0.001);
  if (swapped) add_band(tables, Gas::co2, 0.7, -1.5, 0.002);
  return std::make_shared<BandTables>(tables);
}

const std::vector<double> heights{40e3, 30e3, 20e3, 12e3, 7e3, 3e3, 1e3, 0.0};

double transmittance(const std::vector<AbsorptionTerm>& terms, const std::vector<double>& slant) {
  double sum = 0.0;
  for (const AbsorptionTerm& term : terms) {
    sum += term.weight *
           std::exp(-std::inner_product(slant.begin(), slant.end(), term.depth.begin(), 0.0));
  }
  return sum;
}

TEST_CASE("without an absorber one term of no depth is left", "[atmosphere][gases]") {
  const GasAbsorption none{two_gases(), isothermal(0.0, 0.0), heights};
  const auto terms = none.terms(5.0_um, 5.5_um, 1e-4);
  REQUIRE(terms.size() == 1);
  CHECK(terms[0].weight == 1.0);
  REQUIRE(terms[0].depth.size() == 7);
  for (const double depth : terms[0].depth) CHECK(depth == 0.0);
}

TEST_CASE("one gas in isothermal air has the closed form of its amount", "[atmosphere][gases]") {
  // d = 0.1 ppmv exp(-z (1 + n) / H) per km: between heights a and b the amount is
  // 0.1 ppmv H / (1 + n) (e^-a(1+n)/H - e^-b(1+n)/H).
  const auto tables = two_gases();
  const GasAbsorption gas{tables, isothermal(330.0, 0.0), heights};
  const double v = 1000.0, c = std::pow(10.0, -1.5 + 0.002 * v / 5.0);
  std::vector<double> slant(7, 0.0);
  slant[4] = 2.0;  // the layer from 3 to 7 km, at an air mass of 2
  const double scale = 8.0 / 1.7;
  const double amount = 33.0 * scale * (std::exp(-3.0 / scale) - std::exp(-7.0 / scale));
  double expected = 0.0;
  for (std::size_t j = 0; j < 10; ++j) {
    expected += 0.1 * std::exp(-tables->sets[0].k[j] * c * amount * 2.0);
  }
  const Micrometres at{1e4 / v};
  CHECK(gas.mean_transmittance(at, at, slant) == Approx(expected).epsilon(1e-12));
  // exp(-x^1) by the band model
  CHECK(gas.band_transmittance(at, slant) == Approx(std::exp(-c * amount * 2.0)).epsilon(1e-12));
}

TEST_CASE("few terms stand for all within the tolerance", "[atmosphere][gases]") {
  const GasAbsorption gas{two_gases(), isothermal(330.0, 2.0), heights};
  const double tolerance = GENERATE(1e-2, 1e-3, 5e-4);
  const double hi_um = GENERATE(10.0, 10.5);
  const Micrometres lo{10.0}, hi{hi_um};
  const auto terms = gas.terms(lo, hi, tolerance);
  double weights = 0.0;
  for (const AbsorptionTerm& term : terms) weights += term.weight;
  CHECK(weights == Approx(1.0).epsilon(1e-12));
  CHECK(terms.size() <= 24);
  CHECK(std::is_sorted(terms.begin(), terms.end(), [](const auto& a, const auto& b) {
    return std::accumulate(a.depth.begin(), a.depth.end(), 0.0) <
           std::accumulate(b.depth.begin(), b.depth.end(), 0.0);
  }));
  for (const double air_mass : {1.0, 1.5, 3.0, 5.0, 6.0}) {
    for (std::size_t end = 1; end <= 7; ++end) {
      std::vector<double> down(7, 0.0), up(7, 0.0);
      std::fill_n(down.begin(), end, air_mass);
      std::fill_n(up.rbegin(), end, air_mass);
      CHECK(std::abs(transmittance(terms, down) - gas.mean_transmittance(lo, hi, down)) <
            tolerance);
      CHECK(std::abs(transmittance(terms, up) - gas.mean_transmittance(lo, hi, up)) < tolerance);
    }
  }
}

TEST_CASE("terms do not depend on the order of the gases", "[atmosphere][gases]") {
  const GasAbsorption a{two_gases(false), isothermal(330.0, 2.0), heights};
  const GasAbsorption b{two_gases(true), isothermal(330.0, 2.0), heights};
  for (const double air_mass : {1.0, 4.0}) {
    const std::vector<double> slant(7, air_mass);
    // Which terms merge may differ; what they let through may not, within both tolerances.
    CHECK(std::abs(transmittance(a.terms(9.0_um, 9.2_um, 1e-4), slant) -
                   transmittance(b.terms(9.0_um, 9.2_um, 1e-4), slant)) < 2e-4);
  }
}

TEST_CASE("transmittance falls with the amount and with the path", "[atmosphere][gases]") {
  double before = 1.0;
  for (const double ppmv : {10.0, 100.0, 300.0, 1000.0}) {
    const GasAbsorption gas{two_gases(), isothermal(ppmv, 1.0), heights};
    const double passed =
        transmittance(gas.terms(8.0_um, 8.0_um, 1e-4), std::vector<double>(7, 1.0));
    CHECK(passed < before);
    before = passed;
  }
}

TEST_CASE("layers of any thickness hold the same amount", "[atmosphere][gases]") {
  const Profile air = isothermal(330.0, 2.0);
  const GasAbsorption thick{two_gases(), air, {40e3, 0.0}};
  const GasAbsorption thin{two_gases(), air, heights};
  const double one = thick.mean_transmittance(7.0_um, 7.1_um, {1.0});
  CHECK(thin.mean_transmittance(7.0_um, 7.1_um, std::vector<double>(7, 1.0)) ==
        Approx(one).epsilon(1e-12));
  double rayleigh = 0.0;
  for (const double depth : thin.rayleigh_depth(0.5_um)) rayleigh += depth;
  CHECK(rayleigh == Approx(thick.rayleigh_depth(0.5_um)[0]).epsilon(1e-12));
}

TEST_CASE("the points of an interval are uniform over wavelength", "[atmosphere][gases]") {
  const BandTables tables = without_bands();
  const GasAmounts amounts{tables, isothermal(0.0, 0.0), heights};
  double sum = 0.0, mean_um = 0.0;
  for (const GridPoint& point : grid_points(tables, amounts, 2.0, 2.2)) {
    sum += point.weight;
    mean_um += point.weight * 1e4 / point.wavenumber;
  }
  CHECK(sum == Approx(1.0).epsilon(1e-12));
  // Linear between points 5 cm^-1 apart: (5 / 4762)^2 / 12 of the wavelength is left.
  CHECK(mean_um == Approx(2.1).epsilon(1e-6));
  const auto one = grid_points(tables, amounts, 10.0, 10.0);
  REQUIRE(one.size() == 1);
  CHECK(one[0].wavenumber == 1000.0);
  CHECK_THROWS_WITH(
      grid_points(tables, amounts, 0.1, 0.3),
      Catch::Matchers::Contains("known from 0.2 to 10000 um, asked for 0.1 to 0.3 um"));
  CHECK_THROWS_AS(grid_points(tables, amounts, 2.2, 2.0), InputError);
}

TEST_CASE("a fit without negative unknowns finds what made its equations", "[atmosphere][gases]") {
  // x = (0.3, 0, 0.7) made them; unconstrained, the noise would take the second below 0.
  NonnegativeFit fit{3};
  for (int i = 0; i < 8; ++i) {
    const double t = 0.3 * i;
    const std::vector<double> row{std::exp(-t), std::exp(-2.0 * t), std::exp(-5.0 * t)};
    fit.add(row, 0.3 * row[0] - 1e-3 * row[1] + 0.7 * row[2], 1.0);
  }
  const auto x = fit.solve({0.3, 0.3, 0.4});
  CHECK(x[0] == Approx(0.3).margin(2e-3));
  CHECK(x[1] == 0.0);
  CHECK(x[2] == Approx(0.7).margin(2e-3));
}

TEST_CASE("levels out of order or outside the profile are refused", "[atmosphere][gases]") {
  const Profile air = isothermal(330.0, 2.0);
  CHECK_THROWS_WITH((GasAbsorption{two_gases(), air, {0.0, 10e3}}),
                    Catch::Matchers::Contains("must descend"));
  CHECK_THROWS_WITH((GasAbsorption{two_gases(), air, {50e3, 0.0}}),
                    Catch::Matchers::Contains("above"));
  CHECK_THROWS_WITH((GasAbsorption{two_gases(), air, {40e3, -1.0}}),
                    Catch::Matchers::Contains("below"));
}

}  // namespace
}  // namespace nadir::atmosphere
