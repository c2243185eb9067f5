#include <memory>
#include <string>

#include "materials/bound_material.hpp"
#include "materials/bound_one.hpp"
#include "support/catch.hpp"
#include "support/quadrature.hpp"

using namespace nadir;
using materials::BoundMaterial;
using materials::Material;
using materials::Mixture;
using spectral::Curve;
using spectral::Lanes;
using support::direction;
using support::refusal;

namespace {

const Lanes lanes{{0.5_um, 10.0_um}};

Mixture::Part part(double weight, const Material& material) {
  return {weight, std::make_shared<const Material>(material)};
}

Material plain(const std::string& name, double rho, materials::Scattering scattering = {}) {
  Material material;
  material.name = name;
  material.reflectance = Curve::constant(rho);
  material.scattering = std::move(scattering);
  return material;
}

BoundMaterial mix(std::vector<Mixture::Part> parts) {
  Material material;
  material.name = "ground";
  material.scattering = Mixture{std::move(parts)};
  Diagnostics diagnostics;
  return bind(material, lanes, diagnostics);
}

}  // namespace

TEST_CASE("a mixture is the weighted sum of its parts", "[materials][mixture]") {
  const BoundMaterial both = mix({part(0.25, plain("soil", 0.2)), part(0.75, plain("sand", 0.4))});
  const Vec3 wo = direction(0.5, 0.0);
  // float lanes
  CHECK(albedo(both.scattering, wo).reflectance[0] == Approx(0.35).epsilon(1e-6));
  CHECK(eval(both.scattering, direction(0.2, 2.0), wo)[1] ==
        Approx(0.35 / 3.14159265358979).epsilon(1e-6));
  CHECK(both.emissivity(wo)[0] == Approx(0.65).epsilon(1e-6));
  CHECK_FALSE(both.traits.transmits);
}

TEST_CASE("what a mixture lacks is black", "[materials][mixture]") {
  const BoundMaterial half = mix({part(0.5, plain("snow", 0.8))});
  CHECK(half.emissivity({0.0, 0.0, 1.0})[0] == Approx(0.6).epsilon(1e-6));
}

TEST_CASE("each part of a mixture follows Kirchhoff's law by itself", "[materials][mixture]") {
  Material warm;
  warm.name = "roof";
  warm.emissivity = Curve::constant(0.9);
  const BoundMaterial both = mix({part(0.5, warm), part(0.5, plain("soil", 0.3))});
  CHECK(albedo(both.scattering, {0.0, 0.0, 1.0}).reflectance[1] == Approx(0.2).epsilon(1e-6));
}

// 0.4 x 0.5 of a mirror and 0.6 x 0.5 of a diffuse part: chances 0.4 and 0.6, and all weigh 0.5.
TEST_CASE("a mirror in a mixture is drawn by its share of the albedo", "[materials][mixture]") {
  const BoundMaterial both =
      mix({part(0.4, plain("water", 0.5, materials::Mirror{})), part(0.6, plain("soil", 0.5))});
  const Vec3 wo = direction(0.5, 0.0);
  const auto delta = sample(both.scattering, wo, {0.399, {0.3, 0.3}});
  const auto diffuse = sample(both.scattering, wo, {0.401, {0.3, 0.3}});
  REQUIRE(delta.has_value());
  REQUIRE(diffuse.has_value());
  CHECK(delta->delta);
  CHECK_FALSE(diffuse->delta);
  CHECK(delta->weight[0] == Approx(0.5).epsilon(1e-6));
  CHECK(diffuse->weight[0] == Approx(0.5).epsilon(1e-6));
  CHECK(both.traits.has_delta);
}

TEST_CASE("the number that chooses a part chooses within it as well", "[materials][mixture]") {
  Material leaf = plain("leaf", 0.4, materials::Leaf{});
  leaf.transmittance = Curve::constant(0.4);
  const BoundMaterial both = mix({part(0.5, leaf), part(0.5, leaf)});
  const Vec3 wo = direction(0.5, 0.0);
  // each half of [0, 1) is a leaf, whose own halves are its sides
  CHECK(sample(both.scattering, wo, {0.24, {0.3, 0.3}})->wi.z > 0.0);
  CHECK(sample(both.scattering, wo, {0.26, {0.3, 0.3}})->wi.z < 0.0);
  CHECK(sample(both.scattering, wo, {0.74, {0.3, 0.3}})->wi.z > 0.0);
  CHECK(sample(both.scattering, wo, {0.76, {0.3, 0.3}})->wi.z < 0.0);
}

TEST_CASE("a mixture that would gain energy is refused", "[materials][mixture]") {
  const auto weights = [](double first, double second) {
    return refusal([&] {
      (void)mix({part(first, plain("snow", 0.9)), part(second, plain("sand", 0.5))});
    });
  };
  CHECK(weights(1.0, 0.1) == "no error");  // 0.95
  CHECK_THAT(weights(1.0, 0.5),
             Catch::Matchers::Contains("material \"ground\": mixture: its parts together scatter"));
  CHECK_THAT(weights(1.0, 0.5), Catch::Matchers::Contains("more than 1 creates energy"));
  CHECK(weights(-0.5, 0.5) ==
        "error: material \"ground\": mixture: the weight of \"snow\" is -0.5; it must not be "
        "negative\n");
}

TEST_CASE("a mixture of nothing is refused", "[materials][mixture]") {
  CHECK(refusal([] { (void)mix({}); }) == "error: material \"ground\": mixture: it has no parts\n");
  CHECK(refusal([] {
          (void)mix({{0.5, nullptr}});
        }) == "error: material \"ground\": mixture: a part has no material\n");
}

TEST_CASE("a mistake in a part names part and whole", "[materials][mixture]") {
  CHECK(refusal([] { (void)mix({part(1.0, plain("soil", 1.5))}); }) ==
        "error: material \"ground\": material \"soil\": reflectance is 1.5; it must be from 0 to "
        "1\n");
}

TEST_CASE("relief inside a mixture is left out, and said so", "[materials][mixture]") {
  Material bumpy = plain("gravel", 0.3);
  bumpy.relief = std::make_shared<const materials::ReliefMap>();
  Material material;
  material.name = "ground";
  material.scattering = Mixture{{part(1.0, bumpy)}};
  Diagnostics diagnostics;
  (void)bind(material, lanes, diagnostics);
  REQUIRE(diagnostics.messages().size() == 1);
  CHECK(diagnostics.messages()[0] ==
        "material \"ground\": mixture: the relief of its part \"gravel\" is left out");
}
