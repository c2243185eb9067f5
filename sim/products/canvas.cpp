#include "sim/products/canvas.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "sim/products/font_table.hpp"

namespace nadir::sim {
namespace {

/// The code point that starts at `at`, which moves behind it; U+FFFD where the bytes are no UTF-8.
char32_t next_code_point(std::string_view text, std::size_t& at) {
  constexpr char32_t invalid = U'\uFFFD';
  const auto lead = static_cast<unsigned char>(text[at++]);
  if (lead < 0x80) return lead;
  const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
  if (more == 0) return invalid;
  char32_t code = static_cast<char32_t>(lead & (0x3F >> more));
  for (int i = 0; i < more; ++i, ++at) {
    if (at >= text.size() || (static_cast<unsigned char>(text[at]) & 0xC0) != 0x80) return invalid;
    code = (code << 6) | (static_cast<unsigned char>(text[at]) & 0x3F);
  }
  return code;
}

std::string_view rows_of(char32_t code) {
  const auto found = std::find_if(font_table.begin(), font_table.end(),
                                  [&](const Glyph& glyph) { return glyph.code == code; });
  return found == font_table.end() ? font_table.back().rows : found->rows;
}

int width_of(std::string_view rows) { return static_cast<int>(rows.find(' ')); }

}  // namespace

Canvas::Canvas(int width, int height, Rgb background) {
  picture_.width = width;
  picture_.height = height;
  picture_.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  fill({0, 0, width, height}, background);
}

void Canvas::set(int x, int y, Rgb colour) {
  if (x < 0 || y < 0 || x >= width() || y >= height()) return;
  const auto pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) + static_cast<std::size_t>(x);
  std::copy(colour.begin(), colour.end(),
            picture_.values.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
}

void Canvas::fill(Rectangle area, Rgb colour) {
  for (int y = area.y; y < area.y + area.height; ++y) {
    for (int x = area.x; x < area.x + area.width; ++x) set(x, y, colour);
  }
}

void Canvas::text(int x, int y, const std::string& text, Rgb colour, int scale) {
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rows = rows_of(next_code_point(text, at));
    const int width = width_of(rows);
    for (int dot = 0; dot < static_cast<int>(rows.size()); ++dot) {
      if (rows[static_cast<std::size_t>(dot)] != '#') continue;
      const int column = dot % (width + 1), row = dot / (width + 1);
      fill({x + column * scale, y + row * scale, scale, scale}, colour);
    }
    x += (width + 1) * scale;
  }
}

int text_width(const std::string& text, int scale) {
  int dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    dots += width_of(rows_of(next_code_point(text, at))) + 1;
  }
  return std::max(dots - 1, 0) * scale;
}

}  // namespace nadir::sim
