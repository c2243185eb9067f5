#include "sim/files/air_run_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "atmosphere/paths/path_measure.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "core/error.hpp"
#include "core/quantity.hpp"

namespace nadir::sim {
namespace {

using atmosphere::AirTable;

/// Angles in degrees are written with three decimals.
constexpr double same_angle = 5e-4 * radians_per_degree;

bool same_direction(double a, double b) { return std::abs(a - b) < same_angle; }
bool same_length(double a, double b) { return a == b || std::abs(a - b) < 1e-4 * std::min(a, b); }

bool vertical(const AirRun& run) {
  return run.zenith_rad < same_angle || run.zenith_rad > std::numbers::pi - same_angle;
}

template <class Same>
void sort_unique(std::vector<double>& values, const Same& same) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
}

/// One direction up or down and all that is known along it, by way: share of the way's measure,
/// optical depth per metre of measure, and radiances (sky) or sources.
struct Ray {
  double zenith_rad = 0.0;
  std::vector<double> share;
  std::vector<std::vector<double>> extinction, even;     // [share][lane]
  std::vector<std::vector<std::vector<double>>> smooth;  // [azimuth][share][lane]
};

/// A zenith angle and a length.
struct Way {
  double zenith_rad = 0.0, length_m = 0.0;
};

class Grid {
 public:
  Grid(const std::vector<AirRun>& runs, const GridSettings& settings)
      : runs_{runs}, settings_{settings} {
    for (const AirRun& run : runs) {
      zenith_.push_back(run.zenith_rad);
      const bool matters = !run.solar.empty() && run.azimuth_rad && !vertical(run);
      if (matters) azimuth_.push_back(*run.azimuth_rad);
    }
    sort_unique(zenith_, same_direction);
    sort_unique(azimuth_, same_direction);
    if (azimuth_.empty()) azimuth_.push_back(0.0);
  }

  AirTable::View view() {
    std::vector<Ray> rays;
    for (const double zenith : zenith_) rays.push_back(ray(zenith));
    list_missing();
    if (!settings_.sky) add_horizon(rays);
    return filled(rays);
  }

 private:
  [[nodiscard]] double height() const { return runs_.front().height_m; }

  /// The spectrum that a run gives for a way, whatever its azimuth; null where none does.
  template <class Member>
  [[nodiscard]] const std::vector<double>* find(const Way& way, Member member) const {
    for (const AirRun& run : runs_) {
      if (is_way(run, way) && !(run.*member).empty()) return &(run.*member);
    }
    return nullptr;
  }

  [[nodiscard]] static bool is_way(const AirRun& run, const Way& way) {
    return same_direction(run.zenith_rad, way.zenith_rad) &&
           same_length(run.length_m, way.length_m);
  }

  /// The scattered sunlight of a way. In the vertical any azimuth serves where the very one is not
  /// there.
  [[nodiscard]] const std::vector<double>* find_solar(const Way& way, double azimuth) const {
    const AirRun *exact = nullptr, *any = nullptr;
    for (const AirRun& run : runs_) {
      if (!is_way(run, way) || run.solar.empty()) continue;
      if (run.azimuth_rad && same_direction(*run.azimuth_rad, azimuth)) {
        if (exact != nullptr) {
          throw InputError{fmt::format("{} gives again what an earlier run gives: {}", run.name,
                                       place(way, &azimuth))};
        }
        exact = &run;
      } else if (vertical(run) || !run.azimuth_rad) {
        any = &run;
      }
    }
    if (exact != nullptr) return &exact->solar;
    return any != nullptr ? &any->solar : nullptr;
  }

  [[nodiscard]] std::string place(const Way& way, const double* azimuth) const {
    std::string text = fmt::format("from {:.6g} m at zenith angle {:.6g}", height(),
                                   way.zenith_rad / radians_per_degree);
    if (azimuth != nullptr) text += fmt::format(", azimuth {:.6g}", *azimuth / radians_per_degree);
    text += " degrees";
    return text + (std::isinf(way.length_m) ? ", to the end of the air"
                                            : fmt::format(", over {:.6g} m", way.length_m));
  }

  void miss(const std::string& what) { missing_.push_back(what); }

  void list_missing() const {
    if (missing_.empty()) return;
    std::string text =
        fmt::format("{} runs are missing of a full grid of directions:", missing_.size());
    constexpr std::size_t most = 20;  // more would hide the first line
    for (std::size_t i = 0; i < std::min(most, missing_.size()); ++i) text += "\n  " + missing_[i];
    if (missing_.size() > most) text += fmt::format("\n  and {} more", missing_.size() - most);
    throw InputError{text};
  }

  [[nodiscard]] double whole_measure(double zenith) const {
    return measure(zenith, atmosphere::way_to_end_m(settings_.top_m, settings_.ground_m, height(),
                                                    std::cos(zenith)));
  }
  [[nodiscard]] double measure(double zenith, double length) const {
    const double end = atmosphere::advanced({height(), std::cos(zenith)}, length).height_m;
    return atmosphere::air_measure_m(height(), end, length);
  }

  Ray ray(double zenith) {
    std::vector<double> lengths;
    for (const AirRun& run : runs_) {
      if (same_direction(run.zenith_rad, zenith)) lengths.push_back(run.length_m);
    }
    sort_unique(lengths, same_length);
    if (!std::isinf(lengths.back())) {
      miss(place({zenith, std::numeric_limits<double>::infinity()}, nullptr));
    }
    Ray result;
    result.zenith_rad = zenith;
    result.smooth.resize(azimuth_.size());
    const double whole = whole_measure(zenith);
    for (const double length : lengths) {
      const double metres = std::isinf(length) ? whole : measure(zenith, length);
      result.share.push_back(std::isinf(length) ? 1.0 : metres / whole);
      add_way(result, {zenith, length}, metres);
    }
    return result;
  }

  void add_way(Ray& ray, const Way& way, double metres) {
    const std::vector<double> none(settings_.lanes, 0.0);
    const auto* transmittance = find(way, &AirRun::transmittance);
    if (transmittance == nullptr && !settings_.sky) {
      miss(place(way, nullptr) + ": one that gives the transmittance");
    }
    const std::vector<double> t =
        transmittance == nullptr ? std::vector<double>(settings_.lanes, 1.0) : *transmittance;
    std::vector<double> extinction;
    for (const double value : t) extinction.push_back(depth(value) / std::max(metres, 1e-9));
    ray.extinction.push_back(std::move(extinction));
    const auto* even = find(way, &AirRun::even);
    ray.even.push_back(even == nullptr ? none : source(*even, t));
    for (std::size_t i = 0; i < azimuth_.size(); ++i) {
      const auto* solar = find_solar(way, azimuth_[i]);
      if (solar == nullptr && settings_.sunlit && has_solar()) {
        miss(place(way, &azimuth_[i]));
      }
      ray.smooth[i].push_back(solar == nullptr ? none : source(*solar, t));
    }
  }

  [[nodiscard]] bool has_solar() const {
    return std::any_of(runs_.begin(), runs_.end(),
                       [](const AirRun& run) { return !run.solar.empty(); });
  }

  /// 69: as dark as a printed 0 can be told from; floats of exp(-69) are still normal.
  static double depth(double transmittance) {
    return -std::log(std::clamp(transmittance, 1e-30, 1.0));
  }

  [[nodiscard]] std::vector<double> source(const std::vector<double>& radiance,
                                           const std::vector<double>& t) const {
    if (settings_.sky) return radiance;
    std::vector<double> result;
    for (std::size_t lane = 0; lane < radiance.size(); ++lane) {
      const double opacity = 1.0 - t[lane];
      // Transmittances have seven digits at best: below that nothing is known of the source.
      result.push_back(opacity > 1e-7 ? radiance[lane] / opacity : 0.0);
    }
    return result;
  }

  /// Where directions lie on both sides of the horizon, it is a node twice, as its neighbour is.
  void add_horizon(std::vector<Ray>& rays) const {
    const double horizon = std::acos(atmosphere::horizon_mu(settings_.ground_m, height()));
    const auto below = std::find_if(rays.begin(), rays.end(), [&](const Ray& ray) {
      return ray.zenith_rad > horizon + 1e-7;  // rounding of acos
    });
    if (below == rays.begin() || below == rays.end()) return;
    Ray above_twin = *(below - 1), below_twin = *below;
    above_twin.zenith_rad = below_twin.zenith_rad = horizon;
    if (same_direction((below - 1)->zenith_rad, horizon)) {
      *(below - 1) = above_twin;
      rays.insert(below, std::move(below_twin));
      return;
    }
    const auto at = rays.insert(below, std::move(below_twin));
    rays.insert(at, std::move(above_twin));
  }

  [[nodiscard]] AirTable::View filled(const std::vector<Ray>& rays) const {
    AirTable::View view;
    view.height_m = height();
    view.azimuth_rad = azimuth_;
    for (const Ray& ray : rays) {
      view.zenith_rad.push_back(ray.zenith_rad);
      view.share.insert(view.share.end(), ray.share.begin(), ray.share.end());
    }
    sort_unique(view.share, [](double a, double b) { return std::abs(a - b) < 1e-6; });
    if (view.share.empty() || view.share.back() < 1.0) view.share.push_back(1.0);
    view.share.back() = 1.0;
    const std::size_t all = view.places() * settings_.lanes;
    for (const Ray& ray : rays) {
      append(view.extinction, ray, ray.extinction, view.share);
      append(view.even, ray, ray.even, view.share);
    }
    if (settings_.sunlit) {
      for (std::size_t i = 0; i < azimuth_.size(); ++i) {
        for (const Ray& ray : rays) append(view.smooth, ray, ray.smooth[i], view.share);
      }
    }
    view.ground.assign(all, 0.0F);
    return view;
  }

  void append(std::vector<float>& to, const Ray& ray, const std::vector<std::vector<double>>& rows,
              const std::vector<double>& shares) const {
    for (const double share : shares) {
      const NodePair pair = node_pair(ray.share, share);
      for (std::size_t lane = 0; lane < settings_.lanes; ++lane) {
        to.push_back(static_cast<float>((1.0 - pair.share) * rows[pair.first][lane] +
                                        pair.share * rows[pair.second][lane]));
      }
    }
  }

  const std::vector<AirRun>& runs_;
  GridSettings settings_;
  std::vector<double> zenith_, azimuth_;
  std::vector<std::string> missing_;
};

}  // namespace

NodePair node_pair(const std::vector<double>& nodes, double at) {
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), at);
  if (above == nodes.begin()) return {0, 0, 0.0};
  if (above == nodes.end()) return {nodes.size() - 1, nodes.size() - 1, 0.0};
  const auto second = static_cast<std::size_t>(above - nodes.begin());
  return {second - 1, second, (at - nodes[second - 1]) / (nodes[second] - nodes[second - 1])};
}

AirTable::View view_of_runs(const std::vector<AirRun>& runs, const GridSettings& settings) {
  return Grid{runs, settings}.view();
}

}  // namespace nadir::sim
