#include <cmath>

#include "air_slab.hpp"
#include "atmosphere/paths/path_measure.hpp"
#include "core/error.hpp"
#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "sim/files/air_import.hpp"
#include "sim/files/atomic_file.hpp"
#include "sim/files/uvspec_output.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using support::degree;
using support::printed;

namespace {

const AirRunSettings on_sea_uvspec{0.0, 100'000.0, std::nullopt, 1.0};

// A slab of optical depth 0.6, of which 0.4 lie below the eye at 5 km; sources are 20 (solar, at
// azimuth 0) and 7 (thermal) at either wavelength times 1 and 2.
constexpr double below = 0.4, above = 0.2, mu0 = 0.5, sun = 1500.0;

double depth_over(int level) { return level == 0 ? below + above : level == 1 ? above : 0.0; }
double way(int level, double umu) {
  return (umu > 0.0 ? below + above - depth_over(level) : depth_over(level)) / std::abs(umu);
}
double solar(int wave, int level, double umu, double phi_deg) {
  return 20.0 * (wave + 1) * (1.0 - phi_deg / 360.0) * (1.0 - std::exp(-way(level, umu)));
}
double edir(int wave, int level) {
  return sun * (wave + 1) * mu0 * std::exp(-depth_over(level) / mu0);
}
const std::vector<double> umus{-1.0, -0.5, 0.5, 1.0};

const char* const solar_input =
    "# a slab\nsource solar ../data/solar_flux/atlas_plus_modtran\nsza 60 # degrees\nphi0 10\n"
    "umu -1 -0.5 0.5 1\nphi 10 100 190 280\nzout 0 5 TOA\nalbedo 0\n";

double relative(double phi) { return std::abs(std::remainder(phi - 10.0, 360.0)); }

/// mW m^-2 nm^-1 are W m^-2 um^-1.
std::string user_output() {
  std::string text;
  for (int wave = 0; wave < 2; ++wave) {
    for (int level = 0; level < 3; ++level) {
      text += printed("  %8.3f %g %13.6e %13.6e", 500.0 + 100.0 * wave, 5.0 * level,
                      edir(wave, level), 100.0);
      for (const double umu : umus) {
        for (const double phi : {10.0, 100.0, 190.0, 280.0}) {
          text += printed(" %13.6e", solar(wave, level, umu, relative(phi)));
        }
      }
      text += "\n";
    }
  }
  return text;
}

std::string block_output() {
  std::string text;
  for (int wave = 0; wave < 2; ++wave) {
    for (int level = 0; level < 3; ++level) {
      text += printed(" %8.3f %13.6e %13.6e 0.0 0.0 0.0 0.0\n", 500.0 + 100.0 * wave,
                      edir(wave, level), 100.0);
      text += "                             10.000       100.000      190.000      280.000\n";
      for (const double umu : umus) {
        text += printed("%9.6f %13.6e", umu, 1.0);
        for (const double phi : {10.0, 100.0, 190.0, 280.0}) {
          text += printed(" %13.6e", solar(wave, level, umu, relative(phi)));
        }
        text += "\n";
      }
    }
  }
  return text;
}

const std::string user_input = std::string{solar_input} + "output_user lambda zout edir edn uu\n";

AirRunSet parsed(const std::string& input, const std::string& output) {
  return parse_uvspec({"a.inp", input}, {"a.out", output}, on_sea_uvspec, {});
}

std::string told_uvspec(const std::string& input, const std::string& output) {
  return support::message_of([&] { static_cast<void>(parsed(input, output)); });
}

}  // namespace

TEST_CASE("uvspec's own columns of a slab become its table", "[uvspec]") {
  const atmosphere::AirTable table =
      table_of_runs(parsed(user_input, user_output()), on_sea_uvspec);
  REQUIRE(table.lanes.size() == 2);
  CHECK(table.lanes[0].wavelength_um == Approx(0.5).epsilon(1e-12));
  CHECK(table.bodies.at(0).zenith_rad == Approx(60.0 * degree).epsilon(1e-12));
  for (std::size_t lane = 0; lane < 2; ++lane) {
    const int wave = static_cast<int>(lane);
    // Printed with seven digits.
    CHECK(table.bodies[0].irradiance[lane] == Approx(sun * (wave + 1)).epsilon(1e-6));
    CHECK(table.bodies[0].transmittance[lane] == Approx(std::exp(-0.6 / mu0)).epsilon(1e-6));
    CHECK(table.bodies[0].ground_irradiance[lane] == Approx(edir(wave, 0) + 100.0).epsilon(1e-6));
  }
  // The azimuths 90 and 270 from the sun are one.
  REQUIRE(table.sky.azimuth_rad.size() == 3);
  CHECK(table.sky.zenith_rad == std::vector<double>{0.0, std::acos(0.5)});
  CHECK(table.sky.smooth[((2 * 2) + 1) * 2 + 1] == Approx(solar(1, 0, -0.5, 180.0)).epsilon(1e-6));
}

TEST_CASE("uvspec's levels between ground and top become views of sources", "[uvspec]") {
  const atmosphere::AirTable table =
      table_of_runs(parsed(user_input, user_output()), on_sea_uvspec);
  REQUIRE(table.views.size() == 2);  // at 5 km and at the top
  const auto& view = table.views[0];
  CHECK(view.height_m == 5000.0);
  REQUIRE(view.zenith_rad.size() == 6);  // two up, the horizon twice, two down
  const std::size_t down = 5;            // straight
  CHECK(view.zenith_rad[down] == Approx(std::numbers::pi).epsilon(1e-12));
  const double metres = atmosphere::air_measure_m(5000.0, 0.0, 5000.0);
  CHECK(view.extinction[down * 2] * metres == Approx(below).epsilon(1e-5));
  for (std::size_t z = 0; z < 6; ++z) {
    for (std::size_t lane = 0; lane < 2; ++lane) {
      const double source = 20.0 * static_cast<double>(lane + 1);
      CHECK(view.smooth[z * 2 + lane] == Approx(source).epsilon(1e-5));
    }
  }
}

TEST_CASE("DISORT's blocks say what uvspec's columns say", "[uvspec]") {
  const AirRunSet a = parsed(solar_input, block_output()), b = parsed(user_input, user_output());
  REQUIRE(a.runs.size() == b.runs.size());
  for (std::size_t i = 0; i < a.runs.size(); ++i) {
    CHECK(a.runs[i].solar == b.runs[i].solar);
    CHECK(a.runs[i].zenith_rad == b.runs[i].zenith_rad);
    CHECK(a.runs[i].azimuth_rad == b.runs[i].azimuth_rad);
  }
  CHECK(a.sun_transmittance == b.sun_transmittance);
}

TEST_CASE("thermal output is per wavenumber unless the input says otherwise", "[uvspec]") {
  // 7 W m^-2 sr^-1 um^-1 at 10 um are 7e-2 per cm^-1: 1 um is 100 cm^-1 there.
  const std::string start = "source thermal\numu -1\nphi 0\noutput_user lambda uu\n";
  const auto even = [&](const std::string& more, const std::string& value) {
    return parsed(start + more, "10000.0 " + value + "\n").runs.at(0).even.at(0);
  };
  CHECK(even("", "7e-2") == Approx(7.0).epsilon(1e-12));
  CHECK(even("thermal_bandwidth 5\n", "35e-2") == Approx(7.0).epsilon(1e-12));
  CHECK(even("output_process per_nm\n", "7e-3") == Approx(7.0).epsilon(1e-12));
  CHECK(told_uvspec(start + "mol_abs_param fu\n", "1 1\n")
            .find("a.inp:5:15: error: this scheme gives "
                  "sums over bands") == 0);
}

TEST_CASE("solar and thermal runs of uvspec make one table", "[uvspec]") {
  const support::ScratchFolder folder;
  write_file(folder / "sun.inp", user_input);
  write_file(folder / "sun.out", user_output());
  write_file(folder / "heat.inp",
             "source thermal\numu -1 -0.5 0.5 1\nzout 0 5 TOA\nalbedo 0\nsur_temperature 1\n"
             "output_process per_nm\noutput_user lambda uu\n");
  std::string heat;
  for (int wave = 0; wave < 2; ++wave) {
    for (int level = 0; level < 3; ++level) {
      heat += printed("%g", 500.0 + 100.0 * wave);
      for (const double umu : umus) {
        heat += printed(" %.8e", 7e-3 * (1.0 - std::exp(-way(level, umu))));
      }
      heat += "\n";
    }
  }
  write_file(folder / "heat.out", heat);
  AirImport wanted;
  wanted.from = AirSource::uvspec;
  wanted.files = {folder / "sun.out", folder / "heat.out"};
  wanted.settings = on_sea_uvspec;
  const atmosphere::AirTable table = import_air(wanted);
  CHECK(table.sky.even[0] == Approx(7.0 * (1.0 - std::exp(-0.6))).epsilon(1e-6));
  REQUIRE(table.views.size() == 2);
  for (const float even : table.views[0].even) CHECK(even == Approx(7.0).epsilon(1e-5));
  // What the even sky brings to the ground, of two directions: between them linear.
  CHECK(table.even_ground_irradiance[0] > std::numbers::pi * 7.0 * (1.0 - std::exp(-0.6)));
}

TEST_CASE("watts are told from milliwatts", "[uvspec]") {
  const AirRunSet set =
      parse_uvspec({"a.inp", user_input}, {"a.out", user_output()}, on_sea_uvspec, {true});
  CHECK(set.sun_irradiance[0] == Approx(1000.0 * sun).epsilon(1e-6));
}

TEST_CASE("mistakes of uvspec's files are told with their lines", "[uvspec]") {
  const std::string out = user_output();
  CHECK(told_uvspec("sza 3\n", out).find("a.inp: error: the input has no line \"source solar\"") ==
        0);
  CHECK(told_uvspec(user_input + "include more.inp\n", out)
            .find("a.inp:10:1: error: included files") == 0);
  CHECK(
      told_uvspec(user_input + "output_quantity reflectivity\n", out).find("a.inp:10:1: error: ") ==
      0);
  CHECK(told_uvspec(user_input + "sza forty\n", out).find("a.inp:10:5: error: expected a number") ==
        0);
  CHECK(told_uvspec(user_input + "albedo 0.2\n", out).find("use albedo 0") != std::string::npos);
  CHECK(told_uvspec(user_input + "zout 5 0\n", out).find("the levels do not ascend") !=
        std::string::npos);
  CHECK(told_uvspec(user_input, "").find("a.out: error: the output is empty") == 0);
  CHECK(told_uvspec(user_input, "1 2 3\n")
            .find("a.out:1:1: error: output_user names 20 numbers, found 3") == 0);
  CHECK(told_uvspec(user_input, out.substr(0, out.size() / 3)).find("a.out:") == 0);
  CHECK(told_uvspec(solar_input, block_output().substr(0, 200)).find("a.out:") == 0);
  CHECK(told_uvspec(user_input, "x\n").find("a.out:1:1: error: expected a number, found \"x\"") ==
        0);
}

TEST_CASE("a view without its transmittance is missed", "[uvspec]") {
  const std::string input =
      "source thermal\numu -1\nzout 0 5 TOA\noutput_process per_nm\noutput_user lambda uu\n";
  const AirRunSet set = parsed(input, "10000 1\n10000 0.5\n10000 0\n");
  CHECK(
      support::message_of([&] { static_cast<void>(table_of_runs(set, on_sea_uvspec)); })
          .find("from 5000 m at zenith angle 0 degrees, to the end of the air: one that gives the "
                "transmittance") != std::string::npos);
}
