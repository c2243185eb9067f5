#include "sim/products/line_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nadir::sim {
namespace {

// Pixels.
constexpr double width = 900.0, left = 70.0, right = 190.0, top = 64.0, below = 52.0;
constexpr double panel_height = 250.0, panel_gap = 26.0;
constexpr double plot_width = width - left - right;

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

struct TextStyle {
  const char* anchor = "start";
  int size = 12;
  const char* rest = "";
};

std::string text_at(double x, double y, const std::string& text, const TextStyle& style) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\"{}>{}</text>\n", x, y,
      style.anchor, style.size, style.rest, escaped(text));
}

/// Where values stand in a panel.
struct PanelScale {
  double x_lo, x_hi, y_lo, y_hi;
  double top_px;
  std::vector<double> y_ticks;

  [[nodiscard]] double x(double value) const {
    return left + plot_width * (value - x_lo) / (x_hi - x_lo);
  }
  [[nodiscard]] double y(double value) const {
    return top_px + panel_height * (y_hi - value) / (y_hi - y_lo);
  }
};

std::string polyline(const LinePlot& plot, const PlotSeries& series, const PanelScale& scale) {
  std::string svg, points;
  const auto finish = [&] {
    if (!points.empty()) {
      svg += fmt::format(
          "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{} points=\"{}\"/>\n",
          series.colour, series.dashed ? " stroke-dasharray=\"5 4\"" : "", points);
    }
    points.clear();
  };
  for (std::size_t i = 0; i < plot.x.size() && i < series.y.size(); ++i) {
    if (std::isfinite(series.y[i])) {
      points += fmt::format("{:.1f},{:.1f} ", scale.x(plot.x[i]), scale.y(series.y[i]));
    } else {
      finish();
    }
  }
  finish();
  return svg;
}

PanelScale scale_of(const LinePlot& plot, const PlotPanel& panel, double top_px) {
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  for (const PlotSeries& series : panel.series) {
    for (const double y : series.y) {
      if (!std::isfinite(y)) continue;
      lo = std::min(lo, y);
      hi = std::max(hi, y);
    }
  }
  if (!(lo <= hi)) lo = 0.0, hi = 1.0;
  auto steps = round_steps(lo, hi, 6);
  const double least = steps.front(), most = steps.back();
  return {plot.x.front(), plot.x.back(), least, most, top_px, std::move(steps)};
}

std::string draw_panel(const LinePlot& plot, const PlotPanel& panel, double top_px) {
  const PanelScale scale = scale_of(plot, panel, top_px);
  const double bottom_px = top_px + panel_height;
  std::string svg = fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"white\" stroke=\"#888\"/>\n", left,
      top_px, plot_width, panel_height);
  for (const double y : scale.y_ticks) {
    svg +=
        fmt::format("<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>\n",
                    left, left + plot_width, scale.y(y));
    svg += text_at(left - 6.0, scale.y(y) + 4.0, fmt::format("{:g}", y), {"end"});
  }
  for (const PlotTick& tick : plot.x_ticks) {
    svg +=
        fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#ddd\"/>\n",
                    scale.x(tick.x), top_px, bottom_px);
  }
  double legend_px = top_px + 14.0;
  for (const PlotSeries& series : panel.series) {
    svg += polyline(plot, series, scale);
    svg += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2}\" y2=\"{2}\" stroke=\"{3}\" "
        "stroke-width=\"2\"{4}/>\n",
        left + plot_width + 12.0, left + plot_width + 34.0, legend_px - 4.0, series.colour,
        series.dashed ? " stroke-dasharray=\"5 4\"" : "");
    svg += text_at(left + plot_width + 40.0, legend_px, series.name, {});
    legend_px += 18.0;
  }
  const double middle = top_px + 0.5 * panel_height;
  const std::string turned = fmt::format(" transform=\"rotate(-90 18 {:.1f})\"", middle);
  svg += text_at(18.0, middle, panel.y_label, {"middle", 12, turned.c_str()});
  return svg;
}

}  // namespace

std::vector<double> round_steps(double lo, double hi, int count) {
  if (!(hi > lo)) {
    const double room = std::max(1.0, 0.01 * std::abs(lo));
    lo -= room;
    hi += room;
  }
  const double raw = (hi - lo) / count;
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10.0 * decade;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= factor * decade * (1.0 + 1e-9)) {
      step = factor * decade;
      break;
    }
  }
  std::vector<double> steps;
  const auto first = static_cast<long>(std::floor(lo / step + 1e-9));
  const auto last = static_cast<long>(std::ceil(hi / step - 1e-9));
  for (long i = first; i <= last; ++i) steps.push_back(static_cast<double>(i) * step);
  return steps;
}

std::string to_svg(const LinePlot& plot) {
  const auto panels = static_cast<double>(plot.panels.size());
  const double height = top + panels * panel_height + (panels - 1.0) * panel_gap + below;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
      width, height);
  svg += text_at(left, 26.0, plot.title, {"start", 16});
  svg += text_at(left, 46.0, plot.subtitle, {"start", 12, " fill=\"#555\""});
  double top_px = top;
  for (const PlotPanel& panel : plot.panels) {
    svg += draw_panel(plot, panel, top_px);
    top_px += panel_height + panel_gap;
  }
  const double bottom_px = top_px - panel_gap;
  const double span = plot.x.back() - plot.x.front();
  for (const PlotTick& tick : plot.x_ticks) {
    svg += text_at(left + plot_width * (tick.x - plot.x.front()) / span, bottom_px + 18.0,
                   tick.label, {"middle"});
  }
  svg += text_at(left + 0.5 * plot_width, bottom_px + 40.0, plot.x_label, {"middle"});
  return svg + "</svg>\n";
}

}  // namespace nadir::sim
