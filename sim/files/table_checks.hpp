#pragma once

#include <string>
#include <vector>

#include "ephemeris/instant.hpp"
#include "sim/files/number_table.hpp"

// What tables of numbers have in common beyond their cells: columns that go together, values that
// ascend, moments.

namespace nadir::sim {

/// Columns that mean something only together.
using ColumnGroup = std::vector<std::string>;

/// Index of the one group of which the table has columns. An issue where there is none, more than
/// one, or a column of it is missing: then the result means nothing.
[[nodiscard]] std::size_t only_group(const NumberTable& table,
                                     const std::vector<ColumnGroup>& groups, FileIssues& issues);

/// An issue for every row whose value is not above that of the row before.
void check_ascending(const NumberTable& table, const std::string& column, FileIssues& issues);

/// The columns by which a table says when: time_s, seconds after the origin, or time_utc.
[[nodiscard]] std::vector<NumberColumn> moment_columns(const ephemeris::Instant& origin);

/// The rows' moments, s after the origin. Issues where the table has both columns or none, and
/// where times do not ascend.
[[nodiscard]] std::vector<double> ascending_moments(const NumberTable& table, FileIssues& issues);

}  // namespace nadir::sim
