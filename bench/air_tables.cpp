// Time and error of air tables, a row a setting: a day over 60 wavelengths from 0.4 to 2.45 um,
// seen from space, against a table with many streams, layers, terms and nodes. Error: rms over
// wavelengths and directions, relative, of the sky and of what is seen of a ground of albedo 0.2.
// Times: on the clock, and of the processor in all threads. One thing at a time differs from the
// default.
//
//   air_tables [--csv] [folder of library/atmosphere]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "atmosphere/gases/gas_absorption.hpp"
#include "atmosphere/layered.hpp"
#include "atmosphere/make/levels.hpp"
#include "atmosphere/make/table_job.hpp"
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
  double seconds = 0.0, cpu_seconds = 0.0, interpolation = 0.0;
  std::size_t lanes = 0, layers = 0;
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

/// The default levels with `factor` times as many layers: 1/2, 1/3, ... leave levels out, 2 cuts
/// each layer in half.
std::vector<double> levels_of(const Day& day, double factor) {
  const auto standard = column_levels_m(day.air.profile, day.air.aerosol, {}, 0.0);
  const auto step = static_cast<std::size_t>(std::lround(std::max(1.0, 1.0 / factor)));
  std::vector<double> levels;
  for (std::size_t k = 0; k + 1 < standard.size(); k += step) {
    levels.push_back(standard[k]);
    if (factor > 1.0) levels.push_back(0.5 * (standard[k] + standard[k + 1]));
  }
  levels.push_back(standard.back());
  return levels;
}

struct Table {
  std::vector<SplitLane> lanes;
  std::shared_ptr<const AirTable> table;
};

/// What make_air_table does, on other levels.
Table on_levels(const Day& day, const AirSettings& settings, const std::vector<double>& levels) {
  const GasAbsorption gases{day.air.gases, day.air.profile, levels};
  const Particles particles{day.air.particles, day.air.aerosol, {}, levels};
  const auto rayleigh = std::make_shared<const PhaseFunction>(PhaseFunction::rayleigh(0.0279));
  Table made;
  TableJob job;
  std::vector<std::vector<double>> depths;
  for (std::size_t i = 0; i < day.wavelengths.size(); ++i) {
    spectral::AbsorptionLane lane = day.intervals[i];
    for (const AbsorptionTerm& term :
         gases.terms(Micrometres{lane.lo_um}, Micrometres{lane.hi_um}, settings.term_tolerance)) {
      made.lanes.push_back({static_cast<int>(i), lane, term.weight});
      job.lanes.push_back({day.wavelengths[i].value, lane, term.weight});
      depths.push_back(term.depth);
      ++lane.term;
    }
  }
  job.settings = settings;
  job.level_m = levels;
  job.column = [&](std::size_t lane) {
    const Micrometres wavelength{job.lanes[lane].wavelength_um};
    OpticalColumn column{levels, {}, depths[lane], {{gases.rayleigh_depth(wavelength), rayleigh}}};
    for (const double z : levels) {
      column.level_temperature_k.push_back(level_at(day.air.profile, z).temperature_k);
    }
    for (int k = 0; k < particles.kinds(); ++k) {
      const KindOptics optics = particles.optics(k, wavelength);
      column.kinds.push_back({particles.depth_550(k), optics.phase});
      for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        column.absorption[i] += column.kinds.back().scattering[i] * optics.absorption;
        column.kinds.back().scattering[i] *= optics.scattering;
      }
    }
    return column;
  };
  job.bodies = {{"sun", day.sun[0].direction_enu, day.sun[0].angular_radius,
                 std::vector<double>(job.lanes.size(), 1000.0)}};
  job.airglow = job.starlight = job.urban_glow = std::vector<double>(job.lanes.size(), 0.0);
  made.table = std::make_shared<const AirTable>(filled_table(job));
  return made;
}

/// @param layers  times as many as by default; 1: by the product's own way
Made make(const Day& day, const AirSettings& settings, double layers = 1.0) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  Table made;
  if (layers == 1.0) {
    made.lanes = split_lanes(day.air, settings, day.wavelengths, day.intervals);
    made.table = std::make_shared<const AirTable>(
        make_air_table(day.air, settings, made.lanes, day.wavelengths, day.sun));
  } else {
    made = on_levels(day, settings, levels_of(day, layers));
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  const double cpu_seconds = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
  return {time.count(),
          cpu_seconds,
          made.table->interpolation_error,
          made.lanes.size(),
          levels_of(day, layers).size() - 1,
          look(day, made.table, made.lanes)};
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

/// Prints a row a table: for people, or as CSV.
class Rows {
 public:
  Rows(bool csv, Made reference) : csv_{csv}, reference_{std::move(reference)} {
    if (csv_) {
      std::printf("family,value,lanes,layers,ms,cpu_ms,rms_error,interpolation_error\n");
    } else {
      std::printf("%-24s %6s %6s %8s %8s %10s %13s\n", "setting", "lanes", "layers", "ms", "CPU ms",
                  "rms error", "interpolation");
    }
    add("reference", "", reference_);
  }
  void add(const std::string& family, const std::string& value, const Made& made) const {
    const char* format = csv_ ? "%s,%s,%zu,%zu,%.1f,%.1f,%.6f,%.5f\n"
                              : "%-15s %-8s %6zu %6zu %8.1f %8.1f %10.5f %13.5f\n";
    std::printf(format, family.c_str(), value.c_str(), made.lanes, made.layers, 1e3 * made.seconds,
                1e3 * made.cpu_seconds, rms(made, reference_), made.interpolation);
    std::fflush(stdout);
  }

 private:
  bool csv_;
  Made reference_;
};

AirSettings base() {
  AirSettings s;
  s.observer_height_m = 100e3;
  return s;
}

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", value);
  return buffer;
}

int run(const std::string& folder, bool csv) {
  const Day one = make_day(folder, 1), day = make_day(folder, 60);
  AirSettings fine = base();
  fine.streams = 24;
  fine.term_tolerance = 1e-4;
  fine.zenith_nodes = fine.azimuth_nodes = 37;
  fine.share_nodes = 24;
  const Rows rows{csv, make(day, fine, 2.0)};
  if (!csv) {
    Made warm = make(one, base());
    warm = make(one, base());
    std::printf("%-24s %6zu %6zu %8.1f %8.1f\n", "one wavelength, default", warm.lanes, warm.layers,
                1e3 * warm.seconds, 1e3 * warm.cpu_seconds);
  }
  rows.add("default", "", make(day, base()));
  AirSettings s = base();
  s.mode = AirMode::fast;
  rows.add("fast", "2", make(day, s));
  for (const int streams : {4, 6, 12, 16}) {
    s = base();
    s.streams = streams;
    rows.add("streams", std::to_string(streams), make(day, s));
  }
  for (const double factor : {1.0 / 3.0, 0.5, 2.0}) {
    rows.add("layers", text(factor), make(day, base(), factor));
  }
  for (const double tolerance : {1e-2, 5e-3, 2e-3, 1e-3, 2e-4, 1e-4}) {
    s = base();
    s.term_tolerance = tolerance;
    rows.add("term tolerance", text(tolerance), make(day, s));
  }
  for (const int nodes : {3, 6, 10, 24}) {
    s = base();
    s.zenith_nodes = s.azimuth_nodes = nodes + 1;
    s.share_nodes = std::max(3, nodes * 5 / 6);
    rows.add("nodes", std::to_string(nodes + 1), make(day, s));
  }
  return 0;
}

}  // namespace
}  // namespace nadir

int main(int argc, char** argv) {
  try {
    const bool csv = argc > 1 && std::strcmp(argv[1], "--csv") == 0;
    const int folder = csv ? 2 : 1;
    return nadir::run(argc > folder ? argv[folder] : "scenes/library/atmosphere", csv);
  } catch (const nadir::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
