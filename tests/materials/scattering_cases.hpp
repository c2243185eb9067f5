#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "materials/bound_material.hpp"
#include "spectral/lanes.hpp"

namespace nadir::support {

/// How a case is tested; what is not the default has its reason beside it.
struct CaseTraits {
  /// Width of a lobe about the mirror direction that a grid over the sphere would miss: integrals
  /// run over half vectors of this slope instead. 0: none.
  double narrow = 0.0;
  /// Some draws are lost (a facet sends them below the horizon): the density integrates to less.
  bool lossy = false;
  /// Refractive index below the surface: radiance is compressed by its square.
  double index_below = 1.0;
  /// Of `albedo`, absolute: closed forms are met to the error of the test's quadrature, tables to
  /// what their headers state.
  double albedo_tolerance = 1e-3;
};

/// One model in one regime of its parameters, bound to three lanes with different spectra.
struct ScatteringCase {
  std::string name;
  materials::BoundMaterial material;
  CaseTraits traits;
};

namespace cases {

using namespace materials;
using spectral::Curve;
using spectral::Outside;

inline Curve spectrum(double blue, double near_infrared, double thermal) {
  return Curve{
      {0.4, 0.5, 1.0, 10.0, 12.0}, {blue, blue, near_infrared, thermal, thermal}, Outside::reject};
}

inline Material made_of(Scattering model, std::optional<Curve> rho = {},
                        std::optional<Curve> tau = {}) {
  Material material;
  material.name = "case";
  material.scattering = std::move(model);
  material.reflectance = std::move(rho);
  material.transmittance = std::move(tau);
  return material;
}

inline Mixture::Part part(double weight, Material material) {
  return {weight, std::make_shared<const Material>(std::move(material))};
}

/// A smooth, reciprocal table.
inline std::shared_ptr<const BrdfTable> small_table() {
  auto table = std::make_shared<BrdfTable>();
  for (int i = 0; i <= 8; ++i) table->incidence_rad.push_back(i * 0.18);
  table->view_rad = table->incidence_rad;
  for (int i = 0; i <= 6; ++i) table->azimuth_rad.push_back(i * 3.14159265358979 / 6.0);
  table->wavelength_um = {0.4, 12.0};
  for (const double in : table->incidence_rad) {
    for (const double out : table->view_rad) {
      for (const double azimuth : table->azimuth_rad) {
        const double lobe = 0.05 * std::sin(in) * std::sin(out) * std::cos(azimuth);
        const double f = 0.08 + 0.04 * std::cos(in) * std::cos(out) + lobe;
        table->value.push_back(static_cast<float>(f));
        table->value.push_back(static_cast<float>(0.5 * f));
      }
    }
  }
  return table;
}

inline const Curve grey = spectrum(0.2, 0.55, 0.04);
inline const Curve white = Curve::constant(1.0);
inline const Curve dark = spectrum(0.05, 0.3, 0.02);
inline const Curve through = spectrum(0.1, 0.4, 0.0);
inline const Curve gold_n = spectrum(0.97, 0.25, 12.0), gold_k = spectrum(1.87, 6.8, 55.0);

using Cases = std::vector<ScatteringCase>;

class Builder {
 public:
  void add(const char* name, const Material& material, const CaseTraits& traits = {}) {
    Diagnostics diagnostics;
    cases_.push_back({name, bind(material, lanes_, diagnostics), traits});
  }
  Cases take() { return std::move(cases_); }

 private:
  spectral::Lanes lanes_{{0.5_um, 1.0_um, 10.0_um}};
  Cases cases_;
};

// Of tables of albedo: their own noise and interpolation.
inline constexpr double table = 1e-2;

inline void add_diffuse(Builder& b) {
  b.add("lambertian", made_of(Lambertian{}, grey));
  b.add("lambertian white", made_of(Lambertian{}, white));
  b.add("oren-nayar 5 degrees", made_of(OrenNayar{0.0873}, grey));
  b.add("oren-nayar 35 degrees", made_of(OrenNayar{0.61}, grey));
  b.add("oren-nayar bright", made_of(OrenNayar{0.3}, spectrum(0.97, 1.0, 0.6)));
  b.add("minnaert limb dark", made_of(Minnaert{1.7}, grey));
  b.add("minnaert limb bright", made_of(Minnaert{0.7}, dark));
  b.add("leaf", made_of(Leaf{}, grey, through));
  b.add("leaf opaque", made_of(Leaf{}, grey));
}

inline void add_specular(Builder& b) {
  b.add("mirror", made_of(Mirror{}, grey));
  b.add("mirror gold", made_of(Mirror{gold_n, gold_k}));
  b.add("sheet", made_of(ClearSheet{}, dark, through));
  b.add("sheet of glass", made_of(ClearSheet{Curve::constant(1.5), spectrum(0.1, 0.0, 30.0)}));
  // the lobe is drawn after its facets, some of which face away from the view
  b.add("ward", made_of(Ward{spectrum(0.3, 0.1, 0.05), 0.25, 0.25}, grey),
        {.lossy = true, .albedo_tolerance = table});
  b.add("ward brushed", made_of(Ward{spectrum(0.3, 0.4, 0.9), 0.15, 0.5, 0.6}, dark),
        {.lossy = true, .albedo_tolerance = table});
  b.add("ward glossy", made_of(Ward{spectrum(0.3, 0.1, 0.5), 0.02, 0.02}, grey),
        {.narrow = 0.02, .lossy = true, .albedo_tolerance = table});
}

inline void add_facets(Builder& b) {
  const auto ggx = SlopeDistribution::ggx;
  const auto beckmann = SlopeDistribution::beckmann;
  const Curve glass = Curve::constant(1.5), clear = Curve::constant(0.0);
  b.add("ggx metal", made_of(Microfacet{ggx, 0.3, 0.3, 0.0, gold_n, gold_k}),
        {.narrow = 0.3, .lossy = true, .albedo_tolerance = table});
  b.add("ggx metal polished", made_of(Microfacet{ggx, 0.05, 0.05, 0.0, gold_n, gold_k}),
        {.narrow = 0.05, .lossy = true, .albedo_tolerance = table});
  b.add("beckmann metal", made_of(Microfacet{beckmann, 0.3, 0.3, 0.0, gold_n, gold_k}),
        {.narrow = 0.3, .lossy = true, .albedo_tolerance = table});
  b.add("ggx brushed", made_of(Microfacet{ggx, 0.1, 0.4, 0.5, gold_n, gold_k}),
        {.narrow = 0.2, .lossy = true, .albedo_tolerance = table});
  b.add("rough glass", made_of(Microfacet{ggx, 0.4, 0.4, 0.0, glass, clear, true}),
        {.lossy = true, .index_below = 1.5, .albedo_tolerance = table});
  b.add("priest-germer", made_of(PriestGermer{glass, clear, 0.2}, grey),
        {.narrow = 0.2, .lossy = true, .albedo_tolerance = table});
  b.add("cox-munk calm", made_of(CoxMunk{2.0}),
        {.narrow = 0.1, .lossy = true, .albedo_tolerance = table});
  b.add(
      "cox-munk windy",
      made_of(CoxMunk{
          .wind_speed_m_s = 10.0, .wind_azimuth_rad = 1.0, .water_body = spectrum(0.05, 0.0, 0.0)}),
      {.narrow = 0.2, .lossy = true, .albedo_tolerance = table});
}

inline void add_land(Builder& b) {
  b.add("ross-li",
        made_of(RossLi{spectrum(0.1, 0.35, 0.02), spectrum(0.05, 0.2, 0.005),
                       spectrum(0.01, 0.05, 0.001)}),
        {.albedo_tolerance = table});
  b.add("rpv",
        made_of(RahmanPintyVerstraete{
            spectrum(0.05, 0.2, 0.02), spectrum(0.8, 0.9, 1.1), spectrum(-0.1, -0.05, 0.1), {}}),
        {.albedo_tolerance = table});
  b.add("hapke", made_of(Hapke{spectrum(0.4, 0.8, 0.1), 0.3, 0.3, 0.5, 0.1, 0.26}),
        {.albedo_tolerance = table});
  b.add("measured", made_of(Measured{small_table()}), {.albedo_tolerance = table});
}

inline void add_mixtures(Builder& b) {
  const Material soil = made_of(OrenNayar{0.4}, dark), leaf = made_of(Leaf{}, grey, through);
  const Material puddle = made_of(Mirror{Curve::constant(1.33), {}});
  const Material both = made_of(Mixture{{part(0.4, leaf), part(0.5, soil)}});
  b.add("mixture of diffuse ones", both);
  b.add("mixture with a mirror", made_of(Mixture{{part(0.7, soil), part(0.3, puddle)}}));
  const Material sheet = made_of(ClearSheet{Curve::constant(1.5), {}});
  b.add("mixture of a mixture and a sheet", made_of(Mixture{{part(0.6, both), part(0.4, sheet)}}));
}

}  // namespace cases

/// Every model, at least once. A new one adds a line above and gets every test.
[[nodiscard]] inline const std::vector<ScatteringCase>& scattering_cases() {
  static const cases::Cases all = [] {
    cases::Builder b;
    cases::add_diffuse(b);
    cases::add_specular(b);
    cases::add_facets(b);
    cases::add_land(b);
    cases::add_mixtures(b);
    return b.take();
  }();
  return all;
}

}  // namespace nadir::support
