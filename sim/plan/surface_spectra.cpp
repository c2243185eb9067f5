#include "sim/plan/surface_spectra.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "materials/scattering/fresnel.hpp"

namespace nadir::sim {
namespace {

using spectral::Curve;

constexpr double most_scattered = 0.98;
constexpr double meets_again = 0.8;  // chance to meet another surface, as in a dense canopy

SpectralFunction constant(double value) {
  return [value](double) { return value; };
}

SpectralFunction one_less(std::vector<SpectralFunction> parts) {
  return [parts = std::move(parts)](double lambda_um) {
    double rest = 1.0;
    for (const SpectralFunction& part : parts) rest -= part(lambda_um);
    return std::max(rest, 0.0);
  };
}

/// Reflectance of a smooth face seen straight on.
SpectralFunction smooth_face(const Curve& n, const Curve* k, std::vector<double>& knots_um) {
  return [n = function_of(n, knots_um),
          k = k ? function_of(*k, knots_um) : constant(0.0)](double lambda_um) {
    return materials::fresnel_reflectance(1.0, std::max(n(lambda_um), 1e-6), k(lambda_um));
  };
}

/// The mean over all directions of a measured table.
SpectralFunction mean_albedo(const materials::BrdfTable& table, std::vector<double>& knots_um) {
  const std::size_t waves = table.wavelength_um.size();
  std::vector<double> mean(waves, 0.0);
  for (std::size_t i = 0; i < table.value.size(); ++i) {
    mean[i % waves] += static_cast<double>(table.value[i]);
  }
  const double to_albedo =
      3.141592653589793 * static_cast<double>(waves) / static_cast<double>(table.value.size());
  for (double& value : mean) value = std::clamp(value * to_albedo, 0.0, 1.0);
  if (waves == 1) return constant(mean.front());
  const auto curve =
      std::make_shared<const Curve>(table.wavelength_um, mean, spectral::Outside::hold);
  return
      [curve, held = function_of(*curve, knots_um)](double lambda_um) { return held(lambda_um); };
}

/// What each scattering model reflects or lets through, by itself; nothing for those that take all
/// from the material's own curves.
struct OfModel {
  std::vector<double>* knots_um;
  using List = std::vector<SpectralFunction>;

  [[nodiscard]] SpectralFunction of(const Curve& curve) const {
    return function_of(curve, *knots_um);
  }
  List operator()(const materials::Lambertian& /*m*/) const { return {}; }
  List operator()(const materials::OrenNayar& /*m*/) const { return {}; }
  List operator()(const materials::Minnaert& /*m*/) const { return {}; }
  List operator()(const materials::Leaf& /*m*/) const { return {}; }
  List operator()(const materials::Mirror& m) const {
    if (!m.n) return {};
    return {smooth_face(*m.n, m.k ? &*m.k : nullptr, *knots_um)};
  }
  List operator()(const materials::ClearSheet& m) const {
    if (!m.n) return {};
    const SpectralFunction depth = m.absorption ? of(*m.absorption) : constant(0.0);
    return {smooth_face(*m.n, nullptr, *knots_um),
            [depth](double lambda_um) { return std::exp(-depth(lambda_um)); }};
  }
  List operator()(const materials::Ward& m) const { return {of(m.specular)}; }
  List operator()(const materials::Microfacet& m) const {
    return {smooth_face(m.n, &m.k, *knots_um)};
  }
  List operator()(const materials::PriestGermer& m) const {
    return {smooth_face(m.n, &m.k, *knots_um)};
  }
  List operator()(const materials::CoxMunk& m) const {
    return {smooth_face(m.n, &m.k, *knots_um), of(m.water_body)};
  }
  List operator()(const materials::RossLi& m) const {
    return {of(m.isotropic), of(m.volumetric), of(m.geometric)};
  }
  List operator()(const materials::RahmanPintyVerstraete& m) const { return {of(m.rho0)}; }
  List operator()(const materials::Hapke& m) const { return {of(m.single_scattering_albedo)}; }
  List operator()(const materials::Measured& m) const { return {mean_albedo(*m.table, *knots_um)}; }
  List operator()(const materials::Mixture& /*m*/) const { return {}; }
};

SurfaceSpectra spectra_with(const SpectralFunction& scatters, const SpectralFunction& emits,
                            const std::vector<SpectralFunction>& together) {
  return {scatters, emits, [scatters, together](double lambda_um) {
            double all = 0.0;
            for (const SpectralFunction& one : together) all += one(lambda_um);
            all = std::min(all, most_scattered);
            return scatters(lambda_um) * all / (1.0 - meets_again * all);
          }};
}

}  // namespace

SpectralFunction function_of(const Curve& curve, std::vector<double>& knots_um) {
  knots_um.insert(knots_um.end(), curve.wavelengths_um().begin(), curve.wavelengths_um().end());
  return [at = &curve](double lambda_um) {
    const double held = std::clamp(lambda_um, at->first().value, at->last().value);
    return std::max(at->at(Micrometres{held}), 0.0);
  };
}

std::vector<SurfaceSpectra> surface_spectra(const materials::Material& material,
                                            std::vector<double>& knots_um) {
  if (const auto* mixture = std::get_if<materials::Mixture>(&material.scattering)) {
    std::vector<SurfaceSpectra> all;
    for (const auto& part : mixture->parts) {
      for (auto& spectra : surface_spectra(*part.material, knots_um)) {
        all.push_back(std::move(spectra));
      }
    }
    return all;
  }
  std::vector<SpectralFunction> scattering = std::visit(OfModel{&knots_um}, material.scattering);
  if (material.transmittance) {
    scattering.push_back(function_of(*material.transmittance, knots_um));
  }
  std::optional<SpectralFunction> emissivity;
  if (material.emissivity) emissivity = function_of(*material.emissivity, knots_um);
  if (material.reflectance) {
    scattering.push_back(function_of(*material.reflectance, knots_um));
  } else if (emissivity && materials::curves_taken(material.scattering).reflectance) {
    auto others = scattering;  // Kirchhoff's law: rho = 1 - eps - tau
    others.push_back(*emissivity);
    scattering.push_back(one_less(std::move(others)));
  }
  const SpectralFunction emits = emissivity ? *emissivity : one_less(scattering);
  std::vector<SurfaceSpectra> all;
  for (const SpectralFunction& one : scattering)
    all.push_back(spectra_with(one, emits, scattering));
  if (all.empty()) all.push_back({constant(0.0), emits, constant(0.0)});
  return all;
}

}  // namespace nadir::sim
