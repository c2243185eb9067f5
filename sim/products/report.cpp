#include "sim/products/report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/files/atomic_file.hpp"
#include "sim/files/hash.hpp"

namespace nadir::sim {
namespace {

using Json = nlohmann::ordered_json;  // keeps keys in the order in which they are set

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const ReportValues& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) {
    json[name] = std::visit(
        [](const auto& v) {
          if constexpr (std::is_same_v<std::decay_t<decltype(v)>, double>) return number(v);
          return Json(v);
        },
        value);
  }
  return json;
}

Json json_of(const FileRecord& file) {
  Json json{{"role", file.role}, {"path", file.path.string()}, {"bytes", file.bytes}};
  if (!file.sha256.empty()) json["sha256"] = file.sha256;
  return json;
}

Json json_of(const StageTime& stage) {
  return {{"name", stage.name}, {"wall_s", number(stage.wall_s)}, {"cpu_s", number(stage.cpu_s)}};
}

Json json_of(const ValueRange& range) {
  return {
      {"min", number(range.least)}, {"mean", number(range.mean)}, {"max", number(range.greatest)}};
}

Json json_of(const DnSummary& dn) {
  Json json = json_of(dn.range);
  json["zero_pixels"] = dn.zero_pixels;
  json["saturated_pixels"] = dn.saturated_pixels ? Json(*dn.saturated_pixels) : Json(nullptr);
  return json;
}

Json json_of(const BandSummary& band) {
  Json json{
      {"name", band.name},
      {"centre_um", number(band.centre_um)},
      {"fwhm_um", number(band.fwhm_um)},
      {"radiance", json_of(band.radiance)},
      {"relative_standard_error",
       {{"median", number(band.median_relative_error)}, {"p95", number(band.p95_relative_error)}}}};
  if (std::isfinite(band.brightness_temperature.mean)) {
    json["brightness_temperature_k"] = json_of(band.brightness_temperature);
  }
  json["invalid_pixels"] = band.invalid_pixels;
  json["negative_pixels"] = band.negative_pixels;
  if (band.dn) json["dn"] = json_of(*band.dn);
  return json;
}

Json json_of(const ArraySummary& array);

template <class T>
Json list(const std::vector<T>& items) {
  Json json = Json::array();
  for (const T& item : items) json.push_back(json_of(item));
  return json;
}

Json json_of(const ArraySummary& array) {
  return {{"name", array.name},
          {"samples", array.samples},
          {"lines", array.lines},
          {"surface_share", number(array.surface_share)},
          {"invalid_pixels", array.invalid_pixels},
          {"bands", list(array.bands)}};
}

}  // namespace

FileRecord record_file(std::string role, const std::filesystem::path& path) {
  const FileDigest digest = digest_file(path);
  return {std::move(role), path, digest.bytes, digest.sha256};
}

std::string to_json(const RunReport& report) {
  Json json;
  json["format"] = "nadir run report 1";
  json["version"] = report.version;
  json["started_utc"] = report.started_utc;
  json["finished_utc"] = report.finished_utc;
  json["scenario"] = {{"file", report.scenario_file.string()},
                      {"name", report.scenario_name},
                      {"title", report.scenario_title},
                      {"time_utc", report.scenario_time_utc}};
  json["options"] = json_of(report.options);
  json["settings"] = json_of(report.settings);
  if (!report.air.empty()) json["air"] = json_of(report.air);
  if (!report.heat.empty()) json["heat"] = json_of(report.heat);
  const Json promises = Json::parse(promises_json(report.promises));
  for (const auto& [key, value] : promises.items()) json[key] = value;
  json["inputs"] = list(report.inputs);
  json["stages"] = list(report.stages);
  json["counters"] = report.counters;
  json["peak_memory_bytes"] = report.peak_memory_bytes;
  json["arrays"] = list(report.arrays);
  json["warnings"] = report.warnings;
  json["products"] = list(report.products);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_report(const std::filesystem::path& file, const RunReport& report) {
  write_file(file, to_json(report));
}

}  // namespace nadir::sim
