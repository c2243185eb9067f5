#pragma once

#include <optional>

#include "core/sampler.hpp"
#include "geometry/scene.hpp"
#include "radiometry/counters.hpp"
#include "radiometry/lit_scene.hpp"
#include "radiometry/sample_allocation.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

/// The generic radiometry solver: radiance leaving a surface towards the ray that hit it.
///
///     L(wo) = eps B(T) + sum over targets  f cos E  +  sum over quads  DOmega <f cos L(wi)>
///
/// Quads of the reflecting hemisphere are filled by full samples (rays whose hit is solved in turn)
/// and topped up with direct-only samples (rays that collect only what their hit emits, or the
/// sky). What a quad receives is split into its direct part, the mean over all its samples, and its
/// scattered part, the sum over its full samples divided by their expected number. Where a quad has
/// samples of one kind only this is the plain mean; otherwise it is what keeps the top-up from
/// darkening the quad. Bias remains from the bounce limit, from the sample budget where targets use
/// it up, and from the thresholds, which are counted.
///
/// One solver serves one thread: it counts what it does.
class GenericSolver {
 public:
  explicit GenericSolver(const LitScene& scene) noexcept : scene_{&scene} {}

  /// Radiance from the surface at `hit` back along `ray`, just above that surface (without the air
  /// in between), W m^-2 sr^-1 um^-1 per lane.
  /// @param ray_weight  share of the ray's radiance that counts at the aperture, in [0, 1]
  [[nodiscard]] spectral::Spectrum surface_radiance(const geometry::Ray& ray,
                                                    const geometry::Hit& hit,
                                                    const Sampler& sampler,
                                                    double ray_weight = 1.0);

  /// Radiance at the ray's origin, through the air: surface or open sky.
  [[nodiscard]] spectral::Spectrum aperture_radiance(const geometry::Ray& ray,
                                                     const std::optional<geometry::Hit>& hit,
                                                     const Sampler& sampler);

  [[nodiscard]] const Counters& counters() const noexcept { return counters_; }

 private:
  struct Visit;
  enum class Kind { full, direct_only, none };
  /// A direction that light may come from.
  struct Sample {
    double reflected;    ///< f cos for unit reflectance, sr^-1
    double reflectance;  ///< largest reflectance factor pi f over the wavelengths
    double weight;       ///< of the ray that asked, times the former, times the cosine
  };
  /// Returns how many targets were sampled: they are taken from the budget of full samples.
  int add_targets(const Visit& visit, spectral::SpectrumSum& sum);
  void add_background(const Visit& visit, int targets_sampled, spectral::SpectrumSum& sum);
  [[nodiscard]] Kind admitted(const Sample& sample, bool full);
  void add_quad(const Visit& visit, int quad, const SystematicAllocation::Share& share,
                spectral::SpectrumSum& sum);
  [[nodiscard]] spectral::Spectrum scattered_radiance(const Visit& visit);

  const LitScene* scene_;
  Counters counters_;
};

}  // namespace nadir::radiometry
