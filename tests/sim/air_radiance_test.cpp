// Radiances of the air against LOWTRAN7. docs/air-model.md explains what differs.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "atmosphere/make/columns.hpp"
#include "atmosphere/make/path_light.hpp"
#include "atmosphere/make/twilight.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "core/error.hpp"
#include "sim/lowtran_air.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

namespace nadir::sim::test {
namespace {

using namespace atmosphere;
using std::numbers::pi;

struct Case {
  const char* name;
  const char* profile;
  AerosolType haze;
  double zenith_deg;
  double ground_k;  ///< 0: the path goes up
};

/// LOWTRAN7's own layers, each at the mean temperature of its molecules. The emission of an opaque
/// layer differs from that of one whose temperature runs on to the edge by up to 4 %: a matter of
/// layers, not of physics, so that the comparison uses the same. Levels a tenth of a metre apart
/// stand for the steps.
struct EvenLayers {
  std::vector<double> level_m, temperature_k;

  explicit EvenLayers(const Profile& profile) {
    std::vector<double> z;
    for (int km = 0; km <= 25; ++km) z.push_back(km * 1e3);
    for (const double high : {30e3, 35e3, 40e3, 45e3, 50e3, 70e3, 100e3}) z.push_back(high);
    for (std::size_t k = z.size() - 1; k > 0; --k) {
      const double mean = mean_k(profile, z[k - 1], z[k]);
      level_m.push_back(k + 1 == z.size() ? z[k] : z[k] - 0.05);
      level_m.push_back(k == 1 ? z[0] : z[k - 1] + 0.05);
      temperature_k.insert(temperature_k.end(), 2, mean);
    }
  }
  static double mean_k(const Profile& profile, double from_m, double to_m) {
    double molecules = 0.0, sum = 0.0;
    constexpr int count = 20;
    for (int i = 0; i < count; ++i) {
      const Level level = level_at(profile, from_m + (to_m - from_m) * (i + 0.5) / count);
      molecules += relative_density(level);
      sum += relative_density(level) * level.temperature_k;
    }
    return sum / molecules;
  }
};

/// All extinction taken for absorption, as LOWTRAN7 does without multiple scattering.
OpticalColumn black_column(const EvenLayers& layers, const GasAbsorption& gases,
                           const Particles& particles, Micrometres wavelength,
                           const std::vector<double>& gas_depth) {
  OpticalColumn column{layers.level_m, layers.temperature_k, gas_depth, {}};
  const auto rayleigh = gases.rayleigh_depth(wavelength);
  for (std::size_t i = 0; i < gas_depth.size(); ++i) column.absorption[i] += rayleigh[i];
  for (int k = 0; k < particles.kinds(); ++k) {
    const KindOptics optics = particles.optics(k, wavelength);
    for (std::size_t i = 0; i < gas_depth.size(); ++i) {
      column.absorption[i] += particles.depth_550(k)[i] * (optics.absorption + optics.scattering);
    }
  }
  column.kinds.push_back({std::vector<double>(gas_depth.size(), 0.0),
                          std::make_shared<const PhaseFunction>(PhaseFunction::rayleigh(0.0))});
  return column;
}

AirSettings fast_settings() {
  AirSettings settings;
  settings.mode = AirMode::fast;
  return settings;
}

double thermal_radiance(const Case& c, const EvenLayers& layers, const GasAbsorption& gases,
                        const Particles& particles, Micrometres wavelength) {
  const Shells shells{layers.level_m, DirectionGrid{2}};
  const bool up = c.ground_k <= 0.0;
  const ViewPath path = view_path(shells, up ? 0.0 : 100e3, c.zenith_deg * pi / 180.0,
                                  up ? Side::above : Side::below, {1.0});
  const double ground = spectral::planck(wavelength, Kelvin{c.ground_k}).value;
  double radiance = 0.0;
  for (const AbsorptionTerm& term : gases.terms(wavelength, wavelength, 2e-3)) {
    SolveCounts counts;
    LaneInput input;
    input.column = black_column(layers, gases, particles, wavelength, term.depth);
    input.wavelength = wavelength;
    const LaneFields fields = lane_fields(input, shells, {}, fast_settings(), counts);
    const PathSums sums = PathLight{fields, {}}.along(path, 1);
    radiance += term.weight * (sums.light[LaneFields::even] + ground * std::exp(-sums.depth[0]));
  }
  return radiance;
}

struct Difference {
  double worst = 0.0;  ///< relative at a point
  double off = 0.0;    ///< share of points off by more than 1.5 %
  double band = 0.0;   ///< relative, of the sum over the band
};

}  // namespace

TEST_CASE("The air's emission agrees with LOWTRAN7", "[sim][air]") {
  // Promised: 1.5 % a point and 0.4 % in the band for the sky. From space 5 % in the cores of the
  // bands of carbon dioxide at 2350 and oxygen at 1600 cm^-1, where the layers above 30 km, 5 to 30
  // km thick with one temperature each, emit; the band is held there as well.
  const auto c =
      GENERATE(Case{"down_mls", "midlatitude_summer", AerosolType::none, 0.0, 0.0},
               Case{"down_mls_rural23", "midlatitude_summer", AerosolType::rural, 0.0, 0.0},
               Case{"down_mls_60", "midlatitude_summer", AerosolType::none, 60.0, 0.0},
               Case{"up_mls_300K", "midlatitude_summer", AerosolType::none, 180.0, 300.0},
               Case{"up_saw_257K", "subarctic_winter", AerosolType::none, 180.0, 257.2});
  auto reference = reference_columns("lowtran7_thermal.csv");
  const Layered air = lowtran_air(c.profile, c.haze);
  const EvenLayers layers{air.profile};
  const GasAbsorption gases{air.gases, air.profile, layers.level_m};
  const Particles particles{air.particles, air.aerosol, {}, layers.level_m};
  const auto& wavenumber = reference["wavenumber"];
  const auto& expected = reference[c.name];
  Difference difference;
  double sum = 0.0, expected_sum = 0.0;
  for (std::size_t i = 0; i < wavenumber.size(); ++i) {
    const double v = wavenumber[i];
    const double found = thermal_radiance(c, layers, gases, particles, Micrometres{1e4 / v});
    const double error = std::abs(found / expected[i] - 1.0);
    difference.worst = std::max(difference.worst, error);
    difference.off += (error > 0.015 ? 1.0 : 0.0) / static_cast<double>(wavenumber.size());
    sum += found / (v * v);  // per um to per cm^-1
    expected_sum += expected[i] / (v * v);
  }
  difference.band = sum / expected_sum - 1.0;
  CAPTURE(c.name, difference.worst, difference.off, difference.band);
  const bool sky = c.ground_k <= 0.0;
  // A single window point at 4440 cm^-1, 1e-5 of the peak, is off by 1.55 %.
  CHECK(difference.worst < (sky ? 0.016 : 0.06));
  CHECK(difference.off < (sky ? 0.02 : 0.08));
  CHECK(std::abs(difference.band) < 0.004);
}

namespace {

struct SunCase {
  const char* name;
  const char* profile;
  double sun_deg, zenith_deg, azimuth_deg, height_m;
};

/// First scattering, without delta scaling, and the transmittance of the path.
struct Once {
  double radiance = 0.0, transmittance = 0.0;
};
Once scattered_once(const SunCase& c, const Layered& air, Micrometres wavelength,
                    double irradiance) {
  const ColumnMaker maker{air, {wavelength}};
  const Shells shells{maker.levels_m(), DirectionGrid{2}};
  const BodyPlace sun{std::cos(c.sun_deg * pi / 180.0), 0.0};
  const Side side = c.height_m > 0.0 ? Side::below : Side::above;
  const ViewPath path = view_path(shells, c.height_m, c.zenith_deg * pi / 180.0, side, {1.0});
  const double cosine = scattering_cosine(path.zenith_rad, c.azimuth_deg * pi / 180.0, sun);
  Once once;
  for (const AbsorptionTerm& term : maker.terms({}, wavelength, 5e-4)) {
    SolveCounts counts;
    LaneInput input;
    input.column = maker.column(wavelength, term.depth);
    input.wavelength = wavelength;
    input.irradiance = {irradiance};
    LaneFields fields = lane_fields(input, shells, {sun}, fast_settings(), counts);
    fields.scaled_depth = fields.depth;
    auto& beam = fields.beams.front();
    const auto depths = slant_depths(shells.level_m, fields.depth, sun.mu0);
    std::transform(depths.begin(), depths.end(), beam.transmittance.begin(),
                   [](double d) { return std::exp(-d); });
    const PathLight light{fields, {}};
    const PathSums sums = light.along(path, 1);
    for (std::size_t k = 0; k < fields.phases.size(); ++k) {
      once.radiance += term.weight * sums.light[light.first(0, k)] * fields.phases[k]->at(cosine);
    }
    once.transmittance += term.weight * std::exp(-sums.depth[0]);
  }
  return once;
}

}  // namespace

TEST_CASE("Sunlight scattered once agrees with LOWTRAN7", "[sim][air]") {
  // 3 % from 0.31 to 1.1 um where the path lets through more than 5 %. Beyond, less and less is
  // scattered, by phase functions that LOWTRAN7 interpolates otherwise, and its sum over the band
  // model's path loses to Beer's law in strong bands: 0.9 % at 1.8 um in the zenith, up to a third
  // of almost nothing at 5 um.
  const auto c = GENERATE(SunCase{"sky_z0", "us_standard_1976", 45.0, 0.0, 0.0, 0.0},
                          SunCase{"sky_z60_az0", "us_standard_1976", 45.0, 60.0, 0.0, 0.0},
                          SunCase{"sky_z60_az90", "us_standard_1976", 45.0, 60.0, 90.0, 0.0},
                          SunCase{"sky_z60_az180", "us_standard_1976", 45.0, 60.0, 180.0, 0.0},
                          SunCase{"nadir_sza30", "us_standard_1976", 30.0, 180.0, 0.0, 100e3},
                          SunCase{"nadir_sza60", "us_standard_1976", 60.0, 180.0, 0.0, 100e3},
                          SunCase{"air3km_sza30", "midlatitude_summer", 30.0, 180.0, 0.0, 3e3});
  auto reference = reference_columns("lowtran7_scattering.csv");
  const Layered air = lowtran_air(c.profile, AerosolType::rural);
  const auto& wavenumber = reference["wavenumber"];
  const std::string name = c.name;
  double squares = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < wavenumber.size(); ++i) {
    const double v = wavenumber[i], tau = reference[name + "_tau"][i];
    if (v < 9000.0 || v > 32300.0 || tau < 0.05) continue;
    const Once once = scattered_once(c, air, Micrometres{1e4 / v}, reference["toa"][i]);
    const double error = once.radiance / reference[name + "_ss"][i] - 1.0;
    CAPTURE(name, v, error);
    CHECK(std::abs(error) < 0.035);
    CHECK(once.transmittance == Approx(tau).margin(0.003));
    squares += error * error;
    ++count;
  }
  REQUIRE(count > 15);
  CHECK(std::sqrt(squares / count) < 0.015);
}

TEST_CASE("The sun's sky fades through twilight as measured", "[sim][air]") {
  // Green light in place of the eye's whole response: 73 lux for 1 W m^-2 um^-1 (683 times the
  // 0.107 um that the response is wide). 12 %: the measurements' own scatter; by day their mean
  // weather is a little more turbid than this air.
  const double elevation = GENERATE(40.0, 10.0, 2.0, 0.0, -2.0, -4.0, -6.0, -9.0, -15.0);
  const Layered air = lowtran_air("us_standard_1976", AerosolType::rural);
  AirSettings settings;
  settings.paths = false;
  settings.zenith_nodes = 20;
  const double h = elevation * pi / 180.0;
  const ephemeris::LightSource sun{
      "sun", {0.0, std::cos(h), std::sin(h)}, Angle{0.00465}, spectral::Curve::constant(1870.0)};
  const std::vector<Micrometres> wavelengths{Micrometres{0.55}};
  const auto lanes = split_lanes(air, settings, wavelengths, {});
  const AirTable table = make_air_table(air, settings, lanes, wavelengths, {sun});
  check(table);
  double lux = 0.0;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    lux += 73.0 * lanes[i].weight * static_cast<double>(table.bodies[0].ground_irradiance[i]);
  }
  CAPTURE(elevation, lux);
  CHECK(lux == Approx(ground_illuminance_lux(elevation)).epsilon(0.12));
}

TEST_CASE("Lanes are split into terms whose weights sum to one", "[sim][air]") {
  const Layered air = lowtran_air("midlatitude_summer", AerosolType::rural);
  const std::vector<Micrometres> wavelengths{Micrometres{0.55}, Micrometres{0.94},
                                             Micrometres{10.0}};
  const std::vector<spectral::AbsorptionLane> of{{0.54, 0.56, 0}, {0.93, 0.95, 0}, {}};
  const auto lanes = split_lanes(air, {}, wavelengths, of);
  std::vector<double> sum(3, 0.0);
  for (const SplitLane& lane : lanes) {
    sum[static_cast<std::size_t>(lane.source)] += lane.weight;
    CHECK(lane.absorption.lo_um == of[static_cast<std::size_t>(lane.source)].lo_um);
  }
  for (const double s : sum) CHECK(s == Approx(1.0).epsilon(1e-12));
  CHECK(lanes.size() > 6);
}

TEST_CASE("Ground outside the air's profile and unknown light are refused", "[sim][air]") {
  Layered air = lowtran_air("us_standard_1976", AerosolType::rural);
  const std::vector<Micrometres> wavelengths{Micrometres{0.55}};
  air.ground_height_m = -900.0;
  CHECK_THROWS_AS(split_lanes(air, {}, wavelengths, {}), InputError);
  air.ground_height_m = 130e3;
  CHECK_THROWS_AS(split_lanes(air, {}, wavelengths, {}), InputError);
  air.ground_height_m = 1500.0;
  AirSettings settings;
  settings.observer_height_m = 100.0;
  const auto lanes = split_lanes(air, settings, wavelengths, {});
  CHECK_THROWS_AS(make_air_table(air, settings, lanes, wavelengths, {}), InputError);
  settings.observer_height_m = 2000.0;
  const ephemeris::LightSource sun{
      "sun",
      {0.0, 0.0, 1.0},
      Angle{0.00465},
      spectral::Curve{{1.0, 2.0}, {1.0, 1.0}, spectral::Outside::reject}};
  CHECK_THROWS_AS(make_air_table(air, settings, lanes, wavelengths, {sun}), InputError);
}

}  // namespace nadir::sim::test
