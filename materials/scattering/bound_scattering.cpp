#include "materials/scattering/bound_scattering.hpp"

#include "materials/scattering/parameter_domains.hpp"

namespace nadir::materials {
namespace {

/// Which bound model a description becomes. A description without a line does not compile.
struct Binder {
  const BindContext& c;

  BoundScattering operator()(const Lambertian& m) const { return BoundLambertian{m, c}; }
  BoundScattering operator()(const OrenNayar& m) const { return BoundOrenNayar{m, c}; }
  BoundScattering operator()(const Minnaert& m) const { return BoundMinnaert{m, c}; }
  BoundScattering operator()(const Leaf& m) const { return BoundLeaf{m, c}; }
  BoundScattering operator()(const Mirror& m) const { return BoundMirror{m, c}; }
  BoundScattering operator()(const ClearSheet& m) const { return BoundClearSheet{m, c}; }
  BoundScattering operator()(const Ward& m) const { return BoundWard{m, c}; }
  BoundScattering operator()(const Microfacet& m) const { return BoundMicrofacet{m, c}; }
  BoundScattering operator()(const PriestGermer& m) const { return BoundPriestGermer{m, c}; }
  BoundScattering operator()(const CoxMunk& m) const { return BoundCoxMunk{m, c}; }
  BoundScattering operator()(const RossLi& m) const { return BoundRossLi{m, c}; }
  BoundScattering operator()(const RahmanPintyVerstraete& m) const {
    return BoundRahmanPintyVerstraete{m, c};
  }
  BoundScattering operator()(const Hapke& m) const { return BoundHapke{m, c}; }
  BoundScattering operator()(const Measured& m) const { return BoundMeasured{m, c}; }
  BoundScattering operator()(const Mixture& m) const { return BoundMixture{m, c}; }
};

}  // namespace

BoundScattering bind(const Scattering& model, const BindContext& context) {
  check_parameters(model, context);
  return std::visit(Binder{context}, model);
}

spectral::Spectrum straight_transmittance(const BoundScattering& model, Vec3 wo) noexcept {
  if (const auto* sheet = std::get_if<BoundClearSheet>(&model)) {
    return sheet->albedo(wo).transmittance;
  }
  if (const auto* mixture = std::get_if<BoundMixture>(&model)) return mixture->straight(wo);
  return spectral::Spectrum{albedo(model, wo).reflectance.count()};
}

}  // namespace nadir::materials
