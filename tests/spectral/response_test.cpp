#include "spectral/response.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::literals;
using namespace nadir::spectral;

namespace {

Response table(std::vector<double> wavelength_um, std::vector<double> value) {
  return TabulatedResponse{Curve{std::move(wavelength_um), std::move(value), Outside::zero}};
}

std::string message(const Response& response) {
  try {
    check(response);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a box response is 1 between its limits", "[spectral][response]") {
  const Response box = BoxResponse{8.0_um, 12.5_um};
  CHECK(at(box, 8.0_um) == 1.0);
  CHECK(at(box, 12.5_um) == 1.0);
  CHECK(at(box, 7.99_um) == 0.0);
  CHECK(at(box, 12.51_um) == 0.0);
  CHECK(support(box).lo == 8.0_um);
  CHECK(support(box).hi == 12.5_um);
  CHECK(centre(box) == 10.25_um);
  CHECK(fwhm(box) == 4.5_um);
}

// 10^-4 is reached at sqrt(ln(10^4) / (4 ln 2)) = 1.8226 fwhm from the centre.
TEST_CASE("a Gaussian response has its width and is cut at 1e-4", "[spectral][response]") {
  const Response gauss = GaussianResponse{10.9_um, 0.6_um};
  CHECK(at(gauss, 10.9_um) == 1.0);
  CHECK(at(gauss, 11.2_um) == Approx(0.5).epsilon(1e-13));
  CHECK(at(gauss, 10.6_um) == Approx(0.5).epsilon(1e-13));
  CHECK(at(gauss, 11.5_um) == Approx(1.0 / 16.0).epsilon(1e-13));
  const Support s = support(gauss);
  CHECK((s.hi - 10.9_um).value == Approx(1.8226 * 0.6).epsilon(3e-5));
  CHECK(((s.hi - 10.9_um) - (10.9_um - s.lo)).value == Approx(0.0).margin(4e-15));
  CHECK(at(gauss, s.hi - Micrometres{1e-9}) == Approx(1e-4).epsilon(1e-6));
  CHECK(at(gauss, s.hi + Micrometres{1e-9}) == 0.0);
  CHECK(at(gauss, s.lo - Micrometres{1e-9}) == 0.0);
  CHECK(centre(gauss) == 10.9_um);
  CHECK(fwhm(gauss) == 0.6_um);
}

TEST_CASE("a tabulated response is supported between the zeros that enclose it",
          "[spectral][response]") {
  const Response r = table({1, 2, 3, 4, 5, 6}, {0, 0, 0.5, 1, 0, 0});
  CHECK(support(r).lo == 2.0_um);
  CHECK(support(r).hi == 5.0_um);
  CHECK(at(r, 2.5_um) == 0.25);
  CHECK(at(r, 0.5_um) == 0.0);
  // A table that does not go down to 0 ends where it ends, whatever its curve says outside.
  const Response cut = TabulatedResponse{Curve{{1, 2}, {1, 1}, Outside::hold}};
  CHECK(support(cut).lo == 1.0_um);
  CHECK(support(cut).hi == 2.0_um);
  CHECK(at(cut, 2.1_um) == 0.0);
  CHECK(support(table({1, 2, 3}, {0, 0, 1})).lo == 2.0_um);
  CHECK(support(table({1, 2, 3}, {1, 0, 0})).hi == 2.0_um);
}

// Closed forms: the centroid of a triangle is the mean of its corners; a trapezium on [0, 3] above
// 1 with its flat top on [1, 2] is symmetric; half of any straight flank is reached in its middle.
TEST_CASE("centre and width of tabulated shapes have closed forms", "[spectral][response]") {
  const Response triangle = table({1.0, 2.0, 5.0}, {0.0, 0.3, 0.0});
  CHECK(centre(triangle).value == Approx(8.0 / 3.0).epsilon(1e-15));
  CHECK(fwhm(triangle).value == Approx(2.0).epsilon(1e-15));
  const Response trapezium = table({1, 2, 3, 4}, {0, 7, 7, 0});
  CHECK(centre(trapezium).value == Approx(2.5).epsilon(1e-15));
  CHECK(fwhm(trapezium).value == Approx(2.0).epsilon(1e-15));
  const Response ramp = table({1, 4}, {0, 1});  // centroid at 2/3, cut off at its peak
  CHECK(centre(ramp).value == Approx(3.0).epsilon(1e-15));
  CHECK(fwhm(ramp).value == Approx(1.5).epsilon(1e-15));
  const Response block = table({2, 3}, {1, 1});
  CHECK(centre(block) == 2.5_um);
  CHECK(fwhm(block) == 1.0_um);
}

TEST_CASE("the width of a double peak spans the outermost crossings", "[spectral][response]") {
  const Response r = table({1, 2, 3, 4, 5}, {0, 1, 0, 0.8, 0});
  // Left flank at 1.5; right flank from 0.8 at 4 to 0 at 5 passes 0.5 at 4.375.
  CHECK(fwhm(r).value == Approx(4.375 - 1.5).epsilon(1e-15));
}

TEST_CASE("responses that no band can have are refused", "[spectral][response]") {
  const Micrometres infinity{std::numeric_limits<double>::infinity()};
  CHECK(message(BoxResponse{8.0_um, 12.0_um}) == "accepted");
  CHECK(message(GaussianResponse{10.0_um, 1.0_um}) == "accepted");
  CHECK(message(table({1, 2}, {0, 1})) == "accepted");
  CHECK(message(BoxResponse{12.0_um, 8.0_um}) ==
        "error: expected positive, ascending limits of a box response, found 12 um and 8 um\n");
  CHECK(message(BoxResponse{0.0_um, 8.0_um}) ==
        "error: expected positive, ascending limits of a box response, found 0 um and 8 um\n");
  CHECK(message(BoxResponse{8.0_um, infinity}) ==
        "error: expected positive, ascending limits of a box response, found 8 um and inf um\n");
  CHECK(message(GaussianResponse{10.0_um, 0.0_um}) ==
        "error: expected a positive full width at half maximum, found 0 um\n");
  CHECK_THAT(message(GaussianResponse{1.0_um, 1.0_um}),
             Catch::Matchers::StartsWith("error: expected a Gaussian response at positive "
                                         "wavelengths, found one from -0.82"));
  CHECK(message(table({1, 2}, {0, 0})) ==
        "error: expected a response above 0 somewhere, found 0 at every wavelength\n");
  CHECK(message(table({1, 2}, {-0.1, 1})) ==
        "error: expected a response of at least 0, found -0.1\n");
  CHECK(message(TabulatedResponse{Curve::constant(1.0)}) ==
        "error: expected a response with limits, found one that is the same everywhere\n");
}
