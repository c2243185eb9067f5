#include "thermal/weather/clear_sky.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "atmosphere/make/twilight.hpp"
#include "core/error.hpp"
#include "thermal/surface/humidity.hpp"

namespace nadir::thermal {
namespace {

using std::numbers::pi;

constexpr double diurnal_s = 86400.0;
// Parton & Logan (1981), air 1.5 m above the ground: the warmest moment after the middle of the
// day, and the decay of the night. Their lag of the coldest moment, -0.17 h, is left out: the day's
// low is at sunrise.
constexpr double lag_s = 1.86 * 3600.0;
constexpr double night_decay = 2.20;
// The sun's upper limb on the horizon: half a degree of refraction and a quarter of disc.
const double horizon_cos_zenith = std::sin(-0.8333 * pi / 180.0);

/// Sunrise or sunset.
struct Horizon {
  double time_s = 0.0;
  bool rise = false;
};

std::vector<Horizon> crossings(const std::vector<SunMoment>& sun) {
  std::vector<Horizon> found;
  for (std::size_t i = 1; i < sun.size(); ++i) {
    const double a = sun[i - 1].cos_zenith - horizon_cos_zenith;
    const double b = sun[i].cos_zenith - horizon_cos_zenith;
    if ((a > 0.0) == (b > 0.0)) continue;
    const double share = a / (a - b);
    found.push_back({sun[i - 1].time_s + share * (sun[i].time_s - sun[i - 1].time_s), b > 0.0});
  }
  return found;
}

/// How long before a crossing the one before it was: as a day later, if that is known.
double gap_s(const std::vector<Horizon>& known, std::size_t first, std::size_t second) {
  constexpr double least_s = 60.0;
  if (known.size() < 2) return 0.5 * diurnal_s;
  const double other = std::abs(known[second].time_s - known[first].time_s);
  return std::clamp(diurnal_s - other, least_s, diurnal_s - least_s);
}

/// The temperature of the air through the days.
class DayCycle {
 public:
  DayCycle(const DayOfAir& day, const std::vector<SunMoment>& sun)
      : low_k_{day.low_k}, range_k_{day.high_k - day.low_k}, horizon_{crossings(sun)} {
    if (horizon_.empty()) {
      const auto highest = std::max_element(
          sun.begin(), sun.end(),
          [](const SunMoment& a, const SunMoment& b) { return a.cos_zenith < b.cos_zenith; });
      if (highest->cos_zenith > horizon_cos_zenith) warmest_s_ = highest->time_s + lag_s;
      return;
    }
    // Two before the first moment, since the night needs the day before it.
    while (horizon_.size() < 2 || horizon_[1].time_s > sun.front().time_s) prepend();
    while (horizon_.back().time_s < sun.back().time_s) append();
  }

  [[nodiscard]] double at(double time_s) const {
    if (horizon_.empty()) return without_horizon(time_s);
    const auto after = std::upper_bound(horizon_.begin(), horizon_.end() - 1, time_s,
                                        [](double t, const Horizon& h) { return t < h.time_s; });
    const auto next = static_cast<std::size_t>(after - horizon_.begin());
    const Horizon& last = horizon_[next - 1];
    const double gone_s = time_s - last.time_s;
    const double length_s = horizon_[next].time_s - last.time_s;
    if (last.rise) return by_day(gone_s, length_s);
    const Horizon& rise = horizon_[next - 2];
    const double dusk_k = by_day(last.time_s - rise.time_s, last.time_s - rise.time_s);
    const double end = std::exp(-night_decay);
    const double left = (std::exp(-night_decay * gone_s / length_s) - end) / (1.0 - end);
    return low_k_ + (dusk_k - low_k_) * left;
  }

 private:
  [[nodiscard]] double by_day(double since_rise_s, double length_s) const {
    return low_k_ + range_k_ * std::sin(pi * since_rise_s / (length_s + 2.0 * lag_s));
  }
  [[nodiscard]] double without_horizon(double time_s) const {
    const double mean_k = low_k_ + 0.5 * range_k_;
    if (!warmest_s_) return mean_k;
    return mean_k + 0.5 * range_k_ * std::cos(2.0 * pi * (time_s - *warmest_s_) / diurnal_s);
  }
  void prepend() {
    const double before_s = gap_s(horizon_, 0, 1);
    horizon_.insert(horizon_.begin(), {horizon_.front().time_s - before_s, !horizon_.front().rise});
  }
  void append() {
    const std::size_t n = horizon_.size();
    const double after_s = gap_s(horizon_, n - 1, n < 2 ? 0 : n - 2);
    horizon_.push_back({horizon_.back().time_s + after_s, !horizon_.back().rise});
  }

  double low_k_, range_k_;
  std::vector<Horizon> horizon_;     // empty: the sun neither rises nor sets
  std::optional<double> warmest_s_;  // of a day without night
};

double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto after = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  const auto i = static_cast<std::size_t>(after - x.begin());
  const double share = std::clamp((at - x[i - 1]) / (x[i] - x[i - 1]), 0.0, 1.0);
  return y[i - 1] + share * (y[i] - y[i - 1]);
}

double direct_at(const ClearSkyLight& light, double cos_zenith) {
  const double risen = std::clamp(1.0 - cos_zenith / horizon_cos_zenith, 0.0, 1.0);
  return risen * interpolated(light.cos_zenith, light.direct_normal_w_m2, cos_zenith);
}

/// Below the horizon the sky darkens as measured illuminances do.
double diffuse_at(const ClearSkyLight& light, double cos_zenith) {
  const double above = interpolated(light.cos_zenith, light.diffuse_horizontal_w_m2, cos_zenith);
  if (cos_zenith >= 0.0) return above;
  constexpr double last_twilight_deg = -18.0;
  const double elevation_deg = std::asin(std::max(-1.0, cos_zenith)) * 180.0 / pi;
  if (elevation_deg < last_twilight_deg) return 0.0;
  return above * atmosphere::ground_illuminance_lux(elevation_deg) /
         atmosphere::ground_illuminance_lux(0.0);
}

void require_day(bool holds, const char* what) {
  if (!holds) throw InputError{std::string{"clear-sky weather: "} + what};
}

bool are_light(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](double v) { return std::isfinite(v) && v >= 0.0; });
}

template <class Value, class Key>
bool ascending(const std::vector<Value>& values, Key key) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(key(values[i]))) return false;
    if (i > 0 && !(key(values[i]) > key(values[i - 1]))) return false;
  }
  return true;
}

void check_light(const ClearSkyLight& light) {
  const std::size_t nodes = light.cos_zenith.size();
  require_day(nodes >= 2 && light.direct_normal_w_m2.size() == nodes &&
                  light.diffuse_horizontal_w_m2.size() == nodes,
              "expected as many irradiances as heights of the sun, two at least");
  require_day(ascending(light.cos_zenith, [](double mu) { return mu; }),
              "expected the sun's heights to ascend");
  require_day(are_light(light.direct_normal_w_m2) && are_light(light.diffuse_horizontal_w_m2) &&
                  are_light({light.sky_long_wave_w_m2}),
              "expected irradiances that are not negative");
  require_day(light.profile_k > 0.0, "expected the air's temperature above 0 K");
}

void check_input(const DayOfAir& day, const ClearSkyLight& light,
                 const std::vector<SunMoment>& sun) {
  check_light(light);
  require_day(day.low_k > 0.0 && std::isfinite(day.high_k) && day.high_k >= day.low_k,
              "expected the day's low temperature not above its high one");
  require_day(day.dew_point_k > 0.0 && std::isfinite(day.dew_point_k),
              "expected a dew point above 0 K");
  require_day(!sun.empty() && ascending(sun, [](const SunMoment& m) { return m.time_s; }),
              "expected the sun at ascending times");
  for (const SunMoment& moment : sun) {
    require_day(std::isfinite(moment.cos_zenith) && moment.distance_au > 0.0,
                "expected finite places of the sun");
  }
}

}  // namespace

Weather clear_sky_weather(const DayOfAir& day, const ClearSkyLight& light,
                          const std::vector<SunMoment>& sun) {
  check_input(day, light, sun);
  const DayCycle cycle{day, sun};
  const double dew_hpa = vapour_pressure_of_dew_point_hpa(day.dew_point_k);
  Weather weather;
  const auto put = [](TimeSeries& series, double time_s, double value) {
    series.time_s.push_back(time_s);
    series.value.push_back(value);
  };
  for (const SunMoment& m : sun) {
    const double air_k = cycle.at(m.time_s);
    const double nearness = 1.0 / (m.distance_au * m.distance_au);
    put(weather.air_temperature_k, m.time_s, air_k);
    put(weather.vapour_pressure_hpa, m.time_s, std::min(dew_hpa, saturation_over_water_hpa(air_k)));
    put(weather.pressure_hpa, m.time_s, day.pressure_hpa);
    put(weather.wind_speed_m_s, m.time_s, day.wind_m_s);
    put(weather.direct_normal_w_m2, m.time_s, nearness * direct_at(light, m.cos_zenith));
    put(weather.diffuse_horizontal_w_m2, m.time_s, nearness * diffuse_at(light, m.cos_zenith));
    put(weather.sky_long_wave_w_m2, m.time_s,
        light.sky_long_wave_w_m2 * std::pow(air_k / light.profile_k, 4));
  }
  return weather;
}

}  // namespace nadir::thermal
