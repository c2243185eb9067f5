#include "sim/files/table_checks.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace nadir::sim {
namespace {

std::string columns_text(const ColumnGroup& group) {
  std::string text;
  for (const std::string& column : group) text += (text.empty() ? "" : ", ") + column;
  return text;
}

bool has_any(const NumberTable& table, const ColumnGroup& group) {
  return std::any_of(group.begin(), group.end(),
                     [&](const std::string& column) { return table.has(column); });
}

}  // namespace

std::size_t only_group(const NumberTable& table, const std::vector<ColumnGroup>& groups,
                       FileIssues& issues) {
  std::vector<std::size_t> found;
  std::string all;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    all += (all.empty() ? "" : " or ") + columns_text(groups[i]);
    if (has_any(table, groups[i])) found.push_back(i);
  }
  if (found.empty()) {
    issues.add(table.header(), "expected the columns " + all);
    return 0;
  }
  if (found.size() > 1) {
    issues.add(table.header(), "give either the columns " + columns_text(groups[found[0]]) +
                                   " or " + columns_text(groups[found[1]]) + ", not both");
    return found[0];
  }
  for (const std::string& column : groups[found[0]]) {
    if (!table.has(column)) {
      issues.add(table.header(), "the column " + in_quotes(column) + " is missing");
    }
  }
  return found[0];
}

void check_ascending(const NumberTable& table, const std::string& column, FileIssues& issues) {
  const NumberTable::Row* before = nullptr;
  for (const NumberTable::Row& row : table.rows()) {
    if (before != nullptr && !(table.value(*before, column, 0.0) < table.value(row, column, 0.0))) {
      const Token cell = table.cell(row, column), former = table.cell(*before, column);
      issues.add(cell, column + " must ascend: " + std::string{cell.text} + " follows " +
                           std::string{former.text});
    }
    before = &row;
  }
}

std::vector<NumberColumn> moment_columns(const ephemeris::Instant& origin) {
  constexpr double longest_s = 1e9;  // 30 years: more is a slip
  NumberColumn utc{.name = "time_utc"};
  utc.read = [origin](std::string_view text) {
    return (ephemeris::Instant::parse_utc(text) - origin).value;
  };
  return {{.name = "time_s", .min = -longest_s, .max = longest_s}, std::move(utc)};
}

std::vector<double> ascending_moments(const NumberTable& table, FileIssues& issues) {
  std::vector<double> times_s;
  if (table.has("time_s") == table.has("time_utc")) {
    issues.add(table.header(), table.has("time_s")
                                   ? "give either the column time_s or time_utc, not both"
                                   : "expected the column time_s or time_utc");
    return times_s;
  }
  const std::string column = table.has("time_s") ? "time_s" : "time_utc";
  check_ascending(table, column, issues);
  for (const NumberTable::Row& row : table.rows()) {
    times_s.push_back(table.value(row, column, 0.0));
  }
  return times_s;
}

}  // namespace nadir::sim
