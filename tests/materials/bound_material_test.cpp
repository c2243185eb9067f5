#include "materials/bound_material.hpp"

#include <cmath>
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

/// Directional-hemispherical reflectance for a slanted view.
spectral::Spectrum reflectance(const materials::BoundMaterial& bound) {
  return albedo(bound.scattering, {0.6, 0.0, 0.8}).reflectance;
}
spectral::Spectrum emissivity(const materials::BoundMaterial& bound) {
  return bound.emissivity({0.6, 0.0, 0.8});
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
    CHECK(reflectance(from_reflectance)[lane] == Approx(expected).margin(float_rounding));
    CHECK(emissivity(from_reflectance)[lane] == Approx(1.0 - expected).margin(float_rounding));
    CHECK(emissivity(from_emissivity)[lane] == Approx(expected).margin(float_rounding));
    CHECK(reflectance(from_emissivity)[lane] == Approx(1.0 - expected).margin(float_rounding));
  }
  CHECK(diagnostics.messages().empty());
}

TEST_CASE("black and white stay exactly black and white", "[materials]") {
  const double value = GENERATE(0.0, 1.0);
  Diagnostics diagnostics;
  const auto bound = bind(reflecting(Curve::constant(value)), day_and_night, diagnostics);
  for (int lane = 0; lane < 3; ++lane) {
    CHECK(reflectance(bound)[lane] == static_cast<float>(value));
    CHECK(emissivity(bound)[lane] == static_cast<float>(1.0 - value));
  }
}

TEST_CASE("both curves are kept where both are given", "[materials]") {
  Material material = reflecting(Curve::constant(0.3));
  material.emissivity = Curve::constant(0.6);  // the rest goes nowhere: no excess
  Diagnostics diagnostics;
  const auto bound = bind(material, day_and_night, diagnostics);
  CHECK(reflectance(bound)[1] == 0.3F);
  CHECK(emissivity(bound)[1] == 0.6F);
  CHECK(bound.constant_emissivity);
  CHECK(diagnostics.messages().empty());
}

TEST_CASE("each curve fills the wavelengths where the other is not tabulated", "[materials]") {
  Material material = reflecting({{0.4, 2.5}, {0.25, 0.25}, Outside::hold});
  material.emissivity = Curve{{8.0, 14.0}, {0.96, 0.96}, Outside::hold};
  Diagnostics diagnostics;
  const auto bound = bind(material, day_and_night, diagnostics);
  CHECK(reflectance(bound)[0] == 0.25F);
  CHECK(emissivity(bound)[0] == 0.75F);
  CHECK(reflectance(bound)[2] == Approx(0.04).margin(float_rounding));
  CHECK(emissivity(bound)[2] == 0.96F);
  CHECK(diagnostics.messages().empty());
}

TEST_CASE("a held curve that does not reach the lanes is reported once", "[materials]") {
  Diagnostics diagnostics;
  const auto bound =
      bind(reflecting({{0.42, 2.5}, {0.1, 0.4}, Outside::hold}), day_and_night, diagnostics);
  CHECK(reflectance(bound)[2] == 0.4F);
  CHECK(emissivity(bound)[2] == Approx(0.6).margin(float_rounding));
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

TEST_CASE("a leaf emits what it neither reflects nor lets through", "[materials]") {
  Material leaf = reflecting(Curve::constant(0.3));
  leaf.scattering = materials::Leaf{};
  leaf.transmittance = Curve::constant(0.2);
  Diagnostics diagnostics;
  const auto from_reflectance = bind(leaf, day_and_night, diagnostics);
  CHECK(emissivity(from_reflectance)[0] == Approx(0.5).margin(float_rounding));
  CHECK(from_reflectance.traits.transmits);
  CHECK(from_reflectance.constant_emissivity);

  leaf.reflectance.reset();
  leaf.emissivity = Curve::constant(0.7);
  const auto from_emissivity = bind(leaf, day_and_night, diagnostics);
  CHECK(reflectance(from_emissivity)[2] == Approx(0.1).margin(float_rounding));
}

TEST_CASE("emissivity follows direction where it is not stated", "[materials]") {
  Material rough = reflecting({{0.4, 2.5}, {0.3, 0.3}, Outside::hold});
  rough.emissivity = Curve{{1.0, 2.5, 8.0, 14.0}, {0.6, 0.6, 0.9, 0.9}, Outside::hold};
  rough.scattering = materials::Minnaert{1.5};
  Diagnostics diagnostics;
  const auto bound = bind(rough, day_and_night, diagnostics);
  const Vec3 slanted{0.6, 0.0, 0.8};
  // Minnaert's albedo is rho mu^(k - 1); 1 - x of float lanes
  const double dimmed = std::sqrt(0.8);
  CHECK_FALSE(bound.constant_emissivity);
  CHECK(bound.emissivity(slanted)[0] == Approx(1.0 - 0.3 * dimmed).margin(3e-7));
  CHECK(bound.emissivity(slanted)[1] == 0.6F);  // stated at 2 um
  CHECK(bound.emissivity(slanted)[2] == Approx(1.0 - 0.1 * dimmed).margin(3e-7));
  CHECK(bound.own_emissivity[0] == Approx(0.7).margin(3e-7));
  CHECK(bound.follows_direction[1] == 0.0F);
}

TEST_CASE("a polished metal emits most along its surface but for the very edge", "[materials]") {
  Material gold;
  gold.name = "gold";
  gold.scattering = materials::Mirror{Curve::constant(0.26), Curve::constant(6.8)};
  Diagnostics diagnostics;
  const auto bound = bind(gold, day_and_night, diagnostics);
  const auto at = [&](double mu) {
    return bound.emissivity({std::sqrt(1.0 - mu * mu), 0.0, mu})[0];
  };
  CHECK(at(0.2) > at(1.0));
  CHECK(at(1e-4) < at(1.0));
  CHECK(bound.traits.has_delta);
}

TEST_CASE("curves that a model does not take are refused", "[materials]") {
  Material sea = reflecting(Curve::constant(0.1));
  sea.scattering = materials::CoxMunk{};
  CHECK(error_of(sea) ==
        "error: material \"brick\": reflectance is given, but the scattering model brings its own; "
        "leave out one of the two\n");
  Material opaque = reflecting(Curve::constant(0.1));
  opaque.transmittance = Curve::constant(0.1);
  CHECK(error_of(opaque) ==
        "error: material \"brick\": transmittance is given, but the scattering model lets nothing "
        "through\n");
}

TEST_CASE("more light than arrives is refused at its wavelength", "[materials]") {
  Material leaf = reflecting({{0.4, 0.6, 9.0, 14.0}, {0.5, 0.5, 0.875, 0.875}, Outside::reject});
  leaf.scattering = materials::Leaf{};
  leaf.transmittance = Curve::constant(0.25);
  CHECK(error_of(leaf) ==
        "error: material \"brick\": reflectance + transmittance is 1.125 at 10 um; it "
        "must be at most 1\n");
  leaf.reflectance.reset();
  leaf.emissivity = Curve::constant(0.875);
  CHECK(error_of(leaf) ==
        "error: material \"brick\": emissivity + transmittance is 1.125 at 0.5 um; it must be at "
        "most 1\n");
}

TEST_CASE("what a model refuses is told with the material's name and place", "[materials]") {
  Material shiny = reflecting(Curve::constant(0.1));
  shiny.scattering = materials::Ward{Curve::constant(-0.5), 0.1, 2.0};
  shiny.where = {"scene.xml", 3, 5};
  CHECK(error_of(shiny) ==
        "scene.xml:3:5: error: material \"brick\": ward: specular is -0.5 at 0.5 um; it must be in "
        "[0, 1]\n"
        "scene.xml:3:5: error: material \"brick\": ward: alpha_y is 2; it must be in [1e-04, 1]\n");
}

TEST_CASE("a model's own curve must cover the lanes or be held", "[materials]") {
  Material metal;
  metal.name = "gold";
  metal.scattering = materials::Mirror{Curve{{0.4, 2.5}, {0.3, 0.3}, Outside::reject}, {}};
  CHECK(error_of(metal) ==
        "error: material \"gold\": mirror: n is tabulated from 0.4 to 2.5 um, the simulated "
        "wavelengths are 0.5 to 10 um\n");
  metal.scattering = materials::Mirror{Curve{{0.4, 2.5}, {0.3, 0.3}, Outside::hold}, {}};
  Diagnostics diagnostics;
  (void)bind(metal, day_and_night, diagnostics);
  REQUIRE(diagnostics.messages().size() == 1);
  CHECK(
      diagnostics.messages()[0] ==
      "material \"gold\": mirror: n is tabulated from 0.4 to 2.5 um, the simulated wavelengths are "
      "0.5 to 10 um; it is extrapolated");
}
