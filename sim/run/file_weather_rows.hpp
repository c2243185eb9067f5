#pragma once

#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "sim/files/weather_record.hpp"

namespace nadir::sim {

/// From when to when, seconds since 1970-01-01T00:00Z.
struct UtcSpan {
  double from_s = 0.0, to_s = 0.0;
};

/// `2026-06-21T16:00Z to 2026-06-22T16:00Z`.
[[nodiscard]] std::string span_text(const UtcSpan& span);

/// A mistake at a row's line.
[[nodiscard]] InputIssue row_issue(const WeatherRecord& record, const WeatherRow& row,
                                   std::string message);

/// Tells of what may be wrong at a row's line. Who shows it says that it is a warning.
void warn_at_row(const WeatherRecord& record, const WeatherRow& row, const std::string& message,
                 Diagnostics& diagnostics);

/// The record's rows within a span, by time.
/// @param any_year  rows come with every year by month, day and hour of the file's own clock; a
///                  29 February that the file does not have is its 28th once more, told as a
///                  warning
/// @throws InputError where a time comes twice with the year left out
[[nodiscard]] std::vector<WeatherRow> rows_within(const WeatherRecord& record, const UtcSpan& span,
                                                  bool any_year, Diagnostics& diagnostics);

/// Rows that cover what is needed, without long gaps. The first row speaks for the time that its
/// radiation is the mean of.
/// @param where  of the scenario's element
/// @throws InputError at the element that says what is covered and what is needed; or names the
///         lines about each gap of more than three hours
void check_coverage(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                    const UtcSpan& needed, const SourceLocation& where, Diagnostics& diagnostics);

/// How long the last row may lie before the end of what is needed: minutes end at 23:59.
[[nodiscard]] double late_end_s(const std::vector<WeatherRow>& rows);

/// How far back from the end of what is needed the rows say all that a heat balance has to know,
/// without a hole that is not bridged; with a second of slack.
[[nodiscard]] double rows_reach_back_s(const WeatherRecord& record,
                                       const std::vector<WeatherRow>& rows, const UtcSpan& needed);

}  // namespace nadir::sim
