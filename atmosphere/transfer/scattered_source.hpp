#pragma once

#include <vector>

namespace nadir::atmosphere {

/// Where the light that a column scatters comes from. Each is solved over a black ground; the sum
/// over all of them, each times its strength, is the field in the air.
struct BeamIn {
  double mu0 = 1.0;  ///< cosine of the body's zenith angle at the ground; below 0 it has set
  /// Transmittance of the air between the body and each level (layers + 1, from the top), along
  /// the true slant path: 0 where the earth is in the way.
  std::vector<double> transmittance;
};

struct TransferProblem {
  std::vector<BeamIn> beams;   ///< of irradiance 1 on a plane normal to each
  bool thermal = false;        ///< the air's own emission,
  std::vector<double> planck;  ///< black-body radiance at each level (layers + 1)
  bool sky = false;            ///< an even radiance of 1 from outside the air
  bool ground = true;          ///< an even radiance of 1 from the ground
};

/// What one source sends through the air.
struct FieldFluxes {
  double down_at_ground = 0.0;  ///< diffuse irradiance of the ground, without the direct beam
  double up_at_top = 0.0;       ///< irradiance that leaves to space
};

/// Light that is scattered towards a direction at one place for the second time or later, per
/// optical depth: the part J of dI/dtau = -I + J that the field of scattered light causes. What is
/// scattered out of a beam for the first time, and what the air emits, are not in it: whoever
/// follows a path adds both exactly. In azimuth a Fourier sum: J = sum_m J_m cos(m phi), with phi
/// the azimuth from that of the beam's *source* (looking towards the body is phi = 0).
///
/// Places are the layers' edges from inside: index 2 k is the top of layer k, 2 k + 1 its bottom;
/// between them J runs linearly in optical depth.
struct ScatteredSource {
  int modes = 1;              ///< Fourier terms; 1 for all but beams
  std::vector<double> mu;     ///< cosines at which J is given, ascending, -1 to 1; the direction
                              ///< is that in which light *travels*: mu > 0 is upwards
  std::vector<double> value;  ///< [place][mode][mu]
  FieldFluxes fluxes;

  [[nodiscard]] double at(int place, int mode, int mu_index) const {
    const auto n = mu.size();
    return value[(static_cast<std::size_t>(place) * static_cast<std::size_t>(modes) +
                  static_cast<std::size_t>(mode)) *
                     n +
                 static_cast<std::size_t>(mu_index)];
  }
};

struct TransferSolution {
  std::vector<ScatteredSource> beams;    ///< as in the problem
  ScatteredSource thermal, sky, ground;  ///< empty value where not asked for
};

}  // namespace nadir::atmosphere
