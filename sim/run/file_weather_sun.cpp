#include "sim/run/file_weather_sun.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>

#include "core/constants.hpp"
#include "ephemeris/sun_moon.hpp"
#include "sim/files/weather_text.hpp"
#include "sim/run/file_weather_rows.hpp"

namespace nadir::sim {
namespace {

using std::numbers::pi;

constexpr double sun_node_step_s = 21600.0;
constexpr double turning_rad_s = 2.0 * pi / 86400.0;
constexpr double radians_a_degree = pi / 180.0;

constexpr double far_km = 200.0;  // weather fronts, coasts
constexpr double high_m = 500.0;  // 3 K
constexpr double off_noon_h =
    1.5;  // real days are off by up to an hour: morning fog, afternoon cloud

double turned_back(double angle) { return std::remainder(angle, 2.0 * pi); }

/// On a sphere of the earth's mean radius, good to 0.5 %.
double distance_km(const ephemeris::Site& a, double latitude_deg, double longitude_deg) {
  const double half_lat = std::sin(0.5 * radians_a_degree * (latitude_deg - a.latitude_deg));
  const double half_lon = std::sin(0.5 * radians_a_degree * (longitude_deg - a.longitude_deg));
  const double h = half_lat * half_lat + std::cos(radians_a_degree * a.latitude_deg) *
                                             std::cos(radians_a_degree * latitude_deg) * half_lon *
                                             half_lon;
  return 2.0 * 6371.0 * std::asin(std::min(1.0, std::sqrt(h)));
}

/// Whatever sunlight a row holds; NaN counts as none.
double sunlight_of(const WeatherRow& row) {
  const auto or_none = [](double value) { return std::isnan(value) ? 0.0 : value; };
  const double global = row[WeatherQuantity::global_horizontal_w_m2];
  if (!std::isnan(global)) return global;
  return or_none(row[WeatherQuantity::direct_normal_w_m2]) +
         or_none(row[WeatherQuantity::diffuse_horizontal_w_m2]);
}

double elevation_deg(const SunHeights& sun, double time_s) {
  return std::asin(std::clamp(sun.cos_zenith(time_s), -1.0, 1.0)) / radians_a_degree;
}

/// How a record's sunlight lies to the sun.
struct SunlightFound {
  double total = 0.0, in_the_dark = 0.0;
  double sum_sin = 0.0, sum_cos = 0.0;  ///< of hour angles, weighted with sunlight
  const WeatherRow* dark = nullptr;     ///< the brightest in the dark
  double dark_elevation_deg = 0.0;
  std::set<long> days;

  /// Of the sunlight's centre after noon, hours.
  [[nodiscard]] double late_h() const { return std::atan2(sum_sin, sum_cos) * 12.0 / pi; }
};

SunlightFound look_at_sunlight(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                               const SunHeights& sun, double moment_utc_s) {
  // An hour with the sun's centre 4 degrees down in its middle sees it for 20 minutes at the very
  // most, below 3 degrees: a few W/m2.
  constexpr double well_below_deg = -4.0, bright_w_m2 = 20.0;
  SunlightFound found;
  for (const WeatherRow& row : rows) {
    const double light = sunlight_of(row);
    if (light <= 0.0) continue;
    const double time = row.utc_s - moment_utc_s - 0.5 * record.radiation_mean_s;
    const double angle = sun.hour_angle(time);
    found.total += light;
    found.sum_sin += light * std::sin(angle);
    found.sum_cos += light * std::cos(angle);
    found.days.insert(sun.solar_day(time));
    const double elevation = elevation_deg(sun, time);
    if (elevation > well_below_deg || light < bright_w_m2) continue;
    found.in_the_dark += light;
    if (found.dark != nullptr && sunlight_of(*found.dark) >= light) continue;
    found.dark = &row;
    found.dark_elevation_deg = elevation;
  }
  return found;
}

/// `the times look 5 h early`, rounded to half hours.
std::string shift_text(double late_h) {
  const double rounded = std::round(2.0 * late_h) / 2.0;
  if (rounded == 0.0) return "the times look shifted by less than half an hour";
  return fmt::format("the times look {:g} h {}", std::abs(rounded),
                     rounded > 0.0 ? "late" : "early");
}

std::string zone_text(const WeatherRecord& record) {
  const double hours = record.utc_offset_s / 3600.0;
  return hours == 0.0 ? std::string{"the file's times are taken as UTC"}
                      : fmt::format("the file's times are taken as UTC{:+g} h", hours);
}

/// Whose latitude is known; without a longitude that of the scene is as far as can be told.
void check_distance(const WeatherStation& station, const std::string& name, const std::string& file,
                    const ephemeris::Site& site, Diagnostics& diagnostics) {
  const double latitude_deg = *station.latitude_deg;
  const double far =
      distance_km(site, latitude_deg, station.longitude_deg.value_or(site.longitude_deg));
  if (far <= far_km) return;
  if (latitude_deg * site.latitude_deg < 0.0) {
    throw InputError{InputIssue{
        {file, 1, 1},
        fmt::format("{} lies at latitude {:g}, the scene at {:g}: on the other hemisphere", name,
                    latitude_deg, site.latitude_deg),
        {},
        {}}};
  }
  diagnostics.warn(fmt::format("{}: {} lies {:.0f} km from the scene", file, name, far));
}

/// What a day's rows say of its sunlight while the sun is well up.
struct DayOfSun {
  const WeatherRow *first = nullptr, *last = nullptr;
  double light = 0.0, highest_deg = 0.0;
  bool needed = false;

  void add(const WeatherRow& row, double elevation, bool within) {
    if (first == nullptr) first = &row;
    last = &row;
    light += sunlight_of(row);
    highest_deg = std::max(highest_deg, elevation);
    needed = needed || within;
  }
};

bool knows_sunlight(const WeatherRow& row) {
  return !std::isnan(row[WeatherQuantity::global_horizontal_w_m2]) ||
         !std::isnan(row[WeatherQuantity::diffuse_horizontal_w_m2]);
}

/// The days that the rows see the sun well up on.
std::map<long, DayOfSun> days_of_sun(const WeatherRecord& record,
                                     const std::vector<WeatherRow>& rows, const SunHeights& sun,
                                     const UtcSpan& needed) {
  // Below that the thickest clouds may leave less than a file shows.
  constexpr double well_up_deg = 10.0;
  std::map<long, DayOfSun> days;
  for (const WeatherRow& row : rows) {
    const double time = row.utc_s - needed.to_s - 0.5 * record.radiation_mean_s;
    const double elevation = elevation_deg(sun, time);
    if (elevation < well_up_deg || !knows_sunlight(row)) continue;
    const bool within = row.utc_s >= needed.from_s && row.utc_s <= needed.to_s;
    days[sun.solar_day(time)].add(row, elevation, within);
  }
  return days;
}

}  // namespace

SunHeights::SunHeights(const ephemeris::Instant& moment, const ephemeris::Site& site, double from_s,
                       double to_s)
    : from_s_{from_s},
      sin_latitude_{std::sin(radians_a_degree * site.latitude_deg)},
      cos_latitude_{std::cos(radians_a_degree * site.latitude_deg)} {
  const auto steps = static_cast<std::size_t>(std::ceil((to_s - from_s) / sun_node_step_s)) + 1;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double time = from_s + sun_node_step_s * static_cast<double>(i);
    const ephemeris::BodyPosition body = sun_and_moon(moment + Seconds{time}, site).sun;
    const Vec3 to_sun = body.direction_enu;
    // From the site's axes to those of the equator and the meridian.
    const double sine = to_sun.z * sin_latitude_ + to_sun.y * cos_latitude_;
    const double on_meridian = to_sun.z * cos_latitude_ - to_sun.y * sin_latitude_;
    const double angle = std::atan2(-to_sun.x, on_meridian);
    nodes_.push_back({sine, turned_back(angle - turning_rad_s * time),
                      body.distance.value / astro::astronomical_unit_m});
  }
}

SunHeights::Equatorial SunHeights::at(double time_s) const noexcept {
  const double place =
      std::clamp((time_s - from_s_) / sun_node_step_s, 0.0, static_cast<double>(nodes_.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(place), nodes_.size() - 2);
  const double f = place - static_cast<double>(i);
  const Equatorial &a = nodes_[i], &b = nodes_[i + 1];
  return {a.sin_declination + f * (b.sin_declination - a.sin_declination),
          a.hour_angle_offset + f * turned_back(b.hour_angle_offset - a.hour_angle_offset),
          a.distance_au + f * (b.distance_au - a.distance_au)};
}

double SunHeights::hour_angle(double time_s) const noexcept {
  return turned_back(at(time_s).hour_angle_offset + turning_rad_s * time_s);
}

long SunHeights::solar_day(double time_s) const noexcept {
  return std::lround((turning_rad_s * time_s - hour_angle(time_s)) / (2.0 * pi));
}

double SunHeights::cos_zenith(double time_s) const noexcept {
  const Equatorial sun = at(time_s);
  const double cosine = std::sqrt(std::max(0.0, 1.0 - sun.sin_declination * sun.sin_declination));
  return sin_latitude_ * sun.sin_declination +
         cos_latitude_ * cosine * std::cos(sun.hour_angle_offset + turning_rad_s * time_s);
}

double SunHeights::mean_cos_zenith(double from_s, double to_s) const noexcept {
  constexpr int parts = 12;  // of an hour: five minutes, 0.5 % of the hour of sunrise
  double sum = 0.0;
  for (int i = 0; i < parts; ++i) {
    sum += std::max(0.0, cos_zenith(from_s + (to_s - from_s) * (i + 0.5) / parts));
  }
  return sum / parts;
}

double SunHeights::extraterrestrial_w_m2(double time_s) const noexcept {
  const double distance = at(time_s).distance_au;
  return 1361.0 / (distance * distance);
}

void check_place(const WeatherRecord& record, const ephemeris::Site& site,
                 Diagnostics& diagnostics) {
  const WeatherStation& station = record.station;
  const std::string file = record.files.front().string();
  const std::string name = station.name.empty() ? "the station" : station.name;
  if (!station.latitude_deg || !station.longitude_deg) {
    diagnostics.warn(
        fmt::format("{}: the weather does not say where it was measured ({}): whether "
                    "it is of the scene's {} is not checked",
                    file, station.latitude_deg ? "longitude_deg" : "latitude_deg",
                    station.latitude_deg ? "place" : "place and hemisphere"));
  }
  if (station.latitude_deg) check_distance(station, name, file, site, diagnostics);
  if (station.height_m && std::abs(*station.height_m - site.height_m) > high_m) {
    diagnostics.warn(fmt::format("{}: {} lies at {:.0f} m, the scene at {:.0f} m", file, name,
                                 *station.height_m, site.height_m));
  }
}

void check_sunlight_times(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                          const SunHeights& sun, double moment_utc_s, Diagnostics& diagnostics) {
  // Less than this of all sunlight in the dark is an instrument's slip.
  constexpr double slip = 0.003;
  // One stormy afternoon moves a day's centre by two hours.
  constexpr std::size_t enough_days = 3;
  const SunlightFound found = look_at_sunlight(record, rows, sun, moment_utc_s);
  if (found.dark != nullptr && found.in_the_dark > slip * found.total) {
    throw InputError{row_issue(
        record, *found.dark,
        fmt::format("sunlight of {:.0f} W/m2 at {} while the sun stands {:.0f} degrees below the "
                    "horizon of the scene: {}; {}",
                    sunlight_of(*found.dark), utc_text(found.dark->utc_s),
                    -found.dark_elevation_deg, shift_text(found.late_h()), zone_text(record)))};
  }
  if (found.total == 0.0 || std::abs(found.late_h()) <= off_noon_h) return;
  const std::string message =
      fmt::format("the centre of the sunlight lies {:.1f} h {} noon at the scene: {}; {}",
                  std::abs(found.late_h()), found.late_h() > 0.0 ? "after" : "before",
                  shift_text(found.late_h()), zone_text(record));
  if (found.days.size() >= enough_days) throw InputError{row_issue(record, rows.front(), message)};
  warn_at_row(record, rows.front(), message, diagnostics);
}

void check_sunlight_is_there(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                             const SunHeights& sun, const UtcSpan& needed,
                             Diagnostics& diagnostics) {
  constexpr double enough_s = 3.0 * 3600.0;  // a day's rim alone says nothing
  DayOfSun dark;
  std::size_t count = 0;
  for (const auto& [number, day] : days_of_sun(record, rows, sun, needed)) {
    if (!day.needed || day.light > 0.0) continue;
    if (day.last->utc_s - day.first->utc_s + record.radiation_mean_s < enough_s) continue;
    if (count++ == 0) dark.first = day.first;
    dark.last = day.last;
    dark.highest_deg = std::max(dark.highest_deg, day.highest_deg);
  }
  if (count == 0) return;
  const std::string message = fmt::format(
      "no sunlight at all on {}, from {} to {}, while the sun stands up to {:.0f} "
      "degrees high",
      count == 1 ? std::string{"one day"} : fmt::format("{} days", count),
      utc_text(dark.first->utc_s), utc_text(dark.last->utc_s), dark.highest_deg);
  if (count > 1) throw InputError{row_issue(record, *dark.first, message)};
  warn_at_row(record, *dark.first, message, diagnostics);
}

}  // namespace nadir::sim
