#pragma once

#include <optional>
#include <vector>

#include "core/sampler.hpp"
#include "geometry/scene.hpp"
#include "radiometry/counters.hpp"
#include "radiometry/lit_scene.hpp"
#include "radiometry/sample_allocation.hpp"
#include "radiometry/surface_point.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

/// The generic radiometry solver: radiance leaving a surface towards the ray that hit it.
///
///     L(wo) = eps(wo) B(T) + sum over targets  f cos E  +  sum over quads  DOmega <f cos L(wi)>
///
/// Quads of the reflecting (and transmitting) hemisphere are filled by full samples (rays whose hit
/// is solved in turn) and topped up with direct-only samples (rays that collect only what their hit
/// emits, or the sky). What a quad receives is split into its direct part, the mean over all its
/// samples, and its scattered part, the sum over its full samples divided by their expected number.
/// Where a quad has samples of one kind only this is the plain mean; otherwise it is what keeps the
/// top-up from darkening the quad. Materials whose lobes are narrower than a quad are sampled by
/// their lobes instead, with the same numbers of samples of both kinds. Bias remains from the
/// bounce limit, from the sample budget where targets use it up, and from the thresholds, which are
/// counted.
///
/// Where the scene leaves interreflection out all samples are direct-only but those that go
/// straight through a clear sheet; without shadows no rays are traced to lights.
///
/// One solver serves one thread: it counts what it does.
class GenericSolver {
 public:
  /// @param scene  lit for Method::generic
  explicit GenericSolver(const LitScene& scene);

  /// Radiance from the surface at `hit` back along `ray`, just above that surface (without the air
  /// in between), W m^-2 sr^-1 um^-1 per lane.
  /// @param ray_weight  share of the ray's radiance that counts at the aperture, in [0, 1]
  [[nodiscard]] spectral::Spectrum surface_radiance(const geometry::Ray& ray,
                                                    const geometry::Hit& hit,
                                                    const Sampler& sampler,
                                                    double ray_weight = 1.0);

  /// Radiance at the ray's origin, through the air: surface or open sky.
  /// @param hit  what the ray meets first, its material resolved
  [[nodiscard]] spectral::Spectrum aperture_radiance(const geometry::Ray& ray,
                                                     const std::optional<geometry::Hit>& hit,
                                                     const Sampler& sampler);

  [[nodiscard]] const Counters& counters() const noexcept { return counters_; }

 private:
  enum class Kind { full, direct_only, none };
  struct Visit;
  struct Sample;
  struct LightsAlong;
  struct Arrival;

  [[nodiscard]] spectral::Spectrum scattered_radiance(const Visit& visit);
  /// Return how many rays were spent: they are taken from the budget of full samples.
  int add_targets(const Visit& visit, int lobe_samples, spectral::SpectrumSum& sum);
  int add_lamps(const Visit& visit, int draws, int lobe_samples, spectral::SpectrumSum& sum);
  [[nodiscard]] int full_samples(const Visit& visit);
  void add_quads(const Visit& visit, int budget, spectral::SpectrumSum& sum);
  void add_quad(const Visit& visit, int quad, const SystematicAllocation::Share& share,
                spectral::SpectrumSum& sum);
  struct LobeSamples {
    int count, full;    ///< in all, and of these full ones
    int lamp_draws;     ///< of the shadow rays
    bool share_lights;  ///< with the shadow rays
  };
  void add_lobes(const Visit& visit, const LobeSamples& samples, spectral::SpectrumSum& sum);
  [[nodiscard]] static double lobe_density(const Visit& visit, Vec3 towards);
  [[nodiscard]] Kind admitted(const Sample& sample, bool full);
  void gather(const geometry::Ray& ray, Arrival& arrival, const Sampler& numbers,
              spectral::SpectrumSum& sum);
  /// Takes in what a ray brings: volumes on its way, then sky or surface.
  void receive(const geometry::Ray& ray, const std::optional<geometry::Hit>& hit, Arrival& arrival,
               const Sampler& numbers, spectral::SpectrumSum& sum);
  void cross_volumes(const geometry::Ray& ray, double distance, Arrival& arrival,
                     const Sampler& numbers, spectral::SpectrumSum& sum);
  void add_sky(const geometry::Ray& ray, const Arrival& arrival, spectral::SpectrumSum& sum) const;
  [[nodiscard]] double share_of_lobes(double density, double other) const noexcept;
  void add_lamp_surface(const geometry::Ray& ray, const geometry::Hit& hit, const Arrival& arrival,
                        spectral::SpectrumSum& sum) const;
  [[nodiscard]] spectral::Spectrum scattered_in_volume(const geometry::Ray& ray,
                                                       const VolumeEvent& event,
                                                       const Arrival& arrival,
                                                       const Sampler& numbers);
  void add_volume_lights(const VolumeEvent& event, Vec3 wo, const Sampler& numbers,
                         spectral::SpectrumSum& sum);

  const LitScene* scene_;
  Counters counters_;
  std::vector<double> importance_;  // of the quads, one row for each generation
  std::size_t row_ = 0;             // length of a row
};

}  // namespace nadir::radiometry
