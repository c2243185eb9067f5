#include "sim/files/modtran_csv.hpp"

#include <cmath>

#include "air_slab.hpp"
#include "core/error.hpp"
#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "sim/files/air_import.hpp"
#include "sim/files/atomic_file.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using support::degree;
using support::printed;
using support::Slab;

namespace {

const AirRunSettings on_sea_modtran_csv{0.0, 100'000.0, std::nullopt, 1.0};

enum class Over { wavenumber, micrometres, nanometres };

/// A case over wavenumber, wavelength in um or in nm, with the columns of MODTRAN 6.
std::string csv_case(const Slab& slab, double zenith_deg, Over over) {
  const double mu = std::cos(zenith_deg * degree);
  std::string text = "MODTRAN6\ncase 0\n";
  text += over == Over::wavenumber ? "freq" : "wavelength";
  text +=
      ",path_trans,path_emiss,path_thermal_scat,surface_emiss,path_multi_scat,sing_scat,"
      "grnd_rflt,drct_rflt,total_rad,irrad_ref,irrad_obs,-natlog_path_trans,direct_emiss,"
      "ToA_irrad,bbody_temp\n";
  text += over == Over::wavenumber ? "cm-1,,\n" : over == Over::nanometres ? "nm,,\n" : "um,,\n";
  for (std::size_t i = 0; i < slab.nu.size(); ++i) {
    const double nu = slab.nu[i], t = slab.transmittance(i, mu);
    // W m^-2 um^-1 as W cm^-2 / cm^-1, W cm^-2 um^-1, uW cm^-2 nm^-1.
    const double unit = over == Over::wavenumber    ? 1.0 / (nu * nu)
                        : over == Over::micrometres ? 1e-4
                                                    : 0.1;
    const double at = over == Over::wavenumber    ? nu
                      : over == Over::micrometres ? 1e4 / nu
                                                  : 1e7 / nu;
    const double thermal = slab.emitted(i, mu) * unit, solar = slab.scattered(i, mu, 0.0) * unit;
    const double toa = slab.sun[i] * unit;
    text += printed("%.6f,%.9f,%.6e,%.6e,0,%.6e,%.6e,0,0,%.6e,%.4e,%.4e,%.4f,1,%.4e,250\n", at, t,
                    0.9 * thermal, 0.1 * thermal, 0.6 * solar, 0.4 * solar, thermal + solar, 0.0,
                    toa * slab.transmittance(i, slab.sun_mu), slab.depth[i], toa);
  }
  return text + "-9999.,,\n";
}

}  // namespace

TEST_CASE("MODTRAN 6 CSV over wavenumber, um and nm gives the slab's radiances", "[modtran]") {
  const Over over = GENERATE(Over::wavenumber, Over::micrometres, Over::nanometres);
  const Slab slab;
  const RunGeometry up{0.0, 60.0 * degree, 0.0};
  const AirRunSet set =
      parse_modtran_csv(csv_case(slab, 60.0, over), "a.csv", std::span{&up, 1}, on_sea_modtran_csv);
  REQUIRE(set.runs.size() == 1);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t lane = 2 - i;
    CHECK(set.wavelength_um[lane] == Approx(1e4 / slab.nu[i]).epsilon(1e-6));
    // Six digits are printed.
    CHECK(set.runs[0].even[lane] == Approx(slab.emitted(i, 0.5)).epsilon(2e-6).margin(1e-30));
    CHECK(set.runs[0].solar[lane] == Approx(slab.scattered(i, 0.5, 0.0)).epsilon(2e-6));
    CHECK(set.sun_irradiance[lane] == Approx(slab.sun[i]).epsilon(1e-4));
    CHECK(set.sun_transmittance[lane] == Approx(slab.transmittance(i, slab.sun_mu)).epsilon(2e-4));
  }
}

TEST_CASE("CSV cases of one file or of several make a table by their geometry", "[modtran]") {
  const Slab slab;
  const support::ScratchFolder folder;
  const std::string a = csv_case(slab, 0.0, Over::wavenumber),
                    b = csv_case(slab, 60.0, Over::wavenumber);
  write_file(folder / "all.csv", a + b);
  write_file(folder / "a.csv", a);
  write_file(folder / "b.csv", b);
  write_file(folder / "looks.csv", "height_m,zenith_deg,azimuth_deg\n0,0,0\n0,60,0\n");
  AirImport wanted;
  wanted.from = AirSource::modtran_csv;
  wanted.settings = on_sea_modtran_csv;
  wanted.settings.sun_zenith_rad = std::acos(slab.sun_mu);
  wanted.geometry = folder / "looks.csv";
  wanted.files = {folder / "all.csv"};
  const atmosphere::AirTable one = import_air(wanted);
  wanted.files = {folder / "a.csv", folder / "b.csv"};
  const atmosphere::AirTable two = import_air(wanted);
  CHECK(one.sky.even == two.sky.even);
  REQUIRE(one.sky.zenith_rad.size() == 2);
  CHECK(one.sky.smooth[3] == Approx(slab.scattered(2, 0.5, 0.0)).epsilon(2e-6));
  wanted.geometry.clear();
  CHECK(support::message_of([&] { static_cast<void>(import_air(wanted)); }) ==
        "error: CSV output of MODTRAN does not say where it looks: give a geometry file\n");
}

TEST_CASE("mistakes of a MODTRAN CSV are told with their lines", "[modtran]") {
  const Slab slab;
  const RunGeometry up;
  const auto told = [&](const std::string& text) {
    return support::message_of([&] {
      static_cast<void>(parse_modtran_csv(text, "a.csv", std::span{&up, 1}, on_sea_modtran_csv));
    });
  };
  const std::string good = csv_case(slab, 0.0, Over::wavenumber);
  CHECK(told("a,b\n1,2\n").find("a.csv: error: no line names columns") == 0);
  CHECK(told(good + good).find("the file has 2 cases, the geometry of 1 is given") !=
        std::string::npos);
  std::string bad = good;
  bad.replace(bad.find("0.67"), 4, "zero");
  CHECK(told(bad).find("a.csv:5:13: error: expected a number, found \"zero") == 0);
  bad = good;
  bad.replace(bad.find("path_emiss"), 10, "path_what_");
  CHECK(told(bad).find("a.csv:3:1: error: a.csv, case 1: at") == 0);
}
