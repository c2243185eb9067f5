#pragma once

#include "core/vec.hpp"
#include "spectral/lanes.hpp"

namespace nadir::materials {

/// Random numbers that draw one direction, uniform in [0, 1).
struct ScatteringDraw {
  double choice = 0.0;  ///< which part of the model
  Vec2 point;           ///< where within it
};

/// A direction drawn by a scattering model.
struct ScatteringSample {
  Vec3 wi;                    ///< unit vector away from the surface, local frame
  double pdf = 0.0;           ///< solid-angle density of all parts that are not deltas, sr^-1
  bool delta = false;         ///< drawn from an ideal mirror or sheet: `pdf` is 0 and says nothing
  spectral::Spectrum weight;  ///< eval |cos| / pdf per lane; for a delta its share over its chance
};

/// Directional-hemispherical reflectance and transmittance for light from one direction.
struct Albedo {
  spectral::Spectrum reflectance;
  spectral::Spectrum transmittance;
};

/// What a model can do, for solvers that would rather not ask at every hit.
struct ScatteringTraits {
  bool transmits = false;    ///< light may come from the other side
  bool anisotropic = false;  ///< turning the surface about its normal changes it
  bool has_delta = false;    ///< some light goes into directions of no solid angle
  bool only_delta = false;   ///< all light does
  bool straight = false;     ///< some light goes straight through, as through a clear sheet
};

}  // namespace nadir::materials
