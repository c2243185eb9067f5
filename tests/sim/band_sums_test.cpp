#include "sim/run/band_sums.hpp"

#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

constexpr int replicates = 4, paths = 2;

/// A pixel of one band whose paths have weights w = 2 u and radiance f(u), u uniform.
template <class Radiance>
Estimate weighted_pixel(Rng& rng, const Radiance& radiance) {
  BandSums sums{1, replicates, true};
  sums.begin_pixel();
  for (int r = 0; r < replicates; ++r) {
    double plain = 0.0;
    for (int p = 0; p < paths; ++p) {
      const double u = rng.next(), value = radiance(u);
      plain += value / paths;
      sums.add_weighted(0, 2.0 * u, value);
    }
    sums.close_replicate(std::vector<double>{plain}, paths);
  }
  return sums.estimate(0);
}

}  // namespace

TEST_CASE("without weights a band's radiance is the mean of its replicates", "[sim][run]") {
  BandSums sums{2, 4, false};
  sums.begin_pixel();
  for (const double value : {1.0, 2.0, 4.0, 5.0}) {
    sums.close_replicate(std::vector<double>{value, 10.0 * value}, 2);
  }
  CHECK(sums.estimate(0).mean == Approx(3.0).epsilon(1e-15));
  CHECK(sums.estimate(1).mean == Approx(30.0).epsilon(1e-15));
  // Variance of one draw 10/3, of the mean of four a quarter of it.
  CHECK(sums.estimate(0).standard_error == Approx(std::sqrt(10.0 / 12.0)).epsilon(1e-14));
}

TEST_CASE("weights of paths bring no noise over a level field", "[sim][run]") {
  Rng rng{3};
  for (int pixel = 0; pixel < 20; ++pixel) {
    const Estimate level = weighted_pixel(rng, [](double) { return 7.5; });
    CHECK(level.mean == Approx(7.5).epsilon(1e-14));
    CHECK(level.standard_error < 1e-14);
  }
}

TEST_CASE("weighted paths have the weighted mean as their expectation", "[sim][run]") {
  // int 2 u f(u) du with f = u^2 is 1/2; the plain mean is 1/3. Mean of 40,000 pixels; five of its
  // standard errors.
  Rng rng{11};
  Welford all;
  for (int pixel = 0; pixel < 40000; ++pixel) {
    all.add(weighted_pixel(rng, [](double u) { return u * u; }).mean);
  }
  const Estimate mean = all.estimate();
  CHECK(std::abs(mean.mean - 0.5) < 5.0 * mean.standard_error);
  CHECK(mean.standard_error < 2e-3);  // or the test would not see a bias of 1 %
}

TEST_CASE("a pixel begins afresh", "[sim][run]") {
  BandSums sums{1, 2, true};
  for (int pixel = 0; pixel < 2; ++pixel) {
    sums.begin_pixel();
    for (int r = 0; r < 2; ++r) {
      sums.add_weighted(0, 1.0, pixel + 1.0);
      sums.close_replicate(std::vector<double>{pixel + 1.0}, 1);
    }
    CHECK(sums.estimate(0).mean == Approx(pixel + 1.0).epsilon(1e-15));
  }
}
