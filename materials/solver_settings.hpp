#pragma once

namespace nadir::materials {

/// How the generic radiometry solver works on one material. The scenario has a default, a material
/// may have its own. docs/radiometry.md explains each.
struct SolverSettings {
  int initial_sample_count = 8;    ///< full samples at the first hit, >= 0
  double sample_decay_rate = 2.0;  ///< full samples at generation g: ceil(initial / decay^g), >= 1
  int max_bounces = 3;             ///< generations that full samples may start, >= 0
  int mu_samples = 2;              ///< quads over the cosine of the zenith angle, >= 1
  int phi_samples = 6;             ///< quads over azimuth, >= 1
  int min_quad_samples = 1;        ///< quads with fewer are topped up with direct-only samples

  bool operator==(const SolverSettings&) const = default;
};

}  // namespace nadir::materials
