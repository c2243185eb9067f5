#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "sim/files/weather_text.hpp"
#include "sim/run/file_weather_derive.hpp"
#include "sim/run/file_weather_series.hpp"

namespace nadir::sim {
namespace {

constexpr double bridged_s = 3.0 * 3600.0;
constexpr double bridge_slack_s = 1.0;

/// A series of the weather and what it is made of.
struct SeriesKind {
  const char* name;
  const char* wanted;  ///< what a file would have to have
  double thermal::WeatherState::*value;
  thermal::TimeSeries thermal::Weather::*series;
  std::optional<double> most;  ///< of sunlight, which keeps its energy; thermal::check's limit
};

const std::array<SeriesKind, 7>& series_kinds() {
  using S = thermal::WeatherState;
  using W = thermal::Weather;
  static const std::array<SeriesKind, 7> kinds{{
      {"air temperature", "air temperature", &S::air_temperature_k, &W::air_temperature_k,
       std::nullopt},
      {"humidity", "dew point, relative humidity or vapour pressure", &S::vapour_pressure_hpa,
       &W::vapour_pressure_hpa, std::nullopt},
      {"air pressure", "pressure", &S::pressure_hpa, &W::pressure_hpa, std::nullopt},
      {"wind speed", "wind speed", &S::wind_speed_m_s, &W::wind_speed_m_s, std::nullopt},
      {"direct sunlight", "direct normal or global horizontal radiation", &S::direct_normal_w_m2,
       &W::direct_normal_w_m2, 1500.0},
      {"diffuse sunlight", "diffuse or global horizontal radiation", &S::diffuse_horizontal_w_m2,
       &W::diffuse_horizontal_w_m2, 1000.0},
      {"long-wave radiation of the sky", "long-wave radiation, or temperature and humidity",
       &S::sky_long_wave_w_m2, &W::sky_long_wave_w_m2, std::nullopt},
  }};
  return kinds;
}

/// The moments that have a value, and what lies between them.
class OneSeries {
 public:
  OneSeries(const WeatherRecord& record, const std::vector<WeatherMoment>& moments,
            const SeriesKind& kind, double late_s)
      : record_{record}, moments_{moments}, kind_{kind}, late_s_{late_s} {
    for (std::size_t i = 0; i < moments.size(); ++i) {
      if (!std::isnan(moments[i].state.*kind.value)) known_.push_back(i);
    }
  }

  /// A mistake where too much is missing.
  [[nodiscard]] std::optional<InputIssue> mistake(const UtcSpan& needed) const {
    if (known_.empty()) {
      return InputIssue{{record_.files.front().string(), 0, 0},
                        fmt::format("the weather has no {}: expected {}", kind_.name, kind_.wanted),
                        {},
                        {}};
    }
    if (known_.front() > 0 && at(known_.front()) > needed.from_s + record_.radiation_mean_s) {
      return missing_from(0, known_.front(), "at the beginning");
    }
    for (std::size_t k = 1; k < known_.size(); ++k) {
      const double gap = at(known_[k]) - at(known_[k - 1]);
      if (known_[k] - known_[k - 1] == 1 || gap <= bridged_s + bridge_slack_s) continue;
      if (at(known_[k]) <= needed.from_s || at(known_[k - 1]) >= needed.to_s - late_s_) continue;
      return missing_from(known_[k - 1] + 1, known_[k], fmt::format("for {:.1f} h", gap / 3600.0));
    }
    if (at(known_.back()) < needed.to_s - late_s_ && known_.back() + 1 < moments_.size()) {
      return missing_from(known_.back() + 1, moments_.size(), "at the end");
    }
    return std::nullopt;
  }

  void tell_of_bridges(const UtcSpan& needed, Diagnostics& diagnostics) const {
    const WeatherRow* first = nullptr;
    std::size_t count = 0;
    for (const WeatherMoment& moment : moments_) {
      const double utc_s = moment.row->utc_s;
      if (!std::isnan(moment.state.*kind_.value)) continue;
      if (utc_s < needed.from_s || utc_s > needed.to_s) continue;
      if (count++ == 0) first = moment.row;
    }
    if (count == 0) return;
    warn_at_row(
        record_, *first,
        fmt::format("{} is missing here{} and bridged", kind_.name,
                    count == 1 ? std::string{} : fmt::format(" and in {} more rows", count - 1)),
        diagnostics);
  }

  [[nodiscard]] thermal::TimeSeries series(double heat_step_s) const {
    std::vector<SpanValue> values;
    for (const std::size_t i : known_) {
      const WeatherMoment& moment = moments_[i];
      const double from = is_mean(moment) ? moment.light_from_s : moment.time_s;
      values.push_back({from, moment.time_s, moment.state.*kind_.value});
    }
    const bool dense = values.size() > 1 &&
                       (values.back().to_s - values.front().to_s) <
                           (heat_step_s - bridge_slack_s) * static_cast<double>(values.size() - 1);
    if (dense) values = joined(values, heat_step_s);
    const bool means = values.front().from_s < values.front().to_s;
    return kind_.most && means ? line_of_means(values, *kind_.most) : line_through(values);
  }

 private:
  /// Radiation of the file; what a formula made of temperatures is of their time.
  [[nodiscard]] bool is_mean(const WeatherMoment& moment) const {
    return kind_.most || (kind_.value == &thermal::WeatherState::sky_long_wave_w_m2 &&
                          !std::isnan((*moment.row)[WeatherQuantity::sky_long_wave_w_m2]));
  }
  [[nodiscard]] double at(std::size_t i) const { return moments_[i].row->utc_s; }

  [[nodiscard]] InputIssue missing_from(std::size_t first, std::size_t end,
                                        const std::string& how_long) const {
    return row_issue(
        record_, *moments_[first].row,
        fmt::format("{} is missing {}, in lines {} to {} ({}); at most 3 h are bridged", kind_.name,
                    how_long, moments_[first].row->line, moments_[end - 1].row->line,
                    span_text({at(first), at(end - 1)})));
  }

  const WeatherRecord& record_;
  const std::vector<WeatherMoment>& moments_;
  const SeriesKind& kind_;
  double late_s_;
  std::vector<std::size_t> known_;
};

/// Where the file covers an end by its intervals, the first and last value hold up to it: means of
/// an hour that are drawn through its middle, temperatures at the ends of the first hour.
void hold_to(thermal::TimeSeries& series, double from_s, double to_s) {
  if (series.time_s.size() < 2) return;  // a single value holds for all times
  if (series.time_s.front() > from_s) {
    series.time_s.insert(series.time_s.begin(), from_s);
    series.value.insert(series.value.begin(), series.value.front());
  }
  if (series.time_s.back() < to_s) {
    series.time_s.push_back(to_s);
    series.value.push_back(series.value.back());
  }
}

double late_end_of(const std::vector<WeatherMoment>& moments) {
  std::vector<WeatherRow> rows;
  for (const WeatherMoment& moment : moments) rows.push_back(*moment.row);
  return late_end_s(rows);
}

}  // namespace

thermal::Weather weather_of(const WeatherRecord& record, const std::vector<WeatherMoment>& moments,
                            const UtcSpan& needed, double heat_step_s, Diagnostics& diagnostics) {
  thermal::Weather weather;
  const double late_s = late_end_of(moments);
  // Times of series count from the picture.
  const double picture_utc_s = moments.front().row->utc_s - moments.front().time_s;
  std::vector<InputIssue> issues;
  for (const SeriesKind& kind : series_kinds()) {
    const OneSeries one{record, moments, kind, late_s};
    if (auto mistake = one.mistake(needed)) {
      issues.push_back(std::move(*mistake));
      continue;
    }
    one.tell_of_bridges(needed, diagnostics);
    weather.*kind.series = one.series(heat_step_s);
    hold_to(weather.*kind.series, needed.from_s - picture_utc_s, needed.to_s - picture_utc_s);
  }
  if (!issues.empty()) throw InputError{std::move(issues)};
  return weather;
}

}  // namespace nadir::sim
