#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.hpp"
#include "hard/hard_case.hpp"
#include "sensor/optics/wavelength_quantiles.hpp"
#include "spectral/band_quadrature.hpp"
#include "spectral/coverage.hpp"
#include "support/floating_point_traps.hpp"

// Responses and spectra narrower than any step, and those that end where the band ends.

namespace nadir::radiometry::test {
namespace {

using namespace spectral;

void check_quadrature(const Response& response, int count) {
  check(response);
  const BandQuadrature band = gauss_quadrature(response, count);
  const Support ends = spectral::support(response);
  const double sum = std::accumulate(band.weights.begin(), band.weights.end(), 0.0);
  CHECK(sum == Approx(1.0).epsilon(1e-13));
  for (std::size_t i = 0; i < band.weights.size(); ++i) {
    CHECK(band.weights[i] > 0.0);
    CHECK(band.wavelengths[i].value >= ends.lo.value);
    CHECK(band.wavelengths[i].value <= ends.hi.value);
    if (i > 0) CHECK(band.wavelengths[i].value > band.wavelengths[i - 1].value);
  }
  // Exact for straight lines, whatever the number of nodes: the centroid.
  double mean = 0.0;
  for (std::size_t i = 0; i < band.weights.size(); ++i) {
    mean += band.weights[i] * band.wavelengths[i].value;
  }
  CHECK(mean == Approx(centre(response).value).epsilon(1e-14));
  const auto edges = interval_edges(response, band);
  CHECK(std::is_sorted(edges.begin(), edges.end()));
}

TEST_CASE("a response of one wavelength, 1 nm down to 2e-9 of it wide, is a band there",
          "[hard][spectra]") {
  for (const double at_um : {0.3, 0.55, 10.0, 14.0}) {
    for (const double width_um : {1e-3, 1e-6, 2e-9 * at_um}) {
      for (const int count : {1, 4, 8}) {
        CAPTURE(width_um, at_um, count);
        check_quadrature(BoxResponse{Micrometres{at_um}, Micrometres{at_um + width_um}}, count);
        check_quadrature(GaussianResponse{Micrometres{at_um}, Micrometres{width_um}}, count);
        check_quadrature(
            TabulatedResponse{
                Curve{{at_um - width_um, at_um, at_um + width_um}, {0.0, 1.0, 0.0}, Outside::zero}},
            count);
      }
    }
  }
}

TEST_CASE("a response narrower than 1e-9 of its wavelength is refused, not rounded away",
          "[hard][spectra]") {
  for (const double width_um : {1e-9, 1e-12, 1e-300}) {
    CHECK_THROWS_AS(gauss_quadrature(GaussianResponse{10.0_um, Micrometres{width_um}}, 4),
                    InputError);
    CHECK_THROWS_AS(gauss_quadrature(BoxResponse{10.0_um, Micrometres{10.0 + width_um}}, 4),
                    InputError);
  }
}

TEST_CASE("a laser line's band sees the radiance at the line, as a radiance per um",
          "[hard][spectra]") {
  const BandQuadrature laser =
      gauss_quadrature(GaussianResponse{Micrometres{1.06415}, Micrometres{1e-7}}, 4);
  double radiance = 0.0;
  for (std::size_t i = 0; i < laser.weights.size(); ++i) {
    radiance += laser.weights[i] * planck(laser.wavelengths[i], 6000.0_K).value;
  }
  CHECK(radiance == Approx(planck(Micrometres{1.06415}, 6000.0_K).value).epsilon(1e-9));
}

TEST_CASE("a response without width, without a positive value or with NaN is refused",
          "[hard][spectra]") {
  const double nothing = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const nadir::support::WithoutTraps compares_nan;
  CHECK_THROWS_AS(check(BoxResponse{0.5_um, 0.5_um}), InputError);
  CHECK_THROWS_AS(check(BoxResponse{0.5_um, 0.4_um}), InputError);
  CHECK_THROWS_AS(check(BoxResponse{Micrometres{nothing}, 0.4_um}), InputError);
  CHECK_THROWS_AS(check(BoxResponse{0.5_um, Micrometres{infinite}}), InputError);
  CHECK_THROWS_AS(check(GaussianResponse{0.5_um, Micrometres{0.0}}), InputError);
  CHECK_THROWS_AS(check(GaussianResponse{0.5_um, Micrometres{nothing}}), InputError);
  CHECK_THROWS_AS(check(TabulatedResponse{Curve{{0.4, 0.5}, {0.0, 0.0}, Outside::zero}}),
                  InputError);
  CHECK_THROWS_AS(check(TabulatedResponse{Curve::constant(1.0)}), InputError);
  CHECK_THROWS_AS((Curve{{0.4, 0.5}, {0.0, nothing}, Outside::zero}), InputError);
  CHECK_THROWS_AS((Curve{{0.4, 0.4}, {0.0, 1.0}, Outside::zero}), InputError);
  CHECK_THROWS_AS((Curve{{0.4, infinite}, {0.0, 1.0}, Outside::zero}), InputError);
}

TEST_CASE("a spectrum that ends at the band's edge covers the band, one ulp less does not",
          "[hard][spectra]") {
  const Curve exact{{0.4, 0.7}, {0.1, 0.4}, Outside::reject};
  CHECK(exact.covers(0.4_um, 0.7_um));
  CHECK(exact.at(0.4_um) == 0.1);
  CHECK(exact.at(0.7_um) == 0.4);
  CHECK_FALSE(exact.covers(Micrometres{std::nextafter(0.4, 0.0)}, 0.7_um));
  CHECK_FALSE(exact.covers(0.4_um, Micrometres{std::nextafter(0.7, 1.0)}));
  CHECK(std::isnan(exact.at(Micrometres{std::nextafter(0.7, 1.0)})));
  CHECK_NOTHROW(at_all(exact, Lanes{{0.4_um, 0.7_um}}, "reflectance"));
  CHECK_THROWS_AS(at_all(exact, Lanes{{0.4_um, Micrometres{std::nextafter(0.7, 1.0)}}}, "it"),
                  InputError);
  // Every node of a band's quadrature lies inside the band.
  for (const int count : {1, 2, 16, 32}) {
    const BandQuadrature band = gauss_quadrature(BoxResponse{0.4_um, 0.7_um}, count);
    CHECK_NOTHROW(at_all(exact, Lanes{band.wavelengths}, "reflectance"));
  }
}

TEST_CASE("a line in a light's spectrum keeps its energy in a mean over any interval",
          "[hard][spectra]") {
  // A line 1e-6 um wide, of area 1, in a table with steps of 0.1 um.
  const double w = 1e-6;
  const Curve line{{0.4, 0.5, 0.5 + w, 0.5 + 2.0 * w, 0.6}, {0, 0, 1 / w, 0, 0}, Outside::zero};
  CHECK(line.mean(0.4_um, 0.6_um) * 0.2 == Approx(1.0).epsilon(1e-9));  // digits: w against 0.5
  CHECK(line.mean(0.5_um, Micrometres{0.5 + 2.0 * w}) * 2.0 * w == Approx(1.0).epsilon(1e-9));
  CHECK(line.mean(0.41_um, 0.49_um) == 0.0);
}

TEST_CASE("a table with steps as small as doubles allow is read without a division by zero",
          "[hard][spectra]") {
  const double a = 0.5, b = std::nextafter(a, 1.0), c = std::nextafter(b, 1.0);
  const Curve step{{a, b, c}, {0.0, 1.0, 0.0}, Outside::hold};
  for (const double at : {a, b, c}) CHECK(std::isfinite(step.at(Micrometres{at})));
  CHECK(step.at(Micrometres{b}) == 1.0);
  const double mean = step.mean(Micrometres{a}, Micrometres{c});
  CHECK(mean >= 0.0);
  CHECK(mean <= 1.0);
  const Curve fine{{a, a + 1e-12, a + 2e-12}, {0.0, 1.0, 0.0}, Outside::hold};
  // A step of 1e-12 is 9007 of the doubles here: its middle is off by one of them at most.
  CHECK(fine.mean(Micrometres{a}, Micrometres{a + 2e-12}) == Approx(0.5).epsilon(1e-3));
}

TEST_CASE("a band's light can be drawn from any response: quantiles ascend and stay inside",
          "[hard][spectra]") {
  for (const double width_um : {1e-9, 1e-3, 5.0}) {
    const Response box = BoxResponse{9.0_um, Micrometres{9.0 + width_um}};
    const sensor::WavelengthQuantiles quantiles{box};
    double before = 9.0;
    for (const double share : {0.0, 1e-300, 0.25, 0.5, 0.999999999, 1.0}) {
      const double at = quantiles.at(share);
      CAPTURE(width_um, share);
      CHECK(at >= before);
      CHECK(at <= 9.0 + width_um);
      before = at;
    }
  }
}

TEST_CASE("a pixel of bands narrower than their material's table has its material's radiance",
          "[hard][spectra]") {
  // Steps of 0.5 um in the table; lanes 1e-7 um apart about its corner.
  materials::Material material;
  material.name = "corner";
  material.reflectance = Curve{{0.5, 1.0, 1.5}, {0.1, 0.9, 0.1}, Outside::reject};
  const Lanes lanes{{Micrometres{1.0 - 1e-7}, 1.0_um, Micrometres{1.0 + 1e-7}}};
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 10.0, 10.0}, scene.material(material, Kelvin{0.0}));
    scene.sky(2.0);
    const auto seen = hard_measure(scene.build(), lanes, downward(), 4, 4);
    CAPTURE(name_of(method));
    check_right(seen, {1.8, 1.8, 1.8}, 2e-6);
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
