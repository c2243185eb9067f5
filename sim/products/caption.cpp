#include "sim/products/caption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "core/constants.hpp"
#include "sim/products/colour_map.hpp"

namespace nadir::sim {
namespace {

struct Axis {
  double lo = 0.0, hi = 0.0;
  const char* unit = "";
  int label_y = 0, tick_y = 0;
};

/// Digits after the point that tell neighbouring ticks apart.
int decimals(const std::vector<double>& ticks) {
  if (ticks.size() < 2) return 1;
  return std::max(0, static_cast<int>(std::ceil(-std::log10(ticks[1] - ticks[0]) - 1e-9)));
}

/// The unit stands once, at the right end, and ticks whose labels would touch it go without.
void draw_axis(Canvas& canvas, Rectangle area, const Axis& axis, int scale) {
  const int unit_x = area.x + area.width - text_width(axis.unit, scale);
  canvas.text(unit_x, axis.label_y, axis.unit, caption_bright, scale);
  const auto ticks = round_ticks(axis.lo, axis.hi, std::max(2, area.width / (52 * scale)));
  for (const double tick : ticks) {
    const double place = (tick - axis.lo) / (axis.hi - axis.lo) * (area.width - 1);
    const int x = area.x + static_cast<int>(std::lround(place));
    canvas.fill({std::min(x, area.x + area.width - scale), axis.tick_y, scale, 3 * scale},
                caption_dim);
    const std::string label = fmt::format("{:.{}f}", tick, decimals(ticks));
    const int width = text_width(label, scale);
    const int left = std::max(area.x, x - width / 2);
    if (left + width + 4 * scale > unit_x) continue;
    canvas.text(left, axis.label_y, label, caption_dim, scale);
  }
}

}  // namespace

std::vector<std::string> wrapped(const std::string& text, int width, int scale) {
  std::vector<std::string> lines;
  std::istringstream words{text};
  std::string line;
  for (std::string word; words >> word;) {
    const std::string longer = line.empty() ? word : fmt::format("{} {}", line, word);
    if (!line.empty() && text_width(longer, scale) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

void draw_colour_bar(Canvas& canvas, Rectangle area, TemperatureRange range, int scale) {
  const int bar_y = area.y + 13 * scale, bar_height = 10 * scale;
  for (int x = 0; x < area.width; ++x) {
    const double fraction = (x + 0.5) / area.width;
    canvas.fill({area.x + x, bar_y, 1, bar_height}, inferno(fraction));
  }
  draw_axis(canvas, area, {range.lo_k, range.hi_k, "K", area.y, bar_y - 4 * scale}, scale);
  draw_axis(canvas, area,
            {range.lo_k - si::zero_celsius, range.hi_k - si::zero_celsius, "\u00B0C",
             bar_y + bar_height + 6 * scale, bar_y + bar_height + scale},
            scale);
}

}  // namespace nadir::sim
