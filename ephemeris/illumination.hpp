#pragma once

#include <string>
#include <vector>

#include "core/quantity.hpp"
#include "core/vec.hpp"
#include "spectral/curve.hpp"

namespace nadir::ephemeris {

/// A body that lights the scene: where it stands and how bright it is outside the air.
struct LightSource {
  std::string name;            ///< "sun" or "moon"
  Vec3 direction_enu;          ///< unit vector towards the centre of the disc, scene axes
  Angle angular_radius;        ///< > 0
  spectral::Curve irradiance;  ///< on a plane normal to the direction, W m^-2 um^-1
};

using Illumination = std::vector<LightSource>;

}  // namespace nadir::ephemeris
