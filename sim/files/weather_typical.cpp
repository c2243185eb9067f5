#include "sim/files/weather_typical.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <tuple>

namespace nadir::sim {
namespace {

std::string place_text(const PlaceInYear& at) {
  const int minutes = static_cast<int>(std::lround(at.second / 60.0));
  return fmt::format("{:02d}-{:02d} {:02d}:{:02d}", at.month, at.day, minutes / 60, minutes % 60);
}

}  // namespace

PlaceInYear place_in_year(const WeatherRecord& record, const WeatherRow& row) {
  const double clock = row.utc_s + record.utc_offset_s;
  // Half a second before an end is within its hour.
  const double within = record.radiation_mean_s > 0.0 ? clock - 0.5 : clock;
  const double day = std::floor(within / 86400.0);
  const std::chrono::year_month_day date{
      std::chrono::sys_days{std::chrono::days{static_cast<int>(day)}}};
  return {static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())),
          static_cast<int>(static_cast<unsigned>(date.day())), clock - 86400.0 * day};
}

void check_typical_order(const WeatherRecord& record, const WeatherRow& row, const Token& cell,
                         FileIssues& issues) {
  const PlaceInYear last = place_in_year(record, record.rows.back());
  const PlaceInYear at = place_in_year(record, row);
  if (std::tie(at.month, at.day, at.second) > std::tie(last.month, last.day, last.second)) return;
  issues.add(cell, "times must ascend through the year: " + place_text(at) + " follows " +
                       place_text(last));
}

}  // namespace nadir::sim
