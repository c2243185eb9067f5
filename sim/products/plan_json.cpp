#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/products/plan_sheet.hpp"

namespace nadir::sim {
namespace {

using PlanJson = nlohmann::ordered_json;

PlanJson finite_or_null(double value) {
  return std::isfinite(value) ? PlanJson(value) : PlanJson(nullptr);
}

/// What there is of every band, under the names of arrays and bands.
template <class Values, class F>
PlanJson band_map(const CameraNames& names, const Values& values, F&& value_of_one) {
  PlanJson json = PlanJson::object();
  for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) {
    PlanJson array = PlanJson::object();
    for (std::size_t b = 0; b < names[i].bands.size() && b < values[i].size(); ++b) {
      array[names[i].bands[b]] = value_of_one(values[i][b]);
    }
    json[names[i].array] = std::move(array);
  }
  return json;
}

PlanJson plan_value(const EffectSheet& effect, const CameraNames& names) {
  PlanJson json;
  json["name"] = effect.name;
  json["state"] = effect.state;
  json["bound"] = band_map(names, effect.bound, finite_or_null);
  json["reason"] = effect.reason;
  json["seconds"] = finite_or_null(effect.seconds);
  json["seconds_if_on"] = finite_or_null(effect.seconds_if_on);
  return json;
}

PlanJson plan_value(const std::vector<EffectSheet>& effects, const CameraNames& names) {
  PlanJson list = PlanJson::array();
  for (const EffectSheet& effect : effects) list.push_back(plan_value(effect, names));
  return list;
}

PlanJson plan_value(const BandForecast& band) {
  return {{"median", finite_or_null(band.median_error)},
          {"p95", finite_or_null(band.p95_error)},
          {"share_in_budget", finite_or_null(band.met)}};
}

PlanJson plan_value(const Prediction& p, const CameraNames& names) {
  PlanJson json;
  json["seconds"] = finite_or_null(p.seconds);
  json["stages"] = {{"load", finite_or_null(p.load_s)},
                    {"heat", finite_or_null(p.heat_s)},
                    {"air", finite_or_null(p.air_s)},
                    {"render", finite_or_null(p.render_s)},
                    {"products", finite_or_null(p.products_s)}};
  json["render_cpu_s"] = finite_or_null(p.render_cpu_s);
  json["memory_bytes"] = finite_or_null(p.memory_bytes);
  json["paths_per_pixel"] = finite_or_null(p.mean_paths);
  json["seconds_per_path"] = finite_or_null(p.seconds_per_path);
  json["error"] =
      band_map(names, p.bands, [](const BandForecast& band) { return plan_value(band); });
  json["reachable_accuracy"] = finite_or_null(p.reachable);
  json["pilot"] = {{"pixels", p.pilot_pixels}, {"paths", p.pilot_paths}, {"seconds", p.pilot_s}};
  return json;
}

PlanJson plan_value(const BiasTerms& bias) {
  return {{"dropped_effects", finite_or_null(bias.dropped_effects)},
          {"bounce_limit", finite_or_null(bias.bounce_limit)},
          {"thresholds", finite_or_null(bias.thresholds)},
          {"wavelengths", finite_or_null(bias.wavelengths)},
          {"air_table", finite_or_null(bias.air_table)},
          {"total", finite_or_null(bias.total())}};
}

PlanJson budget_json(const PlanSheet& sheet) {
  PlanJson json;
  json["relative"] = sheet.relative;
  json["effects_share"] = sheet.effects_share;
  json["floor_radiance_w_m2_sr_um"] =
      band_map(sheet.names, sheet.bands,
               [](const PlannedBand& band) { return finite_or_null(band.floor_radiance); });
  json["dropped"] = band_map(sheet.names, sheet.bands,
                             [](const PlannedBand& band) { return finite_or_null(band.dropped); });
  json["bias"] = band_map(sheet.names, sheet.bands,
                          [](const PlannedBand& band) { return plan_value(band.bias); });
  return json;
}

PlanJson settings_json(const PlanSheet& sheet) {
  PlanJson json;
  json["wanted"] = sheet.wanted;
  json["solver"] = sheet.solver;
  json["reason"] = sheet.solver_reason;
  json["samples"] = sheet.samples;
  json["wavelengths"] =
      band_map(sheet.names, sheet.bands, [](const PlannedBand& band) { return band.wavelengths; });
  return json;
}

PlanJson arrays_json(const PlanSheet& sheet) {
  PlanJson list = PlanJson::array();
  for (std::size_t i = 0; i < sheet.names.size(); ++i) {
    PlanJson bands = PlanJson::array();
    for (std::size_t b = 0; b < sheet.names[i].bands.size(); ++b) {
      bands.push_back({{"name", sheet.names[i].bands[b]},
                       {"centre_um", finite_or_null(sheet.bands[i][b].centre_um)}});
    }
    list.push_back({{"name", sheet.names[i].array}, {"pixels", sheet.pixels[i]}, {"bands", bands}});
  }
  return list;
}

std::string dumped(const PlanJson& json, int indent) {
  return json.dump(indent, ' ', false, PlanJson::error_handler_t::replace);
}

}  // namespace

std::string plan_json(const PlanSheet& sheet) {
  PlanJson json;
  json["format"] = "nadir plan 1";
  json["scenario"] = {{"file", sheet.file}, {"name", sheet.scenario}, {"title", sheet.title}};
  json["arrays"] = arrays_json(sheet);
  json["effects"] = plan_value(sheet.effects, sheet.names);
  json["settings"] = settings_json(sheet);
  json["budget"] = budget_json(sheet);
  json["prediction"] =
      sheet.prediction ? plan_value(*sheet.prediction, sheet.names) : PlanJson(nullptr);
  json["warnings"] = sheet.warnings;
  return dumped(json, 2) + "\n";
}

std::string effects_json(const std::vector<EffectSheet>& effects, const CameraNames& names) {
  return dumped(plan_value(effects, names), -1);
}

std::string prediction_json(const Prediction& prediction, const CameraNames& names) {
  return dumped(plan_value(prediction, names), -1);
}

std::string bias_json(const BiasByBand& bias, const CameraNames& names) {
  return dumped(band_map(names, bias, [](const BiasTerms& band) { return plan_value(band); }), -1);
}

}  // namespace nadir::sim
