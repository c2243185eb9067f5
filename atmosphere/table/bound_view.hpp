#pragma once
// Private to this folder: one view of an air table at the lanes of a block.

#include <cstddef>
#include <vector>

#include "atmosphere/air_parts.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/table/air_table.hpp"
#include "atmosphere/table/axis.hpp"
#include "atmosphere/table/lane_kernels.hpp"
#include "atmosphere/table/lane_match.hpp"
#include "core/vec.hpp"

namespace nadir::atmosphere {

/// What is alike for all views of a bound table.
struct AirFrame {
  struct Body {
    std::size_t index = 0;     ///< in the table
    Vec3 towards;              ///< scene axes
    double azimuth_rad = 0.0;  ///< -pi to pi
  };
  std::vector<LaneMatch> matches;  ///< by lane of the block
  double top_m = 0.0, ground_m = 0.0;
  std::vector<Body> bodies;        ///< those whose light the table holds
  std::vector<std::size_t> kinds;  ///< those whose first scattering is not nil
  std::size_t phase_nodes = 0;
  std::vector<float> phase;  ///< [kept kind][angle][padded lane]

  [[nodiscard]] std::size_t padded() const noexcept { return padded_lanes(matches.size()); }
};

/// Rows first to first + count of an array of a table at the lanes of the block, padded with 0, at
/// the end of `out`.
void append_rows(const AirFrame& frame, const AirTable& table, const std::vector<float>& values,
                 std::size_t first, std::size_t count, std::vector<float>& out);

/// The whole way from a point within the air to the ground or the top.
struct WholeWay {
  bool below = false;   ///< it ends on the ground
  double zenith = 0.0;  ///< how far between the zenith (0) and the horizon (1), or between the
                        ///< horizon (0) and the nadir (1)
  double length_m = 0.0;
  double measure_m = 0.0;  ///< air_measure_m
};
[[nodiscard]] WholeWay whole_way(double top_m, double ground_m, PathPoint eye) noexcept;

/// Where a ray looks in a view's table.
struct Look {
  Vec3 direction;
  bool below = false;
  double zenith = 0.0;
  double share = 1.0;
};

class BoundView {
 public:
  struct Want {
    AirLight light;
    bool whole = false;  ///< radiances are to be divided by 1 - T first: those of the table's sky
  };
  /// @param ground  what is wanted of G, padded
  BoundView(const AirTable& table, const AirTable::View& view, const AirFrame& frame,
            const std::vector<float>& ground, Want want);

  [[nodiscard]] double height_m() const noexcept { return height_m_; }
  [[nodiscard]] bool sees_ground() const noexcept { return !below_.empty(); }

  /// Adds `weight` of the extinction per metre of measure and of the source: radiance over 1 - T,
  /// or over 1 - T + sky_floor of a sky.
  void add(const AirFrame& frame, const Look& look, float weight, LaneBuffer& extinction,
           LaneBuffer& source) const noexcept;
  void add_extinction(const AirFrame& frame, const Look& look, LaneBuffer& out) const noexcept;

  /// Nearly nothing where there is air, and what keeps the rest finite where there is none.
  static constexpr float sky_floor = 1e-6F;

 private:
  /// Places around a look and their weights.
  template <std::size_t N>
  struct Cell;
  template <std::size_t N>
  [[nodiscard]] Cell<N> cell(const Look& look, float weight, std::size_t lanes) const noexcept;
  template <std::size_t N>
  void add_cell(const AirFrame& frame, const Look& look, const Cell<N>& cell,
                LaneBuffer& extinction, LaneBuffer& source) const noexcept;
  template <std::size_t N>
  void add_bodies(const AirFrame& frame, Vec3 direction, const Cell<N>& cell,
                  LaneBuffer& source) const noexcept;
  void take_even(const AirTable& table, const AirTable::View& view, const AirFrame& frame,
                 const std::vector<float>& ground, AirLight light);
  void take_bodies(const AirTable& table, const AirTable::View& view, const AirFrame& frame);
  void set_axes(const AirTable::View& view, double horizon_rad);
  void divide_by_loss(const AirTable& table, const AirTable::View& view, const AirFrame& frame);

  double height_m_ = 0.0;
  std::size_t places_ = 0, shares_ = 0, azimuths_ = 0;
  std::size_t bodies_ = 0;  // whose light is wanted: all of the frame's or none
  Axis above_, below_, azimuth_, share_;
  std::vector<float> extinction_;  // [zenith][share][padded lane], as all that follow
  std::vector<float> even_;        // E + G H; empty: no light is wanted
  std::vector<float> first_;       // [body][kept kind]...
  std::vector<float> smooth_;      // [body][azimuth]...
};

}  // namespace nadir::atmosphere
