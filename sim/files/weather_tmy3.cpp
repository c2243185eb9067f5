#include "sim/files/weather_tmy3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "sim/files/weather_text.hpp"
#include "sim/files/weather_typical.hpp"

namespace nadir::sim {
namespace {

using Q = WeatherQuantity;

constexpr const char* tmy3_date = "Date (MM/DD/YYYY)";
constexpr const char* tmy3_time = "Time (HH:MM)";
constexpr MissingCodes tmy3_missing{.up_to = -9900.0, .from = std::nullopt};

const std::vector<WeatherColumn>& tmy3_columns() {
  static const std::vector<WeatherColumn> columns{
      {"GHI (W/m^2)", Q::global_horizontal_w_m2},
      {"DNI (W/m^2)", Q::direct_normal_w_m2},
      {"DHI (W/m^2)", Q::diffuse_horizontal_w_m2},
      {"TotCld (tenths)", Q::cloud_fraction, 0.1},
      {"Dry-bulb (C)", Q::air_temperature_k, 1.0, si::zero_celsius},
      {"Dew-point (C)", Q::dew_point_k, 1.0, si::zero_celsius},
      {"RHum (%)", Q::relative_humidity_percent},
      {"Pressure (mbar)", Q::pressure_hpa},
      {"Wspd (m/s)", Q::wind_speed_m_s}};
  return columns;
}

/// Two digits at a place, or -1.
int two_digits(std::string_view text, std::size_t first) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (text.size() < first + 2 || !is_digit(text[first]) || !is_digit(text[first + 1])) return -1;
  return 10 * (text[first] - '0') + (text[first + 1] - '0');
}

class Tmy3Weather {
 public:
  Tmy3Weather(std::string_view text, const std::string& name) : lines_{text}, issues_{name} {
    record_.files.emplace_back(name);
    record_.typical_year = true;
    record_.radiation_mean_s = 3600.0;
  }

  [[nodiscard]] WeatherRecord read() {
    read_station();
    read_columns();
    issues_.throw_if_any();
    while (const auto line = lines_.next()) {
      if (!without_blanks(line->text).empty()) read_row(comma_cells(*line));
    }
    if (record_.rows.empty() && issues_.empty()) issues_.add("the weather has no rows");
    issues_.throw_if_any();
    return std::move(record_);
  }

 private:
  void read_station() {
    auto line = lines_.next();
    if (!line) return issues_.add("the weather is empty");
    const std::size_t begin = line->text.find_first_not_of("# \t");
    if (begin != std::string_view::npos) line->text.remove_prefix(begin);
    std::vector<Token> cells = comma_cells(*line);
    if (cells.size() < 7) {
      return issues_.add(cells.front(),
                         "expected the station's line: id, name, state, hours ahead of UTC, "
                         "latitude, longitude, height");
    }
    // In shortened files a remark may stand behind the height.
    cells[6].text = cells[6].text.substr(0, cells[6].text.find(' '));
    record_.station.name = std::string{cells[1].text};
    const auto offset = limited_number(cells[3], {"hours ahead of UTC", -14.0, 14.0}, issues_);
    record_.utc_offset_s = 3600.0 * offset.value_or(0.0);
    read_place({cells[4], cells[5], cells[6]}, record_.station, issues_);
  }

  void read_columns() {
    const auto line = lines_.next();
    if (!line) return issues_.add("the line with the names of the columns is missing");
    const std::vector<Token> cells = comma_cells(*line);
    cells_in_row_ = cells.size();
    const auto place_of = [&](const std::string& name) {
      const auto found = std::find_if(cells.begin(), cells.end(),
                                      [&](const Token& cell) { return cell.text == name; });
      return static_cast<std::size_t>(found - cells.begin());
    };
    date_ = place_of(tmy3_date);
    time_ = place_of(tmy3_time);
    for (const char* name : {tmy3_date, tmy3_time}) {
      if (place_of(name) == cells.size()) {
        issues_.add(cells.front(), fmt::format("the column \"{}\" is missing", name));
      }
    }
    for (const WeatherColumn& column : tmy3_columns()) {
      const std::size_t at = place_of(column.name);
      if (at < cells.size()) columns_.push_back({at, column});
    }
  }

  void read_row(const std::vector<Token>& cells) {
    if (cells.size() != cells_in_row_) {
      issues_.add(cells.front(),
                  fmt::format("expected {} cells, found {}", cells_in_row_, cells.size()));
      return;
    }
    const auto clock = clock_of(cells[date_], cells[time_]);
    if (!clock) return;
    WeatherRow row{0, cells.front().line, *clock - record_.utc_offset_s};
    if (!record_.rows.empty()) {
      check_typical_order(record_, row, cells[date_], issues_);
    }
    for (const auto& [index, column] : columns_) {
      row[column.quantity] = weather_value(cells[index], column, tmy3_missing, issues_);
    }
    record_.rows.push_back(row);
  }

  /// MM/DD/YYYY and HH:MM, 01:00 to 24:00.
  [[nodiscard]] std::optional<double> clock_of(const Token& date, const Token& time) {
    const std::string_view d = date.text, t = time.text;
    const bool date_shape = d.size() == 10 && d[2] == '/' && d[5] == '/';
    const auto days =
        date_shape && two_digits(d, 6) >= 0 && two_digits(d, 8) >= 0
            ? days_of(100 * two_digits(d, 6) + two_digits(d, 8), two_digits(d, 0), two_digits(d, 3))
            : std::nullopt;
    if (!days) {
      issues_.add(date, fmt::format("expected a date as MM/DD/YYYY, found \"{}\"", d));
    }
    const int hour = two_digits(t, 0);
    const int minute = t.size() == 5 && t[2] == ':' ? two_digits(t, 3) : -1;
    const bool good = hour >= 0 && minute >= 0 && minute < 60 && 60 * hour + minute <= 1440;
    if (!good) {
      issues_.add(time, fmt::format("expected a time as HH:MM up to 24:00, found \"{}\"", t));
    }
    if (!days || !good) return std::nullopt;
    return 86400.0 * static_cast<double>(*days) + 3600.0 * hour + 60.0 * minute;
  }

  WeatherLines lines_;
  FileIssues issues_;
  WeatherRecord record_;
  std::size_t date_ = 0, time_ = 0, cells_in_row_ = 0;
  std::vector<std::pair<std::size_t, WeatherColumn>> columns_;
};

}  // namespace

WeatherRecord parse_weather_tmy3(std::string_view text, const std::string& name) {
  return Tmy3Weather{text, name}.read();
}

}  // namespace nadir::sim
