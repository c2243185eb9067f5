#include "sim/files/weather_surfrad.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "sim/files/weather_text.hpp"

namespace nadir::sim {
namespace {

using Q = WeatherQuantity;

/// Year, day of the year, month, day, hour, minute, decimal hour, zenith angle; then 20 values.
constexpr std::size_t surfrad_cells = 48;
constexpr MissingCodes surfrad_missing{.up_to = -9999.0, .from = std::nullopt};

struct SurfradColumn {
  std::size_t place;  ///< of the value; its flag of quality follows
  WeatherColumn column;
};
const std::vector<SurfradColumn>& surfrad_columns() {
  static const std::vector<SurfradColumn> columns{
      {8, {"dw_solar (W/m2)", Q::global_horizontal_w_m2}},
      {12, {"direct_n (W/m2)", Q::direct_normal_w_m2}},
      {14, {"diffuse (W/m2)", Q::diffuse_horizontal_w_m2}},
      {16, {"dw_ir (W/m2)", Q::sky_long_wave_w_m2}},
      {38, {"temp (C)", Q::air_temperature_k, 1.0, si::zero_celsius}},
      {40, {"rh (%)", Q::relative_humidity_percent}},
      {42, {"windspd (m/s)", Q::wind_speed_m_s}},
      {46, {"pressure (mb)", Q::pressure_hpa}}};
  return columns;
}

class SurfradWeather {
 public:
  SurfradWeather(std::string_view text, const std::string& name) : lines_{text}, issues_{name} {
    record_.files.emplace_back(name);
  }

  [[nodiscard]] WeatherRecord read() {
    read_station();
    issues_.throw_if_any();
    while (const auto line = lines_.next()) {
      if (const auto cells = blank_cells(*line); !cells.empty()) read_row(cells);
    }
    if (record_.rows.empty() && issues_.empty()) issues_.add("the weather has no rows");
    issues_.throw_if_any();
    record_.radiation_mean_s = time_between_rows();
    return std::move(record_);
  }

 private:
  void read_station() {
    const auto name = lines_.next();
    const auto place = lines_.next();
    if (!place) return issues_.add("expected two lines with the station's name and place");
    record_.station.name = std::string{without_blanks(name->text)};
    const std::vector<Token> cells = blank_cells(*place);
    if (cells.size() < 3) {
      return issues_.add(*place, "expected the station's latitude, longitude and height");
    }
    read_place({cells[0], cells[1], cells[2]}, record_.station, issues_);
  }

  void read_row(const std::vector<Token>& cells) {
    if (cells.size() != surfrad_cells) {
      issues_.add(cells.front(),
                  fmt::format("expected {} numbers, found {}", surfrad_cells, cells.size()));
      return;
    }
    const auto time = time_of(cells);
    if (!time) return;
    WeatherRow row{0, cells.front().line, *time};
    if (!record_.rows.empty() && row.utc_s <= record_.rows.back().utc_s) {
      issues_.add(cells.front(), "times must ascend: " + utc_text(row.utc_s) + " follows " +
                                     utc_text(record_.rows.back().utc_s));
    }
    for (const SurfradColumn& c : surfrad_columns()) {
      if (cells[c.place + 1].text != "0") continue;  // doubtful or worse
      row[c.column.quantity] = weather_value(cells[c.place], c.column, surfrad_missing, issues_);
    }
    record_.rows.push_back(row);
  }

  [[nodiscard]] std::optional<double> time_of(const std::vector<Token>& cells) {
    const auto year = limited_number(cells[0], {"a year of four digits", 1990.0, 2100.0}, issues_);
    const auto month = limited_number(cells[2], {"a month", 1.0, 12.0}, issues_);
    const auto day = limited_number(cells[3], {"a day", 1.0, 31.0}, issues_);
    const auto hour = limited_number(cells[4], {"an hour", 0.0, 24.0}, issues_);
    const auto minute = limited_number(cells[5], {"a minute", 0.0, 59.0}, issues_);
    if (!year || !month || !day || !hour || !minute) return std::nullopt;
    const auto days =
        days_of(static_cast<int>(*year), static_cast<int>(*month), static_cast<int>(*day));
    if (!days) {
      issues_.add(cells[3], "the month has no such day");
      return std::nullopt;
    }
    return 86400.0 * static_cast<double>(*days) + 3600.0 * *hour + 60.0 * *minute;
  }

  /// 60 s since 2009, 180 s before: the shortest step, as rows may be missing.
  [[nodiscard]] double time_between_rows() const {
    double shortest = 180.0;
    for (std::size_t i = 1; i < record_.rows.size(); ++i) {
      shortest = std::min(shortest, record_.rows[i].utc_s - record_.rows[i - 1].utc_s);
    }
    return shortest;
  }

  WeatherLines lines_;
  FileIssues issues_;
  WeatherRecord record_;
};

}  // namespace

WeatherRecord parse_weather_surfrad(std::string_view text, const std::string& name) {
  return SurfradWeather{text, name}.read();
}

std::optional<std::filesystem::path> surfrad_file_of_day(const std::filesystem::path& file,
                                                         long day) {
  const std::string stem = file.stem().string();
  const bool named_alike =
      stem.size() == 8 &&
      std::all_of(stem.begin() + 3, stem.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!named_alike) return std::nullopt;
  const std::chrono::sys_days at{std::chrono::days{day}};
  const std::chrono::year year = std::chrono::year_month_day{at}.year();
  const auto first = days_of(static_cast<int>(year), 1, 1);
  const std::string other = fmt::format("{}{:02d}{:03d}", stem.substr(0, 3),
                                        static_cast<int>(year) % 100, day - *first + 1);
  if (other == stem) return std::nullopt;
  return file.parent_path() / (other + file.extension().string());
}

}  // namespace nadir::sim
