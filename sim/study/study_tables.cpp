#include "sim/study/study_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "sim/study/record_json.hpp"

namespace nadir::sim {
namespace {

using TableJson = nlohmann::ordered_json;

std::string quoted(const std::string& text) {
  std::string safe = "\"";
  for (const char c : text) safe += c == '"' ? std::string{"\"\""} : std::string{c};
  return safe + "\"";
}

/// A number that JSON can hold.
TableJson finite(double value) { return std::isfinite(value) ? TableJson(value) : TableJson(); }

TableJson finite(const std::vector<double>& values) {
  TableJson all = TableJson::array();
  for (const double value : values) all.push_back(finite(value));
  return all;
}

TableJson json_of(const RateFit& fit) {
  return {{"p", finite(fit.rate)},
          {"p_standard_error", finite(fit.rate_uncertainty)},
          {"c", finite(fit.scale)},
          {"bias", finite(fit.bias)},
          {"reduced_chi2", finite(fit.reduced_chi2)}};
}

TableJson json_of(const BandMeasures& f) {
  return {{"bias", finite(f.bias)},
          {"bias_standard_error", finite(f.bias_error)},
          {"square_pixel_bias", finite(f.square_bias)},
          {"square_pixel_bias_standard_error", finite(f.square_bias_error)},
          {"replicate_noise", finite(f.noise)},
          {"replicate_noise_standard_error", finite(f.noise_error)}};
}

TableJson json_of(const LevelFigures& level) {
  TableJson bands = TableJson::array();
  for (std::size_t b = 0; b < level.bands.size(); ++b) {
    TableJson band = json_of(level.bands[b]);
    band["error"] = finite(level.error[b]);
    bands.push_back(std::move(band));
  }
  return {{"samples_per_replicate", level.samples},
          {"replicates_measured", level.replicates},
          {"paths", level.paths},
          {"picture_s", finite(level.picture_s)},
          {"worst_error", finite(level.worst_error)},
          {"cpu_s_per_path", finite(level.cost.path_cpu_s)},
          {"wall_s_per_path", finite(level.cost.path_wall_s)},
          {"rays_per_path", finite(level.cost.rays_per_path)},
          {"peak_memory_bytes", level.cost.peak_memory_bytes},
          {"bands", std::move(bands)}};
}

TableJson json_of(const RowFigures& row) {
  TableJson bands = TableJson::array(), levels = TableJson::array();
  for (const RowBand& band : row.bands) {
    bands.push_back({{"bias", finite(band.bias)},
                     {"bias_standard_error", finite(band.bias_error)},
                     {"pixel_bias_rms", finite(band.pixel_bias)},
                     {"pixel_bias_limit_95", finite(band.pixel_bias_limit)},
                     {"noise_of_one_path", finite(band.path_noise)}});
  }
  for (const LevelFigures& level : row.levels) levels.push_back(json_of(level));
  return {{"name", row.point.name},
          {"varied", row.point.group},
          {"settings", json_of(row.point.settings)},
          {"unbiased", row.point.unbiased()},
          {"paired", row.point.paired},
          {"cpu_s_per_path", finite(row.path_cpu_s)},
          {"wall_s_per_path", finite(row.path_wall_s)},
          {"picture_cpu_s_per_path", finite(row.picture_cpu_s)},
          {"setup_s", finite(row.setup_s)},
          {"rays_per_path", finite(row.rays_per_path)},
          {"peak_memory_bytes", row.peak_memory_bytes},
          {"bands", std::move(bands)},
          {"rate", json_of(row.rate)},
          {"rate_with_bias", json_of(row.with_bias)},
          {"levels", std::move(levels)}};
}

TableJson json_of(const Recommendation& advice) {
  TableJson json{{"target", advice.target}, {"reached", advice.reached}};
  if (advice.reached) {
    json["row"] = advice.row;
    json["settings"] = json_of(advice.settings);
    json["solver_element"] = solver_element(advice.settings);
    json["replicates"] = advice.replicates;
    json["samples_per_replicate"] = advice.samples;
    json["predicted_error"] = finite(advice.error);
    json["predicted_picture_s"] = finite(advice.picture_s);
    json["pixel_bias_by_band"] = finite(advice.bias);
    json["found_error"] = finite(advice.found_error);
  }
  json["reason"] = advice.reason;
  return json;
}

TableJson json_of(const Reference& reference) {
  return {{"method", "path"},
          {"paths", reference.paths},
          {"standard_error_by_band", finite(reference.error)},
          {"mean_radiance_by_band", finite(reference.radiance)},
          {"floor_radiance_by_band", finite(reference.floor)}};
}

TableJson rates_of(const StudyResult& result) {
  TableJson rates = TableJson::array();
  for (const RowFigures& row : result.rows) {
    TableJson rate = json_of(row.rate);
    rate["row"] = row.point.name;
    rates.push_back(std::move(rate));
  }
  return rates;
}

}  // namespace

std::string study_csv(const StudyRecord& record, const StudyResult& result) {
  std::string csv =
      "row,varied,settings,array,band,centre_um,paths_per_pixel,samples_per_replicate,"
      "error_percent,bias_percent,bias_standard_error_percent,pixel_bias_rms_percent,"
      "pixel_bias_limit_95_percent,noise_of_one_path_percent,picture_time_s,cpu_per_path_us,"
      "wall_per_path_us,rays_per_path,peak_memory_MB\r\n";
  for (const RowFigures& row : result.rows) {
    for (const LevelFigures& level : row.levels) {
      for (std::size_t b = 0; b < row.bands.size(); ++b) {
        const StudyBand& band = record.header.bands[b];
        const RowBand& all = row.bands[b];
        csv += fmt::format(
            "{},{},{},{},{},{:.6g},{:g},{},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},"
            "{:.5g},{:.5g},{:.5g}\r\n",
            quoted(row.point.name), quoted(row.point.group), quoted(key_of(row.point.settings)),
            quoted(band.array), quoted(band.name), band.centre_um, level.paths, level.samples,
            100.0 * level.error[b], 100.0 * level.bands[b].bias, 100.0 * level.bands[b].bias_error,
            100.0 * all.pixel_bias, 100.0 * all.pixel_bias_limit, 100.0 * all.path_noise,
            level.picture_s, 1e6 * level.cost.path_cpu_s, 1e6 * level.cost.path_wall_s,
            level.cost.rays_per_path, 1e-6 * level.cost.peak_memory_bytes);
      }
    }
  }
  return csv;
}

std::string study_json(const StudyRecord& record, const StudyResult& result) {
  TableJson rows = TableJson::array(), pareto = TableJson::array(), advice = TableJson::array();
  TableJson skipped = TableJson::array();
  for (const RowFigures& row : result.rows) rows.push_back(json_of(row));
  for (const TradePoint& point : result.pareto) {
    const RowFigures& row = result.rows[point.row];
    pareto.push_back({{"row", row.point.name},
                      {"paths", row.levels[point.level].paths},
                      {"picture_s", finite(point.cost.time_s)},
                      {"error", finite(point.cost.error)}});
  }
  for (const Recommendation& one : result.recommendations) advice.push_back(json_of(one));
  for (const StudySkip& skip : record.skips) {
    skipped.push_back({{"settings", skip.key}, {"reason", skip.reason}});
  }
  TableJson study = json_of(record.header);
  study["budget_s"] = record.finished_budget_s;
  study["spent_s"] = record.spent_s;
  study["reference"] = json_of(result.reference);
  study["recommendations"] = std::move(advice);
  study["pareto"] = std::move(pareto);
  study["rate"] = rates_of(result);
  study["rows"] = std::move(rows);
  study["not_measured"] = std::move(skipped);
  study["warnings"] = record.warnings;
  return study.dump(2, ' ', false, TableJson::error_handler_t::replace) + "\n";
}

}  // namespace nadir::sim
