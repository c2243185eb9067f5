#pragma once

#include "sim/files/text_tokens.hpp"
#include "sim/files/weather_record.hpp"

namespace nadir::sim {

/// A place in the year by the file's own clock. The end of an hour belongs to that hour's day:
/// 24:00 of December 31 is the last of the year.
struct PlaceInYear {
  int year = 0, month = 1, day = 1;
  double second = 0.0;  ///< of the day, up to 86,400
};
[[nodiscard]] PlaceInYear place_in_year(const WeatherRecord& record, const WeatherRow& row);

/// An issue at `cell` where a row does not follow the record's last one, years left out.
void check_typical_order(const WeatherRecord& record, const WeatherRow& row, const Token& cell,
                         FileIssues& issues);

}  // namespace nadir::sim
