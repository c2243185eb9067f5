#include "sim/files/weather_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "sim/files/weather_text.hpp"

namespace nadir::sim {
namespace {

using Q = WeatherQuantity;

const std::vector<WeatherColumn>& csv_columns() {
  static const std::vector<WeatherColumn> columns{
      {"air_temperature_c", Q::air_temperature_k, 1.0, si::zero_celsius},
      {"air_temperature_k", Q::air_temperature_k},
      {"dew_point_c", Q::dew_point_k, 1.0, si::zero_celsius},
      {"dew_point_k", Q::dew_point_k},
      {"relative_humidity_percent", Q::relative_humidity_percent},
      {"vapour_pressure_hpa", Q::vapour_pressure_hpa},
      {"pressure_hpa", Q::pressure_hpa},
      {"pressure_pa", Q::pressure_hpa, 0.01},
      {"wind_speed_m_s", Q::wind_speed_m_s},
      {"direct_normal_w_m2", Q::direct_normal_w_m2},
      {"diffuse_horizontal_w_m2", Q::diffuse_horizontal_w_m2},
      {"global_horizontal_w_m2", Q::global_horizontal_w_m2},
      {"sky_long_wave_w_m2", Q::sky_long_wave_w_m2},
      {"cloud_fraction", Q::cloud_fraction},
      {"cloud_tenths", Q::cloud_fraction, 0.1}};
  return columns;
}

const std::vector<std::string> csv_keys{"station",  "latitude_deg", "longitude_deg",
                                        "height_m", "utc_offset_h", "radiation_mean_s"};
const NumberLimits offset_limits{"hours ahead of UTC", -14.0, 14.0};

/// One file on its way to a record.
class CsvWeather {
 public:
  CsvWeather(std::string_view text, const std::string& name) : lines_{text}, issues_{name} {
    record_.files.emplace_back(name);
  }

  [[nodiscard]] WeatherRecord read() {
    read_head();
    issues_.throw_if_any();  // without sound columns every row would be a mistake
    while (const auto line = lines_.next()) {
      if (is_row(*line)) read_row(comma_cells(*line));
    }
    if (record_.rows.empty() && issues_.empty()) issues_.add("the weather has no rows");
    issues_.throw_if_any();
    return std::move(record_);
  }

 private:
  static bool is_row(const Token& line) {
    const std::string_view content = without_blanks(line.text);
    return !content.empty() && content.front() != '#';
  }

  void read_head() {
    while (const auto line = lines_.next()) {
      if (is_row(*line)) return read_columns(comma_cells(*line));
      read_comment(*line);
    }
    issues_.add("the weather is empty: its first row names the columns");
  }

  /// `# key: value`; other comments pass, but not one that looks like a misspelt key.
  void read_comment(const Token& line) {
    const std::size_t colon = line.text.find(':');
    if (colon == std::string_view::npos) return;
    const std::size_t begin = std::min(line.text.find_first_not_of("# \t"), colon);
    const Token key{without_blanks(line.text.substr(begin, colon - begin)), line.line_text,
                    line.line};
    Token value{without_blanks(line.text.substr(colon + 1)), line.line_text, line.line};
    if (value.text.empty()) value.text = line.text.substr(colon + 1, 0);
    const std::string name{key.text};
    if (std::find(csv_keys.begin(), csv_keys.end(), name) != csv_keys.end()) {
      return take(name, value);
    }
    if (const std::string nearest = nearest_name(name, csv_keys); !nearest.empty()) {
      issues_.add(key, "unknown key \"" + name + "\"", "did you mean \"" + nearest + "\"?");
    }
  }

  void take(const std::string& key, const Token& value) {
    WeatherStation& station = record_.station;
    if (key == "station") station.name = std::string{value.text};
    if (key == "latitude_deg") station.latitude_deg = number(value, {key, -90.0, 90.0});
    if (key == "longitude_deg") station.longitude_deg = number(value, {key, -180.0, 360.0});
    if (key == "height_m") station.height_m = number(value, {key, -500.0, 9000.0});
    if (key == "utc_offset_h") offset_h_ = number(value, offset_limits);
    if (key == "radiation_mean_s") {
      record_.radiation_mean_s = number(value, {key, 0.0, 10800.0}).value_or(0.0);
    }
  }
  std::optional<double> number(const Token& cell, const NumberLimits& limits) {
    return limited_number(cell, limits, issues_);
  }

  void read_columns(const std::vector<Token>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) read_column(cells[i], i);
    if (!utc_ && !local_) {
      issues_.add(cells.front(), "the time is missing: expected a column \"utc\" or \"local\"");
    } else if (utc_ && local_) {
      issues_.add(cells[*local_], "there are two times: expected either \"utc\" or \"local\"");
    } else if (local_ && !offset_h_ && !offset_column_) {
      issues_.add(cells[*local_],
                  "local time without its zone: expected a line such as \"# utc_offset_h: -5\" "
                  "above, or a column \"utc_offset_h\"");
    }
    if (offset_h_) record_.utc_offset_s = local_ ? 3600.0 * *offset_h_ : 0.0;
    columns_in_file_ = cells.size();
  }

  void read_column(const Token& cell, std::size_t index) {
    const std::string name{cell.text};
    if (name == "utc" || name == "local" || name == "utc_offset_h") {
      std::optional<std::size_t>& place =
          name == "utc" ? utc_ : (name == "local" ? local_ : offset_column_);
      if (place) issues_.add(cell, "the column \"" + name + "\" is there twice");
      place = index;
      return;
    }
    const auto& known = csv_columns();
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const WeatherColumn& c) { return c.name == name; });
    if (found == known.end()) return report_unknown(cell, name);
    for (const auto& [at, other] : columns_) {
      if (other.quantity != found->quantity) continue;
      issues_.add(cell, "\"" + name + "\" says what \"" + other.name + "\" has said");
    }
    columns_.push_back({index, *found});
  }

  void report_unknown(const Token& cell, const std::string& name) {
    std::vector<std::string> names{"utc", "local", "utc_offset_h"};
    for (const WeatherColumn& column : csv_columns()) names.push_back(column.name);
    const std::string nearest = nearest_name(name, names);
    issues_.add(cell, "unknown column \"" + name + "\"",
                nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
  }

  void read_row(const std::vector<Token>& cells) {
    if (cells.size() != columns_in_file_) {
      issues_.add(cells.front(),
                  fmt::format("expected {} cells, found {}", columns_in_file_, cells.size()));
      return;
    }
    const auto time = time_of(cells);
    if (!time) return;
    WeatherRow row{0, cells.front().line, *time};
    if (!record_.rows.empty()) check_step(row.utc_s, cells[utc_ ? *utc_ : *local_]);
    for (const auto& [index, column] : columns_) {
      row[column.quantity] = weather_value(cells[index], column, {}, issues_);
    }
    record_.rows.push_back(row);
  }

  void check_step(double utc_s, const Token& cell) {
    const double last_s = record_.rows.back().utc_s;
    if (utc_s <= last_s) {
      issues_.add(cell, "times must ascend: " + utc_text(utc_s) + " follows " + utc_text(last_s));
    } else if (utc_s - last_s < record_.radiation_mean_s - 0.5) {
      issues_.add(cell, fmt::format("{:g} s after the row before, but radiation_mean_s is {:g}",
                                    utc_s - last_s, record_.radiation_mean_s));
    }
  }

  [[nodiscard]] std::optional<double> time_of(const std::vector<Token>& cells) {
    const Token& cell = cells[utc_ ? *utc_ : *local_];
    std::string_view text = cell.text;
    if (utc_) {
      if (!text.ends_with('Z')) text = {};
      if (!text.empty()) text.remove_suffix(1);
    }
    const auto clock = clock_seconds(text);
    if (!clock) {
      issues_.add(cell, fmt::format("expected a time such as {}, found \"{}\"",
                                    utc_ ? "2026-06-21T16:00Z" : "2026-06-21T16:00", cell.text));
      return std::nullopt;
    }
    if (utc_) return clock;
    const auto offset = offset_column_ ? number(cells[*offset_column_], offset_limits) : offset_h_;
    if (!offset) return std::nullopt;
    return *clock - 3600.0 * *offset;
  }

  WeatherLines lines_;
  FileIssues issues_;
  WeatherRecord record_;
  std::optional<double> offset_h_;
  std::optional<std::size_t> utc_, local_, offset_column_;
  std::vector<std::pair<std::size_t, WeatherColumn>> columns_;
  std::size_t columns_in_file_ = 0;
};

}  // namespace

WeatherRecord parse_weather_csv(std::string_view text, const std::string& name) {
  return CsvWeather{text, name}.read();
}

}  // namespace nadir::sim
