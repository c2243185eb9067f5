// Means of a material's spectra over sunlight and over a black body at 300 K.
#include "thermal/surface/broadband_optics.hpp"

#include <cmath>
#include <numbers>

#include "core/constants.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

namespace nadir::thermal {
namespace {

using materials::Material;
using spectral::Curve;
using spectral::Outside;

const Curve flat_sun{{0.3, 4.0}, {100.0, 100.0}, Outside::zero};

Material reflecting(Curve curve) {
  Material material;
  material.name = "plate";
  material.reflectance = std::move(curve);
  return material;
}

/// Share of a black body's radiance at 300 K.
double black_share(double lo_um, double hi_um) {
  return spectral::planck_band(Micrometres{lo_um}, Micrometres{hi_um}, 300.0_K).value *
         std::numbers::pi / (si::stefan_boltzmann * std::pow(300.0, 4));
}

// Lanes are floats.
constexpr double float_rounding = 1e-6;

}  // namespace

TEST_CASE("constant spectra are their own means, and Kirchhoff's law holds", "[thermal][optics]") {
  const double value = GENERATE(0.0, 0.3, 1.0);
  const BroadbandOptics optics = broadband_optics(reflecting(Curve::constant(value)), flat_sun);
  CHECK(optics.solar_reflectance == Approx(value).margin(float_rounding));
  CHECK(optics.solar_transmittance == 0.0);
  CHECK(optics.solar_absorptance == Approx(1.0 - value).margin(float_rounding));
  CHECK(optics.emissivity == Approx(1.0 - value).margin(float_rounding));
  CHECK(optics.solar_covered == Approx(1.0).epsilon(1e-9));
  CHECK(optics.long_wave_covered == Approx(1.0).epsilon(1e-9));
}

TEST_CASE("sunlight weighs the spectrum", "[thermal][optics]") {
  // Reflectance grows linearly from 0 at 0.3 um to 0.74 at 4 um: 0.2 (x - 0.3).
  const Curve slope{{0.3, 4.0}, {0.0, 0.74}, Outside::reject};
  // Even light: the middle. The midpoint rule is exact for a straight line.
  CHECK(broadband_optics(reflecting(slope), flat_sun).solar_reflectance ==
        Approx(0.37).margin(float_rounding));
  // Light that falls off linearly to 0 at 4 um: int (1 - s) s ds / int (1 - s) ds = 1/3 of 0.74.
  // The midpoint rule over 128 cells is within (0.02)^2.
  const Curve falling{{0.3, 4.0}, {100.0, 0.0}, Outside::zero};
  CHECK(broadband_optics(reflecting(slope), falling).solar_reflectance ==
        Approx(0.74 / 3.0).epsilon(4e-4));
}

TEST_CASE("the scale of sunlight does not matter", "[thermal][optics]") {
  const Curve slope{{0.3, 4.0}, {0.1, 0.8}, Outside::reject};
  const Curve dim{{0.3, 1.0, 4.0}, {1e-3, 2e-3, 1e-4}, Outside::zero};
  const Curve bright{{0.3, 1.0, 4.0}, {10.0, 20.0, 1.0}, Outside::zero};
  CHECK(broadband_optics(reflecting(slope), dim).solar_absorptance ==
        Approx(broadband_optics(reflecting(slope), bright).solar_absorptance).epsilon(1e-12));
}

TEST_CASE("emissivity is weighted with Planck's law", "[thermal][optics]") {
  // A selective surface: reflects all beyond 8 um, nothing before 7.98 um.
  const Curve step{{0.3, 7.98, 8.0, 100.0}, {0.0, 0.0, 1.0, 1.0}, Outside::reject};
  const BroadbandOptics optics = broadband_optics(reflecting(step), flat_sun);
  // 3 to 8 um hold 14.0 % of what a black body at 300 K radiates from 3 to 100 um. The step falls
  // into a cell of 0.45 um, which holds 1.5 %.
  const double expected = black_share(3.0, 7.99) / black_share(3.0, 100.0);
  CHECK(optics.emissivity == Approx(expected).margin(0.015));
  CHECK(optics.solar_absorptance == Approx(1.0).margin(float_rounding));
}

TEST_CASE("a stated emissivity counts beside a reflectance of sunlight", "[thermal][optics]") {
  Material material = reflecting(Curve{{0.3, 2.5}, {0.2, 0.2}, Outside::hold});
  material.emissivity = Curve{{8.0, 14.0}, {0.9, 0.9}, Outside::hold};
  const BroadbandOptics optics = broadband_optics(material, flat_sun);
  CHECK(optics.solar_reflectance == Approx(0.2).margin(float_rounding));
  CHECK(optics.emissivity == Approx(0.9).margin(float_rounding));
  // Cells at the edges count with their middles: 2 % of 2.5 um, 5.6 % of 8 and 14 um.
  CHECK(optics.solar_covered == Approx(2.2 / 3.7).margin(0.02));
  CHECK(optics.long_wave_covered == Approx(black_share(8.0, 14.0)).margin(0.04));
}

TEST_CASE("spectra of one end of the spectrum say nothing of the other", "[thermal][optics]") {
  const BroadbandOptics day =
      broadband_optics(reflecting(Curve{{0.3, 2.5}, {0.4, 0.4}, Outside::hold}), flat_sun);
  CHECK(day.solar_absorptance == Approx(0.6).margin(float_rounding));
  CHECK(day.long_wave_covered == 0.0);
  CHECK(day.emissivity == 0.0);
  const BroadbandOptics night =
      broadband_optics(reflecting(Curve{{8.0, 14.0}, {0.4, 0.4}, Outside::reject}), flat_sun);
  CHECK(night.solar_covered == 0.0);
  CHECK(night.solar_absorptance == 0.0);
  CHECK(night.emissivity == Approx(0.6).margin(float_rounding));
}

TEST_CASE("what goes through is neither absorbed nor reflected", "[thermal][optics]") {
  Material leaf = reflecting(Curve::constant(0.3));
  leaf.transmittance = Curve::constant(0.25);
  leaf.scattering = materials::Leaf{};
  const BroadbandOptics optics = broadband_optics(leaf, flat_sun);
  CHECK(optics.solar_transmittance == Approx(0.25).margin(float_rounding));
  CHECK(optics.solar_absorptance == Approx(0.45).margin(float_rounding));
  CHECK(optics.emissivity == Approx(0.45).margin(float_rounding));
}

TEST_CASE("a model's own spectra end where they end", "[thermal][optics]") {
  Material pond;
  pond.name = "pond";
  materials::Mirror water;
  water.n = Curve{{0.3, 20.0}, {1.33, 1.33}, Outside::reject};
  water.k = Curve{{0.3, 14.0}, {0.0, 0.0}, Outside::reject};
  pond.scattering = water;
  const BroadbandOptics optics = broadband_optics(pond, flat_sun);
  CHECK(optics.solar_covered == Approx(1.0).epsilon(1e-9));
  // The cell of 5.6 % at 14 um counts with its middle.
  CHECK(optics.long_wave_covered == Approx(black_share(3.0, 14.0)).margin(0.02));
  // Fresnel at 45 degrees, the mean of both polarisations.
  const double c = std::sqrt(0.5), t = std::sqrt(1.0 - 0.5 / (1.33 * 1.33));
  const double s_wave = (c - 1.33 * t) / (c + 1.33 * t), p_wave = (1.33 * c - t) / (1.33 * c + t);
  const double fresnel = 0.5 * (s_wave * s_wave + p_wave * p_wave);
  CHECK(optics.solar_reflectance == Approx(fresnel).epsilon(1e-5));
  CHECK(optics.emissivity == Approx(1.0 - fresnel).epsilon(1e-5));
}

TEST_CASE("figures that a model refuses at some wavelengths count as unknown there",
          "[thermal][optics]") {
  Material metal;
  metal.name = "metal";
  materials::Mirror mirror;
  mirror.n = Curve{{0.3, 12.0, 100.0}, {1.5, 1.5, 1.5}, Outside::reject};
  mirror.k = Curve{{0.3, 12.0, 100.0}, {9.0, 9.0, 500.0}, Outside::reject};  // domain: up to 100
  metal.scattering = mirror;
  const BroadbandOptics optics = broadband_optics(metal, flat_sun);
  CHECK(optics.solar_covered == Approx(1.0).epsilon(1e-9));
  CHECK(optics.long_wave_covered > 0.4);
  CHECK(optics.long_wave_covered < 0.9);
  CHECK(optics.emissivity > 0.0);
}

TEST_CASE("parts of a mixture must all be known", "[thermal][optics]") {
  Material mixed;
  mixed.name = "mixed";
  const auto part = [](double value, double hi_um) {
    return std::make_shared<const Material>(
        reflecting(Curve{{0.3, hi_um}, {value, value}, Outside::hold}));
  };
  mixed.scattering = materials::Mixture{{{0.25, part(0.8, 4.0)}, {0.75, part(0.4, 1.0)}}};
  const BroadbandOptics optics = broadband_optics(mixed, flat_sun);
  CHECK(optics.solar_reflectance == Approx(0.25 * 0.8 + 0.75 * 0.4).margin(float_rounding));
  CHECK(optics.solar_covered == Approx(0.7 / 3.7).margin(0.01));
}

TEST_CASE("a sun that is one number counts from 0.28 to 4 um", "[thermal][optics]") {
  const BroadbandOptics optics = broadband_optics(
      reflecting(Curve{{0.28, 4.0}, {0.0, 1.0}, Outside::reject}), Curve::constant(5.0));
  CHECK(optics.solar_reflectance == Approx(0.5).margin(float_rounding));
  CHECK(optics.solar_covered == Approx(1.0).epsilon(1e-9));
}

}  // namespace nadir::thermal
