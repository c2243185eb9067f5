#include "sim/files/weather_epw.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "sim/files/weather_text.hpp"
#include "sim/files/weather_typical.hpp"

namespace nadir::sim {
namespace {

using Q = WeatherQuantity;

constexpr std::size_t epw_header_lines = 8;
constexpr std::size_t epw_most_cells = 35;
/// Up to opaque sky cover; files of old versions end before precipitation.
constexpr std::size_t epw_fewest_cells = 24;

/// A column by its place; what stands for missing differs between them.
struct EpwColumn {
  std::size_t place;
  WeatherColumn column;
  double missing_from;
};
const std::vector<EpwColumn>& epw_columns() {
  static const std::vector<EpwColumn> columns{
      {6, {"dry bulb temperature (C)", Q::air_temperature_k, 1.0, si::zero_celsius}, 99.9},
      {7, {"dew point temperature (C)", Q::dew_point_k, 1.0, si::zero_celsius}, 99.9},
      {8, {"relative humidity (%)", Q::relative_humidity_percent}, 999.0},
      {9, {"station pressure (Pa)", Q::pressure_hpa, 0.01}, 999999.0},
      {12, {"horizontal infrared radiation (Wh/m2)", Q::sky_long_wave_w_m2}, 9999.0},
      {13, {"global horizontal radiation (Wh/m2)", Q::global_horizontal_w_m2}, 9999.0},
      {14, {"direct normal radiation (Wh/m2)", Q::direct_normal_w_m2}, 9999.0},
      {15, {"diffuse horizontal radiation (Wh/m2)", Q::diffuse_horizontal_w_m2}, 9999.0},
      {21, {"wind speed (m/s)", Q::wind_speed_m_s}, 999.0},
      {22, {"total sky cover (tenths)", Q::cloud_fraction, 0.1}, 99.0}};
  return columns;
}

class EpwWeather {
 public:
  EpwWeather(std::string_view text, const std::string& name) : lines_{text}, issues_{name} {
    record_.files.emplace_back(name);
    record_.typical_year = true;
  }

  [[nodiscard]] WeatherRecord read() {
    for (std::size_t i = 0; i < epw_header_lines; ++i) read_header();
    if (!has_periods_) issues_.add("the DATA PERIODS line is missing from the eight header lines");
    issues_.throw_if_any();
    while (const auto line = lines_.next()) {
      if (!without_blanks(line->text).empty()) read_row(comma_cells(*line));
    }
    if (record_.rows.empty() && issues_.empty()) issues_.add("the weather has no rows");
    issues_.throw_if_any();
    return std::move(record_);
  }

 private:
  void read_header() {
    const auto line = lines_.next();
    if (!line) return;
    const std::vector<Token> cells = comma_cells(*line);
    if (line->line == 1) read_location(cells);
    if (cells.front().text == "DATA PERIODS") read_periods(cells);
  }

  void read_location(const std::vector<Token>& cells) {
    if (cells.front().text != "LOCATION" || cells.size() < 10) {
      return issues_.add(cells.front(),
                         "expected LOCATION, city, state, country, source, WMO number, latitude, "
                         "longitude, hours ahead of UTC, height");
    }
    record_.station.name = std::string{cells[1].text};
    read_place({cells[6], cells[7], cells[9]}, record_.station, issues_);
    const auto offset = limited_number(cells[8], {"hours ahead of UTC", -14.0, 14.0}, issues_);
    record_.utc_offset_s = 3600.0 * offset.value_or(0.0);
  }

  void read_periods(const std::vector<Token>& cells) {
    has_periods_ = true;
    if (cells.size() < 3) return issues_.add(cells.front(), "the records in an hour are missing");
    const auto records = limited_number(cells[2], {"records in an hour", 1.0, 60.0}, issues_);
    records_in_hour_ = static_cast<int>(records.value_or(1.0));
    if (3600 % records_in_hour_ != 0) issues_.add(cells[2], "an hour cannot be cut into so many");
    record_.radiation_mean_s = 3600.0 / records_in_hour_;
  }

  void read_row(const std::vector<Token>& cells) {
    if (cells.size() < epw_fewest_cells || cells.size() > epw_most_cells) {
      issues_.add(cells.front(), fmt::format("expected {} to {} cells, found {}", epw_fewest_cells,
                                             epw_most_cells, cells.size()));
      return;
    }
    const auto clock = clock_of(cells);
    if (!clock) return;
    WeatherRow row{0, cells.front().line, *clock - record_.utc_offset_s};
    if (!record_.rows.empty()) check_typical_order(record_, row, cells[1], issues_);
    for (const EpwColumn& c : epw_columns()) {
      const MissingCodes codes{.up_to = std::nullopt, .from = c.missing_from};
      const Token& cell = cells[c.place];
      const bool left_out = c.column.quantity == Q::sky_long_wave_w_m2 && cell.text == "0";
      if (!left_out) row[c.column.quantity] = weather_value(cell, c.column, codes, issues_);
    }
    record_.rows.push_back(row);
  }

  /// Year, month, day, hour 1 to 24; the minute counts where there are several records an hour.
  [[nodiscard]] std::optional<double> clock_of(const std::vector<Token>& cells) {
    const auto year = limited_number(cells[0], {"a year", 1900.0, 2100.0}, issues_);
    const auto month = limited_number(cells[1], {"a month", 1.0, 12.0}, issues_);
    const auto day = limited_number(cells[2], {"a day", 1.0, 31.0}, issues_);
    const auto hour = limited_number(cells[3], {"an hour", 1.0, 24.0}, issues_);
    const auto minute = limited_number(cells[4], {"a minute", 0.0, 60.0}, issues_);
    if (!year || !month || !day || !hour || !minute) return std::nullopt;
    const auto days =
        days_of(static_cast<int>(*year), static_cast<int>(*month), static_cast<int>(*day));
    if (!days) {
      issues_.add(cells[2], "the month has no such day");
      return std::nullopt;
    }
    const double in_hour = records_in_hour_ == 1 ? 3600.0 : 60.0 * *minute;
    return 86400.0 * static_cast<double>(*days) + 3600.0 * (*hour - 1.0) + in_hour;
  }

  WeatherLines lines_;
  FileIssues issues_;
  WeatherRecord record_;
  int records_in_hour_ = 1;
  bool has_periods_ = false;
};

}  // namespace

WeatherRecord parse_weather_epw(std::string_view text, const std::string& name) {
  return EpwWeather{text, name}.read();
}

}  // namespace nadir::sim
