#pragma once

#include <functional>
#include <string>
#include <vector>

#include "atmosphere/layered.hpp"
#include "atmosphere/make/lane_fields.hpp"
#include "atmosphere/table/air_table.hpp"

namespace nadir::atmosphere {

/// What an air table is filled from, whoever made the columns.
struct TableJob {
  struct Body {
    std::string name;
    Vec3 direction_enu;  ///< unit vector
    Angle angular_radius;
    std::vector<double> irradiance;  ///< outside the air, by lane
  };
  std::vector<double> level_m;  ///< of all columns, descending
  std::vector<AirTable::Lane> lanes;
  /// The column of a lane: the same levels and as many kinds for all. Called from many threads.
  std::function<OpticalColumn(std::size_t lane)> column;
  std::vector<Body> bodies;
  std::vector<double> airglow, starlight, urban_glow;  ///< in the zenith, by lane
  AirSettings settings;
  std::vector<AirParts> wanted{};  ///< by lane; empty: all

  [[nodiscard]] AirParts wanted_at(std::size_t lane) const {
    return wanted.empty() ? AirParts{} : wanted[lane];
  }
  /// What any lane wants.
  [[nodiscard]] AirParts wanted_anywhere() const;
};

/// Solves and tabulates every lane, in parallel. Bodies that matter at no lane are left out.
/// @param counts  if given, what was solved is added
/// @throws InputError  the observer inside the ground, settings outside their range
[[nodiscard]] AirTable filled_table(const TableJob& job, SolveCounts* counts = nullptr);

}  // namespace nadir::atmosphere
