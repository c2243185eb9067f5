#include "sim/run/file_weather.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sim/files/text_tokens.hpp"
#include "sim/files/weather_format.hpp"
#include "sim/files/weather_surfrad.hpp"
#include "sim/files/weather_typical.hpp"
#include "sim/run/clear_sky_weather.hpp"
#include "sim/run/file_weather_check.hpp"
#include "sim/run/file_weather_derive.hpp"
#include "sim/run/file_weather_rows.hpp"
#include "sim/run/file_weather_sun.hpp"
#include "sim/run/load_air.hpp"

namespace nadir::sim {
namespace {

constexpr double seconds_a_day = 86400.0;
/// Sunlight about the needed hours tells more surely whether its times are right.
constexpr double sun_margin_s = 2.0 * seconds_a_day;
/// What stands before and after the needed hours bridges gaps at their ends.
constexpr double row_margin_s = 4.0 * 3600.0;

std::optional<WeatherLayout> layout_of(WeatherFormat format) {
  switch (format) {
    case WeatherFormat::csv:
      return WeatherLayout::csv;
    case WeatherFormat::tmy3:
      return WeatherLayout::tmy3;
    case WeatherFormat::epw:
      return WeatherLayout::epw;
    case WeatherFormat::surfrad:
      return WeatherLayout::surfrad;
    case WeatherFormat::automatic:
      break;
  }
  return std::nullopt;
}

double utc_seconds(const ephemeris::Instant& instant) {
  constexpr double julian_day_of_1970 = 2440587.5;
  const ephemeris::UtcDate date = instant.utc();
  return seconds_a_day * (date.day - julian_day_of_1970) + seconds_a_day * date.fraction;
}

/// Appends the days of SURFRAD that lie beside the file that was named.
class DaysBeside {
 public:
  DaysBeside(WeatherRecord& record, InputFiles& files) : record_{record}, files_{files} {}

  void read(const UtcSpan& needed) {
    const long last = day_of(needed.to_s) + 1;  // its midnight closes the last day
    for (long day = day_of(needed.from_s); day <= last; ++day) {
      const auto file = surfrad_file_of_day(record_.files.front(), day);
      if (file && std::filesystem::exists(*file)) append(*file);
    }
    std::stable_sort(record_.rows.begin(), record_.rows.end(),
                     [](const WeatherRow& a, const WeatherRow& b) { return a.utc_s < b.utc_s; });
  }

 private:
  static long day_of(double utc_s) { return static_cast<long>(std::floor(utc_s / seconds_a_day)); }

  void append(const std::filesystem::path& file) {
    const std::string text = read_bytes(files_.note(file));
    const WeatherRecord day = parse_weather_surfrad(text, file.string());
    for (WeatherRow row : day.rows) {
      row.file = record_.files.size();
      record_.rows.push_back(row);
    }
    record_.files.push_back(file);
    // One and three minutes meet at the turn of 2009; rows never reach back beyond the one before.
    record_.radiation_mean_s = std::max(record_.radiation_mean_s, day.radiation_mean_s);
  }

  WeatherRecord& record_;
  InputFiles& files_;
};

/// The same hours in the year that a file of one day is of.
UtcSpan in_year_of(const WeatherRecord& record, const UtcSpan& needed, double moment_utc_s) {
  WeatherRow moment;
  moment.utc_s = moment_utc_s;
  WeatherRecord utc;
  const int years = place_in_year(utc, record.rows.front()).year - place_in_year(utc, moment).year;
  const double shift = seconds_a_day * std::round(365.2425 * years);
  return {needed.from_s + shift - (years == 0 ? 0.0 : seconds_a_day),
          needed.to_s + shift + (years == 0 ? 0.0 : seconds_a_day)};
}

WeatherRecord read_record(const WeatherFileInput& input, const UtcSpan& needed, InputFiles& files) {
  const std::string text = read_bytes(files.note(input.file));
  const std::string name = input.file.string();
  const WeatherLayout layout =
      layout_of(input.format) ? *layout_of(input.format) : weather_layout_of(text, name);
  WeatherRecord record = parse_weather(text, name, layout);
  if (layout == WeatherLayout::surfrad) {
    const bool any_year = input.any_year.value_or(false);
    DaysBeside{record, files}.read(any_year ? in_year_of(record, needed, needed.to_s) : needed);
  }
  return record;
}

thermal::ClearSkyFormula formula_of(SkyLongWave choice) {
  using thermal::ClearSkyFormula;
  if (choice == SkyLongWave::swinbank) return ClearSkyFormula::swinbank;
  if (choice == SkyLongWave::brutsaert) return ClearSkyFormula::brutsaert;
  if (choice == SkyLongWave::idso) return ClearSkyFormula::idso;
  return ClearSkyFormula::prata;
}

bool lacks_long_wave(const std::vector<WeatherRow>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const WeatherRow& row) {
    return std::isnan(row[WeatherQuantity::sky_long_wave_w_m2]);
  });
}

}  // namespace

thermal::Weather file_weather(const Scenario& scenario, const WeatherFileInput& input,
                              double history_s, InputFiles& files, Diagnostics& diagnostics) {
  const double moment_utc_s = utc_seconds(scenario.time);
  const UtcSpan needed{moment_utc_s - history_s, moment_utc_s};
  const WeatherRecord record = read_record(input, needed, files);
  const ephemeris::Site site{scenario.origin.latitude_deg, scenario.origin.longitude_deg,
                             scenario.origin.height_m};
  check_place(record, site, diagnostics);

  const bool any_year = input.any_year.value_or(record.typical_year);
  const auto about = [&](double margin_s, Diagnostics& told) {
    return rows_within(record, {needed.from_s - margin_s, needed.to_s + margin_s}, any_year, told);
  };
  const std::vector<WeatherRow> rows = about(row_margin_s, diagnostics);
  check_coverage(record, rows, needed, input.where, diagnostics);
  const SunHeights sun{scenario.time, site, -history_s - sun_margin_s - seconds_a_day,
                       sun_margin_s + seconds_a_day};
  Diagnostics beyond;  // what is told of days that are not needed
  const std::vector<WeatherRow> sunlit = about(sun_margin_s, beyond);
  check_sunlight_times(record, sunlit, sun, moment_utc_s, diagnostics);
  check_sunlight_is_there(record, sunlit, sun, needed, diagnostics);
  check_humidity(record, rows);
  check_air_temperature(record, rows, site, needed, diagnostics);

  SkyChoice sky{formula_of(input.long_wave), nullptr};
  thermal::Weather clear;
  if (input.long_wave == SkyLongWave::from_air && lacks_long_wave(rows)) {
    ClearSkyInput of_air;
    of_air.where = input.where;
    clear = clear_sky_weather_of(scenario, of_air, history_s, files, diagnostics);
    sky.clear = &clear;
  }
  const WeatherView view{moment_utc_s, site.height_m, &sun, sky};
  const std::vector<WeatherMoment> moments = derive(record, rows, view, diagnostics);
  const double heat_step_s = scenario.heat ? scenario.heat->settings.step_s : 600.0;
  thermal::Weather weather = weather_of(record, moments, needed, heat_step_s, diagnostics);
  at_element(input.where, [&] { thermal::check(weather); });
  return weather;
}

double file_weather_reaches_back_s(const Scenario& scenario, const WeatherFileInput& input,
                                   double longest_s, InputFiles& files) {
  const double moment_utc_s = utc_seconds(scenario.time);
  const UtcSpan looked{moment_utc_s - longest_s, moment_utc_s};
  InputFiles beside;  // days of SURFRAD that may not be needed are not noted
  const WeatherRecord record = read_record(input, looked, beside);
  files.note(input.file);
  Diagnostics untold;
  const std::vector<WeatherRow> rows =
      rows_within(record, {looked.from_s - row_margin_s, looked.to_s + row_margin_s},
                  input.any_year.value_or(record.typical_year), untold);
  const double reach = rows_reach_back_s(record, rows, looked);
  return reach >= longest_s ? std::numeric_limits<double>::infinity() : reach;
}

}  // namespace nadir::sim
