#include "sim/run/load_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "sensor/orbit/sgp4.hpp"
#include "sensor/platform/flight.hpp"
#include "sim/files/oem_file.hpp"
#include "sim/files/tle_file.hpp"
#include "sim/files/track_file.hpp"
#include "sim/run/load_air.hpp"

namespace nadir::sim {
namespace {

constexpr double metres_per_km = 1e3;
constexpr double seconds_per_minute = 60.0;

/// Loads one kind of position each.
class TrackLoader {
 public:
  explicit TrackLoader(const PlatformTask& task) : task_{task} {}

  sensor::Track operator()(const geometry::Geodetic& place) const {
    return sensor::Track{task_.frame.enu(place)};
  }
  sensor::Track operator()(const Vec3& place) const {
    return sensor::Track{load_place({place, task_.input().on_terrain}, task_)};
  }
  sensor::Track operator()(const StraightInput& input) const {
    const sensor::StraightFlight flight{geodetic(input.place), input.azimuth_deg, input.speed_m_s,
                                        input.climb_m_s};
    return along(flight);
  }
  sensor::Track operator()(const CircleInput& input) const {
    const sensor::CirclingFlight flight{geodetic(input.centre), input.radius_m, input.speed_m_s,
                                        input.azimuth_deg, input.clockwise};
    return along(flight);
  }
  sensor::Track operator()(const WaypointsInput& input) const {
    const TrackFile file = read_track_file(task_.files.note(input.file), task_.scenario.time);
    require({file.times_s.front(), file.times_s.back()}, input.file);
    // Straight pieces are sparse on purpose.
    check_steps(file.times_s, input.straight ? 2 : most_points,
                input.straight ? input.max_gap_s : longest_step_s(file.times_s, input.max_gap_s),
                input.file);
    std::vector<Vec3> positions;
    for (const Vec3& point : file.points) positions.push_back(position(file.axes, point));
    return {file.times_s, std::move(positions), input.straight ? 2 : most_points};
  }
  sensor::Track operator()(const sensor::Overpass& overpass) const {
    return (*this)(sensor::circular_orbit(overpass, task_.scenario.time));
  }
  sensor::Track operator()(const sensor::KeplerElements& elements) const {
    return tabulated(
        [&](double time_s) { return sensor::orbit_state(elements, moment(time_s)).position; });
  }
  sensor::Track operator()(const TwoLineInput& input) const {
    const sensor::Sgp4 model{read_two_line_elements(task_.files.note(input.file), input.satellite)};
    return tabulated([&](double time_s) {
      const ephemeris::Instant time = moment(time_s);
      sensor::StateVector teme = model.teme_km((time - model.epoch()).value / seconds_per_minute);
      teme.position = teme.position * metres_per_km;
      teme.velocity = teme.velocity * metres_per_km;
      return sensor::ecef_from_teme(teme, time).position;
    });
  }
  sensor::Track operator()(const EphemerisInput& input) const {
    const OrbitEphemeris message =
        read_oem(task_.files.note(input.file), task_.scenario.time.ut1_utc());
    std::vector<double> times_s;
    std::vector<Vec3> positions;
    for (const EphemerisPoint& point : message.points) {
      times_s.push_back((point.time - task_.scenario.time).value);
      positions.push_back(task_.frame.enu_from_ecef(point.ecef.position));
    }
    require({times_s.at(message.first_useable), times_s.at(message.last_useable)}, input.file);
    check_steps(times_s, most_points, longest_step_s(times_s, input.max_gap_s), input.file);
    return {std::move(times_s), std::move(positions), most_points};
  }

 private:
  static constexpr int most_points = 8;

  [[nodiscard]] ephemeris::Instant moment(double time_s) const {
    return task_.scenario.time + Seconds{time_s};
  }
  [[nodiscard]] geometry::Geodetic geodetic(const PlaceInput& place) const {
    const auto* given = std::get_if<geometry::Geodetic>(&place.where);
    return given != nullptr ? *given : task_.frame.geodetic(load_place(place, task_));
  }
  [[nodiscard]] Vec3 position(TrackFile::Axes axes, Vec3 point) const {
    if (axes == TrackFile::Axes::geodetic) return task_.frame.enu({point.x, point.y, point.z});
    return axes == TrackFile::Axes::earth ? task_.frame.enu_from_ecef(point) : point;
  }
  [[nodiscard]] sensor::Track tabulated(const sensor::PositionLaw& law) const {
    return sensor::tabulated(law, task_.frame, task_.span.first_s, task_.span.last_s);
  }
  template <class Flight>
  [[nodiscard]] sensor::Track along(const Flight& flight) const {
    return tabulated([&](double time_s) {
      return task_.frame.ecef(task_.frame.enu(sensor::place_at(flight, time_s)));
    });
  }
  void require(const sensor::TimeSpan& covered, const std::filesystem::path& file) const {
    if (!leaves_open(covered, task_)) return;
    throw InputError{"time outside the trajectory: " +
                     open_message(file.filename().string(), covered, task_)};
  }
  void check_steps(const std::vector<double>& times_s, int points, std::optional<double> longest_s,
                   const std::filesystem::path& file) const {
    if (!longest_s) return;
    const auto gap = gap_of(times_s, points, *longest_s, task_.span);
    if (!gap) return;
    throw InputError{InputIssue{
        {},
        fmt::format("gap in the trajectory: {} has no place for {:.9g} s, from {:.9g} s to {:.9g} "
                    "s after the scenario's time; at most {:.9g} s may lie between two places",
                    file.filename().string(), gap->length_s(), gap->begin_s, gap->end_s,
                    *longest_s),
        "max_gap_s says how long it may be; unless it does, five times the median step",
        {}}};
  }

  const PlatformTask& task_;
};

}  // namespace

Vec3 load_place(const PlaceInput& place, const PlatformTask& task) {
  if (const auto* geodetic = std::get_if<geometry::Geodetic>(&place.where)) {
    return task.frame.enu(*geodetic);
  }
  const Vec3 local = std::get<Vec3>(place.where);
  return place.on_terrain ? task.terrain.lifted(local) : local;
}

sensor::Track load_track(const PlatformTask& task) {
  return at_element(task.input().position_where, [&] {
    try {
      return std::visit(TrackLoader{task}, task.input().position);
    } catch (const sensor::PropagationError& error) {
      throw InputError{std::string{"SGP4: "} + error.what()};
    }
  });
}

bool leaves_open(const sensor::TimeSpan& covered, const PlatformTask& task) noexcept {
  constexpr double rounding_s = 1e-9;  // of times that went through a calendar
  return task.span.first_s < covered.first_s - rounding_s ||
         task.span.last_s > covered.last_s + rounding_s;
}

std::string open_message(const std::string& file, const sensor::TimeSpan& covered,
                         const PlatformTask& task) {
  return fmt::format(
      "the camera looks from {:.9g} s to {:.9g} s after the scenario's time, but {} covers {:.9g} "
      "s "
      "to {:.9g} s",
      task.span.first_s, task.span.last_s, file, covered.first_s, covered.last_s);
}

std::optional<double> longest_step_s(const std::vector<double>& times_s,
                                     std::optional<double> max_gap_s) {
  constexpr std::size_t fewest = 8;
  constexpr double usual_steps = 5.0;
  if (max_gap_s || times_s.size() < fewest) return max_gap_s;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < times_s.size(); ++i) steps_s.push_back(times_s[i] - times_s[i - 1]);
  const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  return usual_steps * *middle;
}

std::optional<TableStep> gap_of(const std::vector<double>& times_s, int points, double longest_s,
                                const sensor::TimeSpan& span) {
  constexpr double rounding_s = 1e-9;  // of times that went through a calendar
  const auto rows = static_cast<std::ptrdiff_t>(times_s.size());
  const std::ptrdiff_t used = std::min<std::ptrdiff_t>(points, rows);
  const auto row = [&](auto found) { return found - times_s.begin() - 1; };
  // The steps in which the span begins and ends; at a row, those that are inside.
  const auto begin =
      row(std::upper_bound(times_s.begin(), times_s.end(), span.first_s + rounding_s));
  const auto end = row(std::lower_bound(times_s.begin(), times_s.end(), span.last_s - rounding_s));
  // The places that a step's polynomial goes through: as sensor::Track chooses them.
  const auto window = [&](std::ptrdiff_t step) {
    return used == 2 ? step : std::clamp<std::ptrdiff_t>(step - (used / 2 - 1), 0, rows - used);
  };
  const std::ptrdiff_t last = std::min(window(end) + used - 1, rows - 1);
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(window(begin), 0); i < last; ++i) {
    const TableStep step{times_s[static_cast<std::size_t>(i)],
                         times_s[static_cast<std::size_t>(i) + 1]};
    if (step.length_s() > longest_s * (1.0 + 1e-9)) return step;
  }
  return std::nullopt;
}

}  // namespace nadir::sim
