#include "sim/files/attitude_file.hpp"

#include <cmath>

#include "core/text.hpp"
#include "sim/files/table_checks.hpp"

namespace nadir::sim {
namespace {

const ColumnGroup attitude_quaternion_columns{"w", "x", "y", "z"};
const ColumnGroup attitude_angle_columns{"yaw_deg", "pitch_deg", "roll_deg"};

std::vector<NumberColumn> known_attitude_columns(const ephemeris::Instant& origin) {
  constexpr double slack = 1e-3;  // of the length, which rounding in a file may give
  std::vector<NumberColumn> known = moment_columns(origin);
  for (const std::string& column : attitude_quaternion_columns) {
    known.push_back({column, false, -1.0 - slack, 1.0 + slack});
  }
  for (const std::string& column : attitude_angle_columns)
    known.push_back({column, false, -360.0, 360.0});
  return known;
}

Quaternion row_quaternion(const NumberTable& table, const NumberTable::Row& row,
                          FileIssues& issues) {
  constexpr double slack = 1e-3;  // more is no rounding: the columns are mixed up
  const Quaternion q{table.value(row, "w", 0.0), table.value(row, "x", 0.0),
                     table.value(row, "y", 0.0), table.value(row, "z", 0.0)};
  const double norm = std::sqrt(dot(q, q));
  if (!(std::abs(norm - 1.0) <= slack)) {
    issues.add(table.cell(row, "w"),
               "a quaternion of length " + number_text(norm) + ", expected 1 within 0.001");
    return {};
  }
  return unit(q);
}

}  // namespace

AttitudeFile parse_attitude_file(std::string_view text, const std::string& name,
                                 const ephemeris::Instant& origin) {
  const NumberTable table{text, name, known_attitude_columns(origin)};
  FileIssues issues{name};
  const std::size_t group =
      only_group(table, {attitude_quaternion_columns, attitude_angle_columns}, issues);
  AttitudeFile attitude{ascending_moments(table, issues), {}, {}};
  issues.throw_if_any();
  std::vector<Quaternion> quaternions;
  std::vector<AttitudeAngles> angles;
  for (const NumberTable::Row& row : table.rows()) {
    attitude.lines.push_back(row.line);
    if (group == 0) {
      quaternions.push_back(row_quaternion(table, row, issues));
    } else {
      angles.push_back({table.value(row, "yaw_deg", 0.0), table.value(row, "pitch_deg", 0.0),
                        table.value(row, "roll_deg", 0.0)});
    }
  }
  issues.throw_if_any();
  if (group == 0) {
    attitude.orientations = std::move(quaternions);
  } else {
    attitude.orientations = std::move(angles);
  }
  return attitude;
}

AttitudeFile read_attitude_file(const std::filesystem::path& file,
                                const ephemeris::Instant& origin) {
  return parse_attitude_file(read_bytes(file), file.string(), origin);
}

}  // namespace nadir::sim
