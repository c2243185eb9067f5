#include "sim/files/air_import.hpp"

#include <cmath>
#include <span>
#include <utility>

#include "core/error.hpp"
#include "core/quantity.hpp"
#include "sim/files/modtran_csv.hpp"
#include "sim/files/modtran_tape7.hpp"
#include "sim/files/number_table.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& message) {
  throw InputError{InputIssue{{file.string(), 0, 0}, message, {}, {}}};
}

/// MODTRAN's CSV files have a case each, or all of them in one file.
AirRunSet all_csv(const AirImport& wanted, const std::vector<RunGeometry>& geometry) {
  if (geometry.empty()) {
    throw InputError{"CSV output of MODTRAN does not say where it looks: give a geometry file"};
  }
  if (wanted.files.size() == 1) {
    return read_modtran_csv(wanted.files.front(), geometry, wanted.settings);
  }
  if (wanted.files.size() != geometry.size()) {
    fail(wanted.geometry, "the file has " + std::to_string(geometry.size()) + " rows for " +
                              std::to_string(wanted.files.size()) + " files");
  }
  AirRunSet all;
  for (std::size_t i = 0; i < wanted.files.size(); ++i) {
    const std::span<const RunGeometry> one{&geometry[i], 1};
    merge(all, read_modtran_csv(wanted.files[i], one, wanted.settings));
  }
  return all;
}

AirRunSet all_tape7(const AirImport& wanted) {
  AirRunSet all;
  for (const fs::path& file : wanted.files) merge(all, read_modtran_tape7(file, wanted.settings));
  return all;
}

AirRunSet all_uvspec(const AirImport& wanted) {
  AirRunSet all;
  for (const fs::path& file : wanted.files) {
    fs::path input = file;
    merge(all, read_uvspec(input.replace_extension(".inp"), file, wanted.settings, wanted.uvspec));
  }
  return all;
}

void place(AirRunSet& set, const AirImport& wanted, const std::vector<RunGeometry>& geometry) {
  if (wanted.from == AirSource::modtran_csv || geometry.empty()) return;
  if (geometry.size() != set.runs.size()) {
    fail(wanted.geometry, "the file has " + std::to_string(geometry.size()) + " rows for " +
                              std::to_string(set.runs.size()) + " runs");
  }
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    AirRun& run = set.runs[i];
    run.height_m = geometry[i].height_m;
    run.zenith_rad = geometry[i].zenith_rad;
    run.length_m = geometry[i].length_m;
    if (geometry[i].azimuth_rad) run.azimuth_rad = geometry[i].azimuth_rad;
  }
}

double folded_rad(double azimuth_deg) {
  return std::abs(std::remainder(azimuth_deg, 360.0)) * radians_per_degree;
}

void turn(AirRunSet& set, const std::vector<double>& azimuth_deg) {
  if (azimuth_deg.empty()) return;
  const bool one = azimuth_deg.size() == 1;
  if (!one && azimuth_deg.size() != set.runs.size()) {
    throw InputError{std::to_string(azimuth_deg.size()) + " azimuths are given for " +
                     std::to_string(set.runs.size()) + " runs: expected one for all, or one each"};
  }
  for (std::size_t i = 0; i < set.runs.size(); ++i) {
    set.runs[i].azimuth_rad = folded_rad(azimuth_deg[one ? 0 : i]);
  }
}

/// Sunlight scattered into a slant way without a word on where the sun is.
void check_azimuths(const AirRunSet& set) {
  for (const AirRun& run : set.runs) {
    const bool vertical = std::abs(std::sin(run.zenith_rad)) < 1e-5;
    if (run.solar.empty() || vertical || run.azimuth_rad) continue;
    throw InputError{run.name +
                     ": the run has scattered sunlight and does not say at which azimuth "
                     "from the sun it looks: give the azimuths"};
  }
}

}  // namespace

std::vector<RunGeometry> read_run_geometry(const fs::path& file) {
  const NumberTable table{read_bytes(file),
                          file.string(),
                          {{"height_m", true, -500.0, 1e9},
                           {"zenith_deg", true, 0.0, 180.0},
                           {"azimuth_deg", false, -360.0, 360.0},
                           {"length_m", false, 1e-3, 1e9}}};
  std::vector<RunGeometry> all;
  for (const NumberTable::Row& row : table.rows()) {
    RunGeometry one;
    one.height_m = table.value(row, "height_m", 0.0);
    one.zenith_rad = table.value(row, "zenith_deg", 0.0) * radians_per_degree;
    if (table.has("azimuth_deg")) {
      one.azimuth_rad = folded_rad(table.value(row, "azimuth_deg", 0.0));
    }
    one.length_m = table.value(row, "length_m", one.length_m);
    all.push_back(one);
  }
  return all;
}

atmosphere::AirTable import_air(const AirImport& wanted) {
  if (wanted.files.empty()) throw InputError{"there is no file to import"};
  std::vector<RunGeometry> geometry;
  if (!wanted.geometry.empty()) geometry = read_run_geometry(wanted.geometry);
  AirRunSet set;
  if (wanted.from == AirSource::tape7) {
    set = all_tape7(wanted);
  } else if (wanted.from == AirSource::modtran_csv) {
    set = all_csv(wanted, geometry);
  } else {
    set = all_uvspec(wanted);
  }
  if (wanted.files.size() > 1) {
    set.made_by += " and " + std::to_string(wanted.files.size() - 1) + " more";
  }
  place(set, wanted, geometry);
  turn(set, wanted.azimuth_deg);
  check_azimuths(set);
  return table_of_runs(set, wanted.settings);
}

}  // namespace nadir::sim
