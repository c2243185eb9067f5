#include "sim/products/heat_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace nadir::sim {
namespace {

using thermal::HeatRecord;

constexpr double hour_s = 3600.0, day_s = 24.0 * hour_s;

/// A column of the record, for the text, the CSV and the plot alike.
struct HeatColumn {
  const char* csv;
  const char* short_name;
  const char* name;    ///< in the plot's legend
  const char* colour;  ///< null: not plotted
  double (*value)(const HeatRecord::Row&);
};

double celsius(double kelvin) { return kelvin - si::zero_celsius; }

constexpr HeatColumn temperatures[] = {
    {"surface_c", "surface", "surface", "#c0392b",
     [](const HeatRecord::Row& r) { return celsius(r.surface_k); }},
    {"back_c", "back", "back", "#8e5a2b",
     [](const HeatRecord::Row& r) { return celsius(r.back_k); }},
    {"air_c", "air", "air", "#2980b9",
     [](const HeatRecord::Row& r) { return celsius(r.weather.air_temperature_k); }},
};
constexpr HeatColumn fluxes[] = {
    {"sun_absorbed_w_m2", "sun", "sun", "#e67e22",
     [](const HeatRecord::Row& r) { return r.terms.direct; }},
    {"sky_light_absorbed_w_m2", "sky", "sky light", "#f1c40f",
     [](const HeatRecord::Row& r) { return r.terms.diffuse; }},
    {"reflected_light_absorbed_w_m2", "refl.", "reflected light", "#9acd32",
     [](const HeatRecord::Row& r) { return r.terms.reflected; }},
    {"sky_long_wave_absorbed_w_m2", "LW sky", "long-wave, sky", "#2980b9",
     [](const HeatRecord::Row& r) { return r.terms.sky_long_wave; }},
    {"surroundings_long_wave_absorbed_w_m2", "LW surr", "long-wave, surroundings", "#16a085",
     [](const HeatRecord::Row& r) { return r.terms.surroundings_long_wave; }},
    {"emitted_w_m2", "emitted", "emitted", "#c0392b",
     [](const HeatRecord::Row& r) { return r.terms.emitted; }},
    {"convected_w_m2", "conv.", "convection", "#7f8c8d",
     [](const HeatRecord::Row& r) { return r.terms.convected; }},
    {"evaporated_w_m2", "evap.", "evaporation", "#8e44ad",
     [](const HeatRecord::Row& r) { return r.terms.evaporated; }},
    {"conducted_w_m2", "into", "into the layers", "#000000",
     [](const HeatRecord::Row& r) { return r.conducted; }},
};
constexpr HeatColumn surroundings[] = {
    {"sun_cosine", "", "", nullptr, [](const HeatRecord::Row& r) { return r.sun_cosine; }},
    {"wind_m_s", "", "", nullptr,
     [](const HeatRecord::Row& r) { return r.weather.wind_speed_m_s; }},
    {"direct_normal_w_m2", "", "", nullptr,
     [](const HeatRecord::Row& r) { return r.weather.direct_normal_w_m2; }},
    {"diffuse_horizontal_w_m2", "", "", nullptr,
     [](const HeatRecord::Row& r) { return r.weather.diffuse_horizontal_w_m2; }},
    {"sky_long_wave_w_m2", "", "", nullptr,
     [](const HeatRecord::Row& r) { return r.weather.sky_long_wave_w_m2; }},
};

std::string utc_of(const TemperatureAt& at, double time_s) {
  return (at.time + Seconds{std::round(time_s)}).to_string();
}

std::string describe(const TemperatureAt& at) {
  std::string text = fmt::format(
      "place       east {:.2f} m, north {:.2f} m, up {:.2f} m; normal ({:.2f}, {:.2f}, {:.2f})\n"
      "surface     {} of {}\n"
      "time        {}\n"
      "temperature {:.2f} K ({:.2f} C)\n",
      at.place.x, at.place.y, at.place.z, at.normal.x, at.normal.y, at.normal.z, at.material,
      at.object, at.time.to_string(), at.temperature.value, celsius(at.temperature.value));
  if (!at.heat || !at.record) return text + "stated, not solved: there is no curve\n";
  const auto& surface = at.heat->surface;
  text += fmt::format(
      "absorptance {:.3f} of sunlight, emissivity {:.3f}, wetness {:.2f}; sees {:.1f} % sky\n",
      surface.solar_absorptance, surface.emissivity, surface.wetness,
      100.0 * at.record->sky_fraction);
  for (const thermal::Layer& layer : at.heat->layers.layers) {
    text += fmt::format("layer       {:.4g} m, {:.4g} W/m/K, {:.4g} kg/m3, {:.4g} J/kg/K\n",
                        layer.thickness_m, layer.substance.conductivity_w_m_k,
                        layer.substance.density_kg_m3, layer.substance.specific_heat_j_kg_k);
  }
  return text + fmt::format("spin-up     {:.0f} days; heat stored {:.4g}, received {:.4g} J/m2\n",
                            at.record->spin_up_days, at.record->stored_j_m2,
                            at.record->received_j_m2);
}

std::string row_text(const TemperatureAt& at, const HeatRecord::Row& row) {
  std::string text = fmt::format("{:<17}", utc_of(at, row.time_s).substr(0, 16) + "Z");
  for (const HeatColumn& column : temperatures) {
    text += fmt::format("{:>8.2f}", column.value(row));
  }
  for (const HeatColumn& column : fluxes) text += fmt::format("{:>8.1f}", column.value(row));
  return text + "\n";
}

}  // namespace

std::string heat_text(const TemperatureAt& at) {
  std::string text = describe(at);
  if (!at.record) return text;
  text += fmt::format("\n{:<17}", "UTC");
  for (const HeatColumn& column : temperatures) text += fmt::format("{:>8}", column.short_name);
  for (const HeatColumn& column : fluxes) text += fmt::format("{:>8}", column.short_name);
  text +=
      fmt::format("\n{:<17}{:>8}{:>8}{:>8}{:>40}\n", "", "C", "C", "C", "W/m2, into the surface");
  double next_s = -day_s;
  for (const HeatRecord::Row& row : at.record->rows) {
    if (row.time_s < next_s - 1.0) continue;
    text += row_text(at, row);
    next_s = row.time_s + hour_s;
  }
  const auto& rows = at.record->rows;
  const auto [least, most] = std::minmax_element(
      rows.begin(), rows.end(),
      [](const HeatRecord::Row& a, const HeatRecord::Row& b) { return a.surface_k < b.surface_k; });
  return text + fmt::format("coldest {:.2f} C at {}, warmest {:.2f} C at {}\n",
                            celsius(least->surface_k), utc_of(at, least->time_s),
                            celsius(most->surface_k), utc_of(at, most->time_s));
}

std::string heat_csv(const TemperatureAt& at) {
  std::string text = "utc";
  const auto heads = [&](const auto& columns) {
    for (const HeatColumn& column : columns) text += fmt::format(",{}", column.csv);
  };
  heads(temperatures);
  heads(fluxes);
  heads(surroundings);
  text += "\n";
  if (!at.record) return text;
  for (const HeatRecord::Row& row : at.record->rows) {
    text += utc_of(at, row.time_s);
    const auto cells = [&](const auto& columns) {
      for (const HeatColumn& column : columns) text += fmt::format(",{:.6g}", column.value(row));
    };
    cells(temperatures);
    cells(fluxes);
    cells(surroundings);
    text += "\n";
  }
  return text;
}

LinePlot heat_plot(const TemperatureAt& at) {
  LinePlot plot;
  plot.title = fmt::format("{} of {}", at.material, at.object);
  plot.subtitle = fmt::format("{}; east {:.1f} m, north {:.1f} m, up {:.1f} m", at.title,
                              at.place.x, at.place.y, at.place.z);
  plot.x_label = "UTC";
  plot.panels = {{"temperature, C", {}}, {"heat into the surface, W/m2", {}}};
  if (!at.record) return plot;
  const auto& rows = at.record->rows;
  for (const HeatRecord::Row& row : rows) plot.x.push_back(row.time_s / hour_s);
  const auto add = [&](PlotPanel& panel, const HeatColumn& column, bool dashed) {
    PlotSeries series{column.name, column.colour, {}, dashed};
    for (const HeatRecord::Row& row : rows) series.y.push_back(column.value(row));
    panel.series.push_back(std::move(series));
  };
  for (const HeatColumn& column : temperatures) add(plot.panels[0], column, column.csv[0] != 's');
  for (const HeatColumn& column : fluxes) add(plot.panels[1], column, false);
  // Whole hours of UTC, few enough that their labels do not touch.
  const double span_h = plot.x.back() - plot.x.front();
  const double every_h = std::max(3.0, 3.0 * std::ceil(span_h / 36.0));
  const double picture_h = static_cast<double>(std::stoi(at.time.to_string().substr(11, 2))) +
                           static_cast<double>(std::stoi(at.time.to_string().substr(14, 2))) / 60.0;
  for (double hour = std::ceil((picture_h + plot.x.front()) / every_h) * every_h;
       hour <= picture_h + plot.x.back() + 1e-9; hour += every_h) {
    const double of_day = hour - 24.0 * std::floor(hour / 24.0);
    plot.x_ticks.push_back({hour - picture_h, fmt::format("{:02.0f}:00", of_day)});
  }
  return plot;
}

}  // namespace nadir::sim
