#include "sim/products/promises.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace nadir::sim {
namespace {

using PromiseJson = nlohmann::ordered_json;

PromiseJson promise_number(double value) {
  return std::isfinite(value) ? PromiseJson(value) : PromiseJson(nullptr);
}

PromiseJson promise_value(const AuditReport& audit) {
  PromiseJson json;
  json["verdict"] = audit.verdict;
  json["effects"] = audit.effects;
  json["not_audited"] = audit.not_audited;
  json["pixels"] = audit.pixels;
  json["budget"] = promise_number(audit.budget);
  if (audit.pixels > 0) {
    json["largest"] = {{"difference", promise_number(audit.largest)},
                       {"standard_error", promise_number(audit.largest_error)},
                       {"of_budget", promise_number(audit.largest / audit.budget)},
                       {"array", audit.array},
                       {"band", audit.band},
                       {"sample", audit.sample},
                       {"line", audit.line}};
  }
  json["beyond_budget"] = audit.beyond;
  json["surely_beyond_budget"] = audit.surely_beyond;
  json["beyond_share_upper_95"] = promise_number(audit.beyond_share);
  json["surely_beyond_share_upper_95"] = promise_number(audit.surely_beyond_share);
  json["seconds"] = promise_number(audit.seconds);
  json["cpu_s"] = promise_number(audit.cpu_s);
  return json;
}

PromiseJson promise_value(const ArrayOutcome& array, const ArrayNames& names) {
  PromiseJson json{{"share_met", promise_number(array.met)},
                   {"pixels", array.pixels},
                   {"paths",
                    {{"least", array.least_paths},
                     {"mean", promise_number(array.mean_paths)},
                     {"most", array.most_paths}}}};
  PromiseJson bands = PromiseJson::object();
  for (std::size_t b = 0; b < array.bands.size() && b < names.bands.size(); ++b) {
    bands[names.bands[b]] = {{"share_met", promise_number(array.bands[b].met)},
                             {"worst", promise_number(array.bands[b].worst)},
                             {"p95", promise_number(array.bands[b].p95)}};
  }
  json["bands"] = std::move(bands);
  return json;
}

PromiseJson promise_value(const GoalReport& goal, const CameraNames& names) {
  double met = 0.0, pixels = 0.0, worst = 0.0;
  PromiseJson arrays = PromiseJson::object();
  for (std::size_t i = 0; i < goal.outcome.arrays.size() && i < names.size(); ++i) {
    const ArrayOutcome& array = goal.outcome.arrays[i];
    met += array.met * static_cast<double>(array.pixels);
    pixels += static_cast<double>(array.pixels);
    for (const BandOutcome& band : array.bands) worst = std::max(worst, band.worst);
    arrays[names[i].array] = promise_value(array, names[i]);
  }
  PromiseJson wanted = PromiseJson::object();
  if (goal.accuracy) wanted["accuracy"] = *goal.accuracy;
  if (goal.time_s) wanted["time_s"] = *goal.time_s;
  return {{"wanted", wanted},
          {"kept", goal.kept},
          {"sentence", goal.sentence},
          {"seconds", promise_number(goal.seconds)},
          {"share_met", promise_number(pixels > 0.0 ? met / pixels : NAN)},
          {"worst", promise_number(worst)},
          {"reached", arrays}};
}

PromiseJson promise_value(const RunFact& fact, const CameraNames& names) {
  PromiseJson error = PromiseJson::object();
  for (std::size_t i = 0; i < names.size() && i < fact.bands.size(); ++i) {
    PromiseJson bands = PromiseJson::object();
    for (std::size_t b = 0; b < names[i].bands.size() && b < fact.bands[i].size(); ++b) {
      bands[names[i].bands[b]] = {{"median", promise_number(fact.bands[i][b].median_error)},
                                  {"p95", promise_number(fact.bands[i][b].p95_error)},
                                  {"share_in_budget", promise_number(fact.bands[i][b].met)}};
    }
    error[names[i].array] = std::move(bands);
  }
  return {{"seconds", promise_number(fact.seconds)},
          {"render_s", promise_number(fact.render_s)},
          {"memory_bytes", promise_number(fact.memory_bytes)},
          {"paths_per_pixel", promise_number(fact.mean_paths)},
          {"error", error}};
}

}  // namespace

std::string promises_json(const Promises& promises) {
  const CameraNames& names = promises.names;
  PromiseJson json = PromiseJson::object();
  if (!promises.effects.empty()) {
    json["effects"] = PromiseJson::parse(effects_json(promises.effects, names));
  }
  if (!promises.settings_reason.empty()) json["settings_reason"] = promises.settings_reason;
  if (promises.prediction) {
    json["prediction"] = PromiseJson::parse(prediction_json(*promises.prediction, names));
  }
  if (promises.fact) json["fact"] = promise_value(*promises.fact, names);
  if (promises.audit) json["audit"] = promise_value(*promises.audit);
  if (promises.goal) json["goal"] = promise_value(*promises.goal, names);
  if (!promises.bias.empty()) json["bias"] = PromiseJson::parse(bias_json(promises.bias, names));
  return json.dump(-1, ' ', false, PromiseJson::error_handler_t::replace);
}

}  // namespace nadir::sim
