#pragma once

#include <array>
#include <vector>

#include "atmosphere/layered.hpp"
#include "atmosphere/make/local_body.hpp"
#include "atmosphere/make/view_paths.hpp"
#include "atmosphere/optical_column.hpp"
#include "atmosphere/transfer/scattered_source.hpp"

namespace nadir::atmosphere {

/// Where a body stands over the scene.
struct BodyPlace {
  double mu0 = 1.0;  ///< cosine of the zenith angle; below 0: it has set
  double angular_radius_rad = 0.0;
  [[nodiscard]] double sine() const;
};

/// What lights the air at one lane, and the air.
struct LaneInput {
  OpticalColumn column;
  Micrometres wavelength;
  std::vector<double> irradiance;  ///< outside the air, by body; 0: left out
  double airglow = 0.0, starlight = 0.0, urban_glow = 0.0;
  bool scattering = true, emission = true;  ///< whether such light is wanted at all
};

/// How often what was solved: nothing is that does not matter.
struct SolveCounts {
  int columns = 0, beam_solves = 0, thermal_solves = 0, sky_solves = 0;
  SolveCounts& operator+=(const SolveCounts& b);
};

/// Everything that light at one lane meets and does in the air, ready to be summed along paths.
struct LaneFields {
  struct Beam {
    std::size_t body = 0;
    double irradiance = 0.0;
    BodyPlace place;
    int modes = 0;  ///< of its scattered light, 0: not solved
    std::size_t first_component = 0;
    std::vector<double> transmittance;  ///< of the scaled air, from outside to each level
    LocalBody local;                    ///< where the body stands low
    double local_share = 0.0;           ///< of it in first scattering
    FieldFluxes fluxes;                 ///< per unit irradiance
  };
  static constexpr std::size_t even = 0, ground = 1;  ///< components; then the beams' modes,
                                                      ///< then the night's where it has its own

  std::vector<double> depth, scaled_depth;      // vertical, by layer
  std::vector<std::vector<double>> scattering;  // true, by kind and layer
  std::vector<std::shared_ptr<const PhaseFunction>> phases;
  std::size_t components = 2, directions = 0;
  /// Where the night sky's light is found: among the emission where it does not matter beside it.
  std::size_t night = even;
  bool night_alone = true;     ///< that component holds nothing else
  std::vector<double> source;  // [place][direction][component]
  std::vector<Beam> beams;
  FieldFluxes thermal, sky, from_ground;
  double night_scattered = 0.0;  // even radiance of the night sky that is scattered
  double airglow = 0.0, starlight = 0.0, urban_glow = 0.0;

  /// Adds what is scattered or emitted at a step's end to `into`, one value a component.
  void add_source(int layer, const StepEnd& end, std::vector<double>& into) const noexcept;
};

[[nodiscard]] LaneFields lane_fields(const LaneInput& input, const Shells& shells,
                                     const std::vector<BodyPlace>& bodies,
                                     const AirSettings& settings, SolveCounts& counts);

/// How strongly a body lights the scene, relative to its irradiance outside the air, to an order of
/// magnitude: mu0 by day, twilight's decline below.
[[nodiscard]] double light_share(double mu0) noexcept;

}  // namespace nadir::atmosphere
