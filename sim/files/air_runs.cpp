#include "sim/files/air_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "atmosphere/paths/path_measure.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "core/error.hpp"
#include "core/quantity.hpp"
#include "sim/files/air_run_grid.hpp"

namespace nadir::sim {
namespace {

using atmosphere::AirTable;

std::vector<float> floats(const std::vector<double>& values, std::size_t count) {
  std::vector<float> result(count, 0.0F);
  std::transform(values.begin(), values.end(), result.begin(),
                 [](double value) { return static_cast<float>(value); });
  return result;
}

/// An eye above the air is one at its top, where the ray comes in: sin(zenith) r stays the same.
void bring_to_top(AirRun& run, const AirRunSettings& settings) {
  if (run.height_m <= settings.top_m) return;
  const double mu = std::cos(run.zenith_rad);
  const double way = atmosphere::way_down_to_m({run.height_m, mu}, settings.top_m);
  if (way < 0.0) {
    throw InputError{fmt::format("{}: the direction misses the air, which ends at {} m", run.name,
                                 settings.top_m)};
  }
  const double mu_top = atmosphere::advanced({run.height_m, mu}, way).mu;
  run.height_m = settings.top_m;
  run.zenith_rad = std::acos(std::clamp(mu_top, -1.0, 1.0));
  run.length_m -= way;
}

bool is_whole(const AirRun& run, const AirRunSettings& settings) {
  const double way = atmosphere::way_to_end_m(settings.top_m, settings.ground_m, run.height_m,
                                              std::cos(run.zenith_rad));
  // 1 %: other programs bend the ray, and some end a little off the ground or the top.
  return run.length_m >= 0.99 * way;
}

/// Runs as they are used: within the air, whole ways without an end.
std::vector<AirRun> normalised_runs(std::vector<AirRun> runs, const AirRunSettings& settings) {
  for (AirRun& run : runs) {
    bring_to_top(run, settings);
    // 1 m: heights are written in km with three decimals.
    if (run.height_m < settings.ground_m - 1.0) {
      throw InputError{fmt::format("{}: the eye at {} m is below the ground at {} m", run.name,
                                   run.height_m, settings.ground_m)};
    }
    run.height_m = std::max(run.height_m, settings.ground_m);
    if (is_whole(run, settings)) run.length_m = std::numeric_limits<double>::infinity();
    if (!(run.length_m > 0.0)) {
      throw InputError{fmt::format("{}: the way has length {}", run.name, run.length_m)};
    }
  }
  return runs;
}

bool same_height(double a, double b) { return std::abs(a - b) < 1.0; }

/// The hemisphere's irradiance by what is tabulated at zenith (rows) and azimuth nodes, linear
/// between them and held beyond: integral of L cos sin over both angles, by the midpoint rule.
double irradiance(const std::vector<double>& zenith, const std::vector<double>& azimuth,
                  const auto& radiance) {
  // 180 x 36 cells: the rule's error for a smooth sky is below 1e-4.
  constexpr int rows = 180, columns = 36;
  double sum = 0.0;
  for (int row = 0; row < rows; ++row) {
    const double theta = (row + 0.5) * std::numbers::pi / 2.0 / rows;
    const NodePair z = node_pair(zenith, theta);
    double ring = 0.0;
    for (int column = 0; column < columns; ++column) {
      const NodePair a = node_pair(azimuth, (column + 0.5) * std::numbers::pi / columns);
      ring += (1.0 - z.share) * ((1.0 - a.share) * radiance(z.first, a.first) +
                                 a.share * radiance(z.first, a.second)) +
              z.share * ((1.0 - a.share) * radiance(z.second, a.first) +
                         a.share * radiance(z.second, a.second));
    }
    sum += ring / columns * std::cos(theta) * std::sin(theta);
  }
  return sum * 2.0 * std::numbers::pi * std::numbers::pi / 2.0 / rows;
}

class TableOfRuns {
 public:
  TableOfRuns(const AirRunSet& set, const AirRunSettings& settings)
      : set_{set}, settings_{settings}, runs_{normalised_runs(set.runs, settings)} {}

  AirTable table() {
    start();
    sun();
    sky();
    views();
    ground();
    check(table_);
    return std::move(table_);
  }

 private:
  [[nodiscard]] std::size_t lanes() const { return set_.wavelength_um.size(); }
  void note(std::string text) { table_.notes.push_back(std::move(text)); }

  void start() {
    if (runs_.empty()) throw InputError{"no run looks along a path: a table needs at least one"};
    for (const double wavelength : set_.wavelength_um)
      table_.lanes.push_back({wavelength, {}, 1.0});
    table_.ground_m = settings_.ground_m;
    table_.top_m = settings_.top_m;
    table_.made_by = set_.made_by;
    table_.notes = set_.notes;
    note(
        "all scattered sunlight is in the smooth part: around the sun the sky is as coarse as the "
        "directions of the runs");
    note("the ground about does not light the air: runs do not tell what it adds to paths");
  }

  [[nodiscard]] bool sunlit() const {
    return std::any_of(runs_.begin(), runs_.end(),
                       [](const AirRun& run) { return !run.solar.empty(); }) ||
           !set_.sun_transmittance.empty();
  }

  void sun() {
    if (!sunlit()) return;
    const auto zenith = settings_.sun_zenith_rad ? settings_.sun_zenith_rad : set_.sun_zenith_rad;
    if (!zenith) throw InputError{"the runs do not say how high the sun stands: give its zenith"};
    if (!settings_.sun_azimuth_rad) {
      throw InputError{"the runs do not say where north is: give the sun's azimuth"};
    }
    if (set_.sun_irradiance.empty()) {
      throw InputError{"no run gives the sun's irradiance outside the air"};
    }
    AirTable::Body body{"sun", *zenith, *settings_.sun_azimuth_rad, {}, {}, {}};
    body.irradiance = floats(set_.sun_irradiance, lanes());
    body.transmittance = floats(
        set_.sun_transmittance.empty() ? set_.sun_transmittance_rough : set_.sun_transmittance,
        lanes());
    if (set_.sun_transmittance.empty() && set_.sun_transmittance_rough.empty()) {
      note("no run tells how much of the sun reaches the ground: its direct light is 0");
    } else if (set_.sun_transmittance.empty()) {
      note(
          "the sun's transmittance to the ground is that of the way from the sun to the ground to "
          "the eye over that from the ground to the eye: too high where lines absorb");
    }
    table_.bodies.push_back(std::move(body));
  }

  [[nodiscard]] bool is_sky(const AirRun& run) const {
    return same_height(run.height_m, settings_.ground_m) && std::isinf(run.length_m) &&
           run.zenith_rad < std::numbers::pi / 2.0 + 1e-9;
  }

  void sky() {
    std::vector<AirRun> runs;
    std::copy_if(runs_.begin(), runs_.end(), std::back_inserter(runs),
                 [this](const AirRun& run) { return is_sky(run); });
    if (runs.empty()) {
      note("no run looks up from the ground: the sky is black");
      AirRun black;
      black.height_m = settings_.ground_m;
      runs.push_back(black);
    } else if (std::all_of(runs.begin(), runs.end(),
                           [](const AirRun& run) { return run.transmittance.empty(); })) {
      note(
          "no run up from the ground tells its transmittance: what shines through the sky, but for "
          "the sun, is not dimmed");
    }
    table_.sky = view_of_runs(
        runs, {settings_.ground_m, settings_.top_m, lanes(), !table_.bodies.empty(), true});
  }

  void views() {
    std::vector<double> heights;
    for (const AirRun& run : runs_) heights.push_back(run.height_m);
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end(), same_height), heights.end());
    for (const double height : heights) {
      std::vector<AirRun> runs;
      std::copy_if(runs_.begin(), runs_.end(), std::back_inserter(runs),
                   [&](const AirRun& run) { return same_height(run.height_m, height); });
      const bool only_sky =
          std::all_of(runs.begin(), runs.end(), [this](const AirRun& run) { return is_sky(run); });
      if (only_sky) continue;
      table_.views.push_back(view_of_runs(
          runs, {settings_.ground_m, settings_.top_m, lanes(), !table_.bodies.empty(), false}));
    }
    if (table_.views.empty())
      note("no run looks along a path: the air between eye and scene is clear");
  }

  void ground() {
    table_.spherical_albedo = floats(set_.spherical_albedo, lanes());
    if (set_.spherical_albedo.empty()) {
      note("no run tells the air's spherical albedo: light between ground and air is not bounced");
    }
    table_.even_ground_irradiance.assign(lanes(), 0.0F);
    for (std::size_t lane = 0; lane < lanes(); ++lane) {
      table_.even_ground_irradiance[lane] = static_cast<float>(
          irradiance(table_.sky.zenith_rad, {0.0}, [&](std::size_t z, std::size_t) {
            return static_cast<double>(table_.sky.even[z * lanes() + lane]);
          }));
    }
    if (table_.bodies.empty()) return;
    AirTable::Body& body = table_.bodies.front();
    body.ground_irradiance = floats(set_.ground_irradiance, lanes());
    if (set_.ground_irradiance.empty()) sunlight_on_ground(body);
  }

  /// The beam, and the sky's integral.
  void sunlight_on_ground(AirTable::Body& body) const {
    const std::vector<double>& zenith = table_.sky.zenith_rad;
    const std::vector<double>& azimuth = table_.sky.azimuth_rad;
    for (std::size_t lane = 0; lane < lanes(); ++lane) {
      const double beam = static_cast<double>(body.irradiance[lane]) *
                          static_cast<double>(body.transmittance[lane]) *
                          std::max(std::cos(body.zenith_rad), 0.0);
      const double diffuse = irradiance(zenith, azimuth, [&](std::size_t z, std::size_t a) {
        return static_cast<double>(table_.sky.smooth[(a * zenith.size() + z) * lanes() + lane]);
      });
      body.ground_irradiance[lane] = static_cast<float>(beam + diffuse);
    }
  }

  const AirRunSet& set_;
  const AirRunSettings& settings_;
  std::vector<AirRun> runs_;
  AirTable table_;
};

void take(std::vector<double>& have, std::vector<double>& more, const std::string& what) {
  if (more.empty()) return;
  if (have.empty()) {
    have = std::move(more);
    return;
  }
  const double scale = *std::max_element(have.begin(), have.end());
  for (std::size_t i = 0; i < have.size(); ++i) {
    // Programs print these with three digits, or with four decimals of the largest.
    if (std::abs(have[i] - more[i]) > 0.02 * std::max(have[i], more[i]) + 1e-3 * scale) {
      throw InputError{fmt::format("two runs disagree on {}: {} and {}", what, have[i], more[i])};
    }
  }
}

}  // namespace

void merge(AirRunSet& set, AirRunSet more) {
  if (set.wavelength_um.empty()) {
    set = std::move(more);
    return;
  }
  const std::string name = more.runs.empty() ? "a run" : more.runs.front().name;
  const auto& a = set.wavelength_um;
  const auto& b = more.wavelength_um;
  const bool same = std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::abs(x - y) < 1e-6 * x;  // wavenumbers are printed with two decimals
  });
  if (!same) {
    throw InputError{
        fmt::format("{} has other wavelengths ({} from {:.6g} to {:.6g} um) than the "
                    "runs before ({} from {:.6g} to {:.6g} um)",
                    name, b.size(), b.empty() ? 0.0 : b.front(), b.empty() ? 0.0 : b.back(),
                    a.size(), a.front(), a.back())};
  }
  if (set.sun_zenith_rad && more.sun_zenith_rad &&
      std::abs(*set.sun_zenith_rad - *more.sun_zenith_rad) > 0.01 * radians_per_degree) {
    throw InputError{fmt::format(
        "{} has the sun at zenith angle {:.6g} degrees, the runs before "
        "at {:.6g}",
        name, *more.sun_zenith_rad / radians_per_degree, *set.sun_zenith_rad / radians_per_degree)};
  }
  if (!set.sun_zenith_rad) set.sun_zenith_rad = more.sun_zenith_rad;
  take(set.sun_irradiance, more.sun_irradiance, "the sun's irradiance");
  take(set.sun_transmittance, more.sun_transmittance, "the transmittance to the sun");
  if (set.sun_transmittance_rough.empty()) {
    set.sun_transmittance_rough = std::move(more.sun_transmittance_rough);
  }
  take(set.ground_irradiance, more.ground_irradiance, "the irradiance of the ground");
  take(set.spherical_albedo, more.spherical_albedo, "the spherical albedo");
  std::move(more.runs.begin(), more.runs.end(), std::back_inserter(set.runs));
  for (std::string& text : more.notes) {
    if (std::find(set.notes.begin(), set.notes.end(), text) == set.notes.end()) {
      set.notes.push_back(std::move(text));
    }
  }
}

AirTable table_of_runs(const AirRunSet& set, const AirRunSettings& settings) {
  return TableOfRuns{set, settings}.table();
}

}  // namespace nadir::sim
