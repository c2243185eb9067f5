#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "sim/run/file_weather_series.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

/// Exact integral of a line over a span: trapezoids between its nodes.
double integral(const thermal::TimeSeries& line, double from, double to) {
  double sum = 0.0, last = from;
  const auto add_to = [&](double time) {
    sum += 0.5 * (line.at(last) + line.at(time)) * (time - last);
    last = time;
  };
  for (const double node : line.time_s) {
    if (node > from && node < to) add_to(node);
  }
  add_to(to);
  return sum;
}

std::vector<SpanValue> hours(const std::vector<double>& values) {
  std::vector<SpanValue> spans;
  for (std::size_t i = 0; i < values.size(); ++i) {
    spans.push_back(
        {3600.0 * static_cast<double>(i), 3600.0 * static_cast<double>(i + 1), values[i]});
  }
  return spans;
}

// The line's mean over an hour is the hour's value by construction; 1e-12 is rounding.
TEST_CASE("interpolation keeps the energy of every hour", "[sim][weather]") {
  // Broken clouds: hours of no light next to bright ones.
  std::vector<double> values{0.0, 0.0, 119.0, 290.0, 30.0, 790.0, 0.0, 850.0, 860.0, 20.0, 0.0};
  SECTION("of a day as measured") {}
  SECTION("of days drawn at random") {
    values.clear();
    Rng random{7};
    for (int i = 0; i < 500; ++i) {
      const double u = random.next();
      values.push_back(u < 0.2 ? 0.0 : 1000.0 * u);
    }
  }
  const std::vector<SpanValue> spans = hours(values);
  const thermal::TimeSeries line = line_of_means(spans, 1e9);
  for (const SpanValue& hour : spans) {
    CHECK(integral(line, hour.from_s, hour.to_s) / 3600.0 ==
          Approx(hour.value).epsilon(1e-12).margin(1e-9));
  }
  for (const double value : line.value) {
    CHECK(value >= 0.0);
    CHECK(value <= 4.0 / 3.0 * 1000.0);
  }
}

TEST_CASE("a steady rise stays a straight line", "[sim][weather]") {
  const thermal::TimeSeries line = line_of_means(hours({100, 200, 300, 400, 500}), 1e9);
  for (double t = 3600.0; t <= 4.0 * 3600.0; t += 450.0) {
    CHECK(line.at(t) == Approx(50.0 + 100.0 * t / 3600.0).epsilon(1e-12));
  }
}

TEST_CASE("a smooth day is met to 1 % of its height", "[sim][weather]") {
  // Means over hours of a half sine from 6 to 18 h. Linear pieces half an hour long are off by
  // h^2 f''/8 = 0.2 %, the values between hours by twice that; the hours of sunrise and sunset,
  // where the curve has a corner, by 1 %.
  using std::numbers::pi;
  const auto mean = [](double hour) {
    return 12.0 / pi * (std::cos(pi * (hour - 6.0) / 12.0) - std::cos(pi * (hour - 5.0) / 12.0));
  };
  std::vector<double> values(24, 0.0);
  for (std::size_t i = 6; i < 18; ++i) values[i] = mean(static_cast<double>(i));
  const thermal::TimeSeries line = line_of_means(hours(values), 1e9);
  double worst = 0.0;
  for (double h = 0.0; h <= 24.0; h += 0.05) {
    const double exact = std::max(0.0, std::sin(pi * (h - 6.0) / 12.0));
    worst = std::max(worst, std::abs(line.at(3600.0 * h) - exact));
  }
  CHECK(worst < 0.07);
}

TEST_CASE("a gap ends at its hours and is bridged by a line", "[sim][weather]") {
  std::vector<SpanValue> spans = hours({100, 100, 0, 0, 300, 300});
  spans.erase(spans.begin() + 2, spans.begin() + 4);
  const thermal::TimeSeries line = line_of_means(spans, 1e9);
  CHECK(line.at(1.9 * 3600.0) == Approx(100.0).epsilon(1e-12));
  CHECK(line.at(3.0 * 3600.0) == Approx(200.0).epsilon(1e-12));
  CHECK(line.at(4.1 * 3600.0) == Approx(300.0).epsilon(1e-12));
}

TEST_CASE("minutes are joined into the means of ten", "[sim][weather]") {
  std::vector<SpanValue> minutes;
  for (int i = -15; i < 15; ++i) minutes.push_back({60.0 * i, 60.0 * (i + 1), double(i)});
  const std::vector<SpanValue> spans = joined(minutes, 600.0);
  REQUIRE(spans.size() == 4);
  CHECK(spans[0].from_s == -1200.0);
  CHECK(spans[0].value == Approx(-13.0).epsilon(1e-12));  // five of them
  CHECK(spans[1].from_s == -600.0);
  CHECK(spans[1].to_s == 0.0);
  CHECK(spans[1].value == Approx(-5.5).epsilon(1e-12));
  CHECK(spans[2].value == Approx(4.5).epsilon(1e-12));
}

}  // namespace
}  // namespace nadir::sim
