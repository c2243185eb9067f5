#include "sim/plan/wavelength_choice.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "sim/plan/surface_spectra.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

// How many wavelengths a band needs, by closed forms and by spectra that are hard.

namespace nadir::test {
namespace {

using sim::BandErrors;
using sim::BandLight;
using spectral::BoxResponse;
using spectral::Response;

Response box(double lo_um, double hi_um) {
  return BoxResponse{Micrometres{lo_um}, Micrometres{hi_um}};
}

/// One pixel that sees one product of functions, known at nodes.
BandLight seen_wavelength_choice(std::vector<sim::SpectralFunction> functions) {
  BandLight light;
  light.functions = std::move(functions);
  light.products.emplace_back();
  for (std::size_t i = 0; i < light.functions.size(); ++i) {
    light.products[0].at_nodes.push_back(i);
  }
  light.pixels = {{{0}}};
  return light;
}

int count_for(const Response& response, const BandLight& light, double share) {
  BandErrors errors{response, light};
  return sim::choose_count(errors, share).count;
}

/// Reflectance of leaves about 0.72 um: a step of 5 to 50 % that is 0.02 um wide.
double red_edge(double lambda_um) {
  return 0.05 + 0.45 / (1.0 + std::exp(-(lambda_um - 0.72) / 0.005));
}

}  // namespace

TEST_CASE("as many wavelengths as a polynomial needs are chosen", "[sim][wavelengths]") {
  // n nodes integrate degree 2 n - 1: x^d over [1, 2] needs ceil((d + 1) / 2).
  const int degree = GENERATE(0, 1, 2, 3, 6, 7, 11);
  const auto light = seen_wavelength_choice({[degree](double x) { return std::pow(x, degree); }});
  CAPTURE(degree);
  // The trapezoid rule of the dense grid is good to (degree / 400)^2 / 12 = 6e-5; the error of one
  // node less is above 5e-4 up to degree 7, and for degree 11 above 1e-4.
  if (degree <= 3) CHECK(count_for(box(1.0, 2.0), light, 1e-4) == (degree + 2) / 2);
  CHECK(count_for(box(1.0, 2.0), light, 1e-4) <= (degree + 2) / 2);
}

TEST_CASE("the error of one wavelength is that of the midpoint rule", "[sim][wavelengths]") {
  // f = 1 + a (x - 1.5)^2 over [1, 2]: mean 1 + a / 12, at the middle 1.
  const auto light =
      seen_wavelength_choice({[](double x) { return 1.0 + 3.0 * (x - 1.5) * (x - 1.5); }});
  const Response response = box(1.0, 2.0);
  BandErrors errors{response, light};
  CHECK(errors.means()[0] == Approx(1.25).epsilon(1e-5));          // trapezoid: a h^2 / 6 = 3e-6
  CHECK(errors.of(1) == Approx(0.25 / 1.25).epsilon(1e-4));        // likewise
  CHECK(errors.of(2) < 1e-5);                                      // exact for cubics
  CHECK(errors.stated(1) == Approx(errors.of(1)).epsilon(1e-12));  // the larger of one and two
  CHECK(errors.stated(32) < 1e-5);
}

TEST_CASE("what is right by chance is not relied upon", "[sim][wavelengths]") {
  // An odd cubic bump about the middle: one node sees its mean exactly, two see a wrong one.
  const auto light = seen_wavelength_choice({[](double x) {
    const double y = 2.0 * x - 3.0;                        // -1 .. 1
    return 2.0 + std::cos(std::numbers::pi * 1.4303 * y);  // sin(k) / k = cos(0) - 1.217
  }});
  const Response response = box(1.0, 2.0);
  BandErrors errors{response, light};
  for (int n = 1; n < 8; ++n) {
    CHECK(errors.stated(n) >= errors.of(n));
    CHECK(errors.stated(n) >= errors.of(n + 1));
  }
}

TEST_CASE("means over intervals see what lies between nodes", "[sim][wavelengths]") {
  // A line of 1 nm in a band of 100 nm: nodes miss it or hit it; means over intervals sum to its
  // integral exactly where the rest is flat and the response is a box.
  BandLight light;
  light.functions = {[](double x) { return std::abs(x - 0.5503) < 0.0005 ? 0.0 : 1.0; }};
  light.knots_um = {0.5497, 0.5498, 0.54981, 0.5508, 0.55079, 0.5509};
  light.products = {{{}, {0}}, {{0}, {}}};
  light.pixels = {{{0}}};
  const Response response = box(0.5, 0.6);
  BandErrors intervals{response, light};
  for (const int n : {1, 2, 5, 16}) CHECK(intervals.of(n) < 1e-9);
  light.pixels = {{{1}}};
  BandErrors nodes{response, light};
  CHECK(nodes.of(4) == Approx(0.01).epsilon(0.1));  // the line's share, all of which is missed
}

TEST_CASE("a node's value counts times the mean of its interval", "[sim][wavelengths]") {
  // x known at nodes times x known by intervals, over [1, 2] with three of Gauss's nodes: the
  // intervals are cut where 5/18 and 13/18 of the band are.
  BandLight light;
  light.functions = {[](double x) { return x; }};
  light.products = {{{0}, {0}}};
  light.pixels = {{{0}}};
  const Response response = box(1.0, 2.0);
  BandErrors errors{response, light};
  const double node = 0.5 * std::sqrt(0.6), mean = 0.5 - 2.5 / 18.0;  // from the middle
  const double three = 5.0 / 18.0 * ((1.5 - node) * (1.5 - mean) + (1.5 + node) * (1.5 + mean)) +
                       4.0 / 9.0 * 1.5 * 1.5;
  // 1e-3 of the error: 6 times what the trapezoid rule leaves of 7/3, h^2 / 6.
  CHECK(errors.of(3) == Approx(1.0 - three * 3.0 / 7.0).epsilon(1e-3));
}

TEST_CASE("Planck's law at 300 K and a red edge get the wavelengths that they need",
          "[sim][wavelengths]") {
  const auto planck = seen_wavelength_choice(
      {[](double x) { return spectral::planck(Micrometres{x}, Kelvin{300.0}).value; }});
  CHECK(count_for(box(8.0, 14.0), planck, 1e-3) == 3);
  CHECK(count_for(box(10.0, 11.0), planck, 2.5e-3) == 1);
  // One node: width^2 / 24 of the second derivative, by differences of Planck's law itself.
  const auto b = [](double x) { return spectral::planck(Micrometres{x}, Kelvin{300.0}).value; };
  const double curvature = (b(10.6) - 2.0 * b(10.5) + b(10.4)) / 0.01;
  const Response response = box(10.0, 11.0);
  BandErrors errors{response, planck};
  CHECK(errors.of(1) == Approx(std::abs(curvature) / 24.0 / b(10.5)).epsilon(0.05));  // 4th order
  const int edge = count_for(box(0.6, 0.9), seen_wavelength_choice({red_edge}), 2.5e-3);
  CHECK(edge >= 5);
  CHECK(edge <= 24);
  CHECK(count_for(box(0.84, 0.9), seen_wavelength_choice({red_edge}), 2.5e-3) == 1);
}

TEST_CASE("dark pixels count against the floor", "[sim][wavelengths]") {
  BandLight light = seen_wavelength_choice({red_edge, [](double) { return 1e-6; }});
  light.functions.emplace_back([](double) { return 1.0; });
  light.products.push_back({{2}, {}});
  light.pixels = {{{0}, 1.0}, {{1}, 1.0}};
  CHECK(count_for(box(0.6, 0.9), light, 2.5e-3) == 1);
  light.pixels[0].floor = 0.0;
  CHECK(count_for(box(0.6, 0.9), light, 2.5e-3) > 4);
}

TEST_CASE("bands that are hard are integrated", "[sim][wavelengths]") {
  const auto flat = seen_wavelength_choice({[](double) { return 0.3; }});
  SECTION("narrower than any spectrum's step") {
    CHECK(count_for(box(0.7199999, 0.7200001), seen_wavelength_choice({red_edge}), 1e-3) == 1);
    CHECK(count_for(box(1.0, 1.0 + 4e-9), flat, 1e-3) == 1);
  }
  SECTION("with a hole in the middle") {
    const Response hole =
        spectral::TabulatedResponse{{{0.60, 0.61, 0.65, 0.66, 0.80, 0.81, 0.89, 0.90},
                                     {0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0},
                                     spectral::Outside::zero}};
    BandLight edge = seen_wavelength_choice({red_edge});
    BandErrors errors{hole, edge};
    const auto chosen = sim::choose_count(errors, 1e-3);
    CHECK(chosen.count >= 2);
    CHECK(chosen.error <= 1e-3);
    edge.products[0] = {{}, {0}};  // intervals may end in the hole
    BandErrors over{hole, edge};
    for (int n = 1; n <= 32; ++n) CHECK(std::isfinite(over.of(n)));
  }
  SECTION("of a table with two wavelengths, and of a Gaussian") {
    const Response ramp =
        spectral::TabulatedResponse{{{0.5, 0.6}, {0.0, 1.0}, spectral::Outside::zero}};
    CHECK(count_for(ramp, flat, 1e-6) == 1);
    const Response bell = spectral::GaussianResponse{Micrometres{0.72}, Micrometres{0.001}};
    CHECK(count_for(bell, seen_wavelength_choice({red_edge}), 1e-3) <= 2);
  }
  SECTION("without any light") {
    const auto dark = seen_wavelength_choice({[](double) { return 0.0; }});
    CHECK(count_for(box(0.5, 0.6), dark, 1e-3) == 1);
    const BandLight nothing;
    CHECK(count_for(box(0.5, 0.6), nothing, 1e-3) == 1);
  }
}

TEST_CASE("what no number of wavelengths can do gets the best there is", "[sim][wavelengths]") {
  // A comb finer than 32 nodes.
  const auto comb =
      seen_wavelength_choice({[](double x) { return std::fmod(x, 0.001) < 0.0002 ? 1.0 : 0.0; }});
  const Response response = box(0.5, 0.6);
  BandErrors errors{response, comb};
  const auto chosen = sim::choose_count(errors, 1e-4);
  CHECK(chosen.error > 1e-4);
  for (int n = 1; n <= 32; ++n) CHECK(chosen.error <= errors.stated(n));
}

TEST_CASE("a material gives the spectra that its light is made of", "[sim][wavelengths]") {
  using materials::Material;
  const auto edge = spectral::Curve{{0.6, 0.7, 0.8}, {0.1, 0.2, 0.6}, spectral::Outside::reject};
  std::vector<double> knots;
  Material leaf;
  leaf.reflectance = edge;
  leaf.transmittance = spectral::Curve::constant(0.3);
  leaf.scattering = materials::Leaf{};
  const auto spectra = sim::surface_spectra(leaf, knots);
  REQUIRE(spectra.size() == 2);
  CHECK(knots == std::vector<double>{0.6, 0.7, 0.8});
  for (const auto& one : spectra) CHECK(one.emits(0.8) == Approx(0.1).epsilon(1e-12));
  CHECK(spectra[1].scatters(0.75) == Approx(0.4).epsilon(1e-12));
  CHECK(spectra[1].scatters(0.5) == Approx(0.1).epsilon(1e-12));  // held at the table's end

  Material paint;  // Kirchhoff's law
  paint.emissivity = spectral::Curve::constant(0.9);
  const auto of_paint = sim::surface_spectra(paint, knots);
  REQUIRE(of_paint.size() == 1);
  CHECK(of_paint[0].scatters(10.0) == Approx(0.1).epsilon(1e-12));

  Material mixture;
  mixture.scattering = materials::Mixture{
      {{0.5, std::make_shared<Material>(leaf)}, {0.5, std::make_shared<Material>(paint)}}};
  CHECK(sim::surface_spectra(mixture, knots).size() == 3);
  Material glass;
  glass.scattering = materials::Microfacet{};
  const auto of_glass = sim::surface_spectra(glass, knots);
  REQUIRE(of_glass.size() == 1);
  CHECK(of_glass[0].scatters(0.5) == Approx(0.04).epsilon(1e-12));  // ((n - 1) / (n + 1))^2
}

}  // namespace nadir::test
