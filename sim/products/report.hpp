#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/products/promises.hpp"
#include "sim/run/image.hpp"

namespace nadir::sim {

/// A file that a run read or wrote.
struct FileRecord {
  std::string role;  ///< "scenario", "mesh", "spectrum", "radiance", "quick look", ...
  std::filesystem::path path;
  std::uint64_t bytes = 0;
  std::string sha256;  ///< 64 hexadecimal digits; empty where it was not taken
};

/// The record of a file as it now stands. @throws std::runtime_error when it cannot be read.
[[nodiscard]] FileRecord record_file(std::string role, const std::filesystem::path& path);

struct StageTime {
  std::string name;
  double wall_s = 0.0;
  double cpu_s = 0.0;  ///< of all threads
};

/// A setting or option as the report shows it.
using ReportValue = std::variant<bool, std::int64_t, double, std::string>;
using ReportValues = std::vector<std::pair<std::string, ReportValue>>;  ///< in the order shown

/// Least, mean and greatest of the finite values; NaN where there are none.
struct ValueRange {
  double least = std::numeric_limits<double>::quiet_NaN();
  double mean = std::numeric_limits<double>::quiet_NaN();
  double greatest = std::numeric_limits<double>::quiet_NaN();
};

/// Of a band's digital numbers.
struct DnSummary {
  ValueRange range;
  std::uint64_t zero_pixels =
      0;  ///< dead, without a valid radiance, or below the converter's range
  /// With the number of a full well or the converter's greatest; nothing: not known.
  std::optional<std::uint64_t> saturated_pixels;
};

struct BandSummary {
  std::string name;
  double centre_um = 0.0, fwhm_um = 0.0;
  ValueRange radiance;  ///< W m^-2 sr^-1 um^-1
  double median_relative_error = std::numeric_limits<double>::quiet_NaN();
  double p95_relative_error = std::numeric_limits<double>::quiet_NaN();
  ValueRange brightness_temperature;  ///< K; all NaN for bands up to 3 um
  std::uint64_t invalid_pixels = 0;   ///< radiance is not a finite number
  std::uint64_t negative_pixels = 0;  ///< radiance below 0
  std::optional<DnSummary> dn{};      ///< nothing without a detector
};

struct ArraySummary {
  std::string name;
  int samples = 0, lines = 0;
  double surface_share = std::numeric_limits<double>::quiet_NaN();  ///< of pixels not seeing sky
  std::uint64_t invalid_pixels = 0;  ///< pixels with any band's radiance not a finite number
  std::vector<BandSummary> bands;
};

/// Relative error: standard error over radiance, of the pixels where both are finite and the
/// radiance is above 0. Without the camera, saturated pixels are not known.
[[nodiscard]] ArraySummary summarise(const ArrayImage& image);

/// All that a run tells about itself. docs/products.md explains every key.
struct RunReport {
  std::string version;
  std::string started_utc, finished_utc;  ///< ISO 8601
  std::filesystem::path scenario_file;
  std::string scenario_name, scenario_title, scenario_time_utc;
  ReportValues options;   ///< of the command line, those that change results
  ReportValues settings;  ///< solver, sampling, seed, threads
  ReportValues air;       ///< how the air was computed; empty where nothing was
  ReportValues heat;      ///< what the heat balance cost; empty where nothing was solved
  Promises promises;      ///< effects, prediction and fact, audit, goal, bias
  std::vector<FileRecord> inputs;
  std::vector<StageTime> stages;
  std::map<std::string, std::uint64_t> counters;  ///< rays of each kind, thresholds that bit
  std::vector<ArraySummary> arrays;
  std::vector<std::string> warnings;
  std::vector<FileRecord> products;
  std::uint64_t peak_memory_bytes = 0;
};

/// The report as JSON (RFC 8259), two spaces a level, keys always in the same order. A number that
/// is not finite becomes null, text that is not UTF-8 gets replacement characters.
[[nodiscard]] std::string to_json(const RunReport& report);

/// Writes the JSON; the name appears only with the whole file.
void write_report(const std::filesystem::path& file, const RunReport& report);

}  // namespace nadir::sim
