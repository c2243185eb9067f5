#include "sim/files/band_tables.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <string>

#include "atmosphere/gases/gas_absorption.hpp"
#include "atmosphere/reference.hpp"
#include "core/error.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using namespace nadir::atmosphere;

const std::filesystem::path folder =
    std::filesystem::path{NADIR_SOURCE_DIR} / "scenes/library/atmosphere";

std::shared_ptr<const BandTables> shipped() {
  static const auto tables = std::make_shared<const BandTables>(read_band_tables(folder));
  return tables;
}

/// LOWTRAN7's own levels.
std::vector<double> levels_m() {
  std::vector<double> heights{100e3, 90e3, 80e3, 70e3, 60e3, 50e3, 45e3, 40e3, 35e3, 30e3, 27.5e3};
  for (int km = 25; km >= 0; --km) heights.push_back(km * 1e3);
  return heights;
}

TEST_CASE("the shipped figures of the gases are whole", "[sim][gases]") {
  const auto tables = shipped();
  CHECK(tables->sets.size() == 41);
  std::size_t figures = 0;
  for (const BandRun& run : tables->bands) figures += run.log10_c.values.size();
  CHECK(figures == 7794);
  CHECK(tables->standard.size() == 6);
  CHECK(tables->nitric_acid.size() == 3);
  CHECK(tables->ozone_far.last() == 50'000.0);
  for (const BandSet& set : tables->sets) {
    // The fits are stated to 3e-4 at worst; half way between the points that they were made at.
    for (double x = 1e-5; x < 100.0; x *= 3.0) {
      double sum = 0.0;
      for (std::size_t j = 0; j < set.k.size(); ++j) sum += set.weight[j] * std::exp(-set.k[j] * x);
      CHECK(std::abs(sum - std::exp(-std::pow(x, set.a))) < 3.5e-4);
    }
  }
}

TEST_CASE("standard profiles have the columns that are known of them", "[sim][gases]") {
  struct Case {
    const char* name;
    double water_cm, ozone_atm_cm;
  };
  // shipped figures integrated independently, three digits
  for (const Case& c :
       {Case{"tropical", 4.12, 0.282}, Case{"midlatitude_summer", 2.92, 0.334},
        Case{"midlatitude_winter", 0.852, 0.378}, Case{"subarctic_summer", 2.08, 0.348},
        Case{"subarctic_winter", 0.416, 0.375}, Case{"us_standard_1976", 1.42, 0.344}}) {
    const Profile profile = standard_profile(*shipped(), c.name);
    CHECK(water_column(profile, 0.0) == Approx(c.water_cm).epsilon(4e-3));
    CHECK(1e-3 * ozone_column(profile, 0.0) == Approx(c.ozone_atm_cm).epsilon(3e-3));
    CHECK(profile.levels.front().mixing(Gas::co2) == Approx(420.0).epsilon(1e-12));
    CHECK_NOTHROW(level_at(profile, -500.0));
    CHECK_THROWS_AS(level_at(profile, -501.0), InputError);
  }
  CHECK_THROWS_WITH(standard_profile(*shipped(), "tropcal"),
                    Catch::Matchers::Contains("did you mean"));
  CHECK_THROWS_WITH(standard_profile(*shipped(), "mars"),
                    Catch::Matchers::Contains("known: tropical"));
}

/// Differences from LOWTRAN7 over 700 to 27,000 cm^-1: rms and largest.
struct BandTablesDifference {
  double rms = 0.0, worst = 0.0;
};
template <class Transmittance>
BandTablesDifference difference(const atmosphere::support::Reference& reference, std::size_t every,
                                Transmittance of) {
  double squares = 0.0, worst = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < reference.wavenumber.size(); i += every) {
    const double v = reference.wavenumber[i];
    if (v < 700.0 || v > 27'000.0) continue;
    const double error = of(Micrometres{1e4 / v}) - reference.transmittance[i];
    squares += error * error;
    worst = std::max(worst, std::abs(error));
    ++count;
  }
  return {std::sqrt(squares / count), worst};
}

TEST_CASE("the clear vertical air transmits as LOWTRAN7's does", "[sim][gases]") {
  const std::string name = GENERATE("tropical", "midlatitude_summer", "midlatitude_winter",
                                    "subarctic_summer", "subarctic_winter", "us_standard_1976");
  CAPTURE(name);
  const GasAbsorption gas{shipped(), standard_profile(*shipped(), name, 330.0), levels_m()};
  const auto rayleigh = [&](Micrometres at) {
    const auto depth = gas.rayleigh_depth(at);
    return std::exp(-std::accumulate(depth.begin(), depth.end(), 0.0));
  };
  const auto reference = atmosphere::support::lowtran7(name + "_clear");
  const std::vector<double> vertical(static_cast<std::size_t>(gas.layers()), 1.0);
  const BandTablesDifference band = difference(reference, 1, [&](Micrometres at) {
    return gas.band_transmittance(at, vertical) * rayleigh(at);
  });
  // Measured 1.9e-4 to 3.4e-4, at most 0.0037: rounding and layers of LOWTRAN7.
  CHECK(band.rms < 4e-4);
  CHECK(band.worst < 0.0045);
  // With the sums' own tolerance; every seventh wavenumber, for time.
  const BandTablesDifference terms = difference(reference, 7, [&](Micrometres at) {
    double passed = 0.0;
    for (const AbsorptionTerm& term : gas.terms(at, at, 5e-4)) {
      passed += term.weight * std::exp(-std::accumulate(term.depth.begin(), term.depth.end(), 0.0));
    }
    return passed * rayleigh(at);
  });
  CHECK(terms.rms < 5e-4);
  CHECK(terms.worst < 0.007);
}

TEST_CASE("windows need one term and bands a handful", "[sim][gases]") {
  const GasAbsorption gas{shipped(), standard_profile(*shipped(), "midlatitude_summer"),
                          levels_m()};
  CHECK(gas.terms(0.45_um, 0.45_um, 5e-4).size() == 1);
  CHECK(gas.terms(0.40_um, 0.50_um, 5e-4).size() == 1);  // ozone alone, and little of it
  CHECK(gas.terms(0.85_um, 0.88_um, 5e-4).size() <= 6);
  CHECK(gas.terms(10.9_um, 10.9_um, 5e-4).size() <= 10);
  CHECK(gas.terms(9.6_um, 9.6_um, 5e-4).size() <= 40);
}

TEST_CASE("terms keep their tolerance in bands of the real air", "[sim][gases]") {
  const GasAbsorption gas{shipped(), standard_profile(*shipped(), "midlatitude_summer"),
                          levels_m()};
  const double lo_um = GENERATE(0.76, 0.94, 1.38, 2.06, 4.3, 9.6, 15.0);
  const Micrometres lo{lo_um}, hi{lo_um + 0.01};
  CAPTURE(lo_um);
  const auto terms = gas.terms(lo, hi, 1e-3);
  const auto layers = static_cast<std::size_t>(gas.layers());
  for (const double air_mass : {1.0, 2.5, 6.0}) {
    for (std::size_t end = 3; end <= layers; end += 3) {
      std::vector<double> down(layers, 0.0), up(layers, 0.0);
      std::fill_n(down.begin(), end, air_mass);
      std::fill_n(up.rbegin(), end, air_mass);
      for (const auto& slant : {down, up}) {
        double passed = 0.0;
        for (const AbsorptionTerm& term : terms) {
          passed += term.weight * std::exp(-std::inner_product(slant.begin(), slant.end(),
                                                               term.depth.begin(), 0.0));
        }
        CHECK(std::abs(passed - gas.mean_transmittance(lo, hi, slant)) < 1e-3);
      }
    }
  }
}

TEST_CASE("damaged figures of the gases are refused with their place", "[sim][gases]") {
  const support::ScratchFolder scratch;
  const auto damaged = [&](const char* name, const std::string& text) {
    for (const char* file :
         {"gas_sets.csv", "gas_bands.txt", "gas_continua.txt", "standard_profiles.csv"}) {
      std::filesystem::copy_file(folder / file, scratch.path() / file,
                                 std::filesystem::copy_options::overwrite_existing);
    }
    std::ofstream{scratch.path() / name} << text;
    try {
      static_cast<void>(read_band_tables(scratch.path()));
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{"(nothing thrown)"};
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(damaged("gas_bands.txt", "# x\nrun h2o/99 0 5 2\n1 2\n"),
             Contains("gas_bands.txt:3") && Contains("no set \"h2o/99\""));
  CHECK_THAT(damaged("gas_bands.txt", "run h2o/17 0 5 3\n1 2\n"), Contains("ends within a run"));
  CHECK_THAT(damaged("gas_bands.txt", "run h2o/17 0 5 2\n1 x\n"),
             Contains("gas_bands.txt:2:3") && Contains("expected a finite number, found \"x\""));
  CHECK_THAT(damaged("gas_bands.txt", "run h2o/17 0 5 2\n1 2 3\n"), Contains("more figures"));
  CHECK_THAT(damaged("gas_continua.txt", "run n2/continuum 0 5 2\n1 2\n"), Contains("is missing"));
  CHECK_THAT(damaged("gas_sets.csv", "names\nxenon,1\n"), Contains("unknown gas \"xenon\""));
  CHECK_THAT(damaged("standard_profiles.csv", "names\na,0,1013\n"), Contains("finite number"));
  CHECK_THROWS_AS(read_band_tables("/nowhere"), InputError);
}

}  // namespace
}  // namespace nadir::sim
