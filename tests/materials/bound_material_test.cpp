#include "materials/bound_material.hpp"

#include <string>

#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using materials::Material;
using spectral::Curve;
using spectral::Lanes;
using spectral::Outside;

namespace {

const Lanes day_and_night{{0.5_um, 2.0_um, 10.0_um}};

Material reflecting(Curve reflectance) {
  Material material;
  material.name = "brick";
  material.reflectance = std::move(reflectance);
  return material;
}

Material emitting(Curve emissivity) {
  Material material;
  material.name = "brick";
  material.emissivity = std::move(emissivity);
  return material;
}

std::string error_of(const Material& material) {
  Diagnostics diagnostics;
  try {
    (void)materials::bind(material, day_and_night, diagnostics);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

// Lanes are floats: 1 - x is exact to half a unit in the last place of 1, 6e-8.
constexpr double float_rounding = 6e-8;

TEST_CASE("emissivity and reflectance of an opaque surface add to one", "[materials]") {
  const Curve curve{{0.4, 1.0, 14.0}, {0.0, 0.3, 1.0}, Outside::reject};
  Diagnostics diagnostics;
  const auto from_reflectance = bind(reflecting(curve), day_and_night, diagnostics);
  const auto from_emissivity = bind(emitting(curve), day_and_night, diagnostics);
  for (int lane = 0; lane < 3; ++lane) {
    CAPTURE(lane);
    const double expected = curve.at(day_and_night[lane]);
    CHECK(from_reflectance.reflectance[lane] == Approx(expected).margin(float_rounding));
    CHECK(from_reflectance.emissivity[lane] == Approx(1.0 - expected).margin(float_rounding));
    CHECK(from_emissivity.emissivity[lane] == Approx(expected).margin(float_rounding));
    CHECK(from_emissivity.reflectance[lane] == Approx(1.0 - expected).margin(float_rounding));
  }
  CHECK(from_reflectance.max_reflectance == from_reflectance.reflectance[2]);
  CHECK(from_emissivity.max_reflectance == from_emissivity.reflectance[0]);
  CHECK(diagnostics.messages().empty());
}

TEST_CASE("black and white stay exactly black and white", "[materials]") {
  const double value = GENERATE(0.0, 1.0);
  Diagnostics diagnostics;
  const auto bound = bind(reflecting(Curve::constant(value)), day_and_night, diagnostics);
  for (int lane = 0; lane < 3; ++lane) {
    CHECK(bound.reflectance[lane] == static_cast<float>(value));
    CHECK(bound.emissivity[lane] == static_cast<float>(1.0 - value));
  }
}

TEST_CASE("both curves are kept where both are given", "[materials]") {
  Material material = reflecting(Curve::constant(0.3));
  material.emissivity = Curve::constant(0.6);  // the rest is transmitted: no excess
  Diagnostics diagnostics;
  const auto bound = bind(material, day_and_night, diagnostics);
  CHECK(bound.reflectance[1] == 0.3F);
  CHECK(bound.emissivity[1] == 0.6F);
  CHECK(diagnostics.messages().empty());
}

TEST_CASE("each curve fills the wavelengths where the other is not tabulated", "[materials]") {
  Material material = reflecting({{0.4, 2.5}, {0.25, 0.25}, Outside::hold});
  material.emissivity = Curve{{8.0, 14.0}, {0.96, 0.96}, Outside::hold};
  Diagnostics diagnostics;
  const auto bound = bind(material, day_and_night, diagnostics);
  CHECK(bound.reflectance[0] == 0.25F);
  CHECK(bound.emissivity[0] == 0.75F);
  CHECK(bound.reflectance[2] == Approx(0.04).margin(float_rounding));
  CHECK(bound.emissivity[2] == 0.96F);
  CHECK(diagnostics.messages().empty());
}

TEST_CASE("a held curve that does not reach the lanes is reported once", "[materials]") {
  Diagnostics diagnostics;
  const auto bound =
      bind(reflecting({{0.42, 2.5}, {0.1, 0.4}, Outside::hold}), day_and_night, diagnostics);
  CHECK(bound.reflectance[2] == 0.4F);
  CHECK(bound.emissivity[2] == Approx(0.6).margin(float_rounding));
  REQUIRE(diagnostics.messages().size() == 1);
  CHECK(diagnostics.messages()[0] ==
        "material \"brick\": reflectance is tabulated from 0.42 to 2.5 um, the simulated "
        "wavelengths are 0.5 to 10 um; it is extrapolated");
}

TEST_CASE("a surface that would create energy is reported", "[materials]") {
  Material material = reflecting({{0.4, 14.0}, {0.5, 0.0}, Outside::reject});
  material.emissivity = Curve::constant(0.75);
  Diagnostics diagnostics;
  (void)bind(material, Lanes{{0.4_um, 14.0_um}}, diagnostics);
  REQUIRE(diagnostics.messages().size() == 1);
  CHECK(diagnostics.messages()[0] ==
        "material \"brick\": reflectance + emissivity is 1.25 at 0.4 um; more than 1 creates "
        "energy");
}

TEST_CASE("a material that cannot be bound says why", "[materials]") {
  CHECK(error_of(reflecting({{0.42, 2.5}, {0.1, 0.4}, Outside::reject})) ==
        "error: material \"brick\": reflectance is tabulated from 0.42 to 2.5 um, the simulated "
        "wavelengths are 0.5 to 10 um\n");
  CHECK(error_of(emitting({{8.0, 14.0}, {0.9, 0.9}, Outside::reject})) ==
        "error: material \"brick\": emissivity is tabulated from 8 to 14 um, the simulated "
        "wavelengths are 0.5 to 10 um\n");

  Material nothing;
  nothing.name = "void";
  CHECK(error_of(nothing) ==
        "error: material \"void\": neither reflectance nor emissivity is given\n");

  Material wrong = reflecting({{0.4, 14.0}, {-0.1, 1.5}, Outside::hold});
  wrong.emissivity = Curve::constant(2.0);
  CHECK(error_of(wrong) ==
        "error: material \"brick\": reflectance is from -0.1 to 1.5; it must be from 0 to 1\n"
        "error: material \"brick\": emissivity is 2; it must be from 0 to 1\n");
}
