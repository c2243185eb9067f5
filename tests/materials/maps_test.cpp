#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "materials/maps/contrast_choice.hpp"
#include "materials/maps/material_map.hpp"
#include "materials/maps/relief_map.hpp"
#include "support/catch.hpp"

namespace nadir::materials {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// 3 columns of 10 m from east 100, 2 rows of 5 m southwards from north 50.
MapFrame frame(bool repeats) {
  MapFrame f;
  f.origin = {100.0, 50.0};
  f.step = {10.0, -5.0};
  f.columns = 3;
  f.rows = 2;
  f.repeats = repeats;
  return f;
}

/// A map whose pixels are numbered from 10 row by row.
MaterialMap numbered(bool repeats) {
  return {frame(repeats), {10, 11, 12, 13, 14, 15}, {0, 1, 2, 3, 4, 5}, {}};
}

TEST_CASE("a choice map gives the material of the pixel that holds the point",
          "[materials][maps]") {
  const MaterialMap map = numbered(false);
  CHECK(map.at({100.1, 49.9}, 0.0) == 10);
  CHECK(map.at({109.9, 49.9}, 0.0) == 10);
  CHECK(map.at({110.1, 49.9}, 0.0) == 11);
  CHECK(map.at({129.9, 49.9}, 0.999) == 12);
  CHECK(map.at({100.1, 44.9}, 0.5) == 13);
  CHECK(map.at({125.0, 42.0}, 0.5) == 15);
}

TEST_CASE("outside its area a map goes on with its edge pixels, or repeats", "[materials][maps]") {
  const MaterialMap held = numbered(false), tiled = numbered(true);
  CHECK(held.at({-1e9, 49.0}, 0.0) == 10);
  CHECK(held.at({1e300, -1e300}, 0.0) == 15);
  CHECK(tiled.at({131.0, 49.0}, 0.0) == 10);
  CHECK(tiled.at({99.0, 49.0}, 0.0) == 12);
  CHECK(tiled.at({101.0, 51.0}, 0.0) == 13);
  CHECK(tiled.at({101.0 + 30.0 * 1000.0, 49.0 - 10.0 * 777.0}, 0.0) == 10);
}

TEST_CASE("a place that is not finite still gives one of the materials", "[materials][maps]") {
  for (const bool repeats : {false, true}) {
    const MaterialMap map = numbered(repeats);
    for (const double x : {not_a_number, infinity, -infinity, 1e308}) {
      for (const double y : {not_a_number, infinity, -infinity, 0.0}) {
        const auto material = map.at({x, y}, 0.5);
        CHECK((material >= 10 && material <= 15));
      }
    }
  }
}

TEST_CASE("fractions are met in the mean, and a layer without a share is never drawn",
          "[materials][maps]") {
  MaterialMap map{frame(false), {7, 8, 9}, {}, {}};
  map.frame.columns = 2;
  map.frame.rows = 1;
  map.cumulative = {0.25F, 0.25F, 1.0F, 0.0F, 1.0F, 1.0F};
  int counts[3] = {};
  const int draws = 4096;
  for (int i = 0; i < draws; ++i) {
    const auto material = map.at({105.0, 49.0}, (i + 0.5) / draws);
    ++counts[material - 7];
    CHECK(map.at({115.0, 49.0}, (i + 0.5) / draws) == 8);
  }
  CHECK(counts[0] == draws / 4);
  CHECK(counts[1] == 0);
  CHECK(counts[2] == draws * 3 / 4);
  // The largest double below 1 rounds to 1 in float.
  CHECK(map.at({105.0, 49.0}, std::nextafter(1.0, 0.0)) == 9);
  CHECK(map.at({115.0, 49.0}, std::nextafter(1.0, 0.0)) == 8);
}

ReliefMap relief(bool repeats, const std::vector<double>& heights, double strength = 1.0) {
  const MapFrame f = frame(repeats);
  return {f, slopes_of_heights(f, heights, strength)};
}

TEST_CASE("heights of a plane give its normal everywhere, whichever way the rows run",
          "[materials][maps]") {
  // z = 0.2 east - 0.1 north at the pixel centres
  std::vector<double> heights;
  for (const double north : {47.5, 42.5}) {
    for (const double east : {105.0, 115.0, 125.0}) heights.push_back(0.2 * east - 0.1 * north);
  }
  const Vec3 expected = normalised({-0.2, 0.1, 1.0});
  for (const Vec2 at : {Vec2{105.0, 47.5}, Vec2{112.3, 44.4}, Vec2{90.0, 60.0}, Vec2{500.0, 0.0}}) {
    // 1e-12: rounding of heights of 25 m against differences of 0.5 m
    CHECK(length(relief(false, heights).normal_at(at) - expected) < 1e-12);
  }
  const Vec3 doubled = normalised({-0.4, 0.2, 1.0});
  CHECK(length(relief(false, heights, 2.0).normal_at({112.0, 45.0}) - doubled) < 1e-12);
}

TEST_CASE("slopes are central differences, taken round the edge where the map repeats",
          "[materials][maps]") {
  const std::vector<double> heights{0.0, 1.0, 4.0, 0.0, 1.0, 4.0};
  const auto held = slopes_of_heights(frame(false), heights, 1.0);
  CHECK(held[0].x == Approx(0.1).epsilon(1e-14));
  CHECK(held[1].x == Approx(0.2).epsilon(1e-14));
  CHECK(held[2].x == Approx(0.3).epsilon(1e-14));
  const auto tiled = slopes_of_heights(frame(true), heights, 1.0);
  CHECK(tiled[0].x == Approx((1.0 - 4.0) / 20.0).epsilon(1e-14));
  CHECK(tiled[2].x == Approx((0.0 - 1.0) / 20.0).epsilon(1e-14));
  CHECK(tiled[4].y == 0.0);
  CHECK_THROWS_AS(slopes_of_heights(frame(true), {1.0}, 1.0), InputError);
}

TEST_CASE("slopes between pixel centres are bilinear, and unit normals point outward",
          "[materials][maps]") {
  ReliefMap map{frame(false), std::vector<Vec2>(6)};
  map.slope[0] = {1.0, 0.0};
  map.slope[1] = {3.0, 0.0};
  map.slope[3] = {0.0, 2.0};
  map.slope[4] = {0.0, 4.0};
  // a quarter of the way east, half way south: x (1.5 + 0) / 2, y (0 + 2.5) / 2
  const Vec3 n = map.normal_at({107.5, 45.0});
  CHECK(-n.x / n.z == Approx(0.75).epsilon(1e-12));
  CHECK(-n.y / n.z == Approx(1.25).epsilon(1e-12));
  CHECK(length(n) == Approx(1.0).epsilon(1e-14));
  CHECK(map.normal_at({not_a_number, 0.0}) == Vec3{0.0, 0.0, 1.0});
  CHECK(map.normal_at({0.0, infinity}) == Vec3{0.0, 0.0, 1.0});
}

TEST_CASE("a repeating relief has no seam", "[materials][maps]") {
  Rng rng{5, 0};
  std::vector<double> heights;
  for (int i = 0; i < 6; ++i) heights.push_back(rng.next());
  const ReliefMap map = relief(true, heights);
  for (int i = 0; i < 100; ++i) {
    const Vec2 at{100.0 + 30.0 * rng.next(), 40.0 + 10.0 * rng.next()};
    // 1e-9: rounding of coordinates of 1e4 m in pixels of 5 m
    CHECK(length(map.normal_at(at) - map.normal_at({at.x + 9e3, at.y - 7e3})) < 1e-9);
  }
  const Vec3 left = map.normal_at({100.0 - 1e-9, 44.0}),
             right = map.normal_at({100.0 + 1e-9, 44.0});
  CHECK(length(left - right) < 1e-9);
}

TEST_CASE("a map whose axes are turned finds its pixels and slopes all the same",
          "[materials][maps]") {
  // Columns run 3 east and 1 north each, rows 2 east and 4 south.
  MapFrame f = frame(false);
  f.origin = {7.0, -2.0};
  f.step = {3.0, -4.0};
  f.lean = {2.0, 1.0};
  const auto place = [&](double column, double row) {
    return Vec2{7.0 + 3.0 * column + 2.0 * row, -2.0 + 1.0 * column - 4.0 * row};
  };
  const MaterialMap map{f, {10, 11, 12, 13, 14, 15}, {0, 1, 2, 3, 4, 5}, {}};
  std::vector<double> heights;
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      const Vec2 centre = place(column + 0.5, row + 0.5);
      CHECK(map.at(centre, 0.0) == 10U + static_cast<unsigned>(3 * row + column));
      heights.push_back(0.3 * centre.x + 0.7 * centre.y);
    }
  }
  const ReliefMap plane{f, slopes_of_heights(f, heights, 1.0)};
  CHECK(length(plane.normal_at(place(1.2, 0.9)) - normalised({-0.3, -0.7, 1.0})) < 1e-12);
}

TEST_CASE("a normal and the slope made from it agree", "[materials][maps]") {
  const Vec3 n = normalised({0.3, -0.2, 0.9});
  const ReliefMap map{frame(false), std::vector<Vec2>(6, slope_of_normal(3.0 * n, 1.0))};
  CHECK(length(map.normal_at({111.0, 46.0}) - n) < 1e-15);
}

TEST_CASE("contrast picks the spectrum of the nearest standard score", "[materials][maps]") {
  // Scores of the picture: -sqrt(3/2), 0, sqrt(3/2); of the spectra the same, in another order.
  const ContrastImage image{3, 1, {100.0F, 150.0F, 200.0F}};
  CHECK(contrast_choice(image, {0.4, 0.2, 0.3}) == std::vector<std::uint16_t>{1, 2, 0});
  // Neither scale nor offset of the picture or of the spectra matters.
  const ContrastImage scaled{3, 1, {-1.0F, -0.5F, 0.0F}};
  CHECK(contrast_choice(scaled, {0.8, 0.0, 0.4}) == std::vector<std::uint16_t>{1, 2, 0});
}

TEST_CASE("a window takes slow changes of brightness out of the contrast", "[materials][maps]") {
  // A ramp with a ripple of one pixel: within 3 x 3 pixels the ripple decides, over all the ramp.
  ContrastImage image{64, 1, {}};
  for (int i = 0; i < 64; ++i) image.values.push_back(static_cast<float>(i + (i % 2 ? 4 : -4)));
  const auto local = contrast_choice(image, {0.1, 0.2}, 2);
  const auto global = contrast_choice(image, {0.1, 0.2});
  for (std::size_t i = 2; i < 62; ++i) CHECK(local[i] == i % 2);
  CHECK(global[4] == 0);
  CHECK(global[5] == 0);
  CHECK(global[60] == 1);
  // A window wider than the picture is the picture.
  CHECK(contrast_choice(image, {0.1, 0.2}, 1 << 30) == global);
}

TEST_CASE("the shares of the spectra follow a picture of the same distribution",
          "[materials][maps]") {
  Rng rng{9, 0};
  ContrastImage image{100, 100, {}};
  for (int i = 0; i < 10000; ++i) image.values.push_back(static_cast<float>(rng.next()));
  std::vector<double> spectra;
  for (int i = 0; i < 10; ++i) spectra.push_back(0.1 + 0.05 * i);
  std::vector<int> counts(10);
  for (const auto choice : contrast_choice(image, spectra)) ++counts[choice];
  // The picture's scores spread evenly over 2 sqrt(3), those of the ten spectra are 0.348 apart: a
  // share of 0.1005 each, and 0.098 for the outermost.
  for (const int count : counts) CHECK(count == Approx(1000).margin(120));  // 4 sigma of binomial
}

TEST_CASE("pictures and spectra without contrast, and holes, fall on the middle spectrum",
          "[materials][maps]") {
  const float hole = std::numeric_limits<float>::quiet_NaN();
  CHECK(contrast_choice({2, 1, {5.0F, 5.0F}}, {0.1, 0.2, 0.31}) ==
        std::vector<std::uint16_t>{1, 1});
  CHECK(contrast_choice({3, 1, {hole, 1.0F, 9.0F}}, {0.1, 0.2, 0.3}) ==
        std::vector<std::uint16_t>{1, 0, 2});
  CHECK(contrast_choice({2, 1, {1.0F, 2.0F}}, {0.2, 0.2, 0.2}) == std::vector<std::uint16_t>{0, 0});
  CHECK(contrast_choice({2, 1, {hole, hole}}, {0.2}) == std::vector<std::uint16_t>{0, 0});
  CHECK(contrast_choice({0, 0, {}}, {0.2}).empty());
  CHECK_THROWS_AS(contrast_choice({2, 2, {1.0F}}, {0.2}), InputError);
  CHECK_THROWS_AS(contrast_choice({1, 1, {1.0F}}, {}), InputError);
}

}  // namespace
}  // namespace nadir::materials
