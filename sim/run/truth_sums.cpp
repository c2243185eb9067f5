#include "sim/run/truth_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/frame.hpp"

namespace nadir::sim {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();
constexpr double missing_place = std::numeric_limits<double>::quiet_NaN();
/// The random numbers of the ray that asks for the sky, beyond those of camera and solver.
constexpr std::uint32_t sky_direction = 64;

float mean_or_missing(double sum, std::uint32_t count) {
  return count > 0 ? static_cast<float>(sum / count) : missing;
}

/// Zenith and azimuth of a direction in local axes, deg.
struct SkyAngles {
  double zenith_deg, azimuth_deg;
};
SkyAngles sky_angles(const Mat3& local, Vec3 direction) {
  const Vec3 seen = normalised(local.transposed() * direction);
  const double azimuth = to_degrees(Angle{std::atan2(seen.x, seen.y)});
  return {to_degrees(Angle{std::acos(std::clamp(seen.z, -1.0, 1.0))}),
          azimuth < 0.0 ? azimuth + 360.0 : azimuth};
}

}  // namespace

TruthSums::TruthSums(const radiometry::SceneDescription& scene, const TruthOptions& options)
    : scene_{&scene}, options_{options}, material_votes_(scene.materials.size() + 1) {
  constexpr std::size_t objects_in_a_pixel = 64;  // more than most pixels have paths
  object_votes_.reserve(objects_in_a_pixel);
}

void TruthSums::begin_pixel() {
  sums_ = {};
  std::fill(material_votes_.begin(), material_votes_.end(), 0U);
  object_votes_.clear();
}

const ephemeris::LightSource* TruthSums::sun() const {
  const auto& bodies = scene_->illumination;
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [](const auto& body) { return body.name == "sun"; });
  return found == bodies.end() ? nullptr : &*found;
}

void TruthSums::add(const geometry::Ray& ray, const geometry::Hit* hit, const Sampler& numbers) {
  ++sums_.paths;
  if (hit == nullptr) {
    ++material_votes_[0];
    return;
  }
  ++material_votes_[scene_->materials[hit->material].shown_as.value_or(hit->material) + 1];
  if (options_.planes) add_surface(ray, *hit, numbers);
}

void TruthSums::add_surface(const geometry::Ray& ray, const geometry::Hit& hit,
                            const Sampler& numbers) {
  ++sums_.hits;
  sums_.range_m += hit.distance;
  sums_.normal = sums_.normal + hit.normal;
  sums_.position = sums_.position + hit.position;
  sums_.towards_sensor = sums_.towards_sensor - ray.direction;
  const auto known = std::find_if(object_votes_.begin(), object_votes_.end(),
                                  [&](const Vote& vote) { return vote.object == hit.object; });
  if (known != object_votes_.end()) {
    ++known->count;
  } else {
    object_votes_.push_back({hit.object, 1});
  }
  const thermal::TemperatureField& temperature = scene_->temperature;
  if (options_.heat || !temperature.solved(hit.material)) {
    const double kelvin = temperature.at(hit).value;
    sums_.temperature_k += std::isfinite(kelvin) ? kelvin : 0.0;
    sums_.with_temperature += std::isfinite(kelvin) ? 1 : 0;
  }
  add_sun(hit);
  if (!options_.sky_view) return;
  // Malley: a uniform point on the disc, lifted to the hemisphere, follows the cosine.
  const Vec2 u = numbers.point(sky_direction);
  const double radius = std::sqrt(u.x), azimuth = 2.0 * std::numbers::pi * u.y;
  const Vec3 towards =
      frame_about(hit.normal)
          .to_world({radius * std::cos(azimuth), radius * std::sin(azimuth), std::sqrt(1.0 - u.x)});
  if (towards.z <= 0.0) return;
  ++rays_;
  if (!scene_->geometry.occluded({geometry::leaving_origin(hit, towards), towards})) {
    sums_.sky += 1.0;
  }
}

void TruthSums::add_sun(const geometry::Hit& hit) {
  const ephemeris::LightSource* body = sun();
  if (body == nullptr) return;
  const Vec3 towards = body->direction_enu;
  const double sine = std::clamp(dot(towards, hit.normal), -1.0, 1.0);
  sums_.sun_elevation_deg += to_degrees(Angle{std::asin(sine)});
  bool dark = towards.z <= 0.0 || sine <= 0.0;
  if (!dark) {
    ++rays_;
    dark = scene_->geometry.occluded({geometry::leaving_origin(hit, towards), towards});
  }
  if (dark) sums_.shadow += 1.0;
}

void TruthSums::store(std::size_t pixel, TruthImage& planes) const {
  if (!options_.planes) return;
  store_ids(pixel, planes);
  const std::uint32_t hits = sums_.hits;
  planes.range_m[pixel] = mean_or_missing(sums_.range_m, hits);
  planes.temperature_k[pixel] = mean_or_missing(sums_.temperature_k, sums_.with_temperature);
  const std::uint32_t lit = sun() == nullptr ? 0 : hits;
  planes.sun_elevation_deg[pixel] = mean_or_missing(sums_.sun_elevation_deg, lit);
  planes.shadow_fraction[pixel] = mean_or_missing(sums_.shadow, lit);
  planes.normal_east[pixel] = mean_or_missing(sums_.normal.x, hits);
  planes.normal_north[pixel] = mean_or_missing(sums_.normal.y, hits);
  planes.normal_up[pixel] = mean_or_missing(sums_.normal.z, hits);
  if (options_.sky_view) planes.sky_view[pixel] = mean_or_missing(sums_.sky, hits);
  store_place(pixel, planes);
}

void TruthSums::store_ids(std::size_t pixel, TruthImage& planes) const {
  const auto winner = std::max_element(material_votes_.begin(), material_votes_.end());
  planes.material[pixel] = static_cast<std::uint32_t>(winner - material_votes_.begin());
  planes.material_fraction[pixel] = static_cast<float>(*winner) / static_cast<float>(sums_.paths);
  Vote most{0, sums_.paths - sums_.hits};  // the sky
  for (const Vote& vote : object_votes_) {
    // Of equally many the least number, whatever the order in which they were seen.
    const bool more = vote.count > most.count;
    if (more || (vote.count == most.count && vote.object + 1 < most.object)) {
      most = {vote.object + 1, vote.count};
    }
  }
  planes.object[pixel] = most.object;
  for (std::size_t i = 0; i < planes.fractions.size(); ++i) {
    planes.fractions[i][pixel] =
        static_cast<float>(material_votes_[i]) / static_cast<float>(sums_.paths);
  }
}

void TruthSums::store_place(std::size_t pixel, TruthImage& planes) const {
  if (options_.frame == nullptr) return;
  if (sums_.hits == 0) {
    for (const auto& plane : place_planes) {
      if (plane.values != &TruthImage::time_s) (planes.*plane.values)[pixel] = missing_place;
    }
    for (auto* plane : {&planes.sun_zenith_deg, &planes.sun_azimuth_deg, &planes.view_zenith_deg,
                        &planes.view_azimuth_deg}) {
      (*plane)[pixel] = missing;
    }
    return;
  }
  // One conversion a pixel, not one a path: of the middle of what it sees.
  const geometry::Geodetic place =
      options_.frame->geodetic(sums_.position * (1.0 / static_cast<double>(sums_.hits)));
  planes.latitude_deg[pixel] = place.latitude_deg;
  planes.longitude_deg[pixel] = place.longitude_deg;
  planes.height_m[pixel] = place.height_m;
  const Mat3 local = options_.frame->axes_at(place);
  const SkyAngles view = sky_angles(local, sums_.towards_sensor);
  planes.view_zenith_deg[pixel] = static_cast<float>(view.zenith_deg);
  planes.view_azimuth_deg[pixel] = static_cast<float>(view.azimuth_deg);
  const ephemeris::LightSource* body = sun();
  planes.sun_zenith_deg[pixel] = planes.sun_azimuth_deg[pixel] = missing;
  if (body == nullptr) return;
  const SkyAngles sun_angles = sky_angles(local, body->direction_enu);
  planes.sun_zenith_deg[pixel] = static_cast<float>(sun_angles.zenith_deg);
  planes.sun_azimuth_deg[pixel] = static_cast<float>(sun_angles.azimuth_deg);
}

void prepare(TruthImage& planes, std::size_t pixels, const radiometry::SceneDescription& scene,
             const std::vector<std::string>& object_names, const TruthOptions& options) {
  if (!options.planes) return;
  for (const materials::Material& material : scene.materials) {
    planes.material_names.push_back(material.name);
  }
  planes.object_names = object_names;
  planes.material.resize(pixels);
  planes.object.resize(pixels);
  const auto wanted = [&](std::vector<float> TruthImage::*values) {
    if (values == &TruthImage::sky_view) return options.sky_view;
    const bool placed =
        values == &TruthImage::sun_zenith_deg || values == &TruthImage::sun_azimuth_deg ||
        values == &TruthImage::view_zenith_deg || values == &TruthImage::view_azimuth_deg;
    return !placed || options.frame != nullptr;
  };
  for (const auto& plane : truth_planes) {
    if (wanted(plane.values)) (planes.*plane.values).resize(pixels);
  }
  for (const auto& plane : place_planes) {
    if (options.frame != nullptr) (planes.*plane.values).resize(pixels);
  }
  if (options.fractions) {
    planes.fractions.assign(scene.materials.size() + 1, std::vector<float>(pixels));
  }
}

}  // namespace nadir::sim
