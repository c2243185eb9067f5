#include "atmosphere/particles/particles.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "atmosphere/particles/haze_profile.hpp"
#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::atmosphere;

namespace {

/// Tables small enough to follow by hand. The heights of LOWTRAN7's rural haze are its own (AFGL-
/// TR-88-0177): the published column depends on them.
std::shared_ptr<const ParticleTables> small_tables() {
  ParticleTables tables;
  tables.wavelength_um = {0.2, 0.55, 1.0, 200.0};
  for (const std::string& name : required_kinds()) {
    tables.kinds[name] = {{2.0, 1.0, 0.5, 0.1}, {0.2, 0.1, 0.1, 0.1}, {0.7, 0.6, 0.5, 0.0}, {}};
  }
  const std::map<std::string, double> swelling{
      {"_0", 0.4}, {"_70", 0.5}, {"_80", 0.6}, {"_99", 0.8}};
  for (const auto& [humidity, at_one_um] : swelling) {
    tables.kinds["rural" + humidity].extinction[2] = at_one_um;
  }
  tables.kinds["maritime_0"].phase = tables.kinds["maritime_70"].phase = {0, 1};
  tables.kinds["maritime_80"].phase = tables.kinds["maritime_99"].phase = {1, 1};
  tables.phase_wavelength_um = {0.5, 2.0};
  tables.phase_angle_rad = {0.0, std::numbers::pi / 2.0, std::numbers::pi};
  tables.phase_functions = {{1.0, 1.0, 1.0}, {100.0, 1.0, 0.1}};

  tables.height_km = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 30, 35, 100};
  const std::vector<double> nothing(tables.height_km.size(), 0.0);
  for (const std::string& name : required_haze()) tables.haze[name] = nothing;
  const auto boundary = [&](const std::string& name, double a, double b, double c) {
    std::vector<double>& values = tables.haze["boundary_" + name];
    values[0] = a, values[1] = b, values[2] = c;
  };
  boundary("50", 0.0662, 0.0415, 0.026);
  boundary("23", 0.158, 0.0991, 0.0621);
  boundary("10", 0.379, 0.379, 0.0621);
  boundary("5", 0.77, 0.77, 0.0621);
  boundary("2", 1.94, 1.94, 0.0621);
  for (const std::string season : {"tropospheric_spring_summer_", "tropospheric_autumn_winter_"}) {
    tables.haze[season + "23"] = {
        0, 0, 0, 0.0346, 0.0185, 0.00931, 0.00771, 0.00623, 0.00337, 0.00182, 0.00114, 0, 0, 0, 0};
    tables.haze[season + "50"] = {
        0, 0, 0, 0.0146, 0.0102, 0.00931, 0.00771, 0.00623, 0.00337, 0.00182, 0.00114, 0, 0, 0, 0};
    const std::string veil = season.find("spring") != std::string::npos
                                 ? "stratospheric_spring_summer_"
                                 : "stratospheric_autumn_winter_";
    for (const char* const state : {"background", "moderate", "high", "extreme"}) {
      tables.haze[veil + state][11] = 8e-4;
      tables.haze[veil + state][12] = 3e-5;
    }
  }
  for (const char* const state : {"background", "moderate", "extreme"}) {
    tables.haze[std::string{"upper_"} + state][13] = 1.6e-5;
    tables.haze[std::string{"upper_"} + state][14] = 1e-9;
  }
  return std::make_shared<const ParticleTables>(tables);
}

std::vector<double> levels(double ground_m = 0.0) {
  std::vector<double> heights;
  for (int km = 100; 1e3 * km > ground_m; km -= km > 30 ? 10 : 1) heights.push_back(1e3 * km);
  heights.push_back(ground_m);
  return heights;
}

double total(const std::vector<double>& depth) {
  return std::accumulate(depth.begin(), depth.end(), 0.0);
}

double column(const Particles& particles) {
  double sum = 0.0;
  for (int kind = 0; kind < particles.kinds(); ++kind) sum += total(particles.depth_550(kind));
  return sum;
}

Particles haze(const Aerosol& aerosol, double ground_m = 0.0) {
  return {small_tables(), aerosol, {}, levels(ground_m)};
}

Aerosol seen(double visibility_km) {
  Aerosol aerosol;
  aerosol.visibility_km = visibility_km;
  return aerosol;
}

std::string refusal(const Aerosol& aerosol, const std::vector<Cloud>& clouds) {
  try {
    const Particles particles{small_tables(), aerosol, clouds, levels()};
    return "none: " + std::to_string(particles.kinds());
  } catch (const InputError& error) {
    return error.issues().at(0).message + " | " + error.issues().at(0).hint;
  }
}

}  // namespace

TEST_CASE("the boundary layer's depth is the integral of an exponential profile",
          "[atmosphere][particles]") {
  const Particles particles = haze(seen(23.0));
  // kinds differ in nothing but name in these tables, but humid ones stay apart
  const double exponential =
      (0.158 - 0.0991) / std::log(0.158 / 0.0991) + (0.0991 - 0.0621) / std::log(0.0991 / 0.0621);
  const double fading = 0.5 * 0.0621;  // linear to 0 at 3 km
  CHECK(total(particles.depth_550(0)) == Approx(exponential + fading).epsilon(1e-12));
  CHECK(particles.depth_550(0).back() ==
        Approx((0.158 - 0.0991) / std::log(0.158 / 0.0991)).epsilon(1e-12));
}

TEST_CASE("rural haze of 23 km has LOWTRAN7's column", "[atmosphere][particles]") {
  // 0.325 by a LOWTRAN7 run (US standard, 0.55 um); 0.003: these tables' stratosphere is coarse
  CHECK(column(haze(seen(23.0))) == Approx(0.325).margin(0.003));
}

TEST_CASE("the ground's extinction is Koschmieder's at any visibility", "[atmosphere][particles]") {
  for (const double visibility : {0.05, 0.4, 1.0, 3.0, 7.0, 15.0, 30.0, 50.0, 90.0, 200.0}) {
    CAPTURE(visibility);
    const Aerosol aerosol = seen(visibility);
    const auto tables = small_tables();
    const HazeProfile profile{*tables, aerosol, visibility, 0.0};
    const double extinction = profile.depth_below(0, 0.01) / 1e-5;
    // the tables are Koschmieder's to 1 % (0.0662 for 0.06665 at 50 km)
    CHECK(extinction == Approx(3.912 / visibility - 0.01159).epsilon(0.01));
  }
}

TEST_CASE("less visibility is more haze, without steps", "[atmosphere][particles]") {
  double last = column(haze(seen(336.0)));
  for (double visibility = 300.0; visibility > 0.1; visibility *= 0.97) {
    CAPTURE(visibility);
    const double now = column(haze(seen(visibility)));
    CHECK(now > last);
    // 3 % in visibility; near clean air, where little haze is left, that is a large part of it
    if (visibility < 150.0) CHECK(now / last < 1.06);
    last = now;
  }
}

TEST_CASE("the tabulated visibilities give the tabulated profiles", "[atmosphere][particles]") {
  const auto tables = small_tables();
  const std::map<double, double> at_one_km{
      {50.0, 0.0415}, {23.0, 0.0991}, {10.0, 0.379}, {5.0, 0.77}, {2.0, 1.94}};
  for (const auto& [visibility, expected] : at_one_km) {
    CAPTURE(visibility);
    const HazeProfile profile{*tables, seen(visibility), visibility, 0.0};
    const double slab = profile.depth_below(0, 1000.1) - profile.depth_below(0, 999.9);
    CHECK(slab / 2e-4 == Approx(expected).epsilon(1e-3));  // 1e-3: the kink at 1 km
  }
}

TEST_CASE("total extinction is continuous in height across the regions' edges",
          "[atmosphere][particles]") {
  const auto tables = small_tables();
  for (const double ground_m : {0.0, 2500.0}) {
    const HazeProfile profile{*tables, seen(10.0), 10.0, ground_m};
    const auto extinction = [&](double height_m) {
      double sum = 0.0;
      for (int region = 0; region < HazeProfile::regions; ++region) {
        sum += profile.depth_below(region, height_m + 0.5) -
               profile.depth_below(region, height_m - 0.5);
      }
      return 1e3 * sum;
    };
    for (const double edge : Particles::edges_m(seen(10.0), {}, ground_m)) {
      CAPTURE(edge);
      // 2 m of a profile that falls by at most e^1.8 a km
      CHECK(extinction(edge + 1.0) == Approx(extinction(edge - 1.0)).epsilon(5e-3));
    }
  }
}

TEST_CASE("an optical depth is met exactly, by a visibility that has it",
          "[atmosphere][particles]") {
  for (const double depth : {0.02, 0.1, 0.324, 1.5, 6.0}) {
    for (const double ground_m : {0.0, 1500.0}) {
      Aerosol aerosol;
      aerosol.optical_depth_550 = depth;
      const Particles particles = haze(aerosol, ground_m);
      CHECK(column(particles) == Approx(depth).epsilon(1e-9));
      CHECK(column(haze(seen(particles.visibility_km()), ground_m)) == Approx(depth).epsilon(1e-9));
    }
  }
}

TEST_CASE("raised ground squeezes the haze and keeps its extinction", "[atmosphere][particles]") {
  const auto tables = small_tables();
  const HazeProfile flat{*tables, seen(23.0), 23.0, 0.0}, raised{*tables, seen(23.0), 23.0, 1500.0};
  // 6 km of haze in 4.5 km of air
  CHECK(raised.depth_below(0, 1e5) == Approx(0.75 * flat.depth_below(0, 1e5)).epsilon(1e-12));
  CHECK(raised.depth_below(0, 3000.0) == Approx(0.75 * flat.depth_below(0, 2000.0)).epsilon(1e-12));
  CHECK(raised.depth_below(1, 1500.0) == 0.0);
  // above 6 km nothing changes
  CHECK(raised.depth_below(2, 2e4) == Approx(flat.depth_below(2, 2e4)).epsilon(1e-12));
  CHECK(raised.depth_below(1, 9e3) - raised.depth_below(1, 7e3) ==
        Approx(flat.depth_below(1, 9e3) - flat.depth_below(1, 7e3)).epsilon(1e-12));
  CHECK(column(haze(seen(23.0), 8000.0)) > 0.0);  // higher than LOWTRAN's 6 km
  CHECK(column(haze(seen(23.0), -430.0)) > column(haze(seen(23.0))));
}

TEST_CASE("humidity runs in the logarithm of dryness and meets the tables",
          "[atmosphere][particles]") {
  const auto extinction = [](double humidity) {
    Aerosol aerosol;
    aerosol.relative_humidity = humidity;
    const KindOptics optics = haze(aerosol).optics(0, 1.0_um);
    return optics.scattering + optics.absorption;
  };
  CHECK(extinction(0.0) == Approx(0.4).epsilon(1e-12));
  CHECK(extinction(0.7) == Approx(0.5).epsilon(1e-12));
  CHECK(extinction(0.8) == Approx(0.6).epsilon(1e-12));
  CHECK(extinction(0.99) == Approx(0.8).epsilon(1e-12));
  // half way between 80 and 99 % in ln(100 - RH): 100 - sqrt(20)
  CHECK(extinction(1.0 - std::sqrt(0.2 * 0.01)) == Approx(0.7).epsilon(1e-12));
  for (double humidity = 0.0; humidity < 0.97; humidity += 0.02) {
    CHECK(extinction(humidity + 0.02) > extinction(humidity));
  }
}

TEST_CASE("extinction is scattering and absorption, linear between wavelengths",
          "[atmosphere][particles]") {
  const std::vector<Cloud> clouds{{"cumulus", 1000.0, 2000.0, 10.0}};
  Aerosol none;
  none.type = AerosolType::none;
  const Particles particles{small_tables(), none, clouds, levels()};
  REQUIRE(particles.kinds() == 1);
  const KindOptics at = particles.optics(0, 0.55_um), between = particles.optics(0, 0.775_um);
  CHECK(at.scattering + at.absorption == Approx(1.0).epsilon(1e-12));
  CHECK(at.absorption == Approx(0.1).epsilon(1e-12));
  CHECK(between.scattering == Approx(0.65).epsilon(1e-12));
  CHECK(particles.scattering(0, 0.775_um) == between.scattering);
  CHECK(between.phase->asymmetry() == Approx(0.55).epsilon(1e-12));
  CHECK(between.phase->moments()[3] == Approx(0.55 * 0.55 * 0.55).epsilon(1e-12));
  CHECK_THROWS_AS(particles.optics(0, 0.19_um), InputError);
  CHECK_THROWS_AS(particles.optics(0, 201.0_um), InputError);
}

TEST_CASE("phase functions blend in wavelength and humidity without steps",
          "[atmosphere][particles]") {
  Aerosol aerosol;
  aerosol.type = AerosolType::maritime;
  aerosol.relative_humidity = 0.5;
  const Particles dry = haze(aerosol);
  const auto g = [&](double um) { return dry.optics(0, Micrometres{um}).phase->asymmetry(); };
  const PhaseFunction peaked{small_tables()->phase_angle_rad, {100.0, 1.0, 0.1}};
  CHECK(g(0.3) == Approx(0.0).margin(1e-9));  // held below 0.5 um
  CHECK(g(5.0) == Approx(peaked.asymmetry()).epsilon(1e-9));
  double last = g(0.5);
  for (double um = 0.505; um < 2.0; um *= 1.01) {
    const double now = g(um);
    CHECK(now > last);
    CHECK(now - last < 0.1);  // 1/140 of the way to a function 100 times as strong
    last = now;
  }
  aerosol.relative_humidity = 0.8;
  CHECK(haze(aerosol).optics(0, 0.5_um).phase->asymmetry() ==
        Approx(peaked.asymmetry()).epsilon(1e-9));
}

TEST_CASE("a cloud lies evenly between its base and its top", "[atmosphere][particles]") {
  Aerosol none;
  none.type = AerosolType::none;
  const Particles particles{small_tables(), none, {{"cirrus", 9500.0, 11000.0, 0.6}}, levels(0.0)};
  const std::vector<double>& depth = particles.depth_550(0);
  const auto above_km = [&](int km) { return depth[depth.size() - 1 - std::size_t(km)]; };
  CHECK(above_km(9) == Approx(0.2).epsilon(1e-12));
  CHECK(above_km(10) == Approx(0.4).epsilon(1e-12));
  CHECK(above_km(8) == 0.0);
  CHECK(above_km(11) == 0.0);
}

TEST_CASE("kinds that are alike count once, kinds that are nowhere not at all",
          "[atmosphere][particles]") {
  Aerosol none;
  none.type = AerosolType::none;
  const std::vector<Cloud> clouds{{"stratus", 500.0, 900.0, 5.0},
                                  {"stratus", 2000.0, 2500.0, 3.0},
                                  {"cirrus", 9000.0, 9500.0, 0.0}};
  const Particles particles{small_tables(), none, clouds, levels()};
  REQUIRE(particles.kinds() == 1);
  CHECK(total(particles.depth_550(0)) == Approx(8.0).epsilon(1e-12));
  CHECK(Particles{small_tables(), none, {}, levels()}.kinds() == 0);
  CHECK(haze(Aerosol{}).kinds() == 4);
  // below 8 km there is no stratosphere
  CHECK(Particles{small_tables(), Aerosol{}, {}, {8000.0, 2000.0, 0.0}}.kinds() == 2);
}

TEST_CASE("edges are those of regions and clouds over the ground", "[atmosphere][particles]") {
  const std::vector<Cloud> clouds{{"stratus", 0.0, 750.0, 5.0}};
  CHECK(Particles::edges_m(Aerosol{}, clouds, 0.0) ==
        std::vector<double>{750.0, 1000.0, 2000.0, 3000.0, 1e4, 1.1e4, 3e4, 3.5e4});
  const std::vector<double> raised = Particles::edges_m(Aerosol{}, {}, 3000.0);
  CHECK(raised[0] == Approx(3500.0).epsilon(1e-12));
  CHECK(raised[3] == 1e4);
  Aerosol none;
  none.type = AerosolType::none;
  CHECK(Particles::edges_m(none, {}, 0.0).empty());
}

TEST_CASE("haze and clouds that cannot be are refused in one sentence", "[atmosphere][particles]") {
  CHECK(refusal(seen(0.0), {}) ==
        "the visibility must be greater than 0 and less than that of clean air, 337 km, found 0 km "
        "| ");
  CHECK(refusal(seen(400.0), {}).find("found 400 km") != std::string::npos);
  CHECK(refusal(seen(std::nan("")), {}).find("visibility") != std::string::npos);
  Aerosol aerosol;
  aerosol.relative_humidity = 1.0;
  CHECK(refusal(aerosol, {}) ==
        "the relative humidity of haze must lie from 0 to 0.99, found 1 | ");
  aerosol = {};
  aerosol.optical_depth_550 = 0.001;
  CHECK(refusal(aerosol, {}).find("the haze cannot have an optical depth of 0.001 at 0.55 um") ==
        0);
  aerosol.optical_depth_550 = std::nan("");
  CHECK(refusal(aerosol, {}).find("the haze cannot have") == 0);
  CHECK(refusal({}, {{"cirus", 8e3, 9e3, 1.0}}) ==
        "unknown cloud \"cirus\" | did you mean \"cirrus\"?");
  CHECK(refusal({}, {{"cirrus", 8e3, 8e3, 1.0}}) ==
        "the cloud \"cirrus\" has no thickness: 8000 to 8000 m above the ground | ");
  CHECK(refusal({}, {{"cirrus", 8e3, 2e5, 1.0}}).find("the air reaches to 1e+05 m") !=
        std::string::npos);
  CHECK(refusal({}, {{"cirrus", -1.0, 2e3, 1.0}}).find("does not lie within the air") !=
        std::string::npos);
  CHECK(refusal({}, {{"cirrus", 8e3, 9e3, -1.0}}).find("cannot have an optical depth of -1") !=
        std::string::npos);
  CHECK_THROWS_AS(Particles(small_tables(), {}, {}, {0.0, 1000.0}), InputError);
}
