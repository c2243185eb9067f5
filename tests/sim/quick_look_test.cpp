#include "sim/products/quick_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "sim/products/band_choice.hpp"
#include "sim/products/colour_map.hpp"
#include "sim/products/percentile.hpp"
#include "sim/products/preview.hpp"
#include "sim/products/temperature_map.hpp"
#include "sim/products/tone_map.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"
#include "synthetic_array.hpp"

using namespace nadir;
using namespace nadir::sim;
using support::nan_value;
using support::synthetic_array;
using Bands = std::vector<std::size_t>;

namespace {

const std::vector<double> oli_um{0.443, 0.482, 0.561, 0.655, 0.865, 1.609, 2.201};

/// Luma of an sRGB colour, for "brighter than".
int luma(Rgb c) { return 2 * c[0] + 7 * c[1] + c[2]; }

Rgb pixel_at(const PngImage& picture, int x, int y) {
  const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                       static_cast<std::size_t>(x));
  return {static_cast<std::uint8_t>(picture.values[at]),
          static_cast<std::uint8_t>(picture.values[at + 1]),
          static_cast<std::uint8_t>(picture.values[at + 2])};
}

/// Grey surfaces of reflectances from 0.02 to 0.5 under a sun of 5772 K.
ArrayImage grey_scene() {
  ArrayImage image = synthetic_array(50, 41, {0.655, 0.56, 0.48});
  for (BandImage& band : image.bands) {
    const double sun = spectral::planck(Micrometres{band.centre_um}, Kelvin{5772.0}).value * 6.8e-5;
    for (std::size_t i = 0; i < band.radiance.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(band.radiance.size());
      band.radiance[i] = static_cast<float>((0.02 + 0.48 * share) * sun);
    }
  }
  return image;
}

}  // namespace

TEST_CASE("percentiles are linear between order statistics", "[sim][products]") {
  std::vector<float> values{5.0F, 1.0F, 3.0F, 2.0F, 4.0F};
  CHECK(percentile(values, 0.0) == 1.0);
  CHECK(percentile(values, 0.5) == 3.0);
  CHECK(percentile(values, 1.0) == 5.0);
  CHECK(percentile(values, 0.6) == Approx(3.4).epsilon(1e-12));  // rounding of 0.6 x 4
  std::vector<float> none;
  CHECK(std::isnan(percentile(none, 0.5)));
}

TEST_CASE("an array with red, green and blue bands is shown in natural colour",
          "[sim][quick_look]") {
  const BandChoice choice = choose_bands(synthetic_array(4, 4, oli_um), {});
  CHECK(choice.look == Look::natural_colour);
  CHECK(choice.bands == Bands{3, 2, 1});
}

TEST_CASE("bands beyond 60 nm of a colour do not stand in for it", "[sim][quick_look]") {
  CHECK(choose_bands(synthetic_array(4, 4, {0.655, 0.621, 0.48}), {}).look == Look::false_colour);
  CHECK(choose_bands(synthetic_array(4, 4, {0.655, 0.619, 0.48}), {}).look == Look::natural_colour);
}

TEST_CASE("other arrays are shown by what their bands allow", "[sim][quick_look]") {
  const auto look_of = [](const std::vector<double>& centres_um) {
    return choose_bands(synthetic_array(4, 4, centres_um), {});
  };
  CHECK(look_of({0.865, 1.609, 2.201}).look == Look::false_colour);
  CHECK(look_of({0.865, 1.609, 2.201}).bands == Bands{2, 1, 0});
  CHECK(look_of({0.6}).look == Look::grey);
  CHECK(look_of({0.6, 10.9}).bands == Bands{0});  // the light, since not all bands are thermal
  CHECK(look_of({3.9, 10.8, 12.0}).look == Look::temperature);
  CHECK(look_of({3.9, 10.8, 12.0}).bands == Bands{1});
}

TEST_CASE("the user's bands are taken where the array has them all", "[sim][quick_look]") {
  const ArrayImage image = synthetic_array(4, 4, oli_um);
  const BandChoice infrared = choose_bands(image, {"B5", "B4", "B3"});
  CHECK(infrared.look == Look::false_colour);
  CHECK(infrared.bands == Bands{4, 3, 2});
  CHECK(infrared.as_wanted);
  const BandChoice missing = choose_bands(image, {"B5", "B4", "B99"});
  CHECK(missing.look == Look::natural_colour);
  CHECK_FALSE(missing.as_wanted);
  CHECK(choose_bands(synthetic_array(4, 4, {0.5, 10.9}), {"B2"}).look == Look::temperature);
}

TEST_CASE("a grey surface under the sun looks grey, and a brighter one brighter",
          "[sim][quick_look]") {
  const ArrayImage image = grey_scene();
  const Picture picture = tone_map(image, choose_bands(image, {}));
  CHECK(picture.invalid_pixels == 0);
  int darker = -1, unequal = 0;
  for (const Rgb colour : picture.pixels) {
    const auto [least, most] = std::minmax_element(colour.begin(), colour.end());
    unequal = std::max(unequal, *most - *least);
    CHECK(luma(colour) >= darker - 10);
    darker = luma(colour);
  }
  // Radiances are floats and codes are rounded: one code of 255, never a cast.
  CHECK(unequal <= 1);
  CHECK(picture.pixels.back() == Rgb{255, 255, 255});
  CHECK(luma(picture.pixels.front()) < 10 * 64);  // the dark end is dark
}

TEST_CASE("a blue haze over a scene does not make its picture blue", "[sim][quick_look]") {
  ArrayImage image = grey_scene();
  const double blue = 40.0, green = 20.0, red = 10.0;  // W m-2 sr-1 um-1
  const std::array haze{red, green, blue};
  for (std::size_t b = 0; b < 3; ++b) {
    for (float& value : image.bands[b].radiance) value += static_cast<float>(haze[b]);
  }
  const Picture picture = tone_map(image, choose_bands(image, {}));
  const Rgb middle = picture.pixels[picture.pixels.size() / 2];
  // A tenth of the haze stays by design, some codes; without the dark point it would be 40.
  CHECK(std::abs(middle[2] - middle[0]) < 12);
}

TEST_CASE("a scene without contrast or without light has a picture", "[sim][quick_look]") {
  ArrayImage image = synthetic_array(8, 8, oli_um);
  const float level = GENERATE(0.0F, 100.0F, -1.0F);
  CAPTURE(level);
  for (BandImage& band : image.bands) std::fill(band.radiance.begin(), band.radiance.end(), level);
  const Picture picture = tone_map(image, choose_bands(image, {}));
  CHECK(picture.invalid_pixels == 0);
  const Rgb first = picture.pixels.front();
  CHECK(std::all_of(picture.pixels.begin(), picture.pixels.end(),
                    [&](Rgb colour) { return colour == first; }));
  CHECK((level > 0.0F) == (luma(first) > 0));
}

TEST_CASE("pixels that are no number are magenta, counted and named", "[sim][quick_look]") {
  const double centre_um = GENERATE(0.6, 10.9);
  ArrayImage image = synthetic_array(400, 10, {centre_um});
  const bool infinite = GENERATE(false, true);
  const float bad = infinite ? std::numeric_limits<float>::infinity() : nan_value;
  CAPTURE(centre_um, bad);
  image.bands[0].radiance[400 * 5 + 7] = bad;
  if (centre_um > 3.0) image.bands[0].brightness_temperature[400 * 5 + 7] = bad;
  const QuickLook look = quick_look(image, {"t", "", "nadir", {}});
  CHECK(look.invalid_pixels == 1);
  CHECK(pixel_at(look.picture, 7, 5) == invalid_colour);
  CHECK(pixel_at(look.picture, 8, 5) != invalid_colour);
  const auto& [key, description] = look.picture.text[1];
  CHECK(key == "Description");
  CHECK(description.find("1 invalid pixels in magenta") != std::string::npos);
}

TEST_CASE("an invalid value does not shift the colours of the others", "[sim][quick_look]") {
  ArrayImage image = grey_scene();
  const BandChoice choice = choose_bands(image, {});
  const Picture clean = tone_map(image, choice);
  image.bands[1].radiance[0] = nan_value;  // a sky pixel: no part in the statistics
  const Picture marked = tone_map(image, choice);
  CHECK(marked.pixels[0] == invalid_colour);
  CHECK(std::equal(clean.pixels.begin() + 1, clean.pixels.end(), marked.pixels.begin() + 1));
}

// matplotlib's table for "inferno" (CC0), entries 0, 64, 128, 192 and 255; the nodes and the linear
// steps between them are within 1.2 of it, and the result is rounded.
TEST_CASE("the colour map is the published one", "[sim][quick_look]") {
  const auto published = std::to_array<std::pair<double, std::array<double, 3>>>(
      {{0.0, {0.37, 0.12, 3.54}},
       {64.0 / 255.0, {87.08, 15.89, 109.50}},
       {128.0 / 255.0, {187.60, 55.06, 84.21}},
       {192.0 / 255.0, {249.50, 142.27, 8.91}},
       {1.0, {252.03, 254.58, 164.46}}});
  for (const auto& [fraction, colour] : published) {
    CAPTURE(fraction);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(static_cast<double>(inferno(fraction)[c]) == Approx(colour[c]).epsilon(0).margin(1.7));
    }
  }
  CHECK(inferno(-1.0) == inferno(0.0));
  CHECK(inferno(nan_value) == invalid_colour);
}

TEST_CASE("temperatures come from the plane, or from the radiance where it is missing",
          "[sim][quick_look]") {
  BandImage band;
  band.centre_um = 10.9;
  band.radiance = {static_cast<float>(spectral::planck(10.9_um, 300.0_K).value), -1.0F, nan_value};
  const std::vector<float> computed = temperatures_of(band);
  // Half a unit of a float's last place in radiance is 3e-8, in temperature 2e-6 K at 300 K,
  // below a float's own step of 3e-5 K.
  CHECK(double{computed[0]} == Approx(300.0).epsilon(0).margin(4e-5));
  CHECK(std::isnan(computed[1]));
  CHECK(std::isnan(computed[2]));
  band.brightness_temperature = {301.0F, 302.0F, 303.0F};
  CHECK(temperatures_of(band)[0] == 301.0F);
  CHECK(std::isnan(temperatures_of(band)[2]));
}

TEST_CASE("the temperature range follows the ground and is 2 K at least", "[sim][quick_look]") {
  ArrayImage image = synthetic_array(10, 10, {10.9});
  std::vector<float> temperature_k(100, 290.0F);
  std::fill(temperature_k.begin(), temperature_k.begin() + 10, 3.0F);  // the sky's line
  const TemperatureRange flat = temperature_range(image, temperature_k);
  CHECK(flat.lo_k == 289.0);
  CHECK(flat.hi_k == 291.0);
  for (std::size_t i = 10; i < 100; ++i) temperature_k[i] = 200.0F + static_cast<float>(i);
  const TemperatureRange wide = temperature_range(image, temperature_k);
  CHECK(wide.lo_k == Approx(210.0).epsilon(0).margin(0.5));  // half a percent of 89 K
  CHECK(wide.hi_k == Approx(299.0).epsilon(0).margin(0.5));
}

TEST_CASE("ticks are round, inside the range and few", "[sim][quick_look]") {
  CHECK(round_ticks(271.3, 299.0, 6) == std::vector<double>{275, 280, 285, 290, 295});
  CHECK(round_ticks(0.0, 1.0, 2) == std::vector<double>{0.0, 0.5, 1.0});
  const auto ticks = round_ticks(-3.0, 3.0, 4);
  CHECK(ticks == std::vector<double>{-2.0, 0.0, 2.0});
  CHECK_FALSE(std::signbit(ticks[1]));  // a label of -0 would look odd
}

TEST_CASE("a small array is magnified by a whole factor", "[sim][quick_look]") {
  const QuickLook look = quick_look(synthetic_array(50, 40, {10.9}), {"t", "", "nadir", {}});
  CHECK(look.picture.width == 500);
  CHECK(look.picture.height > 400);  // and a caption
  CHECK(pixel_at(look.picture, 20, 20) == pixel_at(look.picture, 29, 29));
}

TEST_CASE("extreme shapes have a picture too", "[sim][quick_look]") {
  const auto [samples, lines] = GENERATE(table<int, int>({{1, 1}, {1, 3000}, {3000, 1}}));
  const double centre_um = GENERATE(0.6, 10.9);
  const QuickLook look =
      quick_look(synthetic_array(samples, lines, {centre_um}), {"t", "", "nadir", {}});
  CHECK(look.picture.width >= samples);
  CHECK(look.picture.height > lines);
}

TEST_CASE("a PNG reads back as it was written, in 8 and 16 bits, grey and colour", "[sim][png]") {
  const support::ScratchFolder folder;
  PngImage image;
  image.width = 3;
  image.height = 2;
  image.channels = GENERATE(1, 3);
  image.bits = GENERATE(8, 16);
  image.text = {{"Title", "a test"}};
  for (int i = 0; i < 6 * image.channels; ++i) {
    image.values.push_back(static_cast<std::uint16_t>(image.bits == 8 ? 14 * i : 3643 * i));
  }
  write_png(folder / "a.png", image);
  const PngImage read = read_png(folder / "a.png");
  CHECK(read.width == 3);
  CHECK(read.height == 2);
  CHECK(read.channels == image.channels);
  CHECK(read.bits == image.bits);
  CHECK(read.values == image.values);
  CHECK(support::content_of(folder / "a.png").find("Title") != std::string::npos);
  CHECK(folder.entries() == 1);
}

TEST_CASE("a broken PNG is an error with the decoder's reason", "[sim][png]") {
  const support::ScratchFolder folder;
  const auto file = folder / "a.png";
  std::ofstream{file} << "no picture";
  const std::string message = support::message_of([&] { static_cast<void>(read_png(file)); });
  CHECK(message.starts_with("cannot decode " + file.string() + ": "));
  CHECK(support::message_of([&] { write_png(file, PngImage{}); }) == "a PNG's sizes do not agree");
}

TEST_CASE("the same image gives the same picture", "[sim][quick_look]") {
  const ArrayImage image = synthetic_array(64, 64, oli_um);
  const QuickLookOptions options{"t", "2026-06-21T16:00:00Z", "nadir 1", {}};
  CHECK(quick_look(image, options).picture.values == quick_look(image, options).picture.values);
}

TEST_CASE("the preview of an image that fits holds all pixels that are shown",
          "[sim][quick_look]") {
  const ArrayImage image = synthetic_array(20, 10, oli_um);
  CHECK(preview_step(20, 10, 200) == 1);
  Preview preview{support::strip_of(image, 0, 4), {}, 200};
  preview.take(support::strip_of(image, 0, 4));
  preview.take(support::strip_of(image, 4, 6));
  CHECK(preview.step() == 1);
  CHECK(preview.image().bands[3].radiance == image.bands[3].radiance);
  CHECK(preview.image().bands[4].radiance.empty());  // no part of natural colour
  const QuickLookOptions options{"t", "", "nadir", {}};
  const PngImage whole = quick_look(image, options).picture;
  CHECK(quick_look(preview, options).picture.values == whole.values);
  CHECK(quick_look(preview, options).picture.text == whole.text);
}

TEST_CASE("a band named twice is shown as named", "[sim][quick_look]") {
  const QuickLook look =
      quick_look(synthetic_array(20, 10, oli_um), {"t", "", "nadir", {"B1", "B1", "B2"}});
  CHECK(look.bands_as_wanted);
  CHECK(look.invalid_pixels == 0);
}

TEST_CASE("a preview never has more pixels than it may", "[sim][quick_look]") {
  CHECK(preview_step(20, 10, 199) == 2);
  CHECK(preview_step(20, 10, 50) == 2);
  CHECK(preview_step(20, 10, 49) == 3);
  CHECK(preview_step(1, 1'000'000, 1000) == 1000);
  CHECK(preview_step(7, 7, 1) == 7);
}

TEST_CASE("a decimated quick look tells so, with counts and extremes of all pixels",
          "[sim][quick_look]") {
  const double centre_um = GENERATE(0.6, 10.9);
  CAPTURE(centre_um);
  ArrayImage image = synthetic_array(20, 10, {centre_um});
  image.bands[0].radiance[21] = nan_value;  // neither kept
  image.bands[0].radiance[23] = 5000.0F;
  if (centre_um > 3.0) image.bands[0].brightness_temperature[23] = 500.0F;
  Preview preview{image, {}, 50};
  preview.take(image);
  REQUIRE(preview.step() == 2);
  CHECK(preview.image().samples == 10);
  CHECK(preview.image().lines == 5);
  CHECK(preview.image().bands[0].radiance[11] == image.bands[0].radiance[42]);
  CHECK(preview.image().truth.material[11] == image.truth.material[42]);
  const QuickLook look = quick_look(preview, {"t", "", "nadir", {}});
  CHECK(look.invalid_pixels == 1);
  const std::string& description = look.picture.text[1].second;
  CHECK(description.find("1 of 2 x 2 pixels shown") != std::string::npos);
  CHECK(description.find("1 invalid pixels") != std::string::npos);
  CHECK(description.find(centre_um > 3.0 ? "max 500.0 K" : "to 5000 W") != std::string::npos);
}

TEST_CASE("a decimated preview does not depend on how the lines are cut", "[sim][quick_look]") {
  const ArrayImage image = synthetic_array(7, 11, {0.6, 0.9});  // grey: two bands to choose from
  Preview whole{image, {}, 28}, strips{support::strip_of(image, 0, 3), {}, 28};
  whole.take(image);
  for (int line = 0; line < 11; line += 3) {
    strips.take(support::strip_of(image, line, std::min(3, 11 - line)));
  }
  REQUIRE(whole.step() == 2);
  for (std::size_t band = 0; band < 2; ++band) {
    CHECK(whole.image().bands[band].radiance.size() == 24);
    CHECK(strips.image().bands[band].radiance == whole.image().bands[band].radiance);
    CHECK(whole.image().bands[band].standard_error.size() == 24);
    CHECK(strips.image().bands[band].standard_error == whole.image().bands[band].standard_error);
  }
  const QuickLookOptions options{"t", "", "nadir", {}};
  CHECK(quick_look(strips, options).picture.values == quick_look(whole, options).picture.values);
}
