#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "radiometry/small_scene.hpp"
#include "support/catch.hpp"

// Kirchhoff's law for all scattering models at once: in a closed enclosure where everything is as
// warm, every direction shows the black body's radiance, whatever stands in it. That holds only if
// a model's emissivity is what its directions lack of 1, for every view.

namespace nadir::radiometry::test {
namespace {

using namespace materials;
using spectral::Curve;

constexpr Method both_kirchhoff[] = {Method::generic, Method::path};
const spectral::Lanes lanes{{3.7_um, 8.5_um, 12.0_um}};

struct Model {
  std::string name;
  Material material;
  /// What the model states of its own albedo: tables of it, and facets that send light to each
  /// other, are good to so much of Planck.
  double tolerance;
};

Material made_of(Scattering model, double rho, double tau = 0.0) {
  Material material = grey(rho);
  material.scattering = std::move(model);
  if (tau > 0.0) material.transmittance = Curve::constant(tau);
  return material;
}
Material own(Scattering model) {
  Material material;
  material.name = "own";
  material.scattering = std::move(model);
  return material;
}

std::shared_ptr<const BrdfTable> smooth_table() {
  auto table = std::make_shared<BrdfTable>();
  for (int i = 0; i <= 8; ++i) table->incidence_rad.push_back(i * 0.18);
  table->view_rad = table->incidence_rad;
  for (int i = 0; i <= 6; ++i) table->azimuth_rad.push_back(i * 3.14159265358979 / 6.0);
  table->wavelength_um = {0.4, 14.0};
  for (const double in : table->incidence_rad) {
    for (const double out : table->view_rad) {
      for (std::size_t k = 0; k < table->azimuth_rad.size() * 2; ++k) {
        table->value.push_back(static_cast<float>(0.15 + 0.05 * std::cos(in) * std::cos(out)));
      }
    }
  }
  return table;
}

std::vector<Model> all_models() {
  constexpr double exact = 1e-5, tabulated = 2.5e-3;
  const Curve n = Curve::constant(1.5), metal_n = Curve::constant(2.0), k = Curve::constant(3.0);
  const auto part = [](double weight, const Material& m) {
    return Mixture::Part{weight, std::make_shared<const Material>(m)};
  };
  const auto ggx = SlopeDistribution::ggx, beckmann = SlopeDistribution::beckmann;
  std::vector<Model> all{
      {"lambertian", made_of(Lambertian{}, 0.5), exact},
      {"leaf", made_of(Leaf{}, 0.4, 0.35), exact},
      {"mirror", made_of(Mirror{}, 0.7), exact},
      {"mirror of metal", own(Mirror{metal_n, k}), exact},
      {"sheet", made_of(ClearSheet{}, 0.2, 0.5), exact},
      {"sheet of glass", own(ClearSheet{n, Curve::constant(0.4)}), exact},
      {"oren-nayar", made_of(OrenNayar{0.4}, 0.6), tabulated},
      {"minnaert", made_of(Minnaert{1.5}, 0.5), tabulated},
      {"ward", made_of(Ward{Curve::constant(0.3), 0.2, 0.2}, 0.3), tabulated},
      {"ggx metal", own(Microfacet{ggx, 0.3, 0.3, 0.0, metal_n, k}), tabulated},
      {"beckmann metal", own(Microfacet{beckmann, 0.2, 0.2, 0.0, metal_n, k}), tabulated},
      {"ggx metal, smooth", own(Microfacet{ggx, 1e-3, 1e-3, 0.0, metal_n, k}), tabulated},
      {"brushed metal", own(Microfacet{ggx, 0.1, 0.4, 0.5, metal_n, k}), tabulated},
      {"priest-germer", made_of(PriestGermer{n, Curve::constant(0.0), 0.2}, 0.3), tabulated},
      {"water", own(CoxMunk{6.0}), tabulated},
      {"ross-li", own(RossLi{Curve::constant(0.3), Curve::constant(0.1), Curve::constant(0.03)}),
       tabulated},
      {"rpv",
       own(RahmanPintyVerstraete{
           Curve::constant(0.2), Curve::constant(0.8), Curve::constant(-0.1), {}}),
       tabulated},
      {"hapke", own(Hapke{Curve::constant(0.7), 0.3, 0.3, 0.5, 0.1, 0.2}), tabulated},
      {"measured", own(materials::Measured{smooth_table()}), tabulated},
  };
  all.push_back({"mixture",
                 own(Mixture{{part(0.5, all[0].material), part(0.3, all[2].material),
                              part(0.2, all[1].material)}}),
                 exact});
  return all;
}

/// A ball of the material, or a slanted disc, in the middle of a closed box. Its walls are black:
/// what is random is then only what the material itself does.
SceneDescription furnace(const Material& material, bool as_disc) {
  SmallScene scene;
  const auto wall = scene.material(grey(0.0), 300.0_K);
  scene.add(geometry::Box{{-3.0, -2.0, -2.5}, {3.0, 2.0, 2.5}}, wall);
  const auto index = scene.material(material, 300.0_K);
  if (as_disc) {
    scene.add(geometry::Disc{{}, {0.0, 0.6, 0.8}, 1.0}, index);
  } else {
    scene.add(geometry::Sphere{{}, 1.0}, index);
  }
  scene.solver = {.initial_sample_count = 1,
                  .sample_decay_rate = 1.0,
                  .max_bounces = 9,
                  .mu_samples = 3,
                  .phi_samples = 6};
  return scene.build();
}

void check_furnace(const Model& model, bool as_disc) {
  SceneDescription description = furnace(model.material, as_disc);
  Diagnostics diagnostics;
  const LitScene lit{description, lanes, diagnostics};
  const Vec3 eye{2.5, 1.0, 2.0};
  for (const Vec3 aim : {Vec3{}, Vec3{0.3, 0.6, -0.45}}) {  // the second grazes
    const geometry::Ray ray{eye, normalised(aim - eye)};
    for (const Method method : both_kirchhoff) {
      const test::Measured seen = method == Method::path
                                      ? measure_with(PathSolver{lit}, lit, ray, 16, 256, 1)
                                      : measure_with(GenericSolver{lit}, lit, ray, 16, 16, 1);
      for (int i = 0; i < lanes.count(); ++i) {
        const double expected = spectral::planck(lanes[i], 300.0_K).value;
        const Estimate& lane = seen.lanes[static_cast<std::size_t>(i)];
        CAPTURE(model.name, as_disc, method == Method::path, aim.y, i, lane.mean / expected,
                lane.standard_error / expected);
        CHECK(lane.standard_error < 0.02 * expected);
        CHECK(std::abs(lane.mean - expected) <
              4.0 * lane.standard_error + model.tolerance * expected);
      }
    }
  }
}

TEST_CASE("published: in an isothermal enclosure every model is a black body (Kirchhoff)",
          "[radiometry][published]") {
  for (const Model& model : all_models()) {
    check_furnace(model, false);
    check_furnace(model, true);
  }
}

TEST_CASE("published: a ball of rough glass in an isothermal enclosure is a black body",
          "[radiometry][published]") {
  // Radiance in the glass is n^2 of that outside, and what is lost to facets that meet light twice
  // counts as absorbed: it is emitted again, but from inside without the n^2. A few per cent at
  // most for facets as flat as these.
  const Model glass{"rough glass",
                    own(Microfacet{.alpha_x = 0.05, .alpha_y = 0.05, .transmits = true}), 0.01};
  check_furnace(glass, false);
}

}  // namespace
}  // namespace nadir::radiometry::test
