#include "spectral/curve.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::literals;
using namespace nadir::spectral;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// 1 -> 3 -> 0 over uneven steps; used with each behaviour outside.
Curve tent(Outside outside) { return Curve{{1.0, 2.0, 4.0}, {1.0, 3.0, 0.5}, outside}; }

std::string message(const std::vector<double>& wavelength_um, const std::vector<double>& value) {
  try {
    const Curve curve{wavelength_um, value, Outside::zero};
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a curve is exact at its knots and straight between them", "[spectral][curve]") {
  const Curve curve = tent(Outside::reject);
  CHECK(curve.at(1.0_um) == 1.0);
  CHECK(curve.at(2.0_um) == 3.0);
  CHECK(curve.at(4.0_um) == 0.5);
  CHECK(curve.at(1.25_um) == 1.5);
  CHECK(curve.at(3.0_um) == 1.75);
  CHECK(curve.first() == 1.0_um);
  CHECK(curve.last() == 4.0_um);
  CHECK(curve.min_value() == 0.5);
  CHECK(curve.max_value() == 3.0);
  CHECK_FALSE(curve.is_constant());
}

TEST_CASE("outside its table a curve is what its owner chose", "[spectral][curve]") {
  const Micrometres below{0.999}, above{4.001};
  CHECK(std::isnan(tent(Outside::reject).at(below)));
  CHECK(std::isnan(tent(Outside::reject).at(above)));
  CHECK(tent(Outside::zero).at(below) == 0.0);
  CHECK(tent(Outside::zero).at(above) == 0.0);
  CHECK(tent(Outside::hold).at(below) == 1.0);
  CHECK(tent(Outside::hold).at(above) == 0.5);
  CHECK(std::isnan(tent(Outside::hold).at(Micrometres{not_a_number})));
  CHECK(std::isnan(tent(Outside::zero).at(Micrometres{not_a_number})));
}

TEST_CASE("a curve covers what lies in its table, ends included", "[spectral][curve]") {
  const Curve curve = tent(Outside::hold);
  CHECK(curve.covers(1.0_um, 4.0_um));
  CHECK(curve.covers(2.5_um, 2.5_um));
  CHECK_FALSE(curve.covers(0.9_um, 2.0_um));
  CHECK_FALSE(curve.covers(2.0_um, 4.1_um));
  CHECK_FALSE(curve.covers(Micrometres{not_a_number}, 2.0_um));
}

TEST_CASE("a constant is the same everywhere", "[spectral][curve]") {
  const Curve curve = Curve::constant(0.7);
  CHECK(curve.is_constant());
  CHECK(curve.at(1e-3_um) == 0.7);
  CHECK(curve.at(1e9_um) == 0.7);
  CHECK(curve.mean(3.0_um, 5.0_um) == 0.7);
  CHECK(curve.covers(0.1_um, 1000.0_um));
  CHECK(curve.first() == 0.0_um);
  CHECK(curve.last() == Micrometres{infinity});
  CHECK(curve.min_value() == 0.7);
  CHECK(curve.max_value() == 0.7);
  CHECK_THROWS_AS(Curve::constant(not_a_number), InputError);
  CHECK_THROWS_AS(Curve::constant(infinity), InputError);
}

TEST_CASE("a curve at lanes is the curve at each wavelength", "[spectral][curve]") {
  const Lanes lanes{{0.5_um, 1.0_um, 1.5_um, 3.0_um, 4.0_um, 9.0_um}};
  const Spectrum s = tent(Outside::zero).at(lanes);
  REQUIRE(s.count() == 6);
  const std::vector<float> expected = {0.0F, 1.0F, 2.0F, 1.75F, 0.5F, 0.0F};
  for (int i = 0; i < 6; ++i) CHECK(s[i] == expected[static_cast<std::size_t>(i)]);
}

// Areas of the trapezia by hand: [1, 2] has 2, [2, 4] has 3.5.
TEST_CASE("the mean of a curve is exact", "[spectral][curve]") {
  const Curve inside = tent(Outside::reject);
  CHECK(inside.mean(1.0_um, 4.0_um) == Approx(5.5 / 3.0).epsilon(1e-15));
  CHECK(inside.mean(1.0_um, 2.0_um) == 2.0);
  CHECK(inside.mean(1.5_um, 3.0_um) == Approx((1.25 + 2.375) / 1.5).epsilon(1e-15));
  CHECK(inside.mean(2.2_um, 2.4_um) == Approx(2.625).epsilon(1e-15));  // within one step
  CHECK(inside.mean(3.0_um, 3.0_um) == 1.75);
  CHECK(std::isnan(inside.mean(0.5_um, 2.0_um)));
  CHECK(std::isnan(inside.mean(3.0_um, 2.0_um)));
  CHECK(std::isnan(Curve::constant(1.0).mean(3.0_um, 2.0_um)));
}

TEST_CASE("the mean of a curve knows what lies outside", "[spectral][curve]") {
  const Curve zero = tent(Outside::zero), hold = tent(Outside::hold);
  CHECK(zero.mean(0.5_um, 6.0_um) == Approx(5.5 / 5.5).epsilon(1e-15));
  CHECK(hold.mean(0.5_um, 6.0_um) == Approx((0.5 + 5.5 + 1.0) / 5.5).epsilon(1e-15));
  // Wholly outside, on either side.
  CHECK(zero.mean(5.0_um, 6.0_um) == 0.0);
  CHECK(hold.mean(5.0_um, 6.0_um) == 0.5);
  CHECK(hold.mean(0.25_um, 0.75_um) == 1.0);
}

// Additivity over a random cut, for a table of random steps.
TEST_CASE("means of two parts make the mean of the whole", "[spectral][curve]") {
  Rng rng{41};
  std::vector<double> w{0.3}, v{1.0};
  for (int i = 0; i < 50; ++i) {
    w.push_back(w.back() + 0.01 + rng.next());
    v.push_back(rng.next());
  }
  const Outside outside = GENERATE(Outside::zero, Outside::hold);
  const Curve curve{w, v, outside};
  for (int i = 0; i < 100; ++i) {
    const Micrometres a{0.1 + rng.next()}, b{40.0 * rng.next() + 1.2}, c{45.0 + 10.0 * rng.next()};
    const double parts = curve.mean(a, b) * (b - a).value + curve.mean(b, c) * (c - b).value;
    CHECK(parts == Approx(curve.mean(a, c) * (c - a).value).epsilon(1e-13));
  }
}

TEST_CASE("tables that make no curve are refused, all mistakes at once", "[spectral][curve]") {
  CHECK(message({1.0, 2.0}, {0.0, 0.0}) == "accepted");
  CHECK(message({1.0}, {0.0}) == "error: expected at least two wavelengths, found 1\n");
  CHECK(message({1.0, 2.0}, {0.0}) ==
        "error: expected one value for each of 2 wavelengths, found 1\n");
  CHECK(message({1.0, 3.0, 2.0}, {0, 0, 0}) ==
        "error: expected ascending wavelengths, found 2 um after 3 um in row 3\n");
  CHECK(message({1.0, 1.0}, {0, 0}) ==
        "error: expected ascending wavelengths, found 1 um after 1 um in row 2\n");
  CHECK(message({0.0, 1.0}, {0, 0}) ==
        "error: expected a positive wavelength, found 0 um in row 1\n");
  CHECK(message({1.0, infinity}, {0, 0}) ==
        "error: expected a positive wavelength, found inf um in row 2\n");
  CHECK(message({1.0, not_a_number}, {0, 0}) ==
        "error: expected a positive wavelength, found nan um in row 2\n");
  CHECK(message({1.0, 2.0}, {0.5, not_a_number}) ==
        "error: expected a finite value, found nan in row 2\n");
  CHECK(message({2.0, 1.0}, {infinity, 0.5, 0.5}) ==
        "error: expected one value for each of 2 wavelengths, found 3\n"
        "error: expected ascending wavelengths, found 1 um after 2 um in row 2\n"
        "error: expected a finite value, found inf in row 1\n");
}
