#include "core/share_bound.hpp"

#include <cmath>
#include <cstdint>

#include "support/catch.hpp"

using namespace nadir;

TEST_CASE("the bound of a share without a hit is 1 - (1 - level)^(1/n)", "[core][share]") {
  const auto n = GENERATE(1U, 2U, 10U, 59U, 299U, 1000000U);
  CAPTURE(n);
  // 1e-12: expm1 and log1p against pow, which loses digits near 1.
  CHECK(1.0 - share_upper_bound(0, n, 0.95) ==
        Approx(std::pow(0.05, 1.0 / n)).epsilon(1e-12).margin(0.0));
}

TEST_CASE("59 trials without a hit bound a share to 5 percent", "[core][share]") {
  // The classical size of a sample: S. S. Wilks, Ann. Math. Stat. 12, 91 (1941): 95 % sure of 95 %.
  CHECK(share_upper_bound(0, 59, 0.95) < 0.05);
  CHECK(share_upper_bound(0, 58, 0.95) > 0.05);
}

TEST_CASE("the bound of all hits but one is level^(1/n)", "[core][share]") {
  // At most n - 1 of n: 1 - p^n = 1 - level.
  const auto n = GENERATE(2U, 7U, 40U, 500U);
  CAPTURE(n);
  CHECK(share_upper_bound(n - 1, n, 0.95) ==
        Approx(std::pow(0.95, 1.0 / n)).epsilon(1e-10).margin(0.0));
  CHECK(share_upper_bound(n, n, 0.95) == 1.0);
}

TEST_CASE("the bound has the published values", "[core][share]") {
  // NIST/SEMATECH e-Handbook of Statistical Methods, 7.2.4.1: 4 of 20, upper end of 90 %.
  CHECK(share_upper_bound(4, 20, 0.95) == Approx(0.401029).margin(5e-7));
  // Ends of 95 % intervals in tables of the binomial; their four digits.
  CHECK(share_upper_bound(1, 10, 0.975) == Approx(0.4450).margin(5e-5));
  CHECK(share_upper_bound(5, 10, 0.975) == Approx(0.8129).margin(5e-5));
  CHECK(share_upper_bound(10, 100, 0.975) == Approx(0.1762).margin(5e-5));
}

TEST_CASE("the bound makes few hits as improbable as it says", "[core][share]") {
  // Summed term by term from the first, another way than the bound's own.
  const std::uint64_t n = 200, k = GENERATE(1U, 3U, 30U, 120U);
  const double level = GENERATE(0.3, 0.95, 0.999);
  const double p = share_upper_bound(k, n, level);
  double term = std::pow(1.0 - p, static_cast<double>(n)), sum = term;
  for (std::uint64_t i = 1; i <= k; ++i) {
    term *= static_cast<double>(n - i + 1) / static_cast<double>(i) * p / (1.0 - p);
    sum += term;
  }
  CAPTURE(k, level, p);
  // 1e-9: what lgamma and the bracket leave.
  CHECK(sum == Approx(1.0 - level).epsilon(1e-9));
}

TEST_CASE("the bound of a share knows what it cannot tell", "[core][share]") {
  CHECK(share_upper_bound(0, 0, 0.95) == 1.0);
  CHECK(std::isnan(share_upper_bound(0, 5, 1.0)));
  CHECK(std::isnan(share_upper_bound(0, 5, 0.0)));
}
