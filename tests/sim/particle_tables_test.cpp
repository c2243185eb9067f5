#include "sim/files/particle_tables.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "atmosphere/particles/particles.hpp"
#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::atmosphere;

namespace {

const std::filesystem::path shipped_particle_tables =
    std::filesystem::path{NADIR_SOURCE_DIR} / "scenes/library/atmosphere/particles.txt";

std::string shipped_text() {
  std::ostringstream text;
  text << std::ifstream{shipped_particle_tables}.rdbuf();
  return text.str();
}

/// The shipped text with one piece replaced.
std::string with_particle_tables(const std::string& piece, const std::string& instead) {
  std::string text = shipped_text();
  const std::size_t at = text.find(piece);
  REQUIRE(at != std::string::npos);
  return text.replace(at, piece.size(), instead);
}

std::string particle_tables_mistakes(const std::string& text) {
  try {
    (void)sim::parse_particle_tables(text, "p.txt");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

bool refused(const std::string& text, const std::string& message) {
  const std::string found = particle_tables_mistakes(text);
  CAPTURE(found);
  CHECK(found.find(message) != std::string::npos);
  return !found.empty();
}

std::vector<double> levels() {
  std::vector<double> heights;
  for (int km = 100; km >= 0; km -= km > 30 ? 5 : 1) heights.push_back(1e3 * km);
  return heights;
}

double depth(const Particles& particles, double um) {
  double sum = 0.0;
  for (int kind = 0; kind < particles.kinds(); ++kind) {
    const KindOptics optics = particles.optics(kind, Micrometres{um});
    const std::vector<double>& layers = particles.depth_550(kind);
    sum += (optics.scattering + optics.absorption) *
           std::accumulate(layers.begin(), layers.end(), 0.0);
  }
  return sum;
}

struct ParticleTablesDifference {
  double rms = 0.0, largest = 0.0;
};

/// The clear run dimmed by these particles, against the run with haze, 0.35 to 12 um: vertical
/// transmittance from the ground to 100 km.
ParticleTablesDifference compare(const Particles& particles, const std::string& clear,
                                 const std::string& hazy) {
  std::ifstream file{std::filesystem::path{NADIR_SOURCE_DIR} /
                     "tests/atmosphere/data/lowtran7_transmittance.csv"};
  std::string line;
  while (std::getline(file, line) && line.front() == '#') continue;
  const auto cells = [](const std::string& text) {
    std::vector<std::string> result;
    std::istringstream stream{text};
    for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
    return result;
  };
  const std::vector<std::string> head = cells(line);
  const auto column = [&](const std::string& name) {
    const auto found = std::find(head.begin(), head.end(), name);
    REQUIRE(found != head.end());
    return static_cast<std::size_t>(found - head.begin());
  };
  const std::size_t clear_at = column(clear), hazy_at = column(hazy);
  ParticleTablesDifference result;
  int count = 0;
  for (int row = 0; std::getline(file, line); ++row) {
    if (row % 16 != 0) continue;  // every 16th of 1626 wavenumbers: phase functions take time
    const std::vector<std::string> row_cells = cells(line);
    const double um = 1e4 / std::stod(row_cells[0]);
    if (um < 0.35 || um > 12.0) continue;
    const double difference = std::stod(row_cells[clear_at]) * std::exp(-depth(particles, um)) -
                              std::stod(row_cells[hazy_at]);
    result.rms += difference * difference;
    result.largest = std::max(result.largest, std::abs(difference));
    ++count;
  }
  REQUIRE(count > 80);
  result.rms = std::sqrt(result.rms / count);
  return result;
}

}  // namespace

TEST_CASE("the shipped tables of haze and clouds are whole", "[sim][particles]") {
  const ParticleTables tables = sim::read_particle_tables(shipped_particle_tables);
  CHECK(tables.wavelength_um.size() == 46);
  CHECK(tables.wavelength_um.front() == 0.2);
  CHECK(tables.wavelength_um.back() == 200.0);
  CHECK(tables.phase_functions.size() == 70);
  CHECK(tables.phase_angle_rad.size() == 34);
  CHECK(tables.kinds.size() == required_kinds().size());
  CHECK(tables.haze.size() == required_haze().size());
  for (const auto& [name, optics] : tables.kinds) {
    CAPTURE(name);
    CHECK(optics.extinction[3] == 1.0);  // at 0.55 um
    const auto clouds = cloud_types();
    const bool cloud = std::find(clouds.begin(), clouds.end(), name) != clouds.end();
    CHECK(optics.phase.empty() == (cloud && name.find("fog") != 0));
    for (std::size_t i = 0; i < tables.wavelength_um.size(); ++i) {
      // absorbing only: rounding of the source's last digits
      CHECK(optics.absorption[i] <= optics.extinction[i] * 1.02 + 1e-5);
    }
  }
}

TEST_CASE("the shipped phase functions integrate to 1", "[sim][particles]") {
  const ParticleTables tables = sim::read_particle_tables(shipped_particle_tables);
  const auto right = std::find_if(tables.phase_angle_rad.begin(), tables.phase_angle_rad.end(),
                                  [](double angle) { return angle > 1.57; });
  const auto at = static_cast<std::size_t>(right - tables.phase_angle_rad.begin());
  for (const std::vector<double>& values : tables.phase_functions) {
    // normalised anew it keeps its value at 90 degrees; 1e-3: the script's midpoint rule
    const PhaseFunction phase{tables.phase_angle_rad, values};
    CHECK(phase.at(0.0) == Approx(values[at]).epsilon(1e-3));
  }
}

TEST_CASE("rural haze of 23 km has LOWTRAN7's column and spectrum", "[sim][particles]") {
  const auto tables =
      std::make_shared<const ParticleTables>(sim::read_particle_tables(shipped_particle_tables));
  Aerosol aerosol;
  aerosol.relative_humidity = 0.46;  // of the US standard air at the ground
  const Particles particles{tables, aerosol, {}, levels()};
  // -ln of the ratio of a LOWTRAN7 run with this haze to one without (US standard, vertical, to
  // 100 km); the haze's own humidity differs a little there: 1 % of what is left in the infrared
  CHECK(depth(particles, 0.3504) == Approx(0.51382).epsilon(1e-3));
  CHECK(depth(particles, 0.5637) == Approx(0.31699).epsilon(1e-3));
  CHECK(depth(particles, 1.0707) == Approx(0.12920).epsilon(2e-3));
  CHECK(depth(particles, 2.0747) == Approx(0.03878).epsilon(1e-2));
  CHECK(depth(particles, 11.9048) == Approx(0.01673).epsilon(1e-2));
}

TEST_CASE("the shipped phase functions have the asymmetry of the optics, about",
          "[sim][particles]") {
  const ParticleTables tables = sim::read_particle_tables(shipped_particle_tables);
  for (const auto& [name, optics] : tables.kinds) {
    if (optics.phase.empty()) continue;
    const auto number = static_cast<std::size_t>(optics.phase[2]);  // at 0.55 um
    const PhaseFunction phase{tables.phase_angle_rad, tables.phase_functions[number]};
    CAPTURE(name);
    CHECK(phase.asymmetry() == Approx(optics.asymmetry[3]).margin(0.05));  // see the file's note
  }
}

TEST_CASE("a file of haze and clouds with mistakes is refused where they stand",
          "[sim][particles]") {
  CHECK(refused("", "expected a first line \"# nadir-particles: 1\""));
  CHECK(refused("# nadir-particles: 1\n", "the section [optics] is missing"));
  CHECK(refused(with_particle_tables("\n[haze]\n", "\n[fog]\n"), "unknown section"));
  CHECK(refused(with_particle_tables("\n[phase_choice]\n", "\n[optics]\n"),
                "the section is there twice"));
  CHECK(refused(with_particle_tables("rural_0,extinction,2.0929", "rural_0,extinction,x"),
                "p.txt:13:20: error: expected a number, found \"x\""));
  CHECK(refused(with_particle_tables("rural_0,extinction,2.0929", "rural_0,extinction,-0.5"),
                "must lie from 0 to 1000, found -0.5"));
  CHECK(refused(with_particle_tables("rural_0,extinction,2.0929,", "rural_0,extinction,"),
                "expected 48 cells, found 47"));
  CHECK(refused(with_particle_tables("rural_0,extinction", "rural_0,absorption"),
                "this row is there twice"));
  CHECK(refused(with_particle_tables("rural_0,extinction", "rurall_0,extinction"),
                "the kind \"rurall_0\" lacks extinction, absorption or asymmetry"));
  CHECK(refused(with_particle_tables("boundary_23,", "boundary_24,"),
                "the profile \"boundary_23\" is missing"));
  CHECK(refused(with_particle_tables("kind,0.2,0.3,0.55", "kind,0.3,0.2,0.55"),
                "greater than the one before it"));
  CHECK(refused(with_particle_tables("rural_0,3,5,4", "rural_0,3,99,4"),
                "there is no phase function 99"));
  CHECK(refused(with_particle_tables("rural_0,3,5,4", "ruralo_0,3,5,4"),
                "expected a kind of [optics], each once"));
  CHECK(refused(with_particle_tables("175,180", "175,179"),
                "scattering angles must reach from 0 to 180 deg"));
  CHECK_THROWS_AS(sim::read_particle_tables("no/such/file"), InputError);
}

TEST_CASE("haze dims every band as in LOWTRAN7's runs", "[sim][particles]") {
  const auto tables =
      std::make_shared<const ParticleTables>(sim::read_particle_tables(shipped_particle_tables));
  Aerosol rural, urban;
  rural.relative_humidity = 0.49;  // US standard 1976 between the ground and 2 km
  urban.type = AerosolType::urban;
  urban.visibility_km = 5.0;
  urban.relative_humidity = 0.70;  // mid-latitude summer, 0 and 1 km
  const Particles rural_23{tables, rural, {}, levels()}, urban_5{tables, urban, {}, levels()};
  // measured over all wavenumbers: rms 4.4e-5 and 5.7e-5, at most 3.1e-4 and 1.5e-4. What is left
  // is growth with humidity, which the runs take layer by layer
  const ParticleTablesDifference a = compare(rural_23, "us_standard_1976_clear", "us_rural23");
  CHECK(a.rms < 6e-5);
  CHECK(a.largest < 4e-4);
  const ParticleTablesDifference b = compare(urban_5, "midlatitude_summer_clear", "mls_urban5");
  CHECK(b.rms < 8e-5);
  CHECK(b.largest < 3e-4);
}
