#include "sim/products/stac_item.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "sim/files/atomic_file.hpp"
#include "sim/products/ground_points.hpp"

namespace nadir::sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr double degrees_per_radian = 57.29577951308232;

const char* extension(const char* name) {
  struct Extension {
    const char* name;
    const char* schema;
  };
  static constexpr Extension all[] = {
      {"eo", "https://stac-extensions.github.io/eo/v2.0.0/schema.json"},
      {"view", "https://stac-extensions.github.io/view/v1.1.0/schema.json"},
      {"proj", "https://stac-extensions.github.io/projection/v2.0.0/schema.json"},
      {"sat", "https://stac-extensions.github.io/sat/v1.2.0/schema.json"},
      {"raster", "https://stac-extensions.github.io/raster/v2.0.0/schema.json"}};
  for (const Extension& one : all) {
    if (std::string_view{one.name} == name) return one.schema;
  }
  return "";
}

/// To so many parts of the unit; by division, which keeps decimals short.
double rounded(double value, double parts) { return std::round(value * parts) / parts; }

/// Azimuth clockwise from north, in [0, 360), of a direction in local axes.
double azimuth_deg(Vec3 local) {
  const double azimuth = std::atan2(local.x, local.y) * degrees_per_radian;
  return azimuth < 0.0 ? azimuth + 360.0 : azimuth;
}

/// Angles of the line of sight in the middle of the image.
struct MiddleView {
  GroundPoint ground;
  double off_nadir_deg = 0.0, incidence_deg = 0.0, azimuth_deg = 0.0;
  double gsd_m = 0.0;  ///< geometric mean of a pixel's sides, along the ground
};

/// How far apart neighbouring lines of sight of an array meet the ground.
double pixel_side_m(const GeoTask& task, sensor::ImagePoint from, sensor::ImagePoint to,
                    double height_m) {
  const auto a = ground_at(*task.geometry, *task.array, from, height_m);
  const auto b = ground_at(*task.geometry, *task.array, to, height_m);
  return a && b ? length(a->place - b->place) : 0.0;
}

/// Geometric mean of a pixel's sides about a place of the image.
double ground_sampling_m(const GeoTask& task, sensor::ImagePoint m, double height_m) {
  sensor::DetectorArray even = *task.array;
  even.modules.clear();  // their stagger would count as ground between two samples
  GeoTask plain = task;
  plain.array = &even;
  const double width =
      pixel_side_m(plain, {m.sample - 0.5, m.line}, {m.sample + 0.5, m.line}, height_m);
  const double height =
      pixel_side_m(plain, {m.sample, m.line - 0.5}, {m.sample, m.line + 0.5}, height_m);
  return std::sqrt(width * height);
}

std::optional<MiddleView> middle_view(const GeoTask& task) {
  const sensor::ImagePoint middle{0.5 * task.array->samples, 0.5 * task.array->lines};
  const auto ground = ground_at(*task.geometry, *task.array, middle);
  if (!ground) return std::nullopt;
  const auto view = sensor::image_view(*task.array, task.geometry->camera->platform, middle);
  const geometry::LocalFrame& frame = task.geometry->frame;
  const Mat3 at_ground = frame.axes_at(ground->geodetic).transposed();
  const Mat3 at_camera = frame.axes_at(frame.geodetic(view.ray.origin)).transposed();
  const Vec3 back = at_ground * -view.ray.direction;
  // STAC counts the azimuth from the point below the platform to the scene.
  const Vec3 ahead = at_camera * view.ray.direction;
  return MiddleView{*ground, std::acos(std::clamp(-ahead.z, -1.0, 1.0)) * degrees_per_radian,
                    std::acos(std::clamp(back.z, -1.0, 1.0)) * degrees_per_radian,
                    azimuth_deg(ahead), ground_sampling_m(task, middle, ground->geodetic.height_m)};
}

struct Outline {
  Json geometry, bbox;
};

/// RFC 7946 wants rings counter-clockwise and cut at the date line; ours cross it seldom and then
/// run on beyond 180 degrees, as readers accept.
Outline outline_of(const GeoTask& task) {
  const std::vector<GroundPoint> ring = footprint(*task.geometry, *task.array);
  if (ring.size() < 3) return {nullptr, nullptr};
  std::vector<Vec2> places;
  const double first = ring.front().geodetic.longitude_deg;
  for (const GroundPoint& point : ring) {
    const double east = std::remainder(point.geodetic.longitude_deg - first, 360.0);
    places.push_back({first + east, point.geodetic.latitude_deg});
  }
  double area = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec2 a = places[i], b = places[(i + 1) % places.size()];
    area += a.x * b.y - b.x * a.y;
  }
  if (area < 0.0) std::reverse(places.begin(), places.end());
  places.push_back(places.front());
  Json coordinates = Json::array();
  Vec2 lo = places.front(), hi = lo;
  for (const Vec2& place : places) {
    coordinates.push_back(Json::array({rounded(place.x, 1e9), rounded(place.y, 1e9)}));
    lo = {std::min(lo.x, place.x), std::min(lo.y, place.y)};
    hi = {std::max(hi.x, place.x), std::max(hi.y, place.y)};
  }
  Json geometry{{"type", "Polygon"}};
  geometry["coordinates"] = Json::array({coordinates});
  return {geometry, Json::array({rounded(lo.x, 1e9), rounded(lo.y, 1e9), rounded(hi.x, 1e9),
                                 rounded(hi.y, 1e9)})};
}

std::string moment(const GeoTask& task, double time_s) {
  return (task.geometry->time + Seconds{time_s}).to_string();
}

void add_times(Json& properties, const GeoTask& task) {
  const sensor::DetectorArray& array = *task.array;
  const double middle_s = sensor::image_time_s(array, {0.5 * array.samples, 0.5 * array.lines});
  const sensor::TimeSpan all = sensor::span(array.timing, array.samples, array.lines);
  properties["datetime"] = moment(task, middle_s);
  properties["start_datetime"] = moment(task, all.first_s);
  properties["end_datetime"] = moment(task, all.last_s);
}

void add_view(Json& properties, const GeoTask& task, const MiddleView& view) {
  properties["gsd"] = view.gsd_m;
  properties["view:off_nadir"] = rounded(view.off_nadir_deg, 1e6);
  properties["view:incidence_angle"] = rounded(view.incidence_deg, 1e6);
  properties["view:azimuth"] = rounded(view.azimuth_deg, 1e6);
  const Mat3 at_ground = task.geometry->frame.axes_at(view.ground.geodetic).transposed();
  for (const ephemeris::LightSource& body : task.geometry->bodies) {
    if (body.name != "sun") continue;
    const Vec3 sun = at_ground * body.direction_enu;
    properties["view:sun_azimuth"] = rounded(azimuth_deg(sun), 1e6);
    properties["view:sun_elevation"] =
        rounded(std::asin(std::clamp(sun.z, -1.0, 1.0)) * degrees_per_radian, 1e6);
  }
}

/// Above the air and as fast as what stays there.
bool add_orbit(Json& properties, const GeoTask& task) {
  const sensor::Platform& platform = task.geometry->camera->platform;
  if (platform.is_fixed()) return false;
  const sensor::TimeSpan all =
      sensor::span(task.array->timing, task.array->samples, task.array->lines);
  const double elapsed_s = all.last_s - all.first_s;
  if (!(elapsed_s > 0.0)) return false;
  const geometry::LocalFrame& frame = task.geometry->frame;
  const Vec3 a = platform.steady(all.first_s).position, b = platform.steady(all.last_s).position;
  const geometry::Geodetic from = frame.geodetic(a), to = frame.geodetic(b);
  if (from.height_m < 1.2e5 || length(b - a) / elapsed_s < 2000.0) return false;
  properties["sat:orbit_state"] = to.latitude_deg >= from.latitude_deg ? "ascending" : "descending";
  return true;
}

void add_projection(Json& properties, const GeoTask& task, const Georeference& georeference) {
  if (!georeference.map) return;
  if (georeference.epsg != 0) {
    properties["proj:code"] = fmt::format("EPSG:{}", georeference.epsg);
  } else {
    properties["proj:code"] = nullptr;
  }
  properties["proj:shape"] = {task.array->lines, task.array->samples};
  const auto& t = georeference.map->transform;
  properties["proj:transform"] = {t[1], t[2], t[0], t[4], t[5], t[3], 0.0, 0.0, 1.0};
}

/// Names that STAC's eo extension has for bands (eo:common_name), by centre and width.
const char* common_name(const BandFigures& band) {
  struct Common {
    const char* name;
    double lo_um, hi_um;  // of the centre
  };
  // Middles of the ranges in the extension's table, non-overlapping.
  static constexpr Common all[] = {
      {"coastal", 0.40, 0.45},    {"blue", 0.45, 0.53},   {"green", 0.53, 0.60},
      {"yellow", 0.60, 0.62},     {"red", 0.62, 0.69},    {"rededge071", 0.69, 0.73},
      {"rededge075", 0.73, 0.76}, {"nir", 0.76, 1.00},    {"cirrus", 1.35, 1.40},
      {"swir16", 1.55, 1.75},     {"swir22", 2.08, 2.35}, {"lwir11", 10.5, 11.5},
      {"lwir12", 11.5, 12.5}};
  if (band.fwhm_um > 0.15 * band.centre_um + 0.05) return nullptr;
  for (const Common& one : all) {
    if (band.centre_um >= one.lo_um && band.centre_um < one.hi_um) return one.name;
  }
  return nullptr;
}

Json bands_of(const GeoTask& task, bool digital_numbers, double gsd_m) {
  Json bands = Json::array();
  const auto& calibrations = task.context->calibrations;
  std::size_t i = 0;
  for (const BandFigures& figures : band_figures(*task.array)) {
    Json band{{"name", figures.name},
              {"eo:center_wavelength", figures.centre_um},
              {"eo:full_width_half_max", figures.fwhm_um}};
    if (const char* common = common_name(figures)) band["eo:common_name"] = common;
    band["data_type"] = digital_numbers ? "uint16" : "float32";
    band["unit"] = radiance_unit;
    if (digital_numbers && task.number < calibrations.size() &&
        i < calibrations[task.number].size()) {
      band["raster:scale"] = calibrations[task.number][i].gain;
      band["raster:offset"] = calibrations[task.number][i].offset;
    }
    if (gsd_m > 0.0) band["raster:spatial_resolution"] = gsd_m;
    bands.push_back(band);
    ++i;
  }
  return bands;
}

const char* media_type(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".tif") return "image/tiff; application=geotiff; profile=cloud-optimized";
  if (ending == ".nc") return "application/netcdf";
  if (ending == ".png") return "image/png";
  if (ending == ".json") return "application/json";
  if (ending == ".hdr") return "text/plain";
  if (ending == ".exr") return "image/x-exr";
  return "application/octet-stream";
}

const char* role_of(const ProductFile& file) {
  if (file.kind == "quick look") return "overview";
  const std::string ending = file.path.extension().string();
  return ending == ".json" || ending == ".hdr" ? "metadata" : "data";
}

/// Keys are the names of the files without the array's: unique, and stable from run to run.
Json assets_of(const GeoTask& task, const std::vector<ProductFile>& files, double gsd_m) {
  Json assets = Json::object();
  const std::string stem = task.stem.filename().string();
  for (const ProductFile& file : files) {
    if (file.array != task.array->name) continue;
    const std::string name = file.path.filename().string();
    std::string key = name.rfind(stem, 0) == 0 ? name.substr(stem.size()) : name;
    std::replace(key.begin(), key.end(), '.', '_');
    key.erase(0, key.find_first_not_of('_'));
    Json asset{{"href", "./" + name},
               {"title", file.kind},
               {"type", media_type(file.path)},
               {"roles", Json::array({role_of(file)})}};
    const bool dn = key.rfind("dn_tif", 0) == 0;
    if (dn || key.rfind("radiance_tif", 0) == 0) asset["bands"] = bands_of(task, dn, gsd_m);
    assets[key.empty() ? "file" : key] = asset;
  }
  return assets;
}

void add_origin(Json& properties, const GeoTask& task) {
  const Camera& camera = *task.geometry->camera;
  properties["title"] = fmt::format("{}, array {}", task.context->scenario_name, task.array->name);
  properties["description"] =
      fmt::format("Simulated by nadir {}: no instrument measured it", task.context->version);
  if (!camera.platform_name.empty()) properties["platform"] = camera.platform_name;
  if (!camera.instrument_name.empty()) {
    properties["instruments"] = Json::array({camera.instrument_name});
  }
}

}  // namespace

std::string stac_item(const GeoTask& task, const Georeference& georeference,
                      const std::vector<ProductFile>& files) {
  Json properties, extensions = Json::array({extension("eo"), extension("raster")});
  add_times(properties, task);
  add_origin(properties, task);
  const auto view = middle_view(task);
  if (view) {
    add_view(properties, task, *view);
    extensions.push_back(extension("view"));
  }
  if (add_orbit(properties, task)) extensions.push_back(extension("sat"));
  if (georeference.map) extensions.push_back(extension("proj"));
  add_projection(properties, task, georeference);
  const double gsd_m = view ? view->gsd_m : 0.0;
  properties["bands"] = bands_of(task, false, gsd_m);
  const Outline outline = outline_of(task);
  Json item{{"type", "Feature"},
            {"stac_version", "1.1.0"},
            {"stac_extensions", extensions},
            {"id", fmt::format("{}_{}", task.context->scenario_name, task.array->name)},
            {"geometry", outline.geometry}};
  if (!outline.bbox.is_null()) item["bbox"] = outline.bbox;
  item["properties"] = properties;
  item["links"] = Json::array();
  item["assets"] = assets_of(task, files, gsd_m);
  return item.dump(2) + "\n";
}

std::vector<ProductFile> write_stac_item(const GeoTask& task, const Georeference& georeference,
                                         const std::vector<ProductFile>& files) {
  const auto file = task.with("_stac.json");
  write_file(file, stac_item(task, georeference, files));
  return {task.record("STAC item", file)};
}

}  // namespace nadir::sim
