#pragma once

#include <vector>

#include "atmosphere/make/lane_fields.hpp"
#include "atmosphere/make/view_paths.hpp"

namespace nadir::atmosphere {

/// Light that comes along a path towards its start, summed up to each share of the way: what light
/// that is scattered or emitted on the way reaches the start, through the delta-scaled air.
struct PathSums {
  std::vector<double> depth, scaled_depth;  ///< true and scaled, by share
  std::size_t sums = 0;                     ///< how many there are, see PathLight
  std::vector<double> light;                ///< [share][sum]
  std::vector<double> rate;  ///< [sum]: what each gains per slant of the first layer at the start
  double depth_so_far = 0.0, scaled_so_far = 0.0;  ///< of the whole way in the end
  double first_depth = 0.0, first_scaled = 0.0;    ///< of the first layer
};

/// Sums light along paths at one lane. The sums are: the components of LaneFields; for each beam
/// and kind the amplitude A of first scattering; for each low beam and azimuth its first scattering
/// with the body's local height, whole.
class PathLight {
 public:
  PathLight(const LaneFields& fields, std::vector<double> azimuths_rad);

  [[nodiscard]] PathSums along(const ViewPath& path, std::size_t shares) const;

  [[nodiscard]] std::size_t first(std::size_t beam, std::size_t kind) const noexcept {
    return fields_.components + beam * kinds_ + kind;
  }
  [[nodiscard]] std::size_t local(std::size_t beam, std::size_t azimuth) const noexcept {
    return local_[beam] + azimuth;
  }
  [[nodiscard]] const std::vector<double>& azimuths_rad() const noexcept { return azimuths_rad_; }

 private:
  struct Phases;  // of a path: by kind and azimuth
  struct Work;
  void add_first(const PathStep& step, double reach, Work& work) const;
  void add_local(const PathStep& step, double reach, Work& work) const;
  void start_rates(const ViewPath& path, PathSums& sums, Work& work) const;
  [[nodiscard]] double local_at(std::size_t beam, int layer, const StepEnd& end,
                                double azimuth_rad) const;

  const LaneFields& fields_;
  std::vector<double> azimuths_rad_;
  std::size_t kinds_;
  std::vector<std::size_t> local_;  // by beam
  std::size_t sums_;
};

/// Cosine of the angle between a direction looked in and a body.
/// @param zenith_rad  of the direction, over where the body's place is given; see ViewPath
[[nodiscard]] double scattering_cosine(double zenith_rad, double azimuth_rad,
                                       const BodyPlace& body) noexcept;

/// What a view tells of a path at one share, from its sums: the light L that the path adds to what
/// comes through it from the far end, T L_end. An object as bright as what lies behind it shall not
/// show; with the way on behind it, L = L_all - r (L_all - L_share), r = T / T' = exp(t' - t).
/// Light of the peak about the object's direction comes with T' instead of T; it is taken for as
/// bright as what lies behind.
class ShareLight {
 public:
  /// @param background  sum by sum, what enters at the path's far end, through all of it
  ShareLight(const PathSums& sums, const std::vector<double>& background);

  /// L of a sum over the path to a share.
  [[nodiscard]] double whole(std::size_t sum, std::size_t share) const noexcept;
  /// The same over 1 - T, the mean source along the way; at share 0 its limit.
  [[nodiscard]] double source(std::size_t sum, std::size_t share) const noexcept;

 private:
  [[nodiscard]] double all(std::size_t sum) const noexcept;
  struct Factors {
    double peak_lost, peak_left, lost;  // 1 - r, r, 1 - T
  };
  const PathSums& sums_;
  const std::vector<double>& background_;
  std::vector<Factors> factors_;  // by share
};

}  // namespace nadir::atmosphere
