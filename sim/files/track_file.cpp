#include "sim/files/track_file.hpp"

#include "sim/files/table_checks.hpp"

namespace nadir::sim {
namespace {

/// In the order of TrackFile::Axes.
const std::vector<ColumnGroup>& track_columns() {
  static const std::vector<ColumnGroup> groups{{"latitude_deg", "longitude_deg", "height_m"},
                                               {"x_m", "y_m", "z_m"},
                                               {"east_m", "north_m", "up_m"}};
  return groups;
}

std::vector<NumberColumn> known_track_columns(const ephemeris::Instant& origin) {
  constexpr double farthest_m = 1e8;  // as for coordinates in scenario files
  std::vector<NumberColumn> known = moment_columns(origin);
  known.push_back({"latitude_deg", false, -90.0, 90.0});
  known.push_back({"longitude_deg", false, -180.0, 360.0});
  known.push_back({"height_m", false, -1e4, farthest_m});
  for (std::size_t axes = 1; axes < track_columns().size(); ++axes) {
    for (const std::string& column : track_columns()[axes]) {
      known.push_back({column, false, -farthest_m, farthest_m});
    }
  }
  return known;
}

}  // namespace

TrackFile parse_track_file(std::string_view text, const std::string& name,
                           const ephemeris::Instant& origin) {
  const NumberTable table{text, name, known_track_columns(origin)};
  FileIssues issues{name};
  const std::size_t axes = only_group(table, track_columns(), issues);
  TrackFile track{ascending_moments(table, issues), static_cast<TrackFile::Axes>(axes), {}};
  if (table.rows().size() < 2) issues.add("a way needs at least two rows");
  issues.throw_if_any();
  const ColumnGroup& columns = track_columns()[axes];
  for (const NumberTable::Row& row : table.rows()) {
    track.points.push_back({table.value(row, columns[0], 0.0), table.value(row, columns[1], 0.0),
                            table.value(row, columns[2], 0.0)});
  }
  return track;
}

TrackFile read_track_file(const std::filesystem::path& file, const ephemeris::Instant& origin) {
  return parse_track_file(read_bytes(file), file.string(), origin);
}

}  // namespace nadir::sim
