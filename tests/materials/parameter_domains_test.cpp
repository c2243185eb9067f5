#include "materials/scattering/parameter_domains.hpp"

#include <limits>

#include "materials/bound_one.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::materials;
using spectral::Curve;

namespace {

std::string refused(const Scattering& model) {
  const spectral::Lanes lanes{{0.5_um, 2.0_um}};
  const spectral::Spectrum none{2};
  return support::refusal([&] { check_parameters(model, {lanes, none, none}); });
}

}  // namespace

TEST_CASE("every model accepts its defaults", "[materials][scattering]") {
  CHECK(refused(Lambertian{}) == "no error");
  CHECK(refused(OrenNayar{}) == "no error");
  CHECK(refused(Minnaert{}) == "no error");
  CHECK(refused(Leaf{}) == "no error");
  CHECK(refused(Mirror{}) == "no error");
  CHECK(refused(ClearSheet{}) == "no error");
  CHECK(refused(Ward{}) == "no error");
  CHECK(refused(Microfacet{}) == "no error");
  CHECK(refused(PriestGermer{}) == "no error");
  CHECK(refused(CoxMunk{}) == "no error");
  CHECK(refused(RossLi{}) == "no error");
  CHECK(refused(RahmanPintyVerstraete{}) == "no error");
  CHECK(refused(Hapke{}) == "no error");
}

TEST_CASE("a parameter out of its domain is named with its value and range",
          "[materials][scattering]") {
  CHECK(refused(OrenNayar{1.75}) ==
        "error: oren_nayar: slope_sigma_rad is 1.75; it must be in [0, 1.5707963267948966)\n");
  CHECK(refused(Minnaert{-0.5}) == "error: minnaert: k is -0.5; it must be in [0, 3]\n");
  CHECK(refused(Minnaert{std::numeric_limits<double>::quiet_NaN()}) ==
        "error: minnaert: k is nan; it must be in [0, 3]\n");
  CHECK(refused(Mirror{{}, Curve::constant(2.0)}) == "error: mirror: k is given without n\n");
  CHECK(refused(Mirror{Curve::constant(0.0), {}}) ==
        "error: mirror: n is 0 at 0.5 um; it must be in [0.01, 100]\n");
  CHECK(refused(ClearSheet{{}, Curve::constant(1.0)}) ==
        "error: clear_sheet: absorption is given without n; without n the material's reflectance "
        "and transmittance say all\n");
  CHECK(refused(Microfacet{.k = Curve::constant(1.0), .transmits = true}) ==
        "error: microfacet: k is 1 at 0.5 um; it must be in [0, 0]\n");
  CHECK(refused(PriestGermer{.slope_sigma = 2.0}) ==
        "error: priest_germer: slope_sigma is 2; it must be in [1e-04, 1]\n");
  CHECK(refused(CoxMunk{.wind_speed_m_s = 25.0}) ==
        "error: cox_munk: wind_speed_m_s is 25; it must be in [0, 20]\n");
  CHECK(refused(RossLi{.geometric = Curve::constant(-0.25)}) ==
        "error: ross_li: geometric is -0.25 at 0.5 um; it must be in [0, 10]\n");
  CHECK(refused(RahmanPintyVerstraete{.asymmetry = Curve::constant(1.0), .rho_c = {}}) ==
        "error: rahman_pinty_verstraete: asymmetry is 1 at 0.5 um; it must be in (-1, 1)\n");
  CHECK(refused(Hapke{.asymmetry_b = 1.0}) ==
        "error: hapke: asymmetry_b is 1; it must be in [0, 1)\n");
  CHECK(refused(Measured{}) == "error: measured: no table is given\n");
}

TEST_CASE("all mistakes of a model are told at once", "[materials][scattering]") {
  CHECK(refused(Ward{Curve::constant(2.0), 0.0, 0.1, 90.0}) ==
        "error: ward: specular is 2 at 0.5 um; it must be in [0, 1]\n"
        "error: ward: alpha_x is 0; it must be in [1e-04, 1]\n"
        "error: ward: azimuth_rad is 90; it must be in [-6.283185307179586, 6.283185307179586]\n");
}
