#include "sim/study/log_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nadir::sim {
namespace {

// Units of the drawing: pixels where the page is that wide.
constexpr double log_plot_width = 960.0, log_plot_height = 430.0;
constexpr double left_px = 78.0, right_px = 290.0, top_px = 34.0, bottom_px = 54.0;
constexpr double inner_width = log_plot_width - left_px - right_px;
constexpr double inner_height = log_plot_height - top_px - bottom_px;

/// Decades that an axis shows.
struct LogAxis {
  double lo = 0.0, hi = 1.0;  ///< log10

  void include(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) return;
    any_ = true;
    least_ = std::min(least_, std::log10(value));
    most_ = std::max(most_, std::log10(value));
  }
  /// Ends a little beyond the values, at half a decade's width at least.
  void close() {
    if (!any_) least_ = 0.0, most_ = 1.0;
    const double room = std::max(0.06 * (most_ - least_), 0.08);
    lo = least_ - room;
    hi = most_ + room;
  }
  [[nodiscard]] bool any() const noexcept { return any_; }
  [[nodiscard]] double share(double value) const { return (std::log10(value) - lo) / (hi - lo); }

 private:
  double least_ = std::numeric_limits<double>::infinity(), most_ = -least_;
  bool any_ = false;
};

struct LogScale {
  LogAxis x, y;
  [[nodiscard]] double px(double value) const { return left_px + inner_width * x.share(value); }
  [[nodiscard]] double py(double value) const {
    return top_px + inner_height * (1.0 - y.share(value));
  }
};

bool drawable(const LogPoint& p) {
  return p.x > 0.0 && p.y > 0.0 && std::isfinite(p.x) && std::isfinite(p.y);
}

LogScale scale_for(const LogPlot& plot) {
  LogScale scale;
  for (const LogSeries& series : plot.series) {
    for (const LogPoint& point : series.points) {
      if (!drawable(point)) continue;
      scale.x.include(point.x);
      scale.y.include(point.y);
    }
  }
  scale.x.close();
  scale.y.close();
  return scale;
}

struct LogTick {
  double value;
  bool labelled;
};

/// Ticks at 1, 2, 5 of each decade; labelled all of them on short axes, else the decades.
std::vector<LogTick> ticks_of(const LogAxis& axis) {
  const bool is_short = axis.hi - axis.lo < 2.2;
  std::vector<LogTick> ticks;
  for (int decade = static_cast<int>(std::floor(axis.lo)); decade <= std::ceil(axis.hi); ++decade) {
    for (const double digit : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0}) {
      const double value = digit * std::pow(10.0, decade), at = std::log10(value);
      if (at < axis.lo || at > axis.hi) continue;
      ticks.push_back({value, digit == 1.0 || (is_short && (digit == 2.0 || digit == 5.0))});
    }
  }
  return ticks;
}

/// 0.001 as "0.001", a million as "1e6".
std::string tick_text(double value) {
  const std::string plain = fmt::format("{:.6g}", value);
  if (value >= 1e5 || value < 1e-4) {
    const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
    return fmt::format("{:.0f}e{}", value / std::pow(10.0, power), power);
  }
  return plain;
}

std::string grid(const LogPlot& plot, const LogScale& scale) {
  std::string svg;
  const double bottom = top_px + inner_height;
  for (const LogTick& tick : ticks_of(scale.x)) {
    const double x = scale.px(tick.value);
    svg += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{}\" y2=\"{}\"/>\n",
                       tick.labelled ? "g" : "h", x, x, top_px, bottom);
    if (tick.labelled) {
      svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x,
                         bottom + 17.0, tick_text(tick.value));
    }
  }
  for (const LogTick& tick : ticks_of(scale.y)) {
    const double y = scale.py(tick.value);
    svg += fmt::format("<line class=\"{}\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>\n",
                       tick.labelled ? "g" : "h", left_px, left_px + inner_width, y, y);
    if (tick.labelled) {
      svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
                         left_px - 7.0, y + 4.0, tick_text(tick.value));
    }
  }
  const double middle = top_px + 0.5 * inner_height;
  svg += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#444\"/>\n"
      "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" class=\"l\">{}</text>\n"
      "<text x=\"20\" y=\"{}\" text-anchor=\"middle\" class=\"l\" "
      "transform=\"rotate(-90 20 {})\">{}</text>\n",
      left_px, top_px, inner_width, inner_height, left_px + 0.5 * inner_width,
      log_plot_height - 12.0, escape_markup(plot.x_label), middle, middle,
      escape_markup(plot.y_label));
  return svg;
}

std::string mark(const LogPoint& point, const PlotStyle& style, const LogScale& scale) {
  const double x = scale.px(point.x), y = scale.py(point.y);
  std::string svg;
  if (point.uncertainty > 0.0) {
    const double high = scale.py(point.y + point.uncertainty);
    const double least = std::pow(10.0, scale.y.lo);
    const double low = scale.py(std::max(point.y - point.uncertainty, least));
    svg += fmt::format(
        "<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x, x,
        std::max(high, top_px), low, style.colour);
  }
  const std::string hint =
      point.hint.empty() ? "" : "<title>" + escape_markup(point.hint) + "</title>";
  svg += fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" stroke=\"{}\">{}</circle>\n", x, y,
      style.radius, style.hollow ? "white" : style.colour, style.colour, hint);
  if (style.ringed) {
    svg += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"none\" stroke=\"{}\" "
        "stroke-width=\"1.6\"/>\n",
        x, y, style.radius + 3.0, style.colour);
  }
  return svg;
}

std::string draw(const LogSeries& series, const LogScale& scale) {
  std::string svg, line;
  for (const LogPoint& point : series.points) {
    if (!drawable(point)) continue;
    line += fmt::format("{:.1f},{:.1f} ", scale.px(point.x), scale.py(point.y));
  }
  if (series.style.line && !line.empty()) {
    svg += fmt::format(
        "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.7\"{} "
        "points=\"{}\"/>\n",
        series.style.colour, series.style.dashed ? " stroke-dasharray=\"6 4\"" : "", line);
  }
  if (series.style.radius <= 0.0) return svg;
  for (const LogPoint& point : series.points) {
    if (drawable(point)) svg += mark(point, series.style, scale);
  }
  return svg;
}

std::string legend_line(const LogSeries& series, double y) {
  const double x = left_px + inner_width + 14.0;
  std::string svg;
  if (series.style.line) {
    svg += fmt::format(
        "<line x1=\"{}\" x2=\"{}\" y1=\"{}\" y2=\"{}\" stroke=\"{}\" "
        "stroke-width=\"1.7\"{}/>\n",
        x, x + 24.0, y, y, series.style.colour,
        series.style.dashed ? " stroke-dasharray=\"6 4\"" : "");
  }
  if (series.style.radius > 0.0) {
    svg += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n",
                       x + 12.0, y, series.style.radius,
                       series.style.hollow ? "white" : series.style.colour, series.style.colour);
  }
  if (series.style.ringed) {
    svg += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"none\" stroke=\"{}\"/>\n",
                       x + 12.0, y, series.style.radius + 3.0, series.style.colour);
  }
  return svg + fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", x + 31.0, y + 4.0,
                           escape_markup(series.name));
}

}  // namespace

std::string escape_markup(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string to_svg(const LogPlot& plot) {
  const LogScale scale = scale_for(plot);
  std::string svg =
      fmt::format("<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n",
                  log_plot_width, log_plot_height, escape_markup(plot.title));
  svg += fmt::format("<text x=\"{}\" y=\"20\" class=\"t\">{}</text>\n", left_px,
                     escape_markup(plot.title));
  if (!scale.x.any()) {
    return svg + fmt::format("<text x=\"{}\" y=\"{}\">nothing was measured</text>\n</svg>\n",
                             left_px, top_px + 20.0);
  }
  svg += grid(plot, scale);
  double legend = top_px + 8.0;
  for (const LogSeries& series : plot.series) {
    svg += draw(series, scale);
    if (series.name.empty()) continue;
    svg += legend_line(series, legend);
    legend += 18.0;
  }
  return svg + "</svg>\n";
}

}  // namespace nadir::sim
