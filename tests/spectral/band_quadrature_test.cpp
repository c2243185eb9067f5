#include "spectral/band_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/error.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"
#include "support/quadrature.hpp"

using namespace nadir;
using namespace nadir::literals;
using namespace nadir::spectral;

namespace {

using Long = long double;

/// Shape of a thermal band of 0.6 um about 10.9 um: steep flanks, an uneven top, weak wings.
const Response tirs_like = TabulatedResponse{Curve{
    {10.2, 10.4, 10.5, 10.6, 10.65, 10.7, 10.8, 10.9, 11.0, 11.1, 11.15, 11.2, 11.3, 11.5, 12.0},
    {0.0, 0.03, 0.14, 0.51, 0.73, 0.81, 0.84, 0.92, 1.0, 0.87, 0.65, 0.41, 0.14, 0.01, 0.0},
    Outside::zero}};

const std::vector<Response> responses = {
    BoxResponse{8.0_um, 14.0_um},
    BoxResponse{0.63_um, 0.68_um},
    GaussianResponse{0.56_um, 0.02_um},
    GaussianResponse{10.9_um, 0.6_um},
    tirs_like,
    TabulatedResponse{Curve{{1.0, 2.0}, {0.0, 5.0}, Outside::zero}},
    // Two peaks with nothing between them.
    TabulatedResponse{Curve{{3.0, 3.5, 4.0, 6.0, 6.5, 7.0}, {0, 1, 0, 0, 0.01, 0}, Outside::zero}},
};

/// Interval edges between which the response is smooth.
std::vector<double> edges(const Response& response) {
  const Support s = spectral::support(response);
  std::vector<double> all{s.lo.value, s.hi.value};
  if (const auto* table = std::get_if<TabulatedResponse>(&response)) {
    for (const double w : table->curve.wavelengths_um()) {
      if (w > s.lo.value && w < s.hi.value) all.push_back(w);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// int f R by the double-exponential rule, which shares nothing with the code under test.
template <class F>
Long weighted_integral(const Response& response, F&& f) {
  const auto integrand = [&](Long w) {
    return static_cast<Long>(at(response, Micrometres{static_cast<double>(w)})) * f(w);
  };
  const std::vector<double> e = edges(response);
  const int panels = e.size() > 2 ? 1 : 3;  // for polynomials of degree 23
  Long sum = 0.0L;
  for (std::size_t i = 1; i < e.size(); ++i) {
    sum += support::integrate(integrand, e[i - 1], e[i], panels);
  }
  return sum;
}

template <class F>
Long band_mean(const Response& response, F&& f) {
  return weighted_integral(response, f) / weighted_integral(response, [](Long) { return 1.0L; });
}

double band_sum(const BandQuadrature& band, Kelvin t) {
  double sum = 0.0;
  for (std::size_t i = 0; i < band.weights.size(); ++i) {
    sum += band.weights[i] * planck(band.wavelengths[i], t).value;
  }
  return sum;
}

BandQuadrature monochromatic(const std::vector<double>& wavelengths_um) {
  BandQuadrature band;
  for (const double w : wavelengths_um) {
    band.wavelengths.emplace_back(w);
    band.weights.push_back(1.0 / static_cast<double>(wavelengths_um.size()));
  }
  return band;
}

}  // namespace

TEST_CASE("band weights are positive, sum to 1 and stand inside the band", "[spectral][band]") {
  for (const Response& response : responses) {
    for (const int n : {1, 2, 3, 4, 8, 15, 32}) {
      const BandQuadrature band = gauss_quadrature(response, n);
      CAPTURE(n, spectral::support(response).lo.value);
      REQUIRE(band.wavelengths.size() == static_cast<std::size_t>(n));
      REQUIRE(band.weights.size() == static_cast<std::size_t>(n));
      REQUIRE(std::is_sorted(band.wavelengths.begin(), band.wavelengths.end(), std::less_equal{}));
      REQUIRE(band.wavelengths.front() > spectral::support(response).lo);
      REQUIRE(band.wavelengths.back() < spectral::support(response).hi);
      REQUIRE(*std::min_element(band.weights.begin(), band.weights.end()) > 0.0);
      const double sum = std::accumulate(band.weights.begin(), band.weights.end(), 0.0);
      REQUIRE(sum == Approx(1.0).epsilon(1e-14));  // 32 roundings
    }
  }
}

// Legendre polynomials in u, which maps the support to [-1, 1], stay within 1, so that rounding is
// of one size for all degrees: that of u, 1e-16 times wavelength over half-width (up to 26).
TEST_CASE("n wavelengths integrate every polynomial of degree 2 n - 1", "[spectral][band]") {
  for (const Response& response : responses) {
    const Support s = spectral::support(response);
    const Long middle = (static_cast<Long>(s.lo.value) + static_cast<Long>(s.hi.value)) / 2.0L;
    const Long half = static_cast<Long>(s.hi.value) - middle;
    const Long area = weighted_integral(response, [](Long) { return 1.0L; });
    for (const int n : {1, 2, 5, 12}) {
      const BandQuadrature band = gauss_quadrature(response, n);
      for (const int degree : {n, 2 * n - 2, 2 * n - 1}) {
        const auto p = [&](Long w) {
          const Long u = std::clamp((w - middle) / half, -1.0L, 1.0L);
          return std::legendre(static_cast<unsigned>(degree), u);
        };
        Long sum = 0.0L;
        for (std::size_t i = 0; i < band.weights.size(); ++i) {
          sum += static_cast<Long>(band.weights[i]) * p(band.wavelengths[i].value);
        }
        const Long error = sum - weighted_integral(response, p) / area;
        CAPTURE(s.lo.value, s.hi.value, n, degree);
        CHECK(static_cast<double>(std::abs(error)) < 2e-14);
      }
    }
  }
}

// Orthogonality is exactness for products: the sum of P_j P_k over the nodes is delta / (2 k + 1).
TEST_CASE("the largest rule keeps the Legendre polynomials orthogonal", "[spectral][band]") {
  const BandQuadrature band = gauss_quadrature(BoxResponse{9.0_um, 11.0_um}, 32);
  for (unsigned j = 0; j < 32; j += 3) {
    for (unsigned k = 0; k <= j; ++k) {
      double sum = 0.0;
      for (std::size_t i = 0; i < band.weights.size(); ++i) {
        const double u = band.wavelengths[i].value - 10.0;
        sum += band.weights[i] * std::legendre(j, u) * std::legendre(k, u);
      }
      CAPTURE(j, k);
      CHECK(sum == Approx(j == k ? 1.0 / (2.0 * k + 1.0) : 0.0).margin(2e-14));
    }
  }
}

// Gauss-Legendre, n = 2 and 3: Abramowitz & Stegun, table 25.4.
TEST_CASE("a box response gives the classical Gauss-Legendre wavelengths", "[spectral][band]") {
  const Response box = BoxResponse{9.0_um, 11.0_um};
  const BandQuadrature two = gauss_quadrature(box, 2), three = gauss_quadrature(box, 3);
  CHECK(two.wavelengths[1].value == Approx(10.0 + 1.0 / std::sqrt(3.0)).epsilon(1e-15));
  CHECK(two.weights[0] == Approx(0.5).epsilon(1e-14));
  CHECK(three.wavelengths[0].value == Approx(10.0 - std::sqrt(0.6)).epsilon(1e-15));
  CHECK(three.weights[0] == Approx(5.0 / 18.0).epsilon(1e-14));
  CHECK(three.weights[1] == Approx(8.0 / 18.0).epsilon(1e-14));
  CHECK(gauss_quadrature(box, 1).wavelengths[0] == 10.0_um);
}

TEST_CASE("one wavelength is the centroid of the response", "[spectral][band]") {
  for (const Response& response : responses) {
    CHECK(gauss_quadrature(response, 1).wavelengths[0].value ==
          Approx(centre(response).value).epsilon(1e-14));
  }
}

// The band is narrow against the scale on which Planck changes: each wavelength more gains two
// digits or more. Measured, largest of the three: 1.1e-3, 1.5e-6, 4e-9 (n = 3), 9e-12, 2e-16.
TEST_CASE("few wavelengths are enough for a thermal band", "[spectral][band]") {
  for (const double t : {250.0, 300.0, 350.0}) {
    const auto f = [&](Long w) {
      return static_cast<Long>(planck(Micrometres{static_cast<double>(w)}, Kelvin{t}).value);
    };
    const auto exact = static_cast<double>(band_mean(tirs_like, f));
    const auto error = [&](int n) {
      return std::abs(band_sum(gauss_quadrature(tirs_like, n), Kelvin{t}) / exact - 1.0);
    };
    CAPTURE(t);
    CHECK(error(1) < 3e-3);
    CHECK(error(2) < 3e-6);
    CHECK(error(3) < 1e-8);
    CHECK(error(4) < 2e-11);
    CHECK(error(8) < 1e-14);  // the sum's own rounding
  }
}

TEST_CASE("a box response gives the mean of the band radiance", "[spectral][band]") {
  const BandQuadrature band = gauss_quadrature(BoxResponse{8.0_um, 14.0_um}, 12);
  for (const double t : {200.0, 300.0, 500.0}) {
    CHECK(6.0 * band_sum(band, Kelvin{t}) ==
          Approx(planck_band(8.0_um, 14.0_um, Kelvin{t}).value).epsilon(1e-12));
  }
}

// MODIS's typical radiances of the thermal bands are those of a black body at 300 K. Band limits
// and radiances: NASA, MODIS specifications (modis.gsfc.nasa.gov/about/specifications.php); printed
// with two decimals, of which the last is cut for band 31 (9.5552).
TEST_CASE("bands of MODIS see their published radiance of 300 K", "[spectral][band]") {
  struct Row {
    double lo, hi, radiance;
  };
  for (const Row& row : {Row{3.660, 3.840, 0.45}, Row{8.400, 8.700, 9.58},
                         Row{10.780, 11.280, 9.55}, Row{11.770, 12.270, 8.94}}) {
    const BoxResponse box{Micrometres{row.lo}, Micrometres{row.hi}};
    CAPTURE(row.lo);
    CHECK(band_sum(gauss_quadrature(box, 6), 300.0_K) == Approx(row.radiance).margin(0.01));
  }
}

TEST_CASE("a band needs a legal response and a legal number of wavelengths", "[spectral][band]") {
  CHECK_THROWS_WITH(gauss_quadrature(tirs_like, 0),
                    "error: expected 1 to 32 wavelengths for a band, found 0\n");
  CHECK_THROWS_WITH(gauss_quadrature(tirs_like, 33),
                    "error: expected 1 to 32 wavelengths for a band, found 33\n");
  CHECK_THROWS_AS(gauss_quadrature(BoxResponse{2.0_um, 1.0_um}, 4), InputError);
}

// The inverse of a sum; the radiance comes from the sum itself, whose truth the tests above check.
TEST_CASE("band brightness temperature inverts the band's radiance", "[spectral][band]") {
  for (const Response& response : responses) {
    const BandQuadrature band = gauss_quadrature(response, 7);
    for (const double t : {30.0, 180.0, 300.0, 1000.0, 5772.0}) {
      const double radiance = band_sum(band, Kelvin{t});
      if (radiance < 1e-290) continue;
      CAPTURE(t, spectral::support(response).lo.value);
      CHECK(band_brightness_temperature(band, SpectralRadiance{radiance}).value ==
            Approx(t).epsilon(2e-15));
    }
  }
}

TEST_CASE("for one wavelength it is the brightness temperature proper", "[spectral][band]") {
  for (const double radiance : {1e-250, 1e-9, 3.0, 1e9}) {
    CHECK(band_brightness_temperature(monochromatic({11.0}), SpectralRadiance{radiance}) ==
          brightness_temperature(11.0_um, SpectralRadiance{radiance}));
  }
}

// The hardest case: wavelengths so far apart that the radiance is all in one of them.
TEST_CASE("band brightness temperature is found for wavelengths far apart", "[spectral][band]") {
  const BandQuadrature band = monochromatic({0.2, 20.0});
  for (const double t : {5.0, 40.0, 300.0, 2000.0, 6000.0}) {
    CAPTURE(t);
    CHECK(band_brightness_temperature(band, SpectralRadiance{band_sum(band, Kelvin{t})}).value ==
          Approx(t).epsilon(2e-15));
  }
}

TEST_CASE("band brightness temperature at the edges of its domain", "[spectral][band]") {
  const BandQuadrature band = gauss_quadrature(tirs_like, 4);
  CHECK(band_brightness_temperature(band, SpectralRadiance{0.0}).value == 0.0);
  CHECK(std::isnan(band_brightness_temperature(band, SpectralRadiance{-1.0}).value));
  CHECK(std::isnan(band_brightness_temperature(band, SpectralRadiance{std::nan("")}).value));
  CHECK(std::isnan(band_brightness_temperature({}, SpectralRadiance{1.0}).value));
  const Kelvin faint = band_brightness_temperature(band, SpectralRadiance{1e-310});
  CHECK((faint.value > 1.5 && faint.value < 2.5));  // x = 720
}
