#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "sim/files/png.hpp"

namespace nadir::sim {

using Rgb = std::array<std::uint8_t, 3>;  ///< red, green, blue, sRGB

struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;  ///< pixels; y counts downwards
};

/// An 8-bit picture to paint on. What falls outside its edges is left out.
class Canvas {
 public:
  Canvas(int width, int height, Rgb background);

  [[nodiscard]] int width() const noexcept { return picture_.width; }
  [[nodiscard]] int height() const noexcept { return picture_.height; }
  void set(int x, int y, Rgb colour);
  void fill(Rectangle area, Rgb colour);
  /// Text (UTF-8) with its top left corner at (x, y), each dot of the font `scale` pixels wide.
  void text(int x, int y, const std::string& text, Rgb colour, int scale);

  /// The picture; the canvas is empty afterwards.
  [[nodiscard]] PngImage take() { return std::move(picture_); }

 private:
  PngImage picture_;
};

/// Pixels from the first to the last dot of a line of text.
[[nodiscard]] int text_width(const std::string& text, int scale);
/// Pixels from the top of the capitals to the bottom of the descenders.
[[nodiscard]] constexpr int text_height(int scale) { return 8 * scale; }

}  // namespace nadir::sim
