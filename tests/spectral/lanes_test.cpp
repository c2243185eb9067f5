#include "spectral/lanes.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::spectral;

namespace {

std::vector<Micrometres> um(const std::vector<double>& values) {
  std::vector<Micrometres> wavelengths;
  for (const double v : values) wavelengths.emplace_back(v);
  return wavelengths;
}

std::vector<Micrometres> ramp(int n) {
  std::vector<Micrometres> wavelengths;
  for (int i = 0; i < n; ++i) wavelengths.emplace_back(0.4 + 0.01 * i);
  return wavelengths;
}

/// lane i holds a + b i
Spectrum line(int count, float a, float b) {
  Spectrum s{count};
  for (int i = 0; i < count; ++i) s[i] = a + b * static_cast<float>(i);
  return s;
}

}  // namespace

TEST_CASE("lanes keep their wavelengths", "[spectral][lanes]") {
  const Lanes lanes{um({0.4, 0.5, 11.0})};
  CHECK(lanes.count() == 3);
  CHECK(lanes[2] == Micrometres{11.0});
  CHECK(std::vector<Micrometres>(lanes.begin(), lanes.end()) == um({0.4, 0.5, 11.0}));
  CHECK(Lanes{}.count() == 0);
  CHECK(Lanes{ramp(lane_capacity)}.count() == lane_capacity);
}

TEST_CASE("lanes that cannot be are refused", "[spectral][lanes]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto message = [](const std::vector<Micrometres>& wavelengths) {
    try {
      const Lanes lanes{wavelengths};
    } catch (const InputError& e) {
      return std::string{e.what()};
    }
    return std::string{"accepted"};
  };
  CHECK(message({}) == "error: expected 1 to 128 wavelengths, found 0\n");
  CHECK(message(ramp(129)) == "error: expected 1 to 128 wavelengths, found 129\n");
  CHECK(message(um({0.5, 0.4})) ==
        "error: expected ascending wavelengths, found 0.4 um after 0.5 um\n");
  CHECK(message(um({0.5, 0.5})) ==
        "error: expected ascending wavelengths, found 0.5 um after 0.5 um\n");
  CHECK(message(um({0.0, 0.5})) == "error: expected a positive wavelength, found 0 um\n");
  CHECK(message(um({-1.0})) == "error: expected a positive wavelength, found -1 um\n");
  CHECK(message(um({0.5, nan})) == "error: expected a positive wavelength, found nan um\n");
  CHECK(message(um({0.5, infinity})) == "error: expected a positive wavelength, found inf um\n");
}

// Counts on and off the group of eight; small integers, so that float is exact.
TEST_CASE("spectra compute lane by lane", "[spectral][spectrum]") {
  const int n = GENERATE(1, 5, 7, 8, 9, 100, 127, 128);
  CAPTURE(n);
  const Spectrum a = line(n, 1.0F, 2.0F), b = line(n, 3.0F, -1.0F);
  Spectrum scaled = a, product = a;
  scaled.add_scaled(b, 4.0F);
  product.add_product(a, b);
  const Spectrum sum = a + b, difference = a - b, times = a * b, twice = a * 2.0F;
  for (int i = 0; i < n; ++i) {
    const float x = 1.0F + 2.0F * static_cast<float>(i), y = 3.0F - static_cast<float>(i);
    REQUIRE(sum[i] == x + y);
    REQUIRE(difference[i] == x - y);
    REQUIRE(times[i] == x * y);
    REQUIRE(twice[i] == 2.0F * x);
    REQUIRE(scaled[i] == x + 4.0F * y);
    REQUIRE(product[i] == x + x * y);
  }
  CHECK(a.max() == 1.0F + 2.0F * static_cast<float>(n - 1));
  CHECK((a * -1.0F).max() == -1.0F);
  CHECK(a.mean() == static_cast<float>(n));  // mean of 1, 3, .. 2 n - 1
}

TEST_CASE("a spectrum may be its own operand", "[spectral][spectrum]") {
  Spectrum s = line(11, 1.0F, 1.0F);
  s += s;
  s *= s;
  s.add_product(s, s);
  CHECK(s[10] == 484.0F + 484.0F * 484.0F);
  const Spectrum& same = s;
  s = same;
  CHECK(s[0] == 4.0F + 16.0F);
}

TEST_CASE("a spectrum can be assigned over one of another size", "[spectral][spectrum]") {
  Spectrum s;
  CHECK(s.count() == 0);
  CHECK(s.max() == 0.0F);
  CHECK(s.mean() == 0.0F);
  const Spectrum empty = s;
  s = line(13, 1.0F, 1.0F);
  CHECK(s.count() == 13);
  CHECK(s[12] == 13.0F);
  s = line(3, 5.0F, 0.0F);
  CHECK(s.count() == 3);
  CHECK(s.mean() == 5.0F);
  s = empty;
  CHECK(s.count() == 0);
}

// The eight floats of a group are seen through the object's bytes: lanes 5 .. 7 pad it.
TEST_CASE("padding lanes stay 0, so that they never overflow", "[spectral][spectrum]") {
  Spectrum s{5, 3e38F};
  s *= s;
  s.add_scaled(s, 1e10F);
  s += Spectrum{5, 1.0F};
  s.add_product(s, s);
  const auto* lanes = reinterpret_cast<const float*>(&s);
  CHECK(std::isinf(s[4]));
  for (int i = 5; i < 8; ++i) CHECK(lanes[i] == 0.0F);
}

TEST_CASE("a sum in double keeps what a sum in float would lose", "[spectral][spectrum]") {
  const int n = GENERATE(3, 8, 128);
  SpectrumSum sum{n};
  sum.add(Spectrum{n, 16'777'216.0F});  // 2^24, where float's spacing is 2
  for (int i = 0; i < 100; ++i) sum.add(Spectrum{n, 1.0F}, 0.5);
  CHECK(sum.count() == n);
  CHECK(sum[n - 1] == 16'777'266.0);
  CHECK(sum.spectrum(1.0 / 16'777'266.0)[0] == 1.0F);
  CHECK(sum.spectrum().count() == n);
}
