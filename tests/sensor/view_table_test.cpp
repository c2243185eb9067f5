#include "sensor/camera/view_table.hpp"

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

constexpr double pixel_rad = 1e-3;

// A pinhole camera's lines of sight, with a twist that no perspective has.
Vec3 pinhole(double sample, double line, double twist = 0.0) {
  const double x = (sample - 50.0) * pixel_rad, y = (line - 30.0) * pixel_rad;
  return normalised(Vec3{x + twist * y * y, y + twist * x * x, 1.0});
}

// Of 100 x 60 pixels, nodes every 11 and every 59/2 pixels.
ViewTable pinhole_table(double twist = 0.0) {
  ViewTable table{10, 3, 11.0, 29.5, {}};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 10; ++column) {
      table.directions.push_back(pinhole(0.5 + 11.0 * column, 0.5 + 29.5 * row, twist));
    }
  }
  return table;
}

TEST_CASE("a view table gives its nodes back", "[sensor][view_table]") {
  const auto table = checked(pinhole_table(2.0));
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 10; ++column) {
      const double sample = 0.5 + 11.0 * column, line = 0.5 + 29.5 * row;
      CHECK(length(direction(*table, {sample, line}) - pinhole(sample, line, 2.0)) < 1e-15);
    }
  }
}

// Nodes are of length 1, not of depth 1: the farther one from the axis counts too much, by half the
// square of the step s where the inner one lies on the axis. In the middle of a cell that is s/4 x
// s^2/2: 3.2e-6 rad for 0.0295 rad, and 2e-7 along the other axis. Here half a hundredth of a
// pixel.
TEST_CASE("between the nodes of a pinhole camera its lines of sight are met within 4e-6 rad",
          "[sensor][view_table]") {
  const auto table = checked(pinhole_table());
  double worst = 0.0;
  for (double sample = 0.5; sample < 100.0; sample += 2.3) {
    for (double line = 0.5; line < 60.0; line += 1.7) {
      const Vec3 seen = direction(*table, {sample, line});
      CHECK(length(seen) == Approx(1.0).epsilon(1e-15));
      worst = std::max(worst, length(seen - pinhole(sample, line)));
    }
  }
  CHECK(worst < 4e-6);
}

TEST_CASE("beyond the outermost nodes the outermost cells go on", "[sensor][view_table]") {
  const auto table = checked(pinhole_table());
  CHECK(length(direction(*table, {-3.0, 63.0}) - pinhole(-3.0, 63.0)) < 3e-6);
}

TEST_CASE("looking up a line of sight in a view table is undone", "[sensor][view_table]") {
  const auto table = checked(pinhole_table(2.0));
  for (double sample = -4.0; sample < 104.0; sample += 3.1) {
    for (double line = -3.0; line < 63.0; line += 2.9) {
      const auto place = place_of(*table, direction(*table, {sample, line}));
      CAPTURE(sample, line);
      REQUIRE(place);
      CHECK(std::hypot(place->x - sample, place->y - line) < 1e-9);
    }
  }
  CHECK_FALSE(place_of(*table, {0.0, 0.0, -1.0}));
}

TEST_CASE("off a table of one line, places lie square to it", "[sensor][view_table]") {
  ViewTable line{5, 1, 25.0, 1.0, {}};
  for (int i = 0; i < 5; ++i) line.directions.push_back(pinhole(0.5 + 25.0 * i, 30.0));
  const auto table = checked(line);
  CHECK(length(direction(*table, {50.5, 0.5}) - pinhole(50.5, 30.0)) < 1e-15);
  // At the middle a step down is as wide as one to the right; +y is image down.
  const Vec3 below = direction(*table, {50.0, 2.5});
  CHECK(below.y / below.z == Approx(2.0 * pixel_rad).epsilon(1e-3));  // chords are a bit shorter
  CHECK(below.x / below.z == Approx(0.0).margin(1e-6));
  const auto place = place_of(*table, direction(*table, {71.3, -1.25}));
  REQUIRE(place);
  CHECK(std::hypot(place->x - 71.3, place->y + 1.25) < 1e-9);
}

TEST_CASE("lines of sight are made unit vectors", "[sensor][view_table]") {
  ViewTable table = pinhole_table();
  for (Vec3& direction : table.directions) direction = 7.0 * direction;
  CHECK(length(checked(table)->directions[3]) == Approx(1.0).epsilon(1e-15));
}

TEST_CASE("view tables that cannot be are refused", "[sensor][view_table]") {
  const auto refused = [](auto change, const char* message) {
    ViewTable table = pinhole_table();
    change(table);
    CHECK_THROWS_WITH(checked(table), std::string{"error: "} + message + "\n");
  };
  refused([](ViewTable& t) { t.samples = 1; }, "a view table has at least 2 columns and 1 row");
  refused([](ViewTable& t) { t.directions.pop_back(); },
          "a view table of 10 x 3 nodes has 29 lines of sight");
  refused([](ViewTable& t) { t.sample_step = 0.0; },
          "the steps of a view table must be above 0 pixels");
  refused([](ViewTable& t) { t.directions[4] = {}; },
          "line of sight 4 of the view table is not finite or of no length");
  refused([](ViewTable& t) { t.directions[4].x = std::numeric_limits<double>::infinity(); },
          "line of sight 4 of the view table is not finite or of no length");
  refused(
      [](ViewTable& t) {
        t.directions[12] = {1.0, 0.0, 0.0};
      },
      "the lines of sight of nodes 2 and 12 of the view table are more than 10 degrees apart");
}

}  // namespace
}  // namespace nadir::sensor
