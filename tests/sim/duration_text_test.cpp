#include <string>

#include "core/error.hpp"
#include "message_of.hpp"
#include "sim/run/accuracy_options.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

// 1e-15 throughout: the decimal fractions themselves are rounded.

TEST_CASE("an accuracy is a percentage or a fraction", "[sim][options]") {
  CHECK(parse_accuracy("1%") == Approx(0.01).epsilon(1e-15));
  CHECK(parse_accuracy("0.5 %") == Approx(0.005).epsilon(1e-15));
  CHECK(parse_accuracy(" 0.01 ") == Approx(0.01).epsilon(1e-15));
  CHECK(parse_accuracy("1e-3") == Approx(0.001).epsilon(1e-15));
  CHECK(parse_accuracy("100%") == Approx(1.0).epsilon(1e-15));
}

TEST_CASE("what is no accuracy is refused", "[sim][options]") {
  const std::string text = GENERATE("", "%", "0", "0%", "-1%", "101%", "1.5", "nan", "inf", "1%%",
                                    "1 % 2", "one", "1,5%");
  CAPTURE(text);
  CHECK_THROWS_AS(parse_accuracy(text), InputError);
}

TEST_CASE("a time has units in their order, or is seconds", "[sim][options]") {
  CHECK(parse_duration("90") == 90.0);
  CHECK(parse_duration("60s") == 60.0);
  CHECK(parse_duration("10min") == 600.0);
  CHECK(parse_duration("1h30min") == 5400.0);
  CHECK(parse_duration("1 h 2 min 3.5 s") == 3723.5);
  CHECK(parse_duration("1.5h") == 5400.0);
  CHECK(parse_duration("0.2s") == Approx(0.2).epsilon(1e-15));
}

TEST_CASE("what is no time is refused", "[sim][options]") {
  const std::string text = GENERATE("", "0", "-5s", "5m", "30min1h", "1h30", "s", "1s1s", "nan",
                                    "inf", "9000h", "1e99", "10 min later", "5 S");
  CAPTURE(text);
  CHECK_THROWS_AS(parse_duration(text), InputError);
}

TEST_CASE("a refused time says what is expected", "[sim][options]") {
  CHECK(
      support::message_of([] { return parse_duration("5m"); })
          .find(
              "expected a time above 0 and at most a year, as 60s, 10min, 1h30min or 90 (seconds), "
              "found \"5m\"") != std::string::npos);
}

TEST_CASE("seconds are written as people do", "[sim][options]") {
  CHECK(duration_text(0.4213) == "0.42 s");
  CHECK(duration_text(9.94) == "9.9 s");
  CHECK(duration_text(12.3) == "12 s");
  CHECK(duration_text(59.7) == "1 min");
  CHECK(duration_text(200.0) == "3 min 20 s");
  CHECK(duration_text(5400.0) == "1 h 30 min");
  CHECK(duration_text(7199.0) == "2 h");
}
