#include "core/statistics.hpp"

#include <cmath>

#include "core/random.hpp"
#include "support/catch.hpp"

using namespace nadir;

// Mean and variance of 1 .. n: (n + 1) / 2 and n (n + 1) / 12. The variance is also that of the
// numbers moved by any offset; 1e12 costs the textbook formula all its digits, Welford none that
// the offset's own rounding (integers, exact) does not take.
TEST_CASE("Welford gives mean and variance of an arithmetic series at any offset",
          "[core][statistics]") {
  const double offset = GENERATE(0.0, -1e6, 1e12);
  constexpr int n = 1000;
  Welford w;
  for (int i = 1; i <= n; ++i) w.add(offset + i);
  CHECK(w.count() == n);
  // Each of n additions rounds the mean by up to one unit of the offset's last place, 1e-16.
  CHECK(w.mean() - offset == Approx(500.5).epsilon(1e-13).margin(std::abs(offset) * 1e-15));
  // A mean that is off by d = 1e-3 adds d times the spread, 1e3: 1e-5 of the variance.
  CHECK(w.variance() == Approx(n * (n + 1) / 12.0).epsilon(offset == 1e12 ? 1e-5 : 1e-12));
  CHECK(w.estimate().standard_error == Approx(std::sqrt(w.variance() / n)).epsilon(1e-15));
}

TEST_CASE("merging two parts gives the moments of the whole", "[core][statistics]") {
  const int split = GENERATE(0, 1, 2, 500, 999, 1000);
  Rng rng{11};
  Welford whole, first, second;
  for (int i = 0; i < 1000; ++i) {
    const double x = 100.0 + rng.next();
    whole.add(x);
    (i < split ? first : second).add(x);
  }
  first.merge(second);
  CHECK(first.count() == whole.count());
  CHECK(first.mean() == Approx(whole.mean()).epsilon(1e-14));          // some roundings of 1e-16
  CHECK(first.variance() == Approx(whole.variance()).epsilon(1e-11));  // (100 / 0.3) times that
}

TEST_CASE("an empty part changes nothing, not even a bit", "[core][statistics]") {
  Welford part;
  for (const double x : {0.1, 0.7, 0.3}) part.add(x);
  Welford left = part, right;
  left.merge(Welford{});
  right.merge(part);
  for (const Welford& merged : {left, right}) {
    CHECK(merged.count() == part.count());
    CHECK(merged.mean() == part.mean());
    CHECK(merged.variance() == part.variance());
  }
}

TEST_CASE("one draw has no standard error, equal draws have none but 0", "[core][statistics]") {
  Welford w;
  CHECK(std::isnan(w.variance()));
  w.add(3.7);
  CHECK(w.mean() == 3.7);
  CHECK(std::isnan(w.estimate().standard_error));
  w.add(3.7);
  w.add(3.7);
  CHECK(w.estimate().standard_error == 0.0);
}

// The standard error of 100 uniform numbers is sqrt(1 / 1200). Over 2000 repetitions the mean
// squared error scatters by sqrt(2 / 2000) = 3.2 %: 15 % is 4.7 sigma.
TEST_CASE("the stated standard error is the one that repetitions show", "[core][statistics]") {
  Rng rng{12};
  double squared_error = 0.0, stated = 0.0;
  for (int repetition = 0; repetition < 2000; ++repetition) {
    Welford w;
    for (int i = 0; i < 100; ++i) w.add(rng.next());
    squared_error += std::pow(w.mean() - 0.5, 2) / 2000.0;
    stated += std::pow(w.estimate().standard_error, 2) / 2000.0;
  }
  CHECK(squared_error == Approx(1.0 / 1200.0).epsilon(0.15));
  CHECK(stated == Approx(1.0 / 1200.0).epsilon(0.01));
}
