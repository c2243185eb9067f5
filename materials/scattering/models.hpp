#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "materials/scattering/brdf_table.hpp"
#include "spectral/curve.hpp"

// The scattering models as a scenario describes them: plain data. What each one computes, its paper
// and its domain are in the header of its own name, which turns it into a bound model at the lanes;
// parameter_domains.cpp refuses what is outside of the ranges given here.
// "Scaled" models take their brightness from the material's own reflectance (and transmittance), or
// from its emissivity by Kirchhoff's law; the others bring their spectra with them and the material
// gives none. `curves_taken` tells which is which.

namespace nadir::materials {

struct Material;

// ---- scaled by the material's reflectance --------------------------------------------------

struct Lambertian {};
struct OrenNayar {
  double slope_sigma_rad = 0.0;  ///< standard deviation of the facets' tilt, [0, pi/2)
};
struct Minnaert {
  double k = 1.0;  ///< limb exponent, in [0, 3]; 1: Lambertian; below 1 only for dark surfaces
};
/// Two faces, each diffuse: reflectance and transmittance of the material.
struct Leaf {};
/// Ideal mirror: the material's reflectance at all angles, or Fresnel's where n and k are given.
struct Mirror {
  std::optional<spectral::Curve> n, k;
};
/// A thin pane that light crosses without being turned: the material's reflectance and
/// transmittance at all angles, or those of a plate of refractive index n with both its faces.
struct ClearSheet {
  std::optional<spectral::Curve> n;
  std::optional<spectral::Curve> absorption;  ///< optical depth at normal incidence; none: 0
};
/// Diffuse base (the material's reflectance) plus a Gaussian lobe.
struct Ward {
  spectral::Curve specular = spectral::Curve::constant(0.0);  ///< rho_s, [0, 1]
  double alpha_x = 0.1, alpha_y = 0.1;  ///< sqrt(2) standard deviations of slope, [1e-4, 1]
  double azimuth_rad = 0.0;             ///< of the x axis, anticlockwise from the surface's own
};

// ---- with spectra of their own ---------------------------------------------------------------

enum class SlopeDistribution { ggx, beckmann };
/// Rough interface of facets that obey Fresnel's equations.
struct Microfacet {
  SlopeDistribution slopes = SlopeDistribution::ggx;
  double alpha_x = 0.1, alpha_y = 0.1;  ///< roughness, [1e-4, 1]
  double azimuth_rad = 0.0;
  spectral::Curve n = spectral::Curve::constant(1.5);
  spectral::Curve k = spectral::Curve::constant(0.0);
  bool transmits = false;  ///< a solid of glass: what is not reflected is refracted (k must be 0)
};
/// Priest and Germer's facets (Gaussian slopes) over a diffuse base (the material's reflectance).
struct PriestGermer {
  spectral::Curve n = spectral::Curve::constant(1.5);
  spectral::Curve k = spectral::Curve::constant(0.0);
  double slope_sigma = 0.1;  ///< [1e-4, 1]
};
/// Sea or lake surface whose slopes depend on the wind.
struct CoxMunk {
  double wind_speed_m_s = 5.0;    ///< 12.5 m above the sea, [0, 20]
  double wind_azimuth_rad = 0.0;  ///< where it blows from, clockwise from north
  spectral::Curve n = spectral::Curve::constant(1.34);
  spectral::Curve k = spectral::Curve::constant(0.0);
  spectral::Curve water_body = spectral::Curve::constant(0.0);  ///< diffuse reflectance from below
  bool foam = true;                                             ///< white caps by the wind's law
};
/// RossThick-LiSparse-Reciprocal kernels as in the MODIS products.
struct RossLi {
  spectral::Curve isotropic = spectral::Curve::constant(0.0);
  spectral::Curve volumetric = spectral::Curve::constant(0.0);
  spectral::Curve geometric = spectral::Curve::constant(0.0);
};
struct RahmanPintyVerstraete {
  spectral::Curve rho0 = spectral::Curve::constant(0.1);
  spectral::Curve k = spectral::Curve::constant(1.0);
  spectral::Curve asymmetry = spectral::Curve::constant(0.0);  ///< Theta, (-1, 1)
  std::optional<spectral::Curve> rho_c;                        ///< hot spot; none: rho0
};
struct Hapke {
  spectral::Curve single_scattering_albedo = spectral::Curve::constant(0.5);  ///< w, [0, 1]
  double asymmetry_b = 0.3;     ///< of the double Henyey-Greenstein phase function, [0, 1)
  double asymmetry_c = 0.0;     ///< share of its backward lobe, [-1, 1]
  double opposition_b0 = 0.0;   ///< amplitude of the opposition effect, [0, 1]
  double opposition_h = 0.05;   ///< its angular width, > 0
  double mean_slope_rad = 0.0;  ///< macroscopic roughness theta-bar, [0, pi/3]
};
/// Measured reflectance over directions and wavelength.
struct Measured {
  std::shared_ptr<const BrdfTable> table;
};
/// Weighted sum of the scattering of whole materials (with their reflectances).
struct Mixture {
  struct Part {
    double weight = 0.0;
    std::shared_ptr<const Material> material;
  };
  std::vector<Part> parts;
};

/// The closed set. Adding one: a struct here, its header and bound model, a line below and in
/// bound_scattering.hpp, a line in the reader's table, a line in the law test.
using Scattering =
    std::variant<Lambertian, OrenNayar, Minnaert, Leaf, Mirror, ClearSheet, Ward, Microfacet,
                 PriestGermer, CoxMunk, RossLi, RahmanPintyVerstraete, Hapke, Measured, Mixture>;

/// Which of its own curves a material gives to a model.
struct CurvesTaken {
  bool reflectance = false;    ///< scaled: reflectance or emissivity is needed
  bool transmittance = false;  ///< may be given too
};
[[nodiscard]] inline CurvesTaken curves_taken(const Scattering& model) noexcept {
  if (const auto* mirror = std::get_if<Mirror>(&model)) return {!mirror->n.has_value(), false};
  if (const auto* sheet = std::get_if<ClearSheet>(&model)) {
    return {!sheet->n.has_value(), !sheet->n.has_value()};
  }
  const bool leaf = std::holds_alternative<Leaf>(model);
  const bool scaled =
      leaf || std::holds_alternative<Lambertian>(model) ||
      std::holds_alternative<OrenNayar>(model) || std::holds_alternative<Minnaert>(model) ||
      std::holds_alternative<Ward>(model) || std::holds_alternative<PriestGermer>(model);
  return {scaled, leaf};
}

}  // namespace nadir::materials
