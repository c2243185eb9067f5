#include "radiometry/leaf_effect.hpp"

#include <memory>
#include <utility>
#include <variant>

#include "spectral/curve.hpp"

namespace nadir::radiometry {
namespace {

using materials::BoundMaterial;
using materials::Leaf;
using materials::Material;
using materials::Mixture;
using spectral::Spectrum;

constexpr Vec3 upwards{0.0, 0.0, 1.0};

/// Whether a leaf, alone or in a mixture, lets light through at some wavelength.
bool has_leaf(const Material& material) {
  if (std::holds_alternative<Leaf>(material.scattering)) {
    return material.transmittance && material.transmittance->max_value() > 0.0;
  }
  const auto* mixture = std::get_if<Mixture>(&material.scattering);
  if (mixture == nullptr) return false;
  for (const Mixture::Part& part : mixture->parts) {
    if (has_leaf(*part.material)) return true;
  }
  return false;
}

/// A curve through the lanes' values: lanes of one wavelength share theirs.
spectral::Curve curve_of(const Spectrum& values, const spectral::Lanes& lanes) {
  std::vector<double> wavelength_um, value;
  for (int lane = 0; lane < lanes.count(); ++lane) {
    if (!wavelength_um.empty() && lanes[lane].value <= wavelength_um.back()) continue;
    wavelength_um.push_back(lanes[lane].value);
    value.push_back(static_cast<double>(values[lane]));
  }
  if (value.size() == 1) return spectral::Curve::constant(value.front());
  return {std::move(wavelength_um), std::move(value), spectral::Outside::hold};
}

/// The same with opaque leaves, described at the lanes alone.
Material opaque(const Material& material, const spectral::Lanes& lanes) {
  Material result = material;
  if (auto* mixture = std::get_if<Mixture>(&result.scattering)) {
    for (Mixture::Part& part : mixture->parts) {
      if (has_leaf(*part.material)) {
        part.material = std::make_shared<const Material>(opaque(*part.material, lanes));
      }
    }
    return result;
  }
  // Its reflectance may follow from emissivity and transmittance: it is what was bound.
  Diagnostics heard;
  const BoundMaterial bound = materials::bind(material, lanes, heard);
  const Spectrum rho = materials::albedo(bound.scattering, upwards).reflectance;
  result.reflectance = curve_of(rho, lanes);
  result.emissivity.reset();
  result.transmittance.reset();
  return result;
}

BoundMaterial opaque_leaf(const BoundMaterial& leaf, const spectral::Lanes& lanes) {
  const Spectrum rho = materials::albedo(leaf.scattering, upwards).reflectance;
  const Spectrum nothing{lanes.count()};
  BoundMaterial result = leaf;
  result.scattering = materials::BoundLeaf{Leaf{}, {lanes, rho, nothing, nullptr}};
  result.traits = materials::traits(result.scattering);
  return result;
}

}  // namespace

std::vector<BoundMaterial> without_leaf_transmission(const LeafScene& scene) {
  bool any = false;
  for (const Material& material : scene.materials) any = any || has_leaf(material);
  if (!any) return {};
  std::vector<BoundMaterial> result;
  for (std::size_t i = 0; i < scene.bound.size(); ++i) {
    const Material& material = scene.materials[i];
    if (!has_leaf(material)) {
      result.push_back(scene.bound[i]);
    } else if (std::holds_alternative<Leaf>(material.scattering)) {
      result.push_back(opaque_leaf(scene.bound[i], scene.lanes));
    } else {
      Diagnostics heard;  // its curves were reported when the whole material was bound
      result.push_back(materials::bind(opaque(material, scene.lanes), scene.lanes, heard));
    }
  }
  return result;
}

}  // namespace nadir::radiometry
