#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "materials/scattering/models.hpp"
#include "materials/solver_settings.hpp"
#include "sim/scenario/heat_input.hpp"
#include "sim/scenario/map_place_input.hpp"
#include "sim/scenario/spectral_input.hpp"

// Materials and the maps of materials as a scenario or a library describes them: plain data, files
// named but not yet read. Models without spectra are those of materials/scattering/models.hpp.

namespace nadir::sim {

// ---- scattering ---------------------------------------------------------------------------------

struct MirrorInput {
  std::optional<SpectralInput> n, k;
};
struct ClearSheetInput {
  std::optional<SpectralInput> n, absorption;
};
struct WardInput {
  SpectralInput specular;
  double alpha_x = 0.1, alpha_y = 0.1;
  double azimuth_deg = 0.0;
};
struct MicrofacetInput {
  materials::SlopeDistribution slopes = materials::SlopeDistribution::ggx;
  double alpha_x = 0.1, alpha_y = 0.1;
  double azimuth_deg = 0.0;
  SpectralInput n, k;
  bool transmits = false;
};
struct PriestGermerInput {
  SpectralInput n, k;
  double slope_sigma = 0.1;
};
struct CoxMunkInput {
  double wind_speed_m_s = 5.0;
  double wind_azimuth_deg = 0.0;
  SpectralInput n, k, water_body;
  bool foam = true;
};
struct RossLiInput {
  SpectralInput isotropic, volumetric, geometric;
};
struct RahmanPintyVerstraeteInput {
  SpectralInput rho0, k, asymmetry;
  std::optional<SpectralInput> rho_c;
};
struct HapkeInput {
  SpectralInput single_scattering_albedo;
  materials::Hapke rest;  ///< everything but the albedo
};
struct MeasuredInput {
  std::filesystem::path file;
};
struct MaterialInput;
/// Whole materials, so that a mixture from a library brings its parts along.
struct MixtureInput {
  struct Part {
    double weight = 0.0;
    std::shared_ptr<const MaterialInput> material;
  };
  std::vector<Part> parts;
};

using ScatteringInput =
    std::variant<materials::Lambertian, materials::OrenNayar, materials::Minnaert, materials::Leaf,
                 MirrorInput, ClearSheetInput, WardInput, MicrofacetInput, PriestGermerInput,
                 CoxMunkInput, RossLiInput, RahmanPintyVerstraeteInput, HapkeInput, MeasuredInput,
                 MixtureInput>;

/// Whether the model needs no reflectance of the material and takes none.
[[nodiscard]] bool brings_spectra(const ScatteringInput& scattering);

// ---- materials ----------------------------------------------------------------------------------

struct ReliefInput {
  std::filesystem::path file;
  bool normals = false;  ///< a normal map; otherwise heights
  double strength = 1.0;
  MapPlaceInput place;
  SourceLocation where;
};

struct MaterialInput {
  std::string name;
  std::string description;
  std::optional<SpectralInput> reflectance;
  std::optional<SpectralInput> emissivity;
  TemperatureInput temperature = ConstantTemperatureInput{};
  std::optional<HeatBalanceInput> heat_balance;  ///< that a library's material brings; what counts
                                                 ///< is `temperature`
  std::optional<int>
      variant_of;  ///< index of the material that only temperature sets it apart from
  std::optional<materials::SolverSettings> solver;
  std::optional<SpectralInput> transmittance;
  ScatteringInput scattering;
  std::optional<ReliefInput> relief;
  SourceLocation where;
};

// ---- maps of materials --------------------------------------------------------------------------

/// The raster's value chooses.
struct ChoicesInput {
  struct Choice {
    double value = 0.0;
    int material = 0;  ///< index into Scenario::materials
  };
  int band = 1;
  std::vector<Choice> choices;
};
/// Each band is the fraction of a material.
struct FractionsInput {
  struct Fraction {
    int band = 1;
    int material = 0;
  };
  std::vector<Fraction> fractions;
};
/// The local contrast of an image band chooses among materials that differ in reflectance only.
struct ContrastInput {
  int band = 1;
  double band_low_um = 0.0, band_high_um = 0.0;  ///< where the image was taken
  int half_window_pixels = 0;                    ///< 0: contrast within the whole image
  std::vector<int> materials;
};
struct MaterialMapInput {
  std::string name;
  std::filesystem::path raster;
  MapPlaceInput place;
  std::variant<ChoicesInput, FractionsInput, ContrastInput> rule;
  SourceLocation where;
};

}  // namespace nadir::sim
