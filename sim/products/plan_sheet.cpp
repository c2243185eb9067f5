#include "sim/products/plan_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/products/text_table.hpp"

namespace nadir::sim {
namespace {

constexpr std::size_t page_width = 120;
// More bands than that make a table that nobody reads; the JSON has all.
constexpr std::size_t bands_shown = 16;

std::string percent_text(double share) {
  if (std::isnan(share)) return "-";
  if (std::isinf(share)) return "unknown";
  const double percent = 100.0 * share;
  if (percent == 0.0) return "0 %";
  if (percent < 1e-3) return "<0.001 %";
  if (percent > 1e4) return ">10000 %";
  return fmt::format("{:.3g} %", percent);
}

std::string plan_seconds(double seconds) {
  if (!std::isfinite(seconds)) return "-";
  if (seconds == 0.0) return "0";
  if (seconds < 0.01) return "<0.01";
  return seconds < 100.0 ? fmt::format("{:.2f}", seconds) : fmt::format("{:.0f}", seconds);
}

std::string memory_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes * 1e-6)
                     : fmt::format("{:.2f} GB", bytes * 1e-9);
}

std::string plan_figure(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

double greatest_of(const ByBand& values) {
  double greatest = 0.0;
  for (const auto& array : values) {
    for (const double value : array) greatest = std::max(greatest, value);
  }
  return greatest;
}

std::string state_of(const EffectDecision& decision, const CameraNames& names) {
  std::string on;
  std::size_t count = 0;
  for (std::size_t i = 0; i < decision.on.size(); ++i) {
    if (!decision.on[i]) continue;
    ++count;
    on += (on.empty() ? "" : ", ") + (i < names.size() ? names[i].array : std::to_string(i + 1));
  }
  const bool everywhere = count == decision.on.size();
  if (decision.asked == EffectState::on) return "on (stated)";
  if (decision.asked == EffectState::off) return "off (stated)";
  if (count > 0) {
    return everywhere ? "on"
                      : fmt::format("on in {} of {} arrays: {}", count, decision.on.size(), on);
  }
  return greatest_of(decision.bound) > 0.0 ? "off (auto)" : "off (absent)";
}

/// The band where the bound is greatest.
struct WorstBand {
  double bound = 0.0;
  std::string name;
};
WorstBand worst_of(const ByBand& bound, const CameraNames& names) {
  WorstBand worst;
  std::size_t bands = 0;
  for (std::size_t i = 0; i < bound.size() && i < names.size(); ++i) {
    for (std::size_t b = 0; b < bound[i].size() && b < names[i].bands.size(); ++b, ++bands) {
      if (!(bound[i][b] > worst.bound)) continue;
      worst = {bound[i][b],
               names.size() > 1 ? names[i].array + "/" + names[i].bands[b] : names[i].bands[b]};
    }
  }
  if (bands == 1) worst.name.clear();
  return worst;
}

std::string effects_table(const PlanSheet& sheet) {
  const bool timed = sheet.prediction.has_value();
  std::vector<TextColumn> columns{
      {"effect"}, {"state", false, 22}, {"bound", true}, {"in", false, 16}};
  if (timed) {
    columns.push_back({"seconds", true});
    columns.push_back({"share", true});
  }
  columns.push_back({"reason"});
  std::vector<std::vector<std::string>> rows;
  for (const EffectSheet& effect : sheet.effects) {
    const WorstBand worst = worst_of(effect.bound, sheet.names);
    std::vector<std::string> row{effect.name, effect.state, percent_text(worst.bound), worst.name};
    if (timed) {
      const double all = sheet.prediction->seconds;
      row.push_back(plan_seconds(effect.seconds));
      row.push_back(all > 0.0 ? fmt::format("{:.0f} %", 100.0 * effect.seconds / all) : "-");
    }
    row.push_back(effect.reason);
    rows.push_back(std::move(row));
  }
  return text_table(columns, rows, page_width);
}

std::vector<std::string> band_row(const PlanSheet& sheet, std::size_t array, std::size_t band) {
  const PlannedBand& planned = sheet.bands[array][band];
  std::vector<std::string> row{band == 0 ? sheet.names[array].array : "",
                               sheet.names[array].bands[band],
                               plan_figure(planned.centre_um),
                               std::to_string(planned.wavelengths),
                               plan_figure(planned.floor_radiance),
                               plan_figure(sheet.relative * planned.floor_radiance),
                               percent_text(planned.dropped),
                               percent_text(planned.bias.total())};
  if (sheet.prediction) {
    const BandForecast& forecast = sheet.prediction->bands[array][band];
    row.push_back(percent_text(forecast.median_error));
    row.push_back(percent_text(forecast.p95_error));
    row.push_back(percent_text(forecast.met));
  }
  return row;
}

std::string bands_table(const PlanSheet& sheet) {
  std::vector<TextColumn> columns{{"array", false, 20}, {"band", false, 20}, {"um", true},
                                  {"lanes", true},      {"floor", true},     {"budget", true},
                                  {"left out", true},   {"bias", true}};
  if (sheet.prediction) {
    for (const char* head : {"error: half", "95 %", "in budget"}) columns.push_back({head, true});
  }
  std::vector<std::vector<std::string>> rows;
  std::string more;
  for (std::size_t i = 0; i < sheet.bands.size(); ++i) {
    const std::size_t bands = sheet.bands[i].size();
    for (std::size_t b = 0; b < std::min(bands, bands_shown); ++b) {
      rows.push_back(band_row(sheet, i, b));
    }
    if (bands > bands_shown) {
      more += fmt::format("{}: {} more bands, which --format json shows\n", sheet.names[i].array,
                          bands - bands_shown);
    }
  }
  return text_table(columns, rows, page_width) + more +
         "floor and budget of a dark pixel: W m^-2 sr^-1 um^-1; others: of max(radiance, floor)\n";
}

/// A line under a head, broken where it is too long.
std::string paragraph(const std::string& head, const std::string& text) {
  std::string lines;
  for (const std::string& line : broken_at_spaces(text, page_width - 12)) {
    lines += fmt::format("{:<12}{}\n", lines.empty() ? head : "", line);
  }
  return lines;
}

std::string prediction_text(const Prediction& p) {
  std::string text = paragraph(
      "predicted",
      fmt::format("{} s: load {}, heat {}, air {}, render {}, products {}; {} of memory; {:.1f} "
                  "paths a pixel, {:.1f} us a path",
                  plan_seconds(p.seconds), plan_seconds(p.load_s), plan_seconds(p.heat_s),
                  plan_seconds(p.air_s), plan_seconds(p.render_s), plan_seconds(p.products_s),
                  memory_text(p.memory_bytes), p.mean_paths, 1e6 * p.seconds_per_path));
  if (std::isfinite(p.reachable)) {
    text +=
        paragraph("reached", fmt::format("a standard error of {} in 95 % of every band's pixels",
                                         percent_text(p.reachable)));
  }
  return text + paragraph("pilot", fmt::format("{} pixels, {} paths, {} s", p.pilot_pixels,
                                               p.pilot_paths, plan_seconds(p.pilot_s)));
}

}  // namespace

std::vector<EffectSheet> effect_sheets(const EffectPlan& plan, const CameraNames& names) {
  std::vector<EffectSheet> sheets;
  for (std::size_t i = 0; i < plan.decisions.size(); ++i) {
    const EffectDecision& decision = plan.decisions[i];
    sheets.push_back({std::string{radiometry::effect_names[i]}, state_of(decision, names),
                      decision.bound, decision.reason, 0.0, 0.0});
  }
  return sheets;
}

std::string plan_text(const PlanSheet& sheet) {
  std::string text = paragraph(
      "scenario", sheet.title.empty() ? sheet.scenario : sheet.scenario + ": " + sheet.title);
  text += paragraph("wanted",
                    sheet.wanted + fmt::format("; effects left out may add up to {}",
                                               percent_text(sheet.effects_share * sheet.relative)));
  text += "\n" + effects_table(sheet) + "\n" + bands_table(sheet) + "\n";
  text += paragraph("solver",
                    sheet.solver + (sheet.solver_reason.empty() ? "" : ": " + sheet.solver_reason));
  text += paragraph("samples", sheet.samples);
  if (sheet.prediction) text += prediction_text(*sheet.prediction);
  return text;
}

}  // namespace nadir::sim
