#include "sim/files/modtran_tape7.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "atmosphere/paths/path_measure.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/table/bound_air_table.hpp"
#include "core/error.hpp"
#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "sim/files/air_import.hpp"
#include "sim/files/atomic_file.hpp"
#include "support/catch.hpp"
#include "tape7_text.hpp"

using namespace nadir;
using namespace nadir::sim;
using support::degree;
using support::direct_run;
using support::grid_of;
using support::Look;
using support::radiance_run;
using support::Slab;
using support::thermal_run;

namespace {

const AirRunSettings on_sea_modtran_tape7{0.0, 100'000.0, std::nullopt, 2.0};

atmosphere::AirTable imported(const std::string& text) {
  const support::ScratchFolder folder;
  write_file(folder / "a.tp7", text);
  AirImport wanted;
  wanted.files = {folder / "a.tp7"};
  wanted.settings = on_sea_modtran_tape7;
  return import_air(wanted);
}

std::string told_modtran_tape7(const std::string& text) {
  return support::message_of(
      [&] { static_cast<void>(parse_modtran_tape7(text, "a.tp7", on_sea_modtran_tape7)); });
}

bool has_note(const atmosphere::AirTable& table, const std::string& part) {
  return std::any_of(table.notes.begin(), table.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

// The columns have five digits, of which the last is uncertain by a half.
constexpr double digits = 1e-4;

}  // namespace

TEST_CASE("a tape7 of a homogeneous slab becomes its sky", "[modtran]") {
  const Slab slab;
  const atmosphere::AirTable table = imported(grid_of(slab));
  REQUIRE(table.lanes.size() == 3);
  CHECK(table.lanes[0].wavelength_um == Approx(1.0).epsilon(1e-12));
  CHECK(table.lanes[2].wavelength_um == Approx(10.0).epsilon(1e-12));
  const auto& sky = table.sky;
  REQUIRE(sky.zenith_rad.size() == 3);
  REQUIRE(sky.azimuth_rad.size() == 3);
  for (std::size_t lane = 0; lane < 3; ++lane) {
    const std::size_t i = 2 - lane;  // wavelengths ascend, wavenumbers did
    for (std::size_t z = 0; z < 3; ++z) {
      const double mu = std::cos(sky.zenith_rad[z]);
      CHECK(sky.even[z * 3 + lane] == Approx(slab.emitted(i, mu)).epsilon(digits).margin(1e-30));
      for (std::size_t a = 0; a < 3; ++a) {
        const double azimuth = z == 0 ? 0.0 : 90.0 * static_cast<double>(a);
        CHECK(sky.smooth[(a * 3 + z) * 3 + lane] ==
              Approx(slab.scattered(i, mu, azimuth)).epsilon(digits));
      }
    }
  }
}

TEST_CASE("a tape7's view has the slab's sources and depth", "[modtran]") {
  const Slab slab;
  const atmosphere::AirTable table = imported(grid_of(slab));
  REQUIRE(table.views.size() == 1);  // the ground's runs are all sky
  const auto& view = table.views[0];
  CHECK(view.height_m == 10'000.0);
  REQUIRE(view.zenith_rad.size() == 3);
  REQUIRE(view.share == std::vector<double>{1.0});
  for (std::size_t z = 0; z < 3; ++z) {
    const double mu = std::cos(view.zenith_rad[z]);
    const double way = atmosphere::way_to_end_m(1e5, 0.0, 1e4, mu);
    const double measure = atmosphere::air_measure_m(1e4, 0.0, way);
    for (std::size_t lane = 0; lane < 3; ++lane) {
      const std::size_t i = 2 - lane;
      // Transmittances have eight decimals.
      CHECK(view.extinction[z * 3 + lane] * measure ==
            Approx(slab.depth[i] / std::abs(mu)).epsilon(1e-6));
      CHECK(view.even[z * 3 + lane] == Approx(slab.emission[i]).epsilon(digits).margin(1e-30));
      const bool nadir = z == 2;
      CHECK(view.smooth[(2 * 3 + z) * 3 + lane] ==
            Approx(slab.source(i, nadir ? 0.0 : 180.0)).epsilon(digits));
    }
  }
}

// At the directions of runs, what rays look up is what the runs said.
TEST_CASE("rays through an imported table see what the runs saw", "[modtran]") {
  using nadir::operator""_um;
  const Slab slab;
  const auto table = std::make_shared<const atmosphere::AirTable>(imported(grid_of(slab)));
  const std::vector<float> none(table->lanes.size(), 0.0F);
  const atmosphere::BoundAirTable air{
      table, {none, none}, spectral::Lanes{{1.0_um, 5.0_um, 10.0_um}}};
  const auto towards = [&](double zenith_deg, double azimuth_deg) {
    const double z = zenith_deg * degree, a = 2.0 + azimuth_deg * degree;  // the sun is at 2 rad
    return Vec3{std::sin(z) * std::sin(a), std::sin(z) * std::cos(a), std::cos(z)};
  };
  const double mu = std::cos(60.0 * degree);
  const double way = atmosphere::way_to_end_m(1e5, 0.0, 1e4, -mu);
  const auto path = air.path({0.0, 0.0, 1e4}, towards(120.0, 90.0), way);
  const auto sky = air.sky(towards(60.0, -90.0));  // left and right of the sun are alike
  for (std::size_t i = 0; i < 3; ++i) {
    const int lane = 2 - static_cast<int>(i);
    // Digits of the columns; emission has four of them where 1 - T takes one away.
    CHECK(path.transmittance[lane] == Approx(slab.transmittance(i, mu)).epsilon(2e-5));
    const double radiance = slab.emitted(i, mu) + slab.scattered(i, mu, 90.0);
    CHECK(path.radiance[lane] == Approx(radiance).epsilon(2e-4));
    CHECK(sky[lane] == Approx(radiance).epsilon(2e-4));
  }
  CHECK(air.direct_transmittance(towards(36.8699, 0.0))[0] ==
        Approx(slab.transmittance(2, slab.sun_mu)).margin(6e-5));
}

TEST_CASE("a tape7's direct run tells the sun's irradiance and transmittance", "[modtran]") {
  const Slab slab;
  const atmosphere::AirTable table = imported(grid_of(slab));
  REQUIRE(table.bodies.size() == 1);
  const auto& sun = table.bodies[0];
  CHECK(sun.zenith_rad == Approx(std::acos(slab.sun_mu)).epsilon(1e-6));
  CHECK(sun.azimuth_rad == 2.0);
  for (std::size_t lane = 0; lane < 3; ++lane) {
    const std::size_t i = 2 - lane;
    CHECK(sun.irradiance[lane] == Approx(slab.sun[i]).epsilon(5e-3));  // three digits
    CHECK(sun.transmittance[lane] ==
          Approx(slab.transmittance(i, slab.sun_mu)).margin(6e-5));  // four decimals
  }
  CHECK(has_note(table, "the ground about does not light the air"));
  CHECK(has_note(table, "spherical albedo"));
}

// An even sky of radiance L brings pi L to level ground.
TEST_CASE("what an even sky brings to the ground is pi times its radiance", "[modtran]") {
  Slab slab;
  slab.depth = {25.0, 25.0, 25.0};  // black: every direction has the source's radiance
  const std::string text = direct_run(slab, 0.0) +
                           radiance_run(slab, {3, 0.0, 100.0, 0.0, 0.0, 0.0}) +
                           radiance_run(slab, {3, 0.0, 100.0, 80.0, 0.0, 0.0});
  const atmosphere::AirTable table = imported(text);
  // 1e-4: the quadrature of 180 rows, and the columns' digits.
  for (std::size_t lane = 0; lane < 3; ++lane) {
    const std::size_t i = 2 - lane;
    CHECK(table.even_ground_irradiance[lane] ==
          Approx(std::numbers::pi * slab.emission[i]).epsilon(2e-4).margin(1e-30));
    CHECK(table.bodies[0].ground_irradiance[lane] ==
          Approx(std::numbers::pi * slab.source(i, 0.0)).epsilon(2e-4));
  }
}

TEST_CASE("thermal runs with blank cells need no sun", "[modtran]") {
  const Slab slab;
  const atmosphere::AirTable table = imported(thermal_run(slab, {3, 0.0, 100.0, 0.0, 0.0, 0.0}) +
                                              thermal_run(slab, {3, 5.0, 0.0, 180.0, 0.0, 0.0}));
  CHECK(table.bodies.empty());
  CHECK(table.sky.even[2] == Approx(slab.emitted(0, 1.0)).epsilon(digits));
  REQUIRE(table.views.size() == 1);
  CHECK(table.views[0].even[2] == Approx(slab.emission[0]).epsilon(digits));
}

TEST_CASE("ways of part of a direction become shares, and the horizon is put in", "[modtran]") {
  // Extinction per metre of measure is k: then the source is exact at any length.
  const double k = 2e-5;
  const auto run = [&](const Look& look) {
    const double mu = std::cos(look.zenith_deg * degree);
    const double length = look.type == 3 ? atmosphere::way_to_end_m(1e5, 0.0, look.h1_km * 1e3, mu)
                                         : look.range_km * 1e3;
    const double end = atmosphere::advanced({look.h1_km * 1e3, mu}, length).height_m;
    const double tau = k * atmosphere::air_measure_m(look.h1_km * 1e3, end, length);
    Slab slab;
    slab.depth = std::vector<double>(3, tau * std::abs(mu));
    return thermal_run(slab, look);
  };
  const atmosphere::AirTable table =
      imported(run({3, 4.0, 0.0, 120.0, 0.0, 0.0}) + run({2, 4.0, 3.0, 120.0, 2.0003, 0.0}) +
               run({3, 4.0, 100.0, 40.0, 0.0, 0.0}));
  REQUIRE(table.views.size() == 1);
  const auto& view = table.views[0];
  const double horizon = std::acos(atmosphere::horizon_mu(0.0, 4000.0));
  CHECK(view.zenith_rad == std::vector<double>{40.0 * degree, horizon, horizon, 120.0 * degree});
  REQUIRE(view.share.size() == 2);
  CHECK(view.share[0] > 0.1);
  CHECK(view.share[0] < 0.5);
  CHECK(view.share[1] == 1.0);
  for (const float extinction : view.extinction) CHECK(extinction == Approx(k).epsilon(1e-5));
  for (std::size_t i = 2; i < view.even.size(); i += 3) {
    CHECK(view.even[i] == Approx(8.0).epsilon(3e-4));  // T near 1 costs digits
  }
}

TEST_CASE("ranges and heights of a way between two heights agree", "[modtran]") {
  const Slab slab;
  const auto length = [&](const Look& look) {
    const AirRunSet set = parse_modtran_tape7(thermal_run(slab, look), "a", on_sea_modtran_tape7);
    return std::pair{set.runs.at(0).length_m, set.runs.at(0).zenith_rad};
  };
  // Without a range: to where the line reaches the other height.
  const auto down = length({2, 4.0, 3.0, 120.0, 0.0, 0.0});
  CHECK(atmosphere::advanced({4000.0, std::cos(120.0 * degree)}, down.first).height_m ==
        Approx(3000.0).margin(1e-3));
  // Two heights and a range, without an angle.
  const auto found = length({2, 4.0, 3.0, 0.0, down.first * 1e-3, 0.0});
  CHECK(found.second / degree == Approx(120.0).epsilon(1e-5));
  // Level.
  CHECK(length({1, 4.0, 0.0, 0.0, 7.0, 0.0}) == std::pair{7000.0, std::numbers::pi / 2.0});
}

TEST_CASE("the eye above the air looks in at its top", "[modtran]") {
  const Slab slab;
  const atmosphere::AirTable table = imported(thermal_run(slab, {3, 700.0, 0.0, 150.0, 0.0, 0.0}));
  REQUIRE(table.views.size() == 1);
  CHECK(table.views[0].height_m == 1e5);
  // sin(zenith) r is kept along a straight line.
  const double r = atmosphere::earth_radius_m;
  CHECK(std::sin(table.views[0].zenith_rad[0]) * (r + 1e5) ==
        Approx(std::sin(150.0 * degree) * (r + 7e5)).epsilon(1e-9));
  CHECK(has_note(table, "no run looks up from the ground"));
}

TEST_CASE("columns of MODTRAN 4 and of MODTRAN 6 are known by their names", "[modtran]") {
  const Slab slab;
  const Look look{3, 0.0, 100.0, 0.0, 0.0, 0.0};
  const std::string five = thermal_run(slab, look);
  std::string four = five, six = five;
  const auto put = [](std::string& text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  put(four, "TOT_TRANS", "TOT TRANS");
  put(four, "PTH_THRML", "PTH THRML");
  put(four, "TOTAL_RAD", "TOTAL RAD");
  put(four, "SURF_EMIS", "SURF EMIS");
  put(six, "PTH_THRML", " THRML_EM");
  const auto even = [&](const std::string& text) {
    return parse_modtran_tape7(text, "a", on_sea_modtran_tape7).runs.at(0).even;
  };
  CHECK(even(four) == even(five));
  CHECK(even(six) == even(five));  // THRML_SCT, which is added there, is 0
}

TEST_CASE("a tape7's mistakes are told with their lines", "[modtran]") {
  const Slab slab;
  const std::string good = thermal_run(slab, {3, 0.0, 100.0, 0.0, 0.0, 0.0});
  const auto wrong = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    REQUIRE(text.find(from) != std::string::npos);
    text.replace(text.find(from), from.size(), to);
    return told_modtran_tape7(text);
  };
  CHECK(told_modtran_tape7("") == "a.tp7: error: the file is empty\n");
  CHECK(told_modtran_tape7("hello\n").find(
            "a.tp7:1:1: error: the file ends before a line of column names") == 0);
  CHECK(wrong("-9999.", "").find("a.tp7:11:1: error: the run has no end") == 0);
  CHECK(wrong("0.67032005", "0.6703x005").find("a.tp7:12:10: error: expected a number") == 0);
  CHECK(wrong("0.67032005", "67032005.0").find("a transmittance is 67032005") != std::string::npos);
  CHECK(wrong("TOT_TRANS", "TOT_TRAMS").find("there is no column of the transmittance") !=
        std::string::npos);
  CHECK(wrong("    3    1    1", "    7    1    1").find("hold no ITYPE") != std::string::npos);
  CHECK(wrong(" 2000.00", " 0900.00").find("the wavenumbers turn back") != std::string::npos);
  CHECK(wrong("2.6374E-06", "2.9374E-06").find("add up to") != std::string::npos);
}

// Fortran leaves out the E where an exponent has three digits.
TEST_CASE("exponents of three digits are read", "[modtran]") {
  const Slab slab;
  std::string text = thermal_run(slab, {3, 0.0, 100.0, 0.0, 0.0, 0.0});
  const std::string zero = " 0.0000E+00", tiny = " 1.2345-123";
  text.replace(text.find(zero), zero.size(), tiny);
  CHECK(parse_modtran_tape7(text, "a", on_sea_modtran_tape7).runs.size() == 1);
}

TEST_CASE("missing directions of a grid are listed", "[modtran]") {
  const Slab slab;
  std::string text = direct_run(slab, 0.0);
  for (const double zenith : {30.0, 60.0}) {
    for (const double azimuth : {0.0, 180.0}) {
      if (zenith == 60.0 && azimuth == 180.0) continue;
      text += radiance_run(slab, {3, 0.0, 100.0, zenith, 0.0, azimuth});
    }
  }
  CHECK(support::message_of([&] { static_cast<void>(imported(text)); }) ==
        "error: 1 runs are missing of a full grid of directions:\n"
        "  from 0 m at zenith angle 60, azimuth 180 degrees, to the end of the air\n");
  const std::string twice = direct_run(slab, 0.0) +
                            radiance_run(slab, {3, 0.0, 100.0, 30.0, 0.0, 0.0}) +
                            radiance_run(slab, {3, 0.0, 100.0, 30.0, 0.0, 0.0});
  CHECK(support::message_of([&] {
          static_cast<void>(imported(twice));
        }).find("run 3 gives again what an earlier run gives") != std::string::npos);
}

TEST_CASE("runs of other wavelengths or another sun do not make one table", "[modtran]") {
  Slab slab;
  const std::string one = thermal_run(slab, {3, 0.0, 100.0, 0.0, 0.0, 0.0});
  slab.nu[1] = 2001.0;
  CHECK(told_modtran_tape7(one + thermal_run(slab, {3, 0.0, 100.0, 30.0, 0.0, 0.0}))
            .find("a.tp7, run 2 has other wavelengths") != std::string::npos);
}

TEST_CASE("azimuths may be given for runs that do not say", "[modtran]") {
  const Slab slab;
  std::string text = direct_run(slab, 0.0) + radiance_run(slab, {3, 0.0, 100.0, 30.0, 0.0, 0.0});
  const std::string card = "    2    2    1    0\n";
  text.replace(text.find(card), card.size(), "    0    2    1    0\n");
  const support::ScratchFolder folder;
  write_file(folder / "a.tp7", text);
  AirImport wanted;
  wanted.files = {folder / "a.tp7"};
  wanted.settings = on_sea_modtran_tape7;
  CHECK(support::message_of([&] {
          static_cast<void>(import_air(wanted));
        }).find("does not say at which azimuth") != std::string::npos);
  wanted.azimuth_deg = {-90.0};
  CHECK(import_air(wanted).sky.azimuth_rad == std::vector<double>{90.0 * degree});
}
