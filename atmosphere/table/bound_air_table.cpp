#include "atmosphere/table/bound_air_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "atmosphere/paths/path_measure.hpp"
#include "atmosphere/table/bound_view.hpp"
#include "core/error.hpp"

namespace nadir::atmosphere {

using spectral::Spectrum;

struct BoundAirTable::Bound {
  struct Body {
    Vec3 towards;
    Spectrum transmittance;
  };
  AirFrame frame;
  std::vector<Body> bodies;    // all of the table
  std::vector<BoundView> sky;  // one; before a table without views a second, as the sensor sees it
  std::vector<BoundView> views;
  std::vector<float> sky_ground, path_ground;  // what is wanted of G
  bool sky_lit = true, path_lit = true;        // light is wanted there
  bool loses = true;                           // transmittance on the line of sight
  std::vector<double> sky_measure;  // of the whole way up, over even steps of mu from 0 to 1

  [[nodiscard]] WholeWay sky_way(Vec3 direction) const noexcept;
  [[nodiscard]] Spectrum light(const std::vector<float>& ground) const noexcept;
  [[nodiscard]] Spectrum sky_light(const BoundView& of, const std::vector<float>& ground,
                                   Vec3 direction) const noexcept;
};

// From the ground the whole way up depends on the zenith angle alone. Over a step of 1/1024 the
// measure, which falls off by 20 times itself in mu at the horizon, bends by 20^2 / 1024^2 / 8 =
// 5e-5 of itself.
WholeWay BoundAirTable::Bound::sky_way(Vec3 direction) const noexcept {
  const double mu = std::clamp(direction.z, -1.0, 1.0), height_m = sky.front().height_m();
  if (mu < 0.0 || height_m > frame.ground_m) {
    return whole_way(frame.top_m, frame.ground_m, {height_m, mu});
  }
  const double at = mu * static_cast<double>(sky_measure.size() - 2);
  const auto node = static_cast<std::size_t>(at);
  const double weight = at - static_cast<double>(node);
  WholeWay way;
  way.zenith = std::acos(mu) * 2.0 / std::numbers::pi;
  way.measure_m = sky_measure[node] + weight * (sky_measure[node + 1] - sky_measure[node]);
  return way;
}

namespace {

Vec3 towards(const AirTable::Body& body) {
  const double s = std::sin(body.zenith_rad);
  return {s * std::sin(body.azimuth_rad), s * std::cos(body.azimuth_rad),
          std::cos(body.zenith_rad)};
}

bool any_light(const std::vector<float>& values, std::size_t first, std::size_t count) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  return std::any_of(begin, begin + static_cast<std::ptrdiff_t>(count),
                     [](float v) { return v != 0.0F; });
}

/// The sky, then the views.
std::vector<const AirTable::View*> all_views(const AirTable& table) {
  std::vector<const AirTable::View*> views{&table.sky};
  for (const AirTable::View& view : table.views) views.push_back(&view);
  return views;
}

bool scatters(const AirTable& table, std::size_t body, std::size_t kind) {
  for (const AirTable::View* view : all_views(table)) {
    const std::size_t block = view->places() * table.lanes.size();
    const std::size_t kinds = static_cast<std::size_t>(table.kinds);
    if (any_light(view->first, (body * kinds + kind) * block, block)) return true;
  }
  return false;
}

bool glows(const AirTable& table, std::size_t body) {
  for (const AirTable::View* view : all_views(table)) {
    const std::size_t block = view->azimuth_rad.size() * view->places() * table.lanes.size();
    if (any_light(view->smooth, body * block, block)) return true;
  }
  return false;
}

/// G = (rho E_down / pi + emission) / (1 - rho S), as far as light is wanted: of E_down what the
/// air scatters, or what it emits; the ground's own emission goes with the latter.
std::vector<float> ground_light(const AirTable& table, const GroundLight& ground,
                                const AirFrame& frame, AirLight wanted) {
  const std::size_t there = table.lanes.size(), lanes = frame.matches.size();
  if (ground.reflectance.size() != there || ground.emission.size() != there) {
    throw InputError{"expected the ground's reflectance and emission at each of the table's " +
                     std::to_string(there) + " lanes, found " +
                     std::to_string(ground.reflectance.size()) + " and " +
                     std::to_string(ground.emission.size())};
  }
  std::vector<float> light(frame.padded(), 0.0F);
  for (std::size_t i = 0; i < lanes; ++i) {
    const LaneMatch& match = frame.matches[i];
    const float even = match.of(table.even_ground_irradiance.data());
    const auto& nightly = table.night_ground_irradiance;
    const float night = nightly.empty() ? 0.0F : match.of(nightly.data());
    float down = wanted.emitted ? (wanted.scattered ? even : std::max(0.0F, even - night))
                                : (wanted.scattered ? night : 0.0F);
    for (const AirTable::Body& body : table.bodies) {
      if (wanted.scattered) down += match.of(body.ground_irradiance.data());
    }
    const float rho = match.of(ground.reflectance.data());
    const float own = wanted.emitted ? match.of(ground.emission.data()) : 0.0F;
    light[i] = (rho * down / std::numbers::pi_v<float> + own) /
               (1.0F - rho * match.of(table.spherical_albedo.data()));
  }
  return light;
}

/// @param scattered  whether light of the bodies is wanted at all
AirFrame make_frame(const AirTable& table, const spectral::Lanes& lanes, bool scattered) {
  AirFrame frame;
  frame.matches = match_lanes(table.lanes, lanes);
  frame.top_m = table.top_m;
  frame.ground_m = table.ground_m;
  if (!scattered) return frame;
  std::vector<bool> kept(static_cast<std::size_t>(table.kinds), false);
  for (std::size_t b = 0; b < table.bodies.size(); ++b) {
    bool lit = glows(table, b);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      if (!scatters(table, b, k)) continue;
      kept[k] = true;
      lit = true;
    }
    const AirTable::Body& body = table.bodies[b];
    const double azimuth = std::remainder(body.azimuth_rad, 2.0 * std::numbers::pi);
    if (lit) frame.bodies.push_back({b, towards(body), azimuth});
  }
  frame.phase_nodes = table.phase_grid.size();
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (!kept[k]) continue;
    frame.kinds.push_back(k);
    append_rows(frame, table, table.phase, k * frame.phase_nodes, frame.phase_nodes, frame.phase);
  }
  return frame;
}

void clear(LaneBuffer& buffer, std::size_t n) noexcept {
  std::fill_n(buffer.value.begin(), n, 0.0F);
}

/// What a way does, given its extinction per metre of measure and its source.
PathTerms along(const AirFrame& frame, double measure_m, const LaneBuffer& extinction,
                const LaneBuffer& source) noexcept {
  const std::size_t lanes = frame.matches.size();
  const float measure = static_cast<float>(measure_m);
  LaneBuffer left, light;
  for (std::size_t i = 0, n = frame.padded(); i < n; ++i) {
    const Decay d = decay(extinction.value[i] * measure);
    left.value[i] = d.left;
    light.value[i] = d.lost * positive_part(source.value[i]);
  }
  PathTerms terms{Spectrum{static_cast<int>(lanes)}, Spectrum{static_cast<int>(lanes)}};
  std::copy_n(left.value.begin(), lanes, &terms.transmittance[0]);
  std::copy_n(light.value.begin(), lanes, &terms.radiance[0]);
  return terms;
}

PathTerms nothing(const AirFrame& frame) noexcept {
  const int lanes = static_cast<int>(frame.matches.size());
  return {Spectrum{lanes, 1.0F}, Spectrum{lanes}};
}

/// An eye within the air, and how much way it has left.
struct Inside {
  PathPoint eye;
  double length_m = 0.0;
};

/// From a place in scene axes; from above the air to where the ray enters it. Nothing for a ray
/// that does not.
std::optional<Inside> inside(const AirFrame& frame, Vec3 eye, Vec3 direction,
                             double length_m) noexcept {
  // r - R = ground + (x^2 + y^2 + z (2 R0 + z)) / (r + R0) with R0 to the origin: nothing cancels.
  const double origin_m = earth_radius_m + frame.ground_m;
  const double square = eye.x * eye.x + eye.y * eye.y + eye.z * (2.0 * origin_m + eye.z);
  const double r = std::sqrt(origin_m * origin_m + square);
  const double mu = dot(Vec3{eye.x, eye.y, eye.z + origin_m}, direction) / r;
  Inside in{{frame.ground_m + square / (r + origin_m), std::clamp(mu, -1.0, 1.0)}, length_m};
  if (in.eye.height_m <= frame.top_m) return in;
  const double way = way_down_to_m(in.eye, frame.top_m);
  if (way < 0.0 || way >= length_m) return std::nullopt;
  in.eye = {frame.top_m, advanced(in.eye, way).mu};
  in.length_m -= way;
  return in;
}

/// Adds what the views about an eye's height say: one, or a blend of two.
void add_views(const AirFrame& frame, const std::vector<BoundView>& views, double height_m,
               const Look& look, LaneBuffer& extinction, LaneBuffer& source) noexcept {
  std::size_t upper = 0;
  while (upper < views.size() && views[upper].height_m() < height_m) ++upper;
  if (upper == 0 || upper == views.size()) {
    views[upper == 0 ? 0 : upper - 1].add(frame, look, 1.0F, extinction, source);
    return;
  }
  const double from = views[upper - 1].height_m(), to = views[upper].height_m();
  const float weight = static_cast<float>((height_m - from) / (to - from));
  views[upper - 1].add(frame, look, 1.0F - weight, extinction, source);
  views[upper].add(frame, look, weight, extinction, source);
}

}  // namespace

BoundAirTable::BoundAirTable(const std::shared_ptr<const AirTable>& table,
                             const GroundLight& ground, const spectral::Lanes& lanes,
                             const AirParts& parts) {
  auto bound = std::make_shared<Bound>();
  bound->frame = make_frame(*table, lanes, parts.scattering());
  const AirFrame& frame = bound->frame;
  const AirLight from_sky = sky_light(parts), on_path = path_light(parts);
  bound->sky_ground = ground_light(*table, ground, frame, from_sky);
  bound->path_ground = ground_light(*table, ground, frame, on_path);
  bound->sky_lit = from_sky.any();
  bound->path_lit = on_path.any();
  bound->loses = parts.path_transmittance;
  for (const AirTable::Body& body : table->bodies) {
    Spectrum transmittance{lanes.count()};
    for (int i = 0; i < lanes.count(); ++i) {
      transmittance[i] = frame.matches[static_cast<std::size_t>(i)].of(body.transmittance.data());
    }
    bound->bodies.push_back({towards(body), transmittance});
  }
  using Want = BoundView::Want;
  bound->sky.emplace_back(*table, table->sky, frame, bound->sky_ground, Want{from_sky, true});
  if (table->views.empty()) {
    bound->sky.emplace_back(*table, table->sky, frame, bound->path_ground, Want{on_path, true});
  }
  for (const AirTable::View& view : table->views) {
    bound->views.emplace_back(*table, view, frame, bound->path_ground, Want{on_path, false});
  }
  constexpr int steps = 1024;
  for (int i = 0; i <= steps; ++i) {
    const PathPoint eye{frame.ground_m, static_cast<double>(i) / steps};
    bound->sky_measure.push_back(whole_way(frame.top_m, frame.ground_m, eye).measure_m);
  }
  bound->sky_measure.push_back(bound->sky_measure.back());  // beyond the last step
  bound_ = std::move(bound);
}

Spectrum BoundAirTable::Bound::light(const std::vector<float>& ground) const noexcept {
  Spectrum light{static_cast<int>(frame.matches.size())};
  std::copy_n(ground.begin(), light.count(), &light[0]);
  return light;
}

Spectrum BoundAirTable::ground_radiance() const noexcept {
  return bound_->light(bound_->sky_ground);
}

Spectrum BoundAirTable::sky(Vec3 direction_enu) const noexcept {
  const Bound& b = *bound_;
  if (!b.sky_lit) return Spectrum{static_cast<int>(b.frame.matches.size())};
  return b.sky_light(b.sky.front(), b.sky_ground, direction_enu);
}

Spectrum BoundAirTable::Bound::sky_light(const BoundView& dome, const std::vector<float>& ground,
                                         Vec3 direction_enu) const noexcept {
  const WholeWay way = sky_way(direction_enu);
  if (way.below && !dome.sees_ground()) return light(ground);
  LaneBuffer extinction, source;
  clear(extinction, frame.padded());
  clear(source, frame.padded());
  dome.add(frame, {direction_enu, way.below, way.zenith, 1.0}, 1.0F, extinction, source);
  PathTerms terms = along(frame, way.measure_m, extinction, source);
  // The table holds the radiance over 1 - T + floor.
  for (int i = 0; i < terms.radiance.count(); ++i) {
    terms.radiance[i] +=
        BoundView::sky_floor * std::max(0.0F, source.value[static_cast<std::size_t>(i)]);
  }
  if (way.below) terms.radiance.add_product(terms.transmittance, light(ground));
  return terms.radiance;
}

Spectrum BoundAirTable::direct_transmittance(Vec3 direction_enu) const noexcept {
  constexpr double near = 0.999390827;  // cos 2 degrees
  const Bound::Body* nearest = nullptr;
  double best = near;
  for (const Bound::Body& body : bound_->bodies) {
    const double cosine = dot(body.towards, direction_enu);
    if (cosine < best) continue;
    best = cosine;
    nearest = &body;
  }
  if (nearest != nullptr) return nearest->transmittance;
  constexpr double dip = 0.0174524064;  // sin 1 degree
  const AirFrame& frame = bound_->frame;
  if (direction_enu.z < -dip) return Spectrum{static_cast<int>(frame.matches.size())};
  const BoundView& sky = bound_->sky.front();
  const WholeWay way = bound_->sky_way({0.0, 0.0, std::max(0.0, direction_enu.z)});
  LaneBuffer extinction, source;
  clear(extinction, frame.padded());
  clear(source, frame.padded());
  sky.add_extinction(frame, {direction_enu, way.below, way.zenith, 1.0}, extinction);
  return along(frame, way.measure_m, extinction, source).transmittance;
}

PathTerms BoundAirTable::path(Vec3 eye, Vec3 direction, double length_m) const noexcept {
  const AirFrame& frame = bound_->frame;
  const bool wanted = bound_->path_lit || bound_->loses;
  if (!wanted || bound_->views.empty() || !(length_m > 0.0)) return nothing(frame);
  const std::optional<Inside> in = inside(frame, eye, direction, length_m);
  if (!in) return nothing(frame);
  const WholeWay way = whole_way(frame.top_m, frame.ground_m, in->eye);
  double left_m = std::isfinite(in->length_m) ? in->length_m : way.length_m;
  PathPoint end = advanced(in->eye, left_m);
  if (end.height_m > frame.top_m) {
    left_m = std::min(left_m, std::max(0.0, way_up_to_m(in->eye, frame.top_m)));
    end.height_m = frame.top_m;
  }
  // Deep inside the earth the measure grows beyond bounds; a valley below the scene's ground may
  // lie a little beyond the whole way.
  const double most = 2.0 * way.measure_m + measure_scale_m;
  double measure = air_measure_m(in->eye.height_m, end.height_m, left_m);
  if (!(measure < most)) measure = most;
  const double share = measure < way.measure_m ? measure / way.measure_m : 1.0;
  LaneBuffer extinction, source;
  clear(extinction, frame.padded());
  clear(source, frame.padded());
  add_views(frame, bound_->views, in->eye.height_m, {direction, way.below, way.zenith, share},
            extinction, source);
  PathTerms terms = along(frame, measure, extinction, source);
  if (!bound_->loses) terms.transmittance = Spectrum{terms.transmittance.count(), 1.0F};
  return terms;
}

Spectrum BoundAirTable::beyond(Vec3 eye, Vec3 direction) const noexcept {
  const AirFrame& frame = bound_->frame;
  if (!bound_->path_lit) return Spectrum{static_cast<int>(frame.matches.size())};
  if (bound_->views.empty()) {
    return bound_->sky_light(bound_->sky.back(), bound_->path_ground, direction);
  }
  const std::optional<Inside> in =
      inside(frame, eye, direction, std::numeric_limits<double>::infinity());
  if (!in) return Spectrum{static_cast<int>(frame.matches.size())};
  const WholeWay way = whole_way(frame.top_m, frame.ground_m, in->eye);
  LaneBuffer extinction, source;
  clear(extinction, frame.padded());
  clear(source, frame.padded());
  add_views(frame, bound_->views, in->eye.height_m, {direction, way.below, way.zenith, 1.0},
            extinction, source);
  PathTerms terms = along(frame, way.measure_m, extinction, source);
  if (!way.below) return terms.radiance;
  const Spectrum ground = bound_->light(bound_->path_ground);
  if (!bound_->loses) return terms.radiance += ground;
  return terms.radiance.add_product(terms.transmittance, ground);
}

}  // namespace nadir::atmosphere
