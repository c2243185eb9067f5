#pragma once

#include <string>
#include <vector>

namespace nadir::sim {

/// One curve of a panel.
struct PlotSeries {
  std::string name;       ///< in the legend
  std::string colour;     ///< any that SVG knows
  std::vector<double> y;  ///< one for each of the plot's x; gaps where not finite
  bool dashed = false;
};

/// Curves over the same x, with an axis of their own.
struct PlotPanel {
  std::string y_label;
  std::vector<PlotSeries> series;
};

struct PlotTick {
  double x = 0.0;
  std::string label;
};

/// A picture of curves, panels below each other, all over the same x.
struct LinePlot {
  std::string title, subtitle;
  std::string x_label;
  std::vector<double> x;  ///< ascending, at least two
  std::vector<PlotTick> x_ticks;
  std::vector<PlotPanel> panels;
};

/// The plot as one SVG file that needs nothing else.
[[nodiscard]] std::string to_svg(const LinePlot& plot);

/// Round numbers that cut [lo, hi] into about `count` steps: ascending, the outermost at or beyond
/// lo and hi.
[[nodiscard]] std::vector<double> round_steps(double lo, double hi, int count);

}  // namespace nadir::sim
