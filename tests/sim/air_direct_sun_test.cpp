// Sunlight that comes straight: against LOWTRAN7, and what the shipped sun is against LOWTRAN7's.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "atmosphere/gases/gas_absorption.hpp"
#include "atmosphere/make/columns.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "sim/files/spectrum_file.hpp"
#include "sim/lowtran_air.hpp"
#include "support/catch.hpp"

namespace nadir::sim::test {
namespace {

using namespace atmosphere;

constexpr double sun_mu = 0.5 * std::numbers::sqrt2;  // 45 degrees

Layered direct_air() {
  Layered air = lowtran_air("us_standard_1976", AerosolType::rural);
  air.aerosol.relative_humidity = 0.48;  // the profile's mean over the haze
  return air;
}

}  // namespace

TEST_CASE("Direct sunlight agrees with LOWTRAN7", "[sim][air]") {
  // The levels and paths by which tables attenuate a body's light, the gases by their terms. As
  // promised for vertical paths: rms 5e-4, 0.007 at worst.
  auto reference = reference_columns("lowtran7_direct.csv");
  const ColumnMaker maker{direct_air(), {Micrometres{0.55}}};
  const std::vector<double> no_gas(maker.levels_m().size() - 1, 0.0);
  double squares = 0.0, worst = 0.0, sum = 0.0, expected_sum = 0.0, count = 0.0;
  const auto& wavenumber = reference["wavenumber"];
  for (std::size_t i = 0; i < wavenumber.size(); i += 2) {
    const double v = wavenumber[i];
    const Micrometres wavelength{1e4 / v};
    const OpticalColumn without_gas = maker.column(wavelength, no_gas);
    double passed = 0.0;
    for (const AbsorptionTerm& term : maker.terms({}, wavelength, 5e-4)) {
      std::vector<double> depth = term.depth;
      for (std::size_t k = 0; k < depth.size(); ++k) {
        depth[k] += without_gas.depth(static_cast<int>(k));
      }
      passed += term.weight * std::exp(-slant_depths(maker.levels_m(), depth, sun_mu).back());
    }
    const double error = passed - reference["tau"][i];
    squares += error * error;
    count += 1.0;
    worst = std::max(worst, std::abs(error));
    sum += passed * reference["toa"][i] / (v * v);  // per um to per cm^-1
    expected_sum += reference["direct"][i] / (v * v);
  }
  const double rms = std::sqrt(squares / count);
  CAPTURE(rms, worst, sum / expected_sum);
  CHECK(rms < 5e-4);
  CHECK(worst < 0.007);
  // The irradiance of 0.37 to 14 um: 0.05 %, the mean of the errors above.
  CHECK(sum == Approx(expected_sum).epsilon(5e-4));
}

TEST_CASE("A table passes on direct sunlight as LOWTRAN7 does", "[sim][air]") {
  // Through all of the table's making and binding. A float, and the terms' tolerance of 5e-4.
  auto reference = reference_columns("lowtran7_direct.csv");
  std::vector<std::size_t> rows{232, 187, 154, 102, 68, 43};  // 0.52 to 2.4 um
  std::vector<Micrometres> wavelengths;
  for (const std::size_t i : rows) wavelengths.emplace_back(1e4 / reference["wavenumber"][i]);
  AirSettings settings;
  settings.mode = AirMode::fast;
  settings.paths = false;
  settings.zenith_nodes = 4;
  settings.azimuth_nodes = 3;
  const Layered air = direct_air();
  const ephemeris::LightSource sun{
      "sun", {0.0, sun_mu, sun_mu}, Angle{0.00465}, spectral::Curve::constant(1000.0)};
  const auto lanes = split_lanes(air, settings, wavelengths, {});
  const AirTable table = make_air_table(air, settings, lanes, wavelengths, {sun});
  std::vector<double> passed(rows.size(), 0.0);
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    passed[static_cast<std::size_t>(lanes[lane].source)] +=
        lanes[lane].weight * static_cast<double>(table.bodies[0].transmittance[lane]);
    CHECK(table.bodies[0].irradiance[lane] == 1000.0F);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CAPTURE(wavelengths[i].value);
    CHECK(passed[i] == Approx(reference["tau"][rows[i]]).margin(0.003));
  }
}

TEST_CASE("The shipped sun is LOWTRAN7's but for what was measured since", "[sim][air]") {
  // LOWTRAN7's is some 0.6 % brighter in all and up to 4 % in the near infrared, where TSIS-1 is
  // below all older spectra (Coddington et al. 2021, doi:10.1029/2020GL091709). Parts wide enough
  // for resolution not to matter.
  auto reference = reference_columns("lowtran7_direct.csv");
  std::vector<double> um, toa;
  for (std::size_t i = reference["wavenumber"].size(); i-- > 0;) {
    um.push_back(1e4 / reference["wavenumber"][i]);
    toa.push_back(reference["toa"][i]);
  }
  const spectral::Curve lowtran{um, toa, spectral::Outside::reject};
  const spectral::Curve sun =
      read_curve(NADIR_SOURCE_DIR "/scenes/library/illumination/solar.csv", "",
                 SpectrumQuantity::irradiance, spectral::Outside::reject);
  const std::vector<double> edges{0.4, 0.5, 0.7, 1.0, 1.6, 2.5, 4.0};
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Micrometres lo{edges[i]}, hi{edges[i + 1]};
    CAPTURE(lo.value, hi.value);
    CHECK(sun.mean(lo, hi) == Approx(lowtran.mean(lo, hi)).epsilon(0.045));
  }
  const Micrometres lo{edges.front()}, hi{edges.back()};
  CHECK(sun.mean(lo, hi) == Approx(lowtran.mean(lo, hi)).epsilon(0.01));
}

}  // namespace nadir::sim::test
