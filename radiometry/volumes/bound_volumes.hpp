#pragma once

#include <optional>
#include <vector>

#include "core/sampler.hpp"
#include "geometry/scene.hpp"
#include "materials/volume/bound_phase.hpp"
#include "radiometry/volumes/bound_volume.hpp"
#include "radiometry/volumes/volume.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

/// Where light is scattered in a volume, and by what.
struct VolumeEvent {
  Vec3 position;                       ///< scene axes, m
  const materials::BoundPhase* phase;  ///< owned by the volumes
  spectral::Spectrum weight;           ///< to multiply the light scattered there by
};

/// The volumes of a scene at the wavelengths of one block of lanes. Overlapping volumes add up.
/// Immutable; no allocation after construction. `numbers` are the call's own: every dimension of
/// them may be used, so the caller passes a child of its sampler, a different one to every call.
///
/// How light travels: a ray is cut into steps on which the same volumes overlap and every grid
/// stays in one of its blocks. The least density of each block, with whatever is homogeneous, is
/// treated in closed form; only what grids hold above it is met by chance.
///   - transmittance: residual ratio tracking, Novak, Selle & Jarosz, ACM TOG 33(6) 179 (2014).
///   - scattering: all lanes on one path. Events are drawn from the mean of the lanes' densities,
///   each
///     weighted with what it still carries, so that the mean of the weights never grows and none
///     exceeds the number of lanes times the mean at the start: spectral decomposition tracking
///     with probabilities that know the path's past, Kutz, Habel, Li & Novak, ACM TOG 36(4) 111
///     (2017), which is the balance heuristic of Miller, Georgiev & Jarosz, ACM TOG 38(4) 70
///     (2019).
///   - absorption never ends a path: it is in the weights.
///   - where a grid's share has become very small, Russian roulette ends the search, without bias.
class BoundVolumes {
 public:
  /// @throws InputError located at the volume for negative or uncovered coefficients, grids whose
  ///         size does not match their values, grids outside boxes, values that are not finite; for
  ///         more than 16 volumes whose bounds overlap at one place
  BoundVolumes(const std::vector<Volume>& volumes, const spectral::Lanes& lanes);

  /// Whether there is no volume that attenuates or scatters at these lanes.
  [[nodiscard]] bool empty() const noexcept { return volumes_.empty(); }
  /// Whether any part of the ray before `distance` lies in a volume: most rays stop here.
  [[nodiscard]] bool crossed(const geometry::Ray& ray, double distance) const noexcept;

  /// Transmittance along the ray's first `distance` m, per lane: exact where all volumes crossed
  /// are homogeneous, otherwise an unbiased estimate in [0, 1] on average (ratio tracking). For
  /// shadow rays.
  [[nodiscard]] spectral::Spectrum transmittance(const geometry::Ray& ray, double distance,
                                                 const Sampler& numbers) const noexcept;

  /// For the path solver. Travels at most `distance` m along the ray: adds throughput x (what the
  /// volumes emit) to `radiance`, and multiplies `throughput` by what is left. Returns where the
  /// path is scattered (throughput then holds the event's weight as well, event.weight is 1), or
  /// none where it arrives at the far end. Unbiased per lane for any optical depth.
  /// @param always_split  at the first segment: see `segment`, used by the caller instead
  [[nodiscard]] std::optional<VolumeEvent> fly(const geometry::Ray& ray, double distance,
                                               const Sampler& numbers,
                                               spectral::Spectrum& throughput,
                                               spectral::SpectrumSum& radiance) const noexcept;

  /// For the generic solver, and for the first segment of a path: transmittance and emission of the
  /// whole segment, and one scattering event placed on it whose weight makes transmittance x far
  /// end + emission + weight x scattered light an unbiased estimate of the light at the ray's
  /// origin (the weight holds the transmittance from the origin to the event and the scattering
  /// coefficient over its density). No event where nothing scatters.
  struct Segment {
    spectral::Spectrum transmittance;
    spectral::Spectrum emission;  ///< W m^-2 sr^-1 um^-1
    std::optional<VolumeEvent> event;
  };
  [[nodiscard]] Segment segment(const geometry::Ray& ray, double distance,
                                const Sampler& numbers) const noexcept;

 private:
  std::vector<BoundVolume> volumes_;
  std::optional<geometry::Region> hull_;  // a box around all of them
  int lanes_ = 0;
};

}  // namespace nadir::radiometry
