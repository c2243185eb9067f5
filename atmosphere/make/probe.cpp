#include "atmosphere/make/probe.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "atmosphere/paths/path_measure.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/table/bound_air_table.hpp"

namespace nadir::atmosphere {
namespace {

using std::numbers::pi;

constexpr std::size_t most_lanes = 4;
constexpr int directions = 32;
constexpr double dark = 0.1;  // of the greatest radiance met
constexpr double near_body = 5.0 * pi / 180.0;

/// Points that fill the unit cube evenly: Roberts' additive recurrence of the plastic number's
/// kin, x^4 = x + 1.
struct Point {
  double x, y, z;
};
Point point(int i) {
  constexpr double g = 1.2207440846057596;
  const auto part = [&](double step) { return std::fmod(0.5 + step * (i + 1), 1.0); };
  return {part(1.0 / g), part(1.0 / (g * g)), part(1.0 / (g * g * g))};
}

/// A way to be looked up and summed directly, in scene axes: the scene is the path's anchor.
struct Ray {
  ViewPath path;
  Vec3 eye, direction;
  double length_m = 0.0;
  double azimuth_rad = 0.0;
};

/// Where along a way the probe looks: at what a scene has there, the ground and what rises from it,
/// or the sky.
double probed_share(const Shells& shells, double height_m, double zenith_rad, double u) {
  constexpr double relief_m = 1500.0;
  const double over_ground_m = height_m - shells.ground_m();
  const PathPoint eye{height_m, std::cos(zenith_rad)};
  double end_m = shells.ground_m() + u * u * std::min(relief_m, over_ground_m);
  double way_m = way_down_to_m(eye, end_m);
  if (way_m <= 0.0) {
    constexpr double open_sky = 0.7;
    if (over_ground_m > relief_m || u > open_sky) return 1.0;
    end_m = height_m + 1.0 + u * u * relief_m;
    way_m = way_up_to_m(eye, end_m);
  }
  const double whole_m = way_to_end_m(shells.top_m(), shells.ground_m(), height_m, eye.mu);
  const double whole = air_measure_m(height_m, advanced(eye, whole_m).height_m, whole_m);
  if (whole <= 0.0) return 1.0;  // down from the ground itself: no way, and no part of it
  return air_measure_m(height_m, end_m, way_m) / whole;
}

Ray make_ray(const Shells& shells, double height_m, const Point& p, bool whole) {
  const double horizon = zenith_axis(shells, height_m, 3).below.front();
  Ray ray;
  const bool below = !whole && p.x > 0.5;
  // As dense towards the horizon as the nodes are.
  const double t = whole ? p.x : (p.x > 0.5 ? 2.0 * p.x - 1.0 : 2.0 * p.x);
  const double away = std::pow(t, 1.5);
  const double zenith = below ? horizon + (pi - horizon) * away : horizon * (1.0 - away);
  ray.azimuth_rad = 2.0 * pi * p.y;
  const double share = whole ? 1.0 : probed_share(shells, height_m, zenith, p.z);
  ray.path = view_path(shells, height_m, zenith, below ? Side::below : Side::above, {share, 1.0});
  const Vec3 across{std::sin(ray.azimuth_rad), std::cos(ray.azimuth_rad), 0.0};
  const double arc = ray.path.anchor_rad, scene_zenith = ray.path.scene_zenith_rad();
  const double half = std::sin(0.5 * arc);
  const double r = earth_radius_m + height_m;
  ray.eye = across * (-r * std::sin(arc));
  ray.eye.z = height_m - shells.ground_m() - 2.0 * r * half * half;
  ray.direction = across * std::sin(scene_zenith);
  ray.direction.z = std::cos(scene_zenith);
  for (const PathStep& step : ray.path.steps) {
    const auto k = static_cast<std::size_t>(step.layer);
    ray.length_m += step.slant * (shells.level_m[k] - shells.level_m[k + 1]);
    if (step.share == 0) break;
  }
  return ray;
}

/// Radiances of one lane, summed directly and looked up.
struct Compared {
  std::vector<double> exact, found;

  [[nodiscard]] double largest() const {
    double brightest = 0.0, worst = 0.0;
    for (const double e : exact) brightest = std::max(brightest, e);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const double scale = std::max(exact[i], dark * brightest);
      if (scale > 0.0) worst = std::max(worst, std::abs(found[i] - exact[i]) / scale);
    }
    return worst;
  }
};

/// The path's radiance, summed directly.
double direct_sum(const LaneFields& fields, const AirTable& table, const Ray& ray, double ground,
                  bool whole) {
  std::vector<double> azimuths;
  for (const AirTable::Body& body : table.bodies) {
    azimuths.push_back(ray.azimuth_rad - body.azimuth_rad);
  }
  const PathLight light{fields, azimuths};
  const PathSums sums = light.along(ray.path, 2);
  std::vector<double> background(sums.sums, 0.0);
  const double left = std::exp(-sums.scaled_depth.back());
  background[LaneFields::ground] = ray.path.meets_ground ? left : 0.0;
  background[fields.night] = ray.path.meets_ground ? 0.0 : left * night_beyond(fields, ray.path);
  const ShareLight part{sums, background};
  const std::size_t at = whole ? 1 : 0;
  double sum = part.whole(LaneFields::even, at) + ground * part.whole(LaneFields::ground, at);
  if (fields.night != LaneFields::even) sum += part.whole(fields.night, at);
  if (whole) sum += std::exp(-sums.depth[at]) * night_beyond(fields, ray.path);
  for (std::size_t b = 0; b < fields.beams.size(); ++b) {
    const LaneFields::Beam& beam = fields.beams[b];
    for (int m = 0; m < beam.modes; ++m) {
      sum += part.whole(beam.first_component + static_cast<std::size_t>(m), at) *
             std::cos(m * azimuths[beam.body]);
    }
    const double cosine =
        scattering_cosine(ray.path.scene_zenith_rad(), azimuths[beam.body], beam.place);
    double once = 0.0;
    for (std::size_t k = 0; k < fields.phases.size(); ++k) {
      once += part.whole(light.first(b, k), at) * fields.phases[k]->at(cosine);
    }
    if (!beam.local.empty()) {
      once += beam.local_share * (part.whole(light.local(b, beam.body), at) - once);
    }
    sum += once;
  }
  return std::max(0.0, sum);
}

bool beside_a_body(const TableFiller& filler, const AirTable& table, const Ray& ray) {
  for (std::size_t b = 0; b < table.bodies.size(); ++b) {
    const double cosine =
        scattering_cosine(ray.path.scene_zenith_rad(),
                          ray.azimuth_rad - table.bodies[b].azimuth_rad, filler.places()[b]);
    if (cosine > std::cos(near_body)) return true;
  }
  return false;
}

GroundLight test_ground(const AirTable& table) {
  GroundLight ground{std::vector<float>(table.lanes.size(), 0.2F), table.even_ground_irradiance};
  for (float& emission : ground.emission) emission /= std::numbers::pi_v<float>;
  return ground;
}

}  // namespace

ErrorProbe::ErrorProbe(const TableJob& job, const TableFiller& filler) : filler_{filler} {
  const bool paths = job.wanted_anywhere().path();  // a lane without them has no views to probe
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < job.lanes.size(); ++i) {
    if (job.lanes[i].absorption.term == 0 && job.wanted_at(i).path() == paths) {
      candidates.push_back(i);
    }
  }
  if (candidates.empty()) candidates.push_back(0);
  const std::size_t count = std::min(most_lanes, candidates.size());
  for (std::size_t i = 0; i < count; ++i) {
    kept_.push_back(
        {candidates[i * (candidates.size() - 1) / std::max<std::size_t>(1, count - 1)], {}});
  }
}

void ErrorProbe::keep(std::size_t lane, LaneFields fields) {
  const auto kept =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) { return k.lane == lane; });
  if (kept != kept_.end()) kept->fields = std::move(fields);
}

double ErrorProbe::largest_error(const AirTable& table) const {
  std::vector<std::size_t> lanes;
  std::vector<Micrometres> wavelengths;
  std::vector<spectral::AbsorptionLane> absorption;
  for (const Kept& kept : kept_) {
    lanes.push_back(kept.lane);
    wavelengths.emplace_back(table.lanes[kept.lane].wavelength_um);
    absorption.push_back(table.lanes[kept.lane].absorption);
  }
  // Lent for the time of this call, not owned.
  const std::shared_ptr<const AirTable> lent{std::shared_ptr<const AirTable>{}, &table};
  const BoundAirTable bound{lent, test_ground(table), spectral::Lanes{wavelengths, absorption}};
  double worst = view_error(table, bound, lanes, true);
  if (!table.views.empty()) worst = std::max(worst, view_error(table, bound, lanes, false));
  return worst;
}

double ErrorProbe::view_error(const AirTable& table, const BoundAirTable& bound,
                              const std::vector<std::size_t>& lanes, bool whole) const {
  const spectral::Spectrum ground = bound.ground_radiance();
  const double height = whole ? table.ground_m : table.views.front().height_m;
  std::vector<Compared> compared(lanes.size());
  for (int i = 0; i < directions; ++i) {
    const Ray ray = make_ray(filler_.shells(), height, point(i), whole);
    if (beside_a_body(filler_, table, ray) || ray.length_m <= 0.0) continue;
    const spectral::Spectrum seen = whole
                                        ? bound.sky(ray.direction)
                                        : bound.path(ray.eye, ray.direction, ray.length_m).radiance;
    for (std::size_t k = 0; k < lanes.size(); ++k) {
      const int lane = static_cast<int>(k);
      const double g = static_cast<double>(ground[lane]);
      compared[k].exact.push_back(direct_sum(kept_[k].fields, table, ray, g, whole));
      compared[k].found.push_back(static_cast<double>(seen[lane]));
    }
  }
  double worst = 0.0;
  for (const Compared& c : compared) worst = std::max(worst, c.largest());
  return worst;
}

}  // namespace nadir::atmosphere
