#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/text_tokens.hpp"
#include "sim/files/weather_record.hpp"

// What the readers of weather share: cells, clocks, limits of what the earth's weather can be.

namespace nadir::sim {

/// The lines of a text, one after the other, with their numbers.
class WeatherLines {
 public:
  explicit WeatherLines(std::string_view text);
  /// The next line; nothing at the end.
  [[nodiscard]] std::optional<Token> next();

 private:
  std::string_view rest_;
  int line_ = 0;
};

/// The cells of a line between commas, without blanks and quotation marks about them.
[[nodiscard]] std::vector<Token> comma_cells(const Token& line);
/// The words of a line between blanks.
[[nodiscard]] std::vector<Token> blank_cells(const Token& line);

/// A column of a file and what it holds: quantity = scale x cell + offset.
struct WeatherColumn {
  std::string name;
  WeatherQuantity quantity = WeatherQuantity::air_temperature_k;
  double scale = 1.0, offset = 0.0;
};

/// Cells with numbers that stand for "not measured".
struct MissingCodes {
  std::optional<double> up_to;  ///< this and less
  std::optional<double> from;   ///< this and more
};

/// The cell's value in the quantity's unit, NaN where it is empty or a code for missing. Radiation
/// a little below zero, as instruments show at night, is zero; a cloud cover or humidity a little
/// above the whole is the whole.
/// An issue where it is no number or nothing that the earth's weather can be.
[[nodiscard]] double weather_value(const Token& cell, const WeatherColumn& column,
                                   const MissingCodes& missing, FileIssues& issues);

/// Days since 1970-01-01, or nothing for a date that does not exist.
[[nodiscard]] std::optional<long> days_of(int year, int month, int day);

/// Seconds since 1970 on the clock that a time is written by: 2026-06-21T16:00, seconds and their
/// decimals optional, a blank instead of the T allowed. Nothing for anything else.
[[nodiscard]] std::optional<double> clock_seconds(std::string_view text);

/// 2026-06-21T16:00Z, with seconds where there are any.
[[nodiscard]] std::string utc_text(double utc_s);

/// Checks and takes the station's place; `cells` are latitude, longitude, height.
void read_place(const std::vector<Token>& cells, WeatherStation& station, FileIssues& issues);

/// A number with its limits; an issue and nothing where it is none or lies outside.
struct NumberLimits {
  std::string name;
  double min = 0.0, max = 0.0;
};
[[nodiscard]] std::optional<double> limited_number(const Token& cell, const NumberLimits& limits,
                                                   FileIssues& issues);

}  // namespace nadir::sim
