#pragma once

#include <span>
#include <vector>

#include "thermal/exposure/exposure.hpp"
#include "thermal/solve/heat_model.hpp"
#include "thermal/solve/shared_stages.hpp"

// Private to this folder.

namespace nadir::thermal {

/// What the surroundings that a place sees send back, as factors of what all places share.
///
/// Patch j has the radiosity, of sunlight (the same with 1 - eps and long-wave for rho, E_sky),
///
///     J_j = rho_j (c_j E_dir + s_j E_sky + (1 - s_j) B),  B = sum w_j J_j,  w_j = F_j / sum F
///
/// what it does not see of the sky it sees of surfaces like those that the place itself sees. So
///
///     B = sum w_j rho_j (c_j E_dir + s_j E_sky) / (1 - sum w_j rho_j (1 - s_j)),
///
/// exact where all see the same mix: open ground, and a cavity, which has s = 0 and is black as a
/// whole if it has one temperature. c_j is the patch's own history of sun. Its share of the sky
/// s_j is that of its tilt, times the openness of the place: the sky and sunlight that place and
/// patches have over what they would have without anything about them.
struct SurroundingsFactors {
  struct Emission {
    std::size_t series = 0;          ///< index into SharedStages::surroundings
    double shaded = 0.0, lit = 0.0;  ///< factors of its two series
  };
  double sky_fraction = 1.0;
  double reflected_sky = 0.0;            ///< of the diffuse light on a level plane
  double reflected_long_wave = 0.0;      ///< of the sky's long-wave radiation
  std::vector<double> reflected_direct;  ///< of the direct light, at the patches' moments
  std::vector<Emission> emissions;
};
/// @param place_up  cosine of the place's normal against up
void find_factors(const HeatModel& model, const SharedStages& shared, const SurroundingsSeen& seen,
                  double place_up, SurroundingsFactors& factors);

/// What reaches one side of a cell, at every stage.
struct SideLoad {
  double place_up = 1.0;
  std::vector<double> sun_cosine;    ///< shadow counted
  std::vector<double> sky_fraction;  ///< by stage, since the scene may change
  std::vector<double> reflected_w_m2;
  std::vector<double> surroundings_w_m2;  ///< long-wave

  [[nodiscard]] SurfaceLoad at(std::size_t stage, const SharedStages& shared,
                               const Film& film) const noexcept;
  /// At a stage of the first day's long steps: sunlight and long-wave radiation summed.
  [[nodiscard]] SurfaceLoad at_long(std::size_t stage, const SharedStages& shared,
                                    const Film& film) const noexcept;

  std::vector<SurroundingsFactors> factors;  ///< by epoch: memory to work in
};
void find_load(const HeatModel& model, const SharedStages& shared, const Exposure& exposure,
               double place_up, SideLoad& load);

}  // namespace nadir::thermal
