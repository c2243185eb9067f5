#include "sim/files/jitter_file.hpp"

#include "sim/files/table_checks.hpp"

namespace nadir::sim {
namespace {

constexpr const char* jitter_columns[3] = {"x_rad2_hz", "y_rad2_hz", "z_rad2_hz"};

}  // namespace

JitterFile parse_jitter_file(std::string_view text, const std::string& name) {
  // A density of zero at a frequency is a gap of the spectrum and allowed; a frequency of zero is a
  // shift, not a shaking.
  constexpr double lowest_hz = 1e-9, highest_hz = 1e9, most_rad2_hz = 1e3;
  std::vector<NumberColumn> known{{"frequency_hz", true, lowest_hz, highest_hz}};
  for (const char* column : jitter_columns) known.push_back({column, false, 0.0, most_rad2_hz});
  const NumberTable table{text, name, std::move(known)};
  FileIssues issues{name};
  check_ascending(table, "frequency_hz", issues);
  if (table.rows().size() < 2) issues.add("a spectrum needs at least two rows");
  JitterFile jitter;
  for (const NumberTable::Row& row : table.rows()) {
    jitter.frequencies_hz.push_back(table.value(row, "frequency_hz", 0.0));
  }
  bool any = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!table.has(jitter_columns[axis])) continue;
    any = true;
    for (const NumberTable::Row& row : table.rows()) {
      jitter.density_rad2_hz[axis].push_back(table.value(row, jitter_columns[axis], 0.0));
    }
  }
  if (!any) {
    issues.add(table.header(),
               "expected at least one of the columns x_rad2_hz, y_rad2_hz, "
               "z_rad2_hz");
  }
  issues.throw_if_any();
  return jitter;
}

JitterFile read_jitter_file(const std::filesystem::path& file) {
  return parse_jitter_file(read_bytes(file), file.string());
}

}  // namespace nadir::sim
