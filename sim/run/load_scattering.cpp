#include <utility>

#include "core/quantity.hpp"

#include "sim/run/load_scattering.hpp"

namespace nadir::sim {

namespace {}  // namespace

/// One function a model. Curves of models must cover the wavelengths: extrapolated, a refractive
/// index would be of another substance.
struct ScatteringReader {
  MaterialReader& materials;

  [[nodiscard]] spectral::Curve curve(const SpectralInput& input, SpectrumQuantity quantity) const {
    return materials.curves_.read(input, quantity, spectral::Outside::reject);
  }
  [[nodiscard]] spectral::Curve index(const SpectralInput& input) const {
    return curve(input, SpectrumQuantity::refractive_index);
  }
  [[nodiscard]] spectral::Curve extinction(const SpectralInput& input) const {
    return curve(input, SpectrumQuantity::extinction_coefficient);
  }
  [[nodiscard]] spectral::Curve parameter(const SpectralInput& input) const {
    return curve(input, SpectrumQuantity::parameter);
  }
  template <class Reader>
  [[nodiscard]] static std::optional<spectral::Curve> if_given(
      const std::optional<SpectralInput>& input, const Reader& reader) {
    return input ? std::optional{reader(*input)} : std::nullopt;
  }

  /// Models without spectra are in the scenario as they are.
  template <class Plain>
  materials::Scattering operator()(const Plain& model) const {
    return model;
  }
  materials::Scattering operator()(const MirrorInput& model) const {
    return materials::Mirror{if_given(model.n, [&](const auto& n) { return index(n); }),
                             if_given(model.k, [&](const auto& k) { return extinction(k); })};
  }
  materials::Scattering operator()(const ClearSheetInput& model) const {
    return materials::ClearSheet{
        if_given(model.n, [&](const auto& n) { return index(n); }),
        if_given(model.absorption, [&](const auto& depth) { return parameter(depth); })};
  }
  materials::Scattering operator()(const WardInput& model) const {
    return materials::Ward{curve(model.specular, SpectrumQuantity::reflectance), model.alpha_x,
                           model.alpha_y, model.azimuth_deg * radians_per_degree};
  }
  materials::Scattering operator()(const MicrofacetInput& model) const {
    return materials::Microfacet{
        model.slopes,   model.alpha_x,       model.alpha_y,  model.azimuth_deg * radians_per_degree,
        index(model.n), extinction(model.k), model.transmits};
  }
  materials::Scattering operator()(const PriestGermerInput& model) const {
    return materials::PriestGermer{index(model.n), extinction(model.k), model.slope_sigma};
  }
  materials::Scattering operator()(const CoxMunkInput& model) const {
    return materials::CoxMunk{model.wind_speed_m_s,
                              model.wind_azimuth_deg * radians_per_degree,
                              index(model.n),
                              extinction(model.k),
                              curve(model.water_body, SpectrumQuantity::reflectance),
                              model.foam};
  }
  materials::Scattering operator()(const RossLiInput& model) const {
    return materials::RossLi{parameter(model.isotropic), parameter(model.volumetric),
                             parameter(model.geometric)};
  }
  materials::Scattering operator()(const RahmanPintyVerstraeteInput& model) const {
    return materials::RahmanPintyVerstraete{
        parameter(model.rho0), parameter(model.k), parameter(model.asymmetry),
        if_given(model.rho_c, [&](const auto& rho) { return parameter(rho); })};
  }
  materials::Scattering operator()(const HapkeInput& model) const {
    materials::Hapke hapke = model.rest;
    hapke.single_scattering_albedo = parameter(model.single_scattering_albedo);
    return hapke;
  }
  materials::Scattering operator()(const MeasuredInput& model) const {
    return materials::Measured{materials.table(model.file)};
  }
  materials::Scattering operator()(const MixtureInput& model) const {
    materials::Mixture mixture;
    for (const MixtureInput::Part& part : model.parts) {
      mixture.parts.push_back({part.weight, materials.part(part.material)});
    }
    return mixture;
  }
};

materials::Scattering read_scattering(const ScatteringInput& input, MaterialReader& materials) {
  return std::visit(ScatteringReader{materials}, input);
}

}  // namespace nadir::sim
