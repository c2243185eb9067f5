#include "sensor/platform/track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "core/random.hpp"
#include "support/catch.hpp"

using namespace nadir;
using sensor::Track;

namespace {

struct Polynomial {
  std::vector<Vec3> coefficients;
  [[nodiscard]] Vec3 value(double t) const {
    Vec3 sum;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) sum = sum * t + *c;
    return sum;
  }
  [[nodiscard]] Vec3 slope(double t) const {
    Vec3 sum;
    for (std::size_t i = coefficients.size() - 1; i > 0; --i) {
      sum = sum * t + coefficients[i] * static_cast<double>(i);
    }
    return sum;
  }
};

Polynomial random_polynomial(int degree, Rng& rng) {
  Polynomial p;
  for (int i = 0; i <= degree; ++i) {
    p.coefficients.push_back({2.0 * rng.next() - 1.0, 2.0 * rng.next() - 1.0, rng.next()});
  }
  return p;
}

std::vector<double> times(int count, double unevenness, Rng& rng) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    result.push_back(-1.0 + 2.0 * (i + unevenness * rng.next()) / count);
  }
  return result;
}

template <class Law>
Track sampled(const Law& law, const std::vector<double>& times_s, int points = 8) {
  std::vector<Vec3> positions;
  positions.reserve(times_s.size());
  for (const double t : times_s) positions.push_back(law(t));
  return Track{times_s, positions, points};
}

/// A circular orbit of 705 km, as fast and as curved as they get.
struct LowOrbit {
  double radius_m = 7.083e6, rate_rad_s = std::sqrt(3.986004418e14 / std::pow(7.083e6, 3));
  [[nodiscard]] Vec3 position(double t) const {
    return radius_m * Vec3{std::cos(rate_rad_s * t), std::sin(rate_rad_s * t), 0.0};
  }
  [[nodiscard]] Vec3 velocity(double t) const {
    return radius_m * rate_rad_s * Vec3{-std::sin(rate_rad_s * t), std::cos(rate_rad_s * t), 0.0};
  }
};

std::string message_of(const std::vector<double>& times_s, const std::vector<Vec3>& positions,
                       int points = 8) {
  try {
    const Track track{times_s, positions, points};
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
  return {};
}

}  // namespace

// Sums of eight terms below 10 (the basis at the ends of the table reaches 7): 1e-13; the slope's
// are some 100 times as large at steps of 0.1.
TEST_CASE("eight points give polynomials of degree 7 and their slopes", "[sensor][track]") {
  Rng rng{81};
  for (const double unevenness : {0.0, 0.7}) {
    for (const int count : {8, 9, 20}) {
      const Polynomial law = random_polynomial(7, rng);
      const auto at = times(count, unevenness, rng);
      const Track track = sampled([&](double t) { return law.value(t); }, at);
      for (int i = 0; i < 200; ++i) {
        const double t = at.front() + (at.back() - at.front()) * rng.next();
        CAPTURE(unevenness, count, t);
        CHECK(length(track.at(t).position - law.value(t)) < 2e-13);
        CHECK(length(track.position(t) - law.value(t)) < 2e-13);
        CHECK(length(track.at(t).velocity - law.slope(t)) < 1e-11);
      }
    }
  }
}

TEST_CASE("a track goes through its points, at its ends too", "[sensor][track]") {
  Rng rng{82};
  for (const double unevenness : {0.0, 0.7}) {
    const auto at = times(30, unevenness, rng);
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < at.size(); ++i) places.push_back({rng.next(), rng.next(), 5.0});
    const Track track{at, places};
    for (std::size_t i = 0; i < at.size(); ++i) {
      CHECK(length(track.position(at[i]) - places[i]) < 1e-13);
      CHECK(length(track.at(at[i]).position - places[i]) < 1e-13);
      CHECK(length(track.before(at[i]).position - places[i]) < 1e-13);
    }
    CHECK(track.first_s() == at.front());
    CHECK(track.last_s() == at.back());
  }
}

TEST_CASE("fewer points than eight give the polynomial through all", "[sensor][track]") {
  Rng rng{83};
  const Polynomial law = random_polynomial(2, rng);
  const Track track = sampled([&](double t) { return law.value(t); }, {-1.0, 0.5, 2.0});
  CHECK(length(track.at(1.3).position - law.value(1.3)) < 1e-14);
  CHECK(length(track.at(1.3).velocity - law.slope(1.3)) < 1e-14);
}

// The remainder of eight points is |f^(8)| / 8! times the product of the distances, in the middle
// (0.5 x 1.5 x 2.5 x 3.5)^2 = 43.07 steps^8: r (w h)^8 43.07 / 40320, 1.2e-12 m at 10 s, and 30
// times as much at the ends. What is left is rounding of coordinates of 7083 km, nanometres.
TEST_CASE("an orbit at steps of 10 s is found to a hundredth of a micrometre", "[sensor][track]") {
  const LowOrbit orbit;
  std::vector<double> at;
  for (int i = 0; i <= 40; ++i) at.push_back(10.0 * i);
  const Track track = sampled([&](double t) { return orbit.position(t); }, at);
  double worst_m = 0.0, worst_m_s = 0.0;
  for (double t = 0.0; t < 400.0; t += 0.37) {
    worst_m = std::max(worst_m, length(track.at(t).position - orbit.position(t)));
    worst_m_s = std::max(worst_m_s, length(track.at(t).velocity - orbit.velocity(t)));
  }
  CAPTURE(worst_m, worst_m_s);
  CHECK(worst_m < 2e-8);
  CHECK(worst_m_s < 2e-9);
}

// At 60 s it shows: 2.0e-6 m. The next order is 1e-3 of it, rounding 2e-9 m.
TEST_CASE("the error of a coarse track is the remainder of its polynomial", "[sensor][track]") {
  const LowOrbit orbit;
  std::vector<double> at;
  for (int i = 0; i <= 20; ++i) at.push_back(60.0 * i);
  const Track track = sampled([&](double t) { return orbit.position(t); }, at);
  const double expected_m =
      orbit.radius_m * std::pow(orbit.rate_rad_s * 60.0, 8) * 43.0664 / 40320.0;
  for (const double t : {390.0, 630.0, 750.0}) {
    CHECK(length(track.position(t) - orbit.position(t)) == Approx(expected_m).epsilon(5e-3));
  }
}

TEST_CASE("two points give straight pieces whose velocity jumps at the way points",
          "[sensor][track]") {
  for (const double end : {4.0, 5.0}) {  // evenly spaced and not
    const Track track{{0.0, 2.0, end}, {{0, 0, 10}, {20, 0, 10}, {20, 40, 10}}, 2};
    CHECK(length(track.at(1.0).position - Vec3{10, 0, 10}) < 1e-14);
    CHECK(length(track.at(1.0).velocity - Vec3{10, 0, 0}) < 1e-14);
    CHECK(length(track.before(2.0).velocity - Vec3{10, 0, 0}) < 1e-14);
    CHECK(length(track.at(2.0).velocity - Vec3{0, 40 / (end - 2.0), 0}) < 1e-13);
    CHECK(length(track.at(end).position - Vec3{20, 40, 10}) < 1e-13);
  }
}

// 0.1 is no binary fraction: division by the step must not pick the wrong piece.
TEST_CASE("at every moment of an even table the piece that begins there holds", "[sensor][track]") {
  std::vector<double> at;
  std::vector<Vec3> places;
  for (int i = 0; i < 1000; ++i) {
    at.push_back(0.1 * i);
    places.push_back({i % 2 == 0 ? 0.0 : 1.0, 0.0, 0.0});
  }
  const Track track{at, places, 2};
  for (int i = 1; i + 1 < 1000; ++i) {
    const double t = at[static_cast<std::size_t>(i)];
    const double slope = i % 2 == 0 ? 10.0 : -10.0;
    REQUIRE(track.at(t).velocity.x == Approx(slope).epsilon(1e-12));
    REQUIRE(track.before(t).velocity.x == Approx(-slope).epsilon(1e-12));
  }
}

TEST_CASE("a track that stands still does so at all times", "[sensor][track]") {
  const Track track{Vec3{1, 2, 3}};
  CHECK(track.is_fixed());
  CHECK(track.at(1e9).position == Vec3{1, 2, 3});
  CHECK(track.position(-1e9) == Vec3{1, 2, 3});
  CHECK(track.at(0.0).velocity == Vec3{});
  CHECK(track.first_s() == -std::numeric_limits<double>::infinity());
  CHECK(track.last_s() == std::numeric_limits<double>::infinity());
}

TEST_CASE("tables that are no tracks are refused", "[sensor][track]") {
  CHECK(message_of({0.0, 1.0}, {{}}) == "a track has 2 times but 1 positions");
  CHECK(message_of({0.0}, {{}}) == "a track needs at least two times");
  CHECK(message_of({0.0, 0.0}, {{}, {}}) == "the times of a track must ascend: 0 s follows 0 s");
  CHECK(message_of({0.0, std::nan("")}, {{}, {}}) == "entry 2 of the track is not finite");
  CHECK(message_of({0.0, 1.0}, {{}, {std::nan(""), 0, 0}}) == "entry 2 of the track is not finite");
  CHECK(message_of({0.0, 1.0}, {{}, {}}, 9) ==
        "a track is interpolated through 2 to 8 points, not 9");
}
