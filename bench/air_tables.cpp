// Time and error of air tables, a row a setting: a day over 60 wavelengths from 0.4 to 2.45 um,
// seen from space, against a table with many streams, terms and nodes. Error: rms over wavelengths
// and directions, relative, of the sky and of what is seen of a ground of albedo 0.2.
//
//   air_tables [folder of library/atmosphere]
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "atmosphere/layered.hpp"
#include "atmosphere/table/bound_air_table.hpp"
#include "core/error.hpp"
#include "sim/files/band_tables.hpp"
#include "sim/files/particle_tables.hpp"

namespace nadir {
namespace {

using namespace atmosphere;

struct Day {
  Layered air;
  std::vector<Micrometres> wavelengths;
  std::vector<spectral::AbsorptionLane> intervals;
  ephemeris::Illumination sun;
};

Day make_day(const std::string& folder, int count) {
  const auto gases = std::make_shared<const BandTables>(sim::read_band_tables(folder));
  const auto particles =
      std::make_shared<const ParticleTables>(sim::read_particle_tables(folder + "/particles.txt"));
  const auto dark = spectral::Curve::constant(0.0);
  Day day{{gases,
           particles,
           standard_profile(*gases, "us_standard_1976"),
           0.0,
           {},
           {},
           {dark, dark, dark}},
          {},
          {},
          {}};
  for (int i = 0; i < count; ++i) {
    const double um = count == 1 ? 0.55 : 0.4 + 2.05 * i / (count - 1);
    day.wavelengths.emplace_back(um);
    day.intervals.push_back({um - 0.01, um + 0.01, 0});
  }
  const double z = 40.0 * std::numbers::pi / 180.0;
  day.sun = {
      {"sun", {0.0, std::sin(z), std::cos(z)}, Angle{0.00465}, spectral::Curve::constant(1000.0)}};
  return day;
}

struct Made {
  double seconds = 0.0, interpolation = 0.0;
  std::size_t lanes = 0;
  std::vector<double> seen;  // [wavelength][direction]
};

/// Radiances in some directions, by wavelength.
std::vector<double> look(const Day& day, const std::shared_ptr<const AirTable>& table,
                         const std::vector<SplitLane>& lanes) {
  constexpr int directions = 8;
  std::vector<double> seen(day.wavelengths.size() * directions, 0.0);
  for (std::size_t first = 0; first < lanes.size(); first += 128) {
    const std::size_t last = std::min(lanes.size(), first + 128);
    std::vector<Micrometres> wavelengths;
    std::vector<spectral::AbsorptionLane> absorption;
    for (std::size_t i = first; i < last; ++i) {
      wavelengths.push_back(day.wavelengths[static_cast<std::size_t>(lanes[i].source)]);
      absorption.push_back(lanes[i].absorption);
    }
    const GroundLight ground{std::vector<float>(lanes.size(), 0.2F),
                             std::vector<float>(lanes.size(), 0.0F)};
    const BoundAirTable bound{table, ground, spectral::Lanes{wavelengths, absorption}};
    for (int d = 0; d < directions; ++d) {
      const bool up = d < directions / 2;
      const double z =
          (up ? 8.0 + 21.0 * d : 180.0 - 3.0 - 13.0 * (d - 4)) * std::numbers::pi / 180.0;
      const double a = 0.4 + 0.9 * d;
      const Vec3 direction{std::sin(z) * std::sin(a), std::sin(z) * std::cos(a), std::cos(z)};
      const auto light = up ? bound.sky(direction) : bound.beyond({0.0, 0.0, 100e3}, direction);
      for (std::size_t i = first; i < last; ++i) {
        seen[static_cast<std::size_t>(lanes[i].source) * directions +
             static_cast<std::size_t>(d)] +=
            lanes[i].weight * static_cast<double>(light[static_cast<int>(i - first)]);
      }
    }
  }
  return seen;
}

Made make(const Day& day, const AirSettings& settings) {
  const auto start = std::chrono::steady_clock::now();
  const auto lanes = split_lanes(day.air, settings, day.wavelengths, day.intervals);
  const auto table = std::make_shared<const AirTable>(
      make_air_table(day.air, settings, lanes, day.wavelengths, day.sun));
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return {time.count(), table->interpolation_error, lanes.size(), look(day, table, lanes)};
}

double rms(const Made& made, const Made& reference) {
  double largest = 0.0, sum = 0.0;
  for (const double r : reference.seen) largest = std::max(largest, r);
  for (std::size_t i = 0; i < made.seen.size(); ++i) {
    const double scale = std::max(reference.seen[i], 1e-3 * largest);
    sum += std::pow((made.seen[i] - reference.seen[i]) / scale, 2);
  }
  return std::sqrt(sum / static_cast<double>(made.seen.size()));
}

void row(const char* name, const Made& made, const Made& reference) {
  std::printf("%-28s %6zu %9.1f %11.5f %13.5f\n", name, made.lanes, 1e3 * made.seconds,
              rms(made, reference), made.interpolation);
}

AirSettings base() {
  AirSettings s;
  s.observer_height_m = 100e3;
  return s;
}

int run(const std::string& folder) {
  const Day one = make_day(folder, 1), day = make_day(folder, 60);
  AirSettings fine = base();
  fine.streams = 24;
  fine.term_tolerance = 1e-4;
  fine.zenith_nodes = fine.azimuth_nodes = 37;
  fine.share_nodes = 24;
  const Made reference = make(day, fine);
  std::printf("%-28s %6s %9s %11s %13s\n", "setting", "lanes", "ms", "rms error", "interpolation");
  row("reference", reference, reference);
  Made warm = make(one, base());
  warm = make(one, base());
  std::printf("%-28s %6zu %9.1f\n", "one wavelength, default", warm.lanes, 1e3 * warm.seconds);
  row("default", make(day, base()), reference);
  AirSettings s = base();
  s.mode = AirMode::fast;
  row("fast", make(day, s), reference);
  for (const int streams : {4, 16}) {
    s = base();
    s.streams = streams;
    row(("streams " + std::to_string(streams)).c_str(), make(day, s), reference);
  }
  for (const double tolerance : {1e-2, 2e-3, 1e-4}) {
    s = base();
    s.term_tolerance = tolerance;
    row(("term tolerance " + std::to_string(tolerance)).c_str(), make(day, s), reference);
  }
  for (const int nodes : {6, 24}) {
    s = base();
    s.zenith_nodes = s.azimuth_nodes = nodes + 1;
    s.share_nodes = nodes * 5 / 6;
    row(("nodes " + std::to_string(nodes)).c_str(), make(day, s), reference);
  }
  return 0;
}

}  // namespace
}  // namespace nadir

int main(int argc, char** argv) {
  try {
    return nadir::run(argc > 1 ? argv[1] : "scenes/library/atmosphere");
  } catch (const nadir::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
