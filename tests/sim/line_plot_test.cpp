#include "sim/products/line_plot.hpp"

#include <limits>

#include "support/catch.hpp"

namespace nadir::sim {
namespace {

TEST_CASE("axes are cut at round numbers that hold all values", "[sim][plot]") {
  CHECK(round_steps(0.3, 9.7, 5) == std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0});
  CHECK(round_steps(-130.0, 880.0, 6).front() == -200.0);
  CHECK(round_steps(-130.0, 880.0, 6).back() == 1000.0);
  const auto same = round_steps(288.0, 288.0, 5);
  CHECK(same.front() < 288.0);
  CHECK(same.back() > 288.0);
}

LinePlot two_points(double second) {
  LinePlot plot;
  plot.title = "a < b & c";
  plot.x_label = "UTC";
  plot.x = {0.0, 1.0, 2.0};
  plot.x_ticks = {{1.0, "12:00"}};
  plot.panels = {{"K", {{"surface", "#c00", {280.0, second, 290.0}, false}}}};
  return plot;
}

TEST_CASE("a plot is one SVG with its texts made safe", "[sim][plot]") {
  const std::string svg = to_svg(two_points(285.0));
  CHECK(svg.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\"", 0) == 0);
  CHECK_THAT(svg, Catch::Contains("a &lt; b &amp; c"));
  CHECK_THAT(svg, Catch::Contains(">12:00</text>"));
  CHECK_THAT(svg, Catch::Contains(">surface</text>"));
  CHECK_THAT(svg, Catch::EndsWith("</svg>\n"));
}

TEST_CASE("a curve stands where its values are", "[sim][plot]") {
  // The axis runs from 280 to 290 over 250 px below y = 64, x over 640 px from 70.
  CHECK_THAT(to_svg(two_points(285.0)),
             Catch::Contains("points=\"70.0,314.0 390.0,189.0 710.0,64.0 \""));
}

TEST_CASE("no tick stands outside its panel", "[sim][plot]") {
  LinePlot plot = two_points(285.0);
  plot.panels[0].series[0].y = {-618.0, 0.0, 573.0};  // ticks of 200: -800 to 600
  const std::string svg = to_svg(plot);
  CHECK_THAT(svg, Catch::Contains(">-800</text>") && Catch::Contains(">600</text>"));
  CHECK_THAT(svg, !Catch::Contains("1000"));
}

TEST_CASE("what is not a number leaves a gap", "[sim][plot]") {
  const std::string svg = to_svg(two_points(std::numeric_limits<double>::quiet_NaN()));
  CHECK_THAT(svg, Catch::Contains("points=\"70.0,314.0 \""));
  CHECK_THAT(svg, Catch::Contains("points=\"710.0,64.0 \""));
  CHECK_THAT(svg, !Catch::Contains("nan"));
}

}  // namespace
}  // namespace nadir::sim
