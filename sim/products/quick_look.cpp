#include "sim/products/quick_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "core/constants.hpp"
#include "sim/products/band_choice.hpp"
#include "sim/products/caption.hpp"
#include "sim/products/colour_map.hpp"
#include "sim/products/preview.hpp"
#include "sim/products/temperature_map.hpp"
#include "sim/products/tone_map.hpp"

namespace nadir::sim {
namespace {

constexpr int least_width = 320;   // below this a picture is magnified
constexpr int wanted_width = 480;  // up to about this
constexpr int most_lines = 1600;   // but no taller than this

/// What stands below the picture.
struct Caption {
  std::string heading, shown, extremes, invalid;
  std::optional<TemperatureRange> colour_bar;
};

std::string band_text(const BandImage& band) {
  return fmt::format("{} {:.3g} \u00B5m", band.name, band.centre_um);
}

std::string with_dots(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) {
    if (!part.empty()) text += (text.empty() ? "" : " \u00B7 ") + part;
  }
  return text;
}

/// The same in ASCII, for the PNG's text, which knows no superscripts.
std::string in_ascii(std::string text) {
  constexpr std::pair<std::string_view, std::string_view> signs[] = {
      {"\u00B5", "u"}, {" \u00B7 ", ", "}, {"\u00B0", "deg "},
      {"\u207B", "-"}, {"\u00B9", "1"},    {"\u00B2", "2"}};
  for (const auto& [sign, plain] : signs) {
    for (auto at = text.find(sign); at != std::string::npos; at = text.find(sign, at)) {
      text.replace(at, sign.size(), plain);
      at += plain.size();
    }
  }
  return text;
}

std::string invalid_text(std::size_t count) {
  return count == 0 ? std::string{} : fmt::format("{} invalid pixels in magenta", count);
}

std::string kelvin_text(double kelvin) {
  return fmt::format("{:.1f} K ({:.1f} \u00B0C)", kelvin, kelvin - si::zero_celsius);
}

Caption temperature_caption(const ArrayImage& image, const ShownFacts& facts,
                            TemperatureRange range) {
  const Extremes& extremes = facts.extremes[0];
  Caption caption;
  caption.shown = "brightness temperature, band " + band_text(image.bands[facts.choice.bands[0]]);
  caption.colour_bar = range;
  caption.extremes =
      with_dots({extremes.any ? "min " + kelvin_text(extremes.least) : "no valid pixel",
                 extremes.any ? "max " + kelvin_text(extremes.greatest) : ""});
  return caption;
}

Caption radiance_caption(const ArrayImage& image, const ShownFacts& facts) {
  const BandChoice& choice = facts.choice;
  Caption caption;
  Extremes extremes;
  std::vector<std::string> names;
  for (const std::size_t band : choice.bands) names.push_back(band_text(image.bands[band]));
  for (const Extremes& band : facts.extremes) extremes.add(band);
  const char* kind = choice.look == Look::natural_colour ? "natural colour"
                     : choice.look == Look::false_colour ? "false colour"
                                                         : "grey";
  caption.shown = fmt::format("{}: {}", kind, with_dots(names));
  const std::string range = extremes.any
                                ? fmt::format(
                                      "radiance {:.4g} to {:.4g} W m\u207B\u00B2 sr\u207B\u00B9 "
                                      "\u00B5m\u207B\u00B9",
                                      extremes.least, extremes.greatest)
                                : std::string{"no valid pixel"};
  caption.extremes = range;
  return caption;
}

std::string step_text(int step) {
  return step == 1 ? std::string{} : fmt::format("1 of {0} x {0} pixels shown", step);
}

int magnification(const ArrayImage& image) {
  if (image.samples >= least_width) return 1;
  const int by_width = (wanted_width + image.samples - 1) / image.samples;
  return std::max(1, std::min(by_width, most_lines / image.lines));
}

void draw_picture(Canvas& canvas, const Picture& picture, const ArrayImage& image, int factor) {
  const int left = (canvas.width() - image.samples * factor) / 2;
  std::size_t pixel = 0;
  for (int line = 0; line < image.lines; ++line) {
    for (int sample = 0; sample < image.samples; ++sample) {
      canvas.fill({left + sample * factor, line * factor, factor, factor}, picture.pixels[pixel++]);
    }
  }
}

struct Line {
  std::string text;
  Rgb colour;
};

void add_lines(std::vector<Line>& lines, const std::string& text, int width, int scale,
               Rgb colour) {
  for (const std::string& line : wrapped(text, width, scale)) lines.push_back({line, colour});
}

PngImage compose(const ArrayImage& image, const Picture& picture, const Caption& caption) {
  const int factor = magnification(image);
  const int width = std::max(least_width, image.samples * factor);
  const int scale = caption_scale(width), margin = 6 * scale;
  const int inner = width - 2 * margin, pitch = text_height(scale) + 4 * scale;
  std::vector<Line> lines;
  add_lines(lines, caption.heading, inner, scale, caption_bright);
  add_lines(lines, caption.shown, inner, scale, caption_dim);
  add_lines(lines, caption.extremes, inner, scale, caption_dim);
  add_lines(lines, caption.invalid, inner, scale, invalid_colour);

  const int top = image.lines * factor;
  const int bar = caption.colour_bar ? colour_bar_height(scale) + 4 * scale : 0;
  const int height = top + 2 * margin + bar + static_cast<int>(lines.size()) * pitch - 4 * scale;
  Canvas canvas{width, height, caption_background};
  draw_picture(canvas, picture, image, factor);
  int y = top + margin;
  if (caption.colour_bar) {
    draw_colour_bar(canvas, {margin, y, inner, bar}, *caption.colour_bar, scale);
    y += bar;
  }
  for (const Line& line : lines) {
    canvas.text(margin, y, line.text, line.colour, scale);
    y += pitch;
  }
  return canvas.take();
}

}  // namespace

QuickLook quick_look(const Preview& preview, const QuickLookOptions& options) {
  const ArrayImage& image = preview.image();
  const BandChoice choice = choose_bands(image, options.bands);
  const ShownFacts& facts = preview.facts(choice);
  Picture picture;
  Caption caption;
  if (choice.look == Look::temperature) {
    const auto temperature_k = temperatures_of(image.bands[choice.bands[0]]);
    const TemperatureRange range = temperature_range(image, temperature_k);
    picture = temperature_map(temperature_k, range);
    caption = temperature_caption(image, facts, range);
  } else {
    picture = tone_map(image, choice);
    caption = radiance_caption(image, facts);
  }
  caption.extremes = with_dots({caption.extremes, step_text(preview.step())});
  caption.invalid = invalid_text(facts.invalid_pixels);
  caption.heading = with_dots({options.title, image.name, options.time});

  QuickLook look{compose(image, picture, caption), facts.invalid_pixels, choice.as_wanted};
  look.picture.text = {
      {"Title", in_ascii(with_dots({options.title, image.name}))},
      {"Description", in_ascii(with_dots({caption.shown, caption.extremes, caption.invalid}))},
      {"Software", options.software}};
  if (!options.time.empty()) look.picture.text.emplace_back("Acquisition Time", options.time);
  return look;
}

QuickLook quick_look(const ArrayImage& image, const QuickLookOptions& options) {
  Preview preview{image, options.bands, std::numeric_limits<std::size_t>::max()};
  preview.take(image);
  return quick_look(preview, options);
}

}  // namespace nadir::sim
