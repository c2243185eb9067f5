#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "sim/products/sensor_sheet.hpp"

namespace nadir::sim {
namespace {

using SheetJson = nlohmann::ordered_json;

std::string figure_text(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "-";
}
std::string figure_text(const std::optional<double>& value, int digits) {
  return value ? figure_text(*value, digits) : "-";
}

std::vector<std::string> sheet_row(const BandSheet& band) {
  const sensor::BandFigures& f = band.figures;
  return {f.array,
          f.band,
          figure_text(f.centre_um, 5),
          figure_text(f.fwhm_um, 4),
          figure_text(f.gsd_x_m, 4),
          figure_text(f.gsd_y_m, 4),
          figure_text(f.swath_m / 1000.0, 4),
          figure_text(f.reference_radiance, 4),
          figure_text(f.snr, 4),
          figure_text(f.nedl, 3),
          figure_text(f.nedt_k, 3),
          figure_text(f.saturation, 4),
          figure_text(f.mtf_nyquist_x, 3),
          figure_text(f.mtf_nyquist_y, 3)};
}

SheetJson number_or_null(double value) {
  return std::isfinite(value) ? SheetJson(value) : SheetJson(nullptr);
}
SheetJson number_or_null(const std::optional<double>& value) {
  return value ? number_or_null(*value) : SheetJson(nullptr);
}

SheetJson mtf_json(const sensor::SystemMtf& mtf) {
  SheetJson terms = SheetJson::object();
  for (const sensor::MtfTerm& term : mtf.terms) terms[term.name] = term.values;
  return {{"cycles_per_pixel", mtf.cycles_per_pixel}, {"terms", terms}, {"total", mtf.total}};
}

SheetJson band_json(const BandSheet& band) {
  const sensor::BandFigures& f = band.figures;
  SheetJson json;
  json["array"] = f.array;
  json["band"] = f.band;
  json["centre_um"] = number_or_null(f.centre_um);
  json["fwhm_um"] = number_or_null(f.fwhm_um);
  json["gsd_x_m"] = number_or_null(f.gsd_x_m);
  json["gsd_y_m"] = number_or_null(f.gsd_y_m);
  json["swath_m"] = number_or_null(f.swath_m);
  json["exposure_s"] = number_or_null(band.exposure_s);
  json["motion_x_px_s"] = number_or_null(band.motion.x_px_s);
  json["motion_y_px_s"] = number_or_null(band.motion.y_px_s);
  json["reference_radiance_w_m2_sr_um"] = number_or_null(f.reference_radiance);
  json["snr"] = number_or_null(f.snr);
  json["nedl_w_m2_sr_um"] = number_or_null(f.nedl);
  json["nedt_300k_k"] = number_or_null(f.nedt_k);
  json["saturation_w_m2_sr_um"] = number_or_null(f.saturation);
  json["mtf_nyquist_x"] = number_or_null(f.mtf_nyquist_x);
  json["mtf_nyquist_y"] = number_or_null(f.mtf_nyquist_y);
  json["mtf_x"] = mtf_json(band.mtf_x);
  json["mtf_y"] = mtf_json(band.mtf_y);
  return json;
}

const char* sheet_colour(std::size_t i) {
  constexpr std::array<const char*, 8> colours = {"#c0392b", "#2980b9", "#27ae60", "#8e44ad",
                                                  "#e67e22", "#16a085", "#7f8c8d", "#000000"};
  return colours[i % colours.size()];
}

std::string full_name(const BandSheet& band) {
  return band.figures.array + "/" + band.figures.band;
}

const BandSheet& band_named(const SensorSheet& sheet, const std::string& name) {
  std::vector<std::string> names;
  for (const BandSheet& band : sheet.bands) {
    if (name.empty() || band.figures.band == name || full_name(band) == name) return band;
    names.push_back(full_name(band));
  }
  if (sheet.bands.empty()) throw InputError{"the sensor has no bands"};
  throw InputError{
      InputIssue{{}, "no band \"" + name + "\" in the sensor", nearest_name(name, names), {}}};
}

PlotPanel mtf_panel(const SensorSheet& sheet, const BandSheet& detailed, const char* label,
                    sensor::SystemMtf BandSheet::*direction) {
  PlotPanel panel{label, {}};
  for (std::size_t i = 0; i < sheet.bands.size(); ++i) {
    const BandSheet& band = sheet.bands[i];
    panel.series.push_back({full_name(band), sheet_colour(i), (band.*direction).total, false});
  }
  const auto& terms = (detailed.*direction).terms;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    panel.series.push_back({terms[i].name, sheet_colour(i + 4), terms[i].values, true});
  }
  return panel;
}

}  // namespace

std::string sheet_text(const SensorSheet& sheet) {
  std::vector<std::vector<std::string>> rows = {
      {"array", "band", "centre", "width", "GSD x", "GSD y", "swath", "L ref", "SNR", "NEdL",
       "NEdT", "L max", "MTF x", "MTF y"},
      {"", "", "um", "um", "m", "m", "km", "W/", "at", "W/", "at", "W/", "at Ny-", "at Ny-"},
      {"", "", "", "", "", "", "", "m2 sr um", "L ref", "m2 sr um", "300 K, K", "m2 sr um", "quist",
       "quist"}};
  for (const BandSheet& band : sheet.bands) rows.push_back(sheet_row(band));
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  const std::string& name = sheet.title.empty() ? sheet.instrument : sheet.title;
  if (!name.empty()) text += name + "\n";
  if (!sheet.source.empty()) text += sheet.source + "\n";
  text += fmt::format("{} m over the ground, which passes at {} m/s\n",
                      figure_text(sheet.height_m, 7), figure_text(sheet.ground_speed_m_s, 5));
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += i < 2 ? fmt::format("{:<{}}  ", row[i], widths[i])
                    : fmt::format("{:>{}}  ", row[i], widths[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string sheet_json(const SensorSheet& sheet) {
  SheetJson json;
  json["instrument"] = sheet.instrument;
  json["platform"] = sheet.platform;
  json["title"] = sheet.title;
  json["source"] = sheet.source;
  json["height_m"] = number_or_null(sheet.height_m);
  json["ground_speed_m_s"] = number_or_null(sheet.ground_speed_m_s);
  json["bands"] = SheetJson::array();
  for (const BandSheet& band : sheet.bands) json["bands"].push_back(band_json(band));
  return json.dump(2, ' ', false, SheetJson::error_handler_t::replace) + "\n";
}

LinePlot mtf_plot(const SensorSheet& sheet, const std::string& band) {
  const BandSheet& detailed = band_named(sheet, band);
  LinePlot plot;
  plot.title = "Modulation transfer";
  const std::string& name = sheet.title.empty() ? sheet.instrument : sheet.title;
  if (!name.empty()) plot.title += ": " + name;
  plot.subtitle = "dashed: the terms of " + full_name(detailed);
  plot.x_label = "cycles per pixel (Nyquist: 0.5)";
  plot.x = detailed.mtf_x.cycles_per_pixel;
  for (int i = 0; i <= 10; ++i) plot.x_ticks.push_back({0.1 * i, fmt::format("{:.1f}", 0.1 * i)});
  plot.panels.push_back(mtf_panel(sheet, detailed, "across, x", &BandSheet::mtf_x));
  plot.panels.push_back(mtf_panel(sheet, detailed, "along, y", &BandSheet::mtf_y));
  return plot;
}

}  // namespace nadir::sim
