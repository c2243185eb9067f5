#pragma once

#include <string>
#include <vector>

namespace nadir::sim {

/// How a series is drawn.
struct PlotStyle {
  std::string colour = "#555";
  bool line = false;  ///< joins its points
  bool dashed = false;
  double radius = 3.0;  ///< of the points' marks; 0: none
  bool hollow = false;
  bool ringed = false;  ///< a second ring around each mark
};

struct LogPoint {
  double x = 0.0, y = 0.0;
  double uncertainty = 0.0;  ///< of y: an error bar; 0: none
  std::string hint;          ///< shown where the pointer rests on the mark
};

struct LogSeries {
  std::string name;  ///< in the legend; empty: not there
  PlotStyle style;
  std::vector<LogPoint> points;  ///< those with x or y not above 0 are left out
};

/// A picture with logarithmic axes.
struct LogPlot {
  std::string title;
  std::string x_label, y_label;
  std::vector<LogSeries> series;
};

/// As one inline <svg> element, which scales with the page and needs nothing else. Without any
/// point it says so.
[[nodiscard]] std::string to_svg(const LogPlot& plot);

/// Text for HTML and SVG.
[[nodiscard]] std::string escape_markup(const std::string& text);

}  // namespace nadir::sim
