#pragma once

#include <string>
#include <vector>

#include "sim/products/canvas.hpp"
#include "sim/products/temperature_map.hpp"

namespace nadir::sim {

/// The colours of the strip below a quick look.
inline constexpr Rgb caption_background{20, 21, 24};
inline constexpr Rgb caption_bright{236, 236, 232};
inline constexpr Rgb caption_dim{164, 166, 170};

/// Font scale that suits a picture of this width.
[[nodiscard]] constexpr int caption_scale(int width) { return 1 + (width + 340) / 800; }

/// Text cut into lines no wider than `width`, at spaces where there are any.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, int width, int scale);

/// A colour bar with kelvin ticks above and degrees Celsius below it. `area` gives its left, top
/// and width; its height is `colour_bar_height`.
void draw_colour_bar(Canvas& canvas, Rectangle area, TemperatureRange range, int scale);
[[nodiscard]] constexpr int colour_bar_height(int scale) { return 38 * scale; }

}  // namespace nadir::sim
