// The data that ship under scenes/library/.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "sim/files/spectrum_file.hpp"
#include "spectral/response.hpp"
#include "support/catch.hpp"

using namespace nadir;
using sim::SpectrumFile;
using sim::SpectrumQuantity;
using spectral::Curve;
using spectral::Outside;

namespace {

namespace fs = std::filesystem;
const fs::path library = fs::path{NADIR_SOURCE_DIR} / "scenes" / "library";

/// All tables but the air's: those of gases and profiles have readers and tests of their own.
std::vector<fs::path> spectrum_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator{folder}) {
    const std::string name = entry.path().filename().string();
    const bool other = name == "gas_sets.csv" || name == "standard_profiles.csv" ||
                       name == "thermal.csv";  // tables of another kind
    if (other) continue;
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

spectral::Response response_of(const sim::SpectrumColumn& column) {
  return spectral::TabulatedResponse{Curve{column.wavelength_um, column.value, Outside::zero}};
}

using Centres = std::map<std::string, double>;

void check_centres(const std::string& name, const Centres& published, double tolerance) {
  const SpectrumFile file = sim::read_spectrum_file(library / "responses" / name);
  REQUIRE(file.columns.size() == published.size());
  for (const auto& [band, centre_um] : published) {
    CAPTURE(name, band);
    const double found_um = spectral::centre(response_of(file.column(band))).value;
    CHECK(found_um == Approx(centre_um).epsilon(tolerance));
  }
}

}  // namespace

TEST_CASE("every shipped spectrum reads and says where it comes from", "[sim][library]") {
  const auto files = spectrum_files(library);
  CHECK(files.size() >= 40);
  for (const fs::path& path : files) {
    CAPTURE(path.string());
    const SpectrumFile file = sim::read_spectrum_file(path);
    CHECK(file.quantity.has_value());
    CHECK(file.title.size() > 3);
    CHECK(file.source.size() > 10);
    CHECK(file.licence.size() > 3);
    CHECK(file.made_by.rfind("tools/make_library.py", 0) == 0);
    // names of files only: nothing of the machine that made them
    CHECK(file.made_by.find(" /") == std::string::npos);
    CHECK(file.made_by.find("..") == std::string::npos);
  }
}

TEST_CASE("every shipped reflectance covers 0.35 to 14 um, from 0 to 1, in few rows",
          "[sim][library]") {
  const auto files = spectrum_files(library / "spectra");
  CHECK(files.size() >= 25);
  for (const fs::path& path : files) {
    CAPTURE(path.string());
    const Curve curve =
        sim::read_curve(path, "reflectance", SpectrumQuantity::reflectance, Outside::reject);
    CHECK(curve.covers(0.35_um, 14.0_um));
    CHECK(curve.min_value() >= 0.0);
    CHECK(curve.max_value() <= 1.0);
    CHECK(curve.values().size() <= 302);  // 300 thinned points and the two ends
  }
}

TEST_CASE("every spectrum of the JPL library keeps its notice", "[sim][library]") {
  int kept = 0;
  for (const fs::path& path : spectrum_files(library / "spectra")) {
    const SpectrumFile file = sim::read_spectrum_file(path);
    if (file.made_by.find("surfaces_manmade/") == std::string::npos) continue;
    ++kept;
    CAPTURE(path.string());
    const std::string notice =
        "Reproduced from the ECOSTRESS Spectral Library through the courtesy of the Jet Propulsion "
        "Laboratory, California Institute of Technology";
    CHECK(file.source.find(notice) != std::string::npos);
    CHECK(file.licence.find(notice) != std::string::npos);
  }
  CHECK(kept >= 25);
}

TEST_CASE("the material library and the folder of spectra name each other", "[sim][library]") {
  std::ostringstream text;
  text << std::ifstream{library / "materials.xml"}.rdbuf();
  const std::string xml = text.str(), key = "reflectance=\"";
  std::set<std::string> named, there;
  for (std::size_t at = 0; (at = xml.find(key, at)) != std::string::npos;) {
    at += key.size();
    CHECK(named.insert(xml.substr(at, xml.find('"', at) - at)).second);
  }
  for (const fs::path& path : spectrum_files(library / "spectra")) {
    there.insert("spectra/" + path.filename().string());
  }
  CHECK(named == there);
}

TEST_CASE("natural surfaces are as warm and as green as measured ones", "[sim][library]") {
  const auto curve_of = [](const std::string& name) {
    return sim::read_curve(library / "spectra" / (name + ".csv"), "", SpectrumQuantity::reflectance,
                           Outside::reject);
  };
  for (const std::string name : {"meadow_grass", "irrigated_vegetation", "broadleaf_forest",
                                 "pine_forest", "mixed_forest", "scrub"}) {
    CAPTURE(name);
    const Curve curve = curve_of(name);
    CHECK(curve.at(0.86_um) > 3.0 * curve.at(0.66_um));  // the red edge
    // Emissivity of vegetation at 10 to 12 um: 0.94 to 0.995 (Salisbury & D'Aria 1992, Remote
    // Sens. Environ. 42, 83)
    CHECK(1.0 - curve.mean(10.0_um, 12.0_um) >= 0.94);
    CHECK(1.0 - curve.mean(10.0_um, 12.0_um) <= 0.995);
  }
  // Water at normal incidence: (n-1)^2/(n+1)^2 with n = 1.333 is 0.0204 at 0.589 um; emissivity
  // 0.99 at 11 um (MODIS land emissivity: 0.992 for band 31).
  CHECK(curve_of("water").at(0.589_um) == Approx(0.0204).epsilon(0.02));
  CHECK(1.0 - curve_of("water").at(11.0_um) == Approx(0.992).margin(0.004));
}

TEST_CASE("the shipped sun gives the solar constant", "[sim][library]") {
  const Curve sun = sim::read_curve(library / "illumination" / "solar.csv", "",
                                    SpectrumQuantity::irradiance, Outside::reject);
  const double total = sun.mean(sun.first(), sun.last()) * (sun.last() - sun.first()).value;
  // 1360.8 W m^-2 (Kopp & Lean 2011, GRL 38, L01706); 0.1 % of it lies outside the table.
  CHECK(total == Approx(1361.0).epsilon(0.005));
  // Peak of the visible: 1.9 W m^-2 nm^-1 at 0.55 um (ASTM E490: 1.88 about there).
  CHECK(sun.mean(0.54_um, 0.56_um) == Approx(1880.0).epsilon(0.02));
}

TEST_CASE("the shipped clear air is plausible", "[sim][library]") {
  const fs::path folder = library / "atmosphere";
  const auto read = [&](const std::string& name, SpectrumQuantity quantity) {
    return sim::read_curve(folder / (name + ".csv"), "", quantity, Outside::reject);
  };
  const Curve direct = read("clear_direct_transmittance", SpectrumQuantity::transmittance);
  const Curve sky = read("clear_sky_day", SpectrumQuantity::radiance);
  const Curve thermal = read("clear_sky_thermal", SpectrumQuantity::radiance);
  const Curve diffuse = read("clear_sky_diffuse", SpectrumQuantity::radiance);
  const Curve path = read("clear_path_radiance", SpectrumQuantity::radiance);
  for (const Curve* curve : {&direct, &sky, &thermal, &diffuse, &path}) {
    CHECK(curve->covers(0.3_um, 14.0_um));
  }
  // exp(-(0.0971 + 0.06 0.55^-1.3) / cos 25 deg) with Bodhaine's Rayleigh depth at 0.55 um
  CHECK(direct.at(0.55_um) == Approx(0.7775).epsilon(2e-3));
  CHECK(diffuse.at(0.45_um) > 2.0 * diffuse.at(0.65_um));  // the sky is blue
  CHECK(path.at(0.45_um) < diffuse.at(0.45_um));
  CHECK(sky.at(0.5_um) == Approx(diffuse.at(0.5_um)).epsilon(1e-5));  // six digits in the file
  CHECK(thermal.at(11.0_um) > 1.0);  // black body of 294 K: 9; a clear humid sky: a third
  CHECK(thermal.at(11.0_um) < 5.0);
}

// A hole between the half-maximum edges, or a lobe far outside, would be a fault of the table.
TEST_CASE("every shipped response is one lobe without holes", "[sim][library]") {
  for (const fs::path& path : spectrum_files(library / "responses")) {
    const SpectrumFile file = sim::read_spectrum_file(path);
    for (const sim::SpectrumColumn& column : file.columns) {
      CAPTURE(path.string(), column.name);
      const spectral::Response response = response_of(column);
      const double centre_um = spectral::centre(response).value;
      const double width_um = spectral::fwhm(response).value;
      const double peak = *std::max_element(column.value.begin(), column.value.end());
      CHECK(width_um < 0.3 * centre_um);  // the widest is Landsat's panchromatic band
      double least_inside = peak, most_outside = 0.0;
      for (std::size_t i = 0; i < column.value.size(); ++i) {
        const double off_um = std::abs(column.wavelength_um[i] - centre_um);
        if (off_um < 0.3 * width_um) least_inside = std::min(least_inside, column.value[i]);
        if (off_um > 3.0 * width_um) most_outside = std::max(most_outside, column.value[i]);
      }
      CHECK(least_inside > 0.3 * peak);
      CHECK(most_outside < 0.02 * peak);
    }
  }
}

// Centres published by USGS (Landsat 8 and 9 band designations), as the middle of the half-maximum
// edges; the centroid of the response may differ by some 0.5 %.
TEST_CASE("the shipped responses of Landsat have the published centres", "[sim][library]") {
  const Centres oli{{"CoastalAerosol", 0.443}, {"Blue", 0.482},   {"Green", 0.5615},
                    {"Red", 0.6545},           {"NIR", 0.865},    {"Cirrus", 1.3735},
                    {"SWIR1", 1.6085},         {"SWIR2", 2.2005}, {"Pan", 0.5895}};
  check_centres("landsat8_oli.csv", oli, 0.01);
  check_centres("landsat9_oli2.csv", oli, 0.01);
  // USGS: band 6 of Landsat 4, 5 and 7 is 10.4 to 12.5 um, TIRS band 10 is 10.6 to 11.19 um. The
  // response of Landsat 4 leans to short wavelengths: its centroid is 11.15 um, 2.6 % off.
  check_centres("landsat_thermal.csv",
                {{"landsat4_tm_b6", 11.45},
                 {"landsat5_tm_b6", 11.45},
                 {"landsat7_etm_b6", 11.45},
                 {"landsat8_tirs_b10", 10.895}},
                0.03);
}

// ESA, Sentinel-2 user handbook, table 1.
TEST_CASE("the shipped response of Sentinel-2A has the published centres", "[sim][library]") {
  check_centres("sentinel2a_msi.csv",
                {{"B1", 0.443},
                 {"B2", 0.490},
                 {"B3", 0.560},
                 {"B4", 0.665},
                 {"B5", 0.705},
                 {"B6", 0.740},
                 {"B7", 0.783},
                 {"B8", 0.842},
                 {"B8A", 0.865},
                 {"B9", 0.945},
                 {"B10", 1.375},
                 {"B11", 1.610},
                 {"B12", 2.190}},
                0.015);
}

// NASA MODIS specifications: middle of each band's stated edges.
TEST_CASE("the shipped response of MODIS has the published centres", "[sim][library]") {
  const std::vector<double> middle_um{
      0.645,  0.8585, 0.469, 0.555,  1.240, 1.640, 2.130, 0.4125, 0.443,  0.488,  0.531,  0.551,
      0.667,  0.678,  0.748, 0.8695, 0.905, 0.936, 0.940, 3.750,  3.959,  3.959,  4.050,  4.4655,
      4.5155, 1.375,  6.715, 7.325,  8.550, 9.730, 11.03, 12.02,  13.335, 13.635, 13.935, 14.235};
  Centres centres;
  for (std::size_t i = 0; i < middle_um.size(); ++i) {
    centres["band_" + std::to_string(i + 1)] = middle_um[i];
  }
  check_centres("modis_aqua.csv", centres, 0.02);
}
