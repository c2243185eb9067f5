#include "sim/run/file_weather_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "sim/files/weather_text.hpp"
#include "sim/files/weather_typical.hpp"

namespace nadir::sim {
namespace {

constexpr double longest_gap_s = 3.0 * 3600.0;
constexpr double told_gap_s = 3600.0;  // an hour is what most stations report
constexpr double time_slack_s = 1.0;   // leap seconds, decimals

int year_of(double utc_s) {
  const std::chrono::sys_days day{std::chrono::days{static_cast<int>(std::floor(utc_s / 86400.0))}};
  return static_cast<int>(std::chrono::year_month_day{day}.year());
}

/// What every row has to say, or be bridged; the rest is derived.
std::array<bool (*)(const WeatherRow&), 4> says_what_is_needed() {
  using Q = WeatherQuantity;
  const auto air = [](const WeatherRow& row) { return !std::isnan(row[Q::air_temperature_k]); };
  const auto humidity = [](const WeatherRow& row) {
    return !std::isnan(row[Q::vapour_pressure_hpa]) || !std::isnan(row[Q::dew_point_k]) ||
           !std::isnan(row[Q::relative_humidity_percent] * row[Q::air_temperature_k]);
  };
  const auto wind = [](const WeatherRow& row) { return !std::isnan(row[Q::wind_speed_m_s]); };
  const auto sunlight = [](const WeatherRow& row) {
    return !std::isnan(row[Q::global_horizontal_w_m2]) ||
           !std::isnan(row[Q::direct_normal_w_m2] + row[Q::diffuse_horizontal_w_m2]);
  };
  return {air, humidity, wind, sunlight};
}

/// The first of ascending times from which no gap is longer than can be bridged, up to `end_s`;
/// infinity where they do not reach it.
double unbroken_from(const std::vector<double>& times, double end_s, double late_s) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (times.empty() || times.back() < end_s - late_s) return never;
  std::size_t first = times.size() - 1;
  while (first > 0 && times[first - 1] >= end_s - late_s) --first;
  while (first > 0 && times[first] - times[first - 1] <= longest_gap_s + time_slack_s) --first;
  return times[first] > end_s ? never : times[first];
}

/// A typical record laid over the years of a span.
class YearlyRows {
 public:
  YearlyRows(const WeatherRecord& record, const UtcSpan& span) : record_{record}, span_{span} {
    has_leap_day_ = std::any_of(record.rows.begin(), record.rows.end(), [&](const WeatherRow& row) {
      const PlaceInYear at = place_in_year(record, row);
      return at.month == 2 && at.day == 29;
    });
  }

  [[nodiscard]] std::vector<WeatherRow> rows() {
    for (int year = year_of(span_.from_s) - 1; year <= year_of(span_.to_s) + 1; ++year) {
      for (const WeatherRow& row : record_.rows) place(row, year);
    }
    std::stable_sort(rows_.begin(), rows_.end(),
                     [](const WeatherRow& a, const WeatherRow& b) { return a.utc_s < b.utc_s; });
    return std::move(rows_);
  }
  [[nodiscard]] bool leap_day_made() const { return leap_day_made_; }

 private:
  void place(const WeatherRow& row, int year) {
    const PlaceInYear at = place_in_year(record_, row);
    add(row, days_of(year, at.month, at.day), at.second);
    if (at.month != 2 || at.day != 28 || has_leap_day_) return;
    leap_day_made_ = add(row, days_of(year, 2, 29), at.second) || leap_day_made_;
  }
  bool add(WeatherRow row, std::optional<long> day, double second) {
    if (!day) return false;  // 29 February of a common year
    row.utc_s = 86400.0 * static_cast<double>(*day) + second - record_.utc_offset_s;
    if (row.utc_s < span_.from_s || row.utc_s > span_.to_s) return false;
    rows_.push_back(row);
    return true;
  }

  const WeatherRecord& record_;
  UtcSpan span_;
  bool has_leap_day_ = false, leap_day_made_ = false;
  std::vector<WeatherRow> rows_;
};

void check_unique(const WeatherRecord& record, const std::vector<WeatherRow>& rows) {
  std::vector<InputIssue> issues;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].utc_s > rows[i - 1].utc_s) continue;
    issues.push_back(
        row_issue(record, rows[i],
                  fmt::format("with the year left out this time is there twice, also "
                              "in line {}; give any_year=\"false\" to go by real dates",
                              rows[i - 1].line)));
    if (issues.size() == 5) break;  // a second year has them all
  }
  if (!issues.empty()) throw InputError{std::move(issues)};
}

/// The middle one of the steps between rows.
double usual_step(const std::vector<WeatherRow>& rows) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < rows.size(); ++i) steps.push_back(rows[i].utc_s - rows[i - 1].utc_s);
  if (steps.empty()) return 0.0;
  std::nth_element(steps.begin(), steps.begin() + static_cast<long>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

std::string gap_text(const WeatherRow& before, const WeatherRow& after) {
  return fmt::format("nothing for {:.1f} h after line {}, from {} to {}",
                     (after.utc_s - before.utc_s) / 3600.0, before.line, utc_text(before.utc_s),
                     utc_text(after.utc_s));
}

void check_gaps(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                const UtcSpan& needed, Diagnostics& diagnostics) {
  const double told = std::max(told_gap_s, 1.5 * usual_step(rows)) + time_slack_s;
  const double end_s = needed.to_s - late_end_s(rows);
  std::vector<InputIssue> issues;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const WeatherRow &before = rows[i - 1], &after = rows[i];
    const double gap = after.utc_s - before.utc_s;
    if (after.utc_s <= needed.from_s || before.utc_s >= end_s) continue;
    if (gap > longest_gap_s + time_slack_s) {
      issues.push_back(row_issue(
          record, after,
          "a gap in the weather: " + gap_text(before, after) + "; at most 3 h are bridged"));
    } else if (gap > told) {
      warn_at_row(record, after, "a gap in the weather is bridged: " + gap_text(before, after),
                  diagnostics);
    }
  }
  if (!issues.empty()) throw InputError{std::move(issues)};
}

}  // namespace

std::string span_text(const UtcSpan& span) {
  return utc_text(span.from_s) + " to " + utc_text(span.to_s);
}

InputIssue row_issue(const WeatherRecord& record, const WeatherRow& row, std::string message) {
  return {{record.files[row.file].string(), row.line, 1}, std::move(message), {}, {}};
}

void warn_at_row(const WeatherRecord& record, const WeatherRow& row, const std::string& message,
                 Diagnostics& diagnostics) {
  diagnostics.warn(fmt::format("{}:{}: {}", record.files[row.file].string(), row.line, message));
}

std::vector<WeatherRow> rows_within(const WeatherRecord& record, const UtcSpan& span, bool any_year,
                                    Diagnostics& diagnostics) {
  if (any_year) {
    YearlyRows yearly{record, span};
    std::vector<WeatherRow> rows = yearly.rows();
    check_unique(record, rows);
    if (yearly.leap_day_made()) {
      diagnostics.warn(record.files.front().string() +
                       ": the weather has no 29 February: its 28th is taken again");
    }
    return rows;
  }
  std::vector<WeatherRow> rows;
  for (const WeatherRow& row : record.rows) {
    if (row.utc_s >= span.from_s && row.utc_s <= span.to_s) rows.push_back(row);
  }
  // A typical year's months come from years of their own.
  std::stable_sort(rows.begin(), rows.end(),
                   [](const WeatherRow& a, const WeatherRow& b) { return a.utc_s < b.utc_s; });
  return rows;
}

double late_end_s(const std::vector<WeatherRow>& rows) {
  return std::min(usual_step(rows), 600.0) + time_slack_s;
}

double rows_reach_back_s(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                         const UtcSpan& needed) {
  const double late_s = late_end_s(rows);
  double reach = std::numeric_limits<double>::infinity();
  for (const auto& says : says_what_is_needed()) {
    std::vector<double> times;
    for (const WeatherRow& row : rows) {
      if (says(row)) times.push_back(row.utc_s);
    }
    const double from = unbroken_from(times, needed.to_s, late_s) - record.radiation_mean_s;
    reach = std::min(reach, needed.to_s - from + time_slack_s);
  }
  return std::max(0.0, reach);
}

void check_coverage(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                    const UtcSpan& needed, const SourceLocation& where, Diagnostics& diagnostics) {
  const double early_s = record.radiation_mean_s + time_slack_s;
  const bool covered = !rows.empty() && rows.front().utc_s <= needed.from_s + early_s &&
                       rows.back().utc_s >= needed.to_s - late_end_s(rows);
  if (!covered) {
    UtcSpan all{record.rows.front().utc_s, record.rows.front().utc_s};
    for (const WeatherRow& row : record.rows) {
      all = {std::min(all.from_s, row.utc_s), std::max(all.to_s, row.utc_s)};
    }
    throw InputError{
        InputIssue{where,
                   fmt::format("the weather of {} does not cover the hours before the picture: "
                               "needed are {}, the file has {}",
                               record.files.front().string(), span_text(needed), span_text(all)),
                   {},
                   {}}};
  }
  check_gaps(record, rows, needed, diagnostics);
}

}  // namespace nadir::sim
