#include "sim/files/weather_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "core/text.hpp"

namespace nadir::sim {
namespace {

/// What the earth's weather can be. Records on the ground: air -89.2 and 56.7 C, dew point 35 C,
/// wind 113 m/s (WMO archive of weather extremes); pressure from 5,500 m up to the highest of
/// Siberia; under broken cloud sunlight may exceed that outside the air for minutes.
struct WeatherLimits {
  double min, max;
  double kept_min, kept_max;  ///< what a little outside is taken for
};
constexpr std::array<WeatherLimits, weather_quantities> limits_of_weather{{
    {180.0, 335.0, 180.0, 335.0},  // air_temperature_k
    {150.0, 310.0, 150.0, 310.0},  // dew_point_k
    {0.0, 110.0, 0.0, 100.0},      // relative_humidity_percent: sensors in fog
    {0.0, 60.0, 0.0, 60.0},        // vapour_pressure_hpa
    {400.0, 1090.0, 400.0, 1090.0},
    {0.0, 120.0, 0.0, 120.0},
    {-30.0, 1400.0, 0.0, 1400.0},  // thermopiles cool to the sky at night
    {-30.0, 1000.0, 0.0, 1000.0},
    {-30.0, 1800.0, 0.0, 1800.0},
    {40.0, 700.0, 40.0, 700.0},
    {0.0, 1.0, 0.0, 1.0},
}};

/// A limit in the file's unit, without the noise of the conversion.
std::string in_unit_of(const WeatherColumn& column, double limit) {
  return nadir::number_text(std::round((limit - column.offset) / column.scale * 1e4) / 1e4);
}

bool is_missing(double number, const MissingCodes& missing) {
  return (missing.up_to && number <= *missing.up_to) || (missing.from && number >= *missing.from);
}

/// Two or four digits as a number, or -1.
int digits_at(std::string_view text, std::size_t first, std::size_t count) {
  if (text.size() < first + count) return -1;
  int value = 0;
  for (const char c : text.substr(first, count)) {
    if (c < '0' || c > '9') return -1;
    value = 10 * value + (c - '0');
  }
  return value;
}

}  // namespace

WeatherLines::WeatherLines(std::string_view text) : rest_{text} {
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

std::optional<Token> WeatherLines::next() {
  if (rest_.empty()) return std::nullopt;
  const std::string_view text = take_line(rest_);
  return Token{text, text, ++line_};
}

std::vector<Token> comma_cells(const Token& line) {
  std::vector<Token> cells;
  const std::string_view whole = line.text;
  for (std::size_t begin = 0; begin <= whole.size();) {
    std::size_t end = begin;
    for (bool quoted = false; end < whole.size() && (quoted || whole[end] != ','); ++end) {
      if (whole[end] == '"') quoted = !quoted;
    }
    std::string_view text = without_blanks(whole.substr(begin, end - begin));
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
      text = text.substr(1, text.size() - 2);
    }
    if (text.empty()) text = whole.substr(begin, 0);  // keeps its place
    cells.push_back({text, line.line_text, line.line});
    begin = end + 1;
  }
  return cells;
}

std::vector<Token> blank_cells(const Token& line) {
  std::vector<Token> cells;
  constexpr const char* blanks = " \t";
  for (std::size_t begin = line.text.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.text.find_first_of(blanks, begin), line.text.size());
    cells.push_back({line.text.substr(begin, end - begin), line.line_text, line.line});
    begin = line.text.find_first_not_of(blanks, end);
  }
  return cells;
}

double weather_value(const Token& cell, const WeatherColumn& column, const MissingCodes& missing,
                     FileIssues& issues) {
  if (cell.text.empty()) return no_weather_value;
  const auto number = strict_number_in<double>(cell.text);
  if (!number) {
    issues.add(cell, fmt::format("expected a number for {}, found \"{}\"", column.name, cell.text));
    return no_weather_value;
  }
  if (is_missing(*number, missing)) return no_weather_value;
  const WeatherLimits& limits = limits_of_weather[static_cast<std::size_t>(column.quantity)];
  const double value = column.scale * *number + column.offset;
  // 1e-9: what the conversion of a limit itself may be off.
  if (value < limits.min - 1e-9 || value > limits.max + 1e-9) {
    issues.add(cell, fmt::format("{} is {}, which no weather is: it must lie from {} to {}",
                                 column.name, cell.text, in_unit_of(column, limits.min),
                                 in_unit_of(column, limits.max)));
    return no_weather_value;
  }
  return std::clamp(value, limits.kept_min, limits.kept_max);
}

std::optional<long> days_of(int year, int month, int day) {
  const std::chrono::year_month_day date{std::chrono::year{year},
                                         std::chrono::month{static_cast<unsigned>(month)},
                                         std::chrono::day{static_cast<unsigned>(day)}};
  if (!date.ok()) return std::nullopt;
  return static_cast<long>(std::chrono::sys_days{date}.time_since_epoch().count());
}

std::optional<double> clock_seconds(std::string_view text) {
  constexpr std::string_view shape = "0000-00-00T00:00";
  if (text.size() < shape.size() || text[4] != '-' || text[7] != '-' || text[13] != ':' ||
      (text[10] != 'T' && text[10] != ' ')) {
    return std::nullopt;
  }
  const int year = digits_at(text, 0, 4), month = digits_at(text, 5, 2),
            day = digits_at(text, 8, 2), hour = digits_at(text, 11, 2),
            minute = digits_at(text, 14, 2);
  if (year < 0 || month < 0 || day < 0 || hour < 0 || hour > 23 || minute < 0 || minute > 59) {
    return std::nullopt;
  }
  double second = 0.0;
  if (const std::string_view rest = text.substr(shape.size()); !rest.empty()) {
    const auto number = rest.size() >= 3 && rest.front() == ':' && digits_at(rest, 1, 2) >= 0
                            ? strict_number_in<double>(rest.substr(1))
                            : std::nullopt;
    if (!number || *number >= 61.0) return std::nullopt;
    second = *number;
  }
  const auto days = days_of(year, month, day);
  if (!days) return std::nullopt;
  return 86400.0 * static_cast<double>(*days) + 3600.0 * hour + 60.0 * minute + second;
}

std::string utc_text(double utc_s) {
  const double whole = std::round(utc_s);
  const double day = std::floor(whole / 86400.0);
  const auto second = static_cast<int>(whole - 86400.0 * day);
  const std::chrono::year_month_day date{
      std::chrono::sys_days{std::chrono::days{static_cast<int>(day)}}};
  const std::string text =
      fmt::format("{:04d}-{:02d}-{:02d}T{:02d}:{:02d}", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  second / 3600, second / 60 % 60);
  return second % 60 == 0 ? text + "Z" : text + fmt::format(":{:02d}Z", second % 60);
}

std::optional<double> limited_number(const Token& cell, const NumberLimits& limits,
                                     FileIssues& issues) {
  std::string_view text = cell.text;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto number = strict_number_in<double>(text);
  if (number && *number >= limits.min && *number <= limits.max) return number;
  issues.add(
      cell, fmt::format("expected {} from {} to {}, found \"{}\"", limits.name,
                        nadir::number_text(limits.min), nadir::number_text(limits.max), cell.text));
  return std::nullopt;
}

void read_place(const std::vector<Token>& cells, WeatherStation& station, FileIssues& issues) {
  station.latitude_deg =
      limited_number(cells[0], {"the station's latitude in degrees", -90.0, 90.0}, issues);
  station.longitude_deg =
      limited_number(cells[1], {"the station's longitude in degrees", -180.0, 360.0}, issues);
  station.height_m =
      limited_number(cells[2], {"the station's height in m", -500.0, 9000.0}, issues);
}

}  // namespace nadir::sim
