#include "sim/run/strips.hpp"

#include "support/catch.hpp"

using namespace nadir::sim;

TEST_CASE("strips cover an image line by line, in multiples of a unit", "[sim][run]") {
  for (const int samples : {1, 100, 1000, 100000}) {
    const auto strips = cut_into_strips(samples, 1003, 16);
    int next = 0;
    for (const Strip& strip : strips) {
      CHECK(strip.first_line == next);
      CHECK(strip.lines > 0);
      if (&strip != &strips.back()) CHECK(strip.lines % 16 == 0);
      next += strip.lines;
    }
    CHECK(next == 1003);
  }
}

TEST_CASE("a strip holds some 131,072 pixels, however many lines there are", "[sim][run]") {
  const auto strips = cut_into_strips(1000, 20000, 16);
  CHECK(strips.front().lines == 144);  // the first multiple of 16 with 131,072 pixels or more
  CHECK(cut_into_strips(100000, 20000, 16).front().lines == 16);
}

TEST_CASE("appended strips make the whole image", "[sim][run]") {
  const auto strip_of = [](int first, int lines, float value) {
    ArrayImage strip;
    strip.samples = 3;
    strip.lines = lines;
    strip.first_line = first;
    strip.all_lines = 5;
    const std::size_t n = strip.pixels();
    strip.bands.resize(1);
    strip.bands[0].radiance.assign(n, value);
    strip.bands[0].standard_error.assign(n, value);
    strip.bands[0].dn.assign(n, 7);
    strip.truth.material.assign(n, 2);
    strip.truth.range_m.assign(n, value);
    strip.truth.latitude_deg.assign(n, 36.5);
    strip.truth.fractions.assign(2, std::vector<float>(n, value));
    return strip;
  };
  ArrayImage image = strip_of(0, 2, 1.0F);
  append(image, strip_of(2, 3, 4.0F));
  CHECK(image.lines == 5);
  REQUIRE(image.bands[0].radiance.size() == 15);
  CHECK(image.bands[0].radiance[5] == 1.0F);
  CHECK(image.bands[0].radiance[6] == 4.0F);
  CHECK(image.bands[0].dn.size() == 15);
  CHECK(image.truth.material.size() == 15);
  CHECK(image.truth.range_m.size() == 15);
  CHECK(image.truth.latitude_deg.size() == 15);
  CHECK(image.truth.fractions[1].size() == 15);
  CHECK(image.truth.height_m.empty());
}
