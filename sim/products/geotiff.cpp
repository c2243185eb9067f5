#include "sim/products/geotiff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/products/ground_points.hpp"
#include "sim/products/least_squares.hpp"

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;

std::string digits(double value) { return fmt::format("{:.17g}", value); }

/// The axis within 1e-6 rad of the vertical: a relief of a kilometre shifts by a millimetre.
bool looks_straight_down(const Camera& camera, const sensor::DetectorArray& array) {
  if (!std::holds_alternative<sensor::Orthographic>(array.projection)) return false;
  if (!camera.platform.is_fixed()) return false;
  return length(cross(camera.platform.steady(0.0).axes.z, Vec3{0.0, 0.0, -1.0})) < 1e-6 &&
         camera.platform.steady(0.0).axes.z.z < 0.0;
}

/// The plane's coefficients: value = c[0] + sample c[1] + line c[2].
std::optional<std::vector<double>> plane_through(const std::vector<GroundPoint>& points,
                                                 const std::vector<double>& values) {
  std::vector<double> a;
  for (const GroundPoint& point : points) {
    a.insert(a.end(), {1.0, point.image.sample, point.image.line});
  }
  return least_squares(std::move(a), values, 3);
}

struct FittedMap {
  MapPlacement placement;
  double residual_px = 0.0;
};

std::optional<FittedMap> fit_map(const std::string& coordinates,
                                 const std::vector<GroundPoint>& points) {
  std::vector<geometry::Geodetic> places;
  for (const GroundPoint& point : points) places.push_back(point.geodetic);
  std::vector<double> x, y;
  for (const Vec2& on_map : projected(coordinates, places)) {
    x.push_back(on_map.x);
    y.push_back(on_map.y);
  }
  const auto to_x = plane_through(points, x), to_y = plane_through(points, y);
  if (!to_x || !to_y) return std::nullopt;
  FittedMap map{
      {coordinates, {(*to_x)[0], (*to_x)[1], (*to_x)[2], (*to_y)[0], (*to_y)[1], (*to_y)[2]}}};
  const auto& t = map.placement.transform;
  const double pixel_m = std::sqrt(std::abs(t[1] * t[5] - t[2] * t[4]));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const sensor::ImagePoint at = points[i].image;
    const double off = std::hypot(t[0] + at.sample * t[1] + at.line * t[2] - x[i],
                                  t[3] + at.sample * t[4] + at.line * t[5] - y[i]);
    map.residual_px = std::max(map.residual_px, off / pixel_m);
  }
  if (!std::isfinite(map.residual_px)) return std::nullopt;
  return map;
}

/// Zone of the universal transverse Mercator projection on WGS84; 0 near the poles. The exceptions
/// about Norway are left out: any zone nearby serves.
int utm_epsg(const geometry::Geodetic& site) {
  if (std::abs(site.latitude_deg) > 84.0) return 0;
  const double east = std::remainder(site.longitude_deg, 360.0) + 180.0;
  const int zone = std::clamp(static_cast<int>(std::floor(east / 6.0)) + 1, 1, 60);
  return (site.latitude_deg >= 0.0 ? 32600 : 32700) + zone;
}

/// Points at the scene's mean height, all over the image; empty where one of them shows the sky.
std::vector<GroundPoint> level_points(const GeoTask& task) {
  std::vector<GroundPoint> points;
  for (const auto& image : image_grid(*task.array, {9, 9})) {
    const auto point = ground_at(*task.geometry, *task.array, image, task.geometry->mean_height_m);
    if (!point) return {};
    points.push_back(*point);
  }
  return points;
}

void place_on_map(const GeoTask& task, Georeference& found) {
  const std::vector<GroundPoint> points = level_points(task);
  if (points.empty()) return;
  const geometry::Geodetic& site = task.geometry->frame.origin();
  const int utm = utm_epsg(site);
  const std::string own = fmt::format(
      "+proj=ortho +lat_0={:.12g} +lon_0={:.12g} +datum=WGS84 "
      "+units=m +type=crs",
      site.latitude_deg, site.longitude_deg);
  for (const int epsg : {utm, 0}) {
    const auto map = fit_map(epsg != 0 ? fmt::format("EPSG:{}", epsg) : own, points);
    if (!map || map->residual_px > most_map_residual_px) continue;
    found.map = map->placement;
    found.epsg = epsg;
    found.map_residual_px = map->residual_px;
    return;
  }
}

/// Heights above the ellipsoid that polynomials are to serve.
struct HeightRange {
  double lo_m = 0.0, hi_m = 0.0;
};

/// What the image shows and as much again as terrain models may be off by, but nothing near the
/// camera's own height.
HeightRange heights_for(const GeoTask& task, const std::vector<GroundPoint>& points) {
  HeightRange range{points.front().geodetic.height_m, points.front().geodetic.height_m};
  double nearest_m = 1e9;
  for (const GroundPoint& point : points) {
    range.lo_m = std::min(range.lo_m, point.geodetic.height_m);
    range.hi_m = std::max(range.hi_m, point.geodetic.height_m);
    const auto view = sensor::image_view(*task.array, task.geometry->camera->platform, point.image);
    nearest_m = std::min(nearest_m, length(view.ray.origin - point.place));
  }
  const double around = std::min(0.6 * (range.hi_m - range.lo_m) + 100.0, 0.05 * nearest_m);
  return {range.lo_m - around, range.hi_m + around};
}

std::vector<RpcPoint> space_points(const GeoTask& task, HeightRange range, GridSize grid,
                                   bool inner) {
  constexpr int levels = 5;
  std::vector<RpcPoint> points;
  const int count = inner ? levels - 1 : levels;
  for (int level = 0; level < count; ++level) {
    const double share = (level + (inner ? 0.5 : 0.0)) / (levels - 1.0);
    const double height_m = range.lo_m + share * (range.hi_m - range.lo_m);
    for (const auto& image : image_grid(*task.array, grid, inner)) {
      const auto point = ground_at(*task.geometry, *task.array, image, height_m);
      if (point) points.push_back({{image.sample, image.line}, point->geodetic});
    }
  }
  return points;
}

/// The largest jump of the line of sight from sample to sample where modules meet.
double stagger_px(const sensor::DetectorArray& array) {
  const auto turned_px = [](const sensor::Module& m) {
    return 0.5 * m.samples * std::abs(std::sin(m.rotation_rad));
  };
  double largest = 0.0;
  for (std::size_t i = 1; i < array.modules.size(); ++i) {
    const sensor::Module &a = array.modules[i - 1], &b = array.modules[i];
    const double apart_px = std::hypot((b.offset_x_m - a.offset_x_m) / array.pitch_m,
                                       (b.offset_y_m - a.offset_y_m) / array.height_m());
    largest = std::max(largest, apart_px + turned_px(a) + turned_px(b));
  }
  return largest;
}

/// The points' places for GDAL. Longitudes run on across the date line: readers interpolate.
std::vector<ControlPoint> control_points(const std::vector<GroundPoint>& points) {
  std::vector<ControlPoint> control;
  const double first = points.front().geodetic.longitude_deg;
  for (const GroundPoint& point : points) {
    geometry::Geodetic place = point.geodetic;
    // As it is where nothing is to be done: the sum would round.
    const double turns = std::round((place.longitude_deg - first) / 360.0);
    if (turns != 0.0) place.longitude_deg -= 360.0 * turns;
    control.push_back({{point.image.sample, point.image.line}, place});
  }
  return control;
}

void add_polynomials(const GeoTask& task, HeightRange range, Georeference& found) {
  const std::vector<RpcPoint> points = space_points(task, range, {12, 12}, false);
  found.rpc = fit_rpc(points, space_points(task, range, {11, 11}, true));
  if (!found.rpc) {
    task.warn(points.size() < least_rpc_points
                  ? "no rational polynomials: too few lines of sight meet the earth"
                  : "no rational polynomials: all that fit have poles within the image");
  } else if (found.rpc->largest_px > most_rpc_residual_px) {
    task.warn(fmt::format("no rational polynomials: they would be off by up to {:.2g} pixels",
                          found.rpc->largest_px));
    found.rpc.reset();
  }
}

void place_by_points(const GeoTask& task, Georeference& found) {
  if (const double jump_px = stagger_px(*task.array); jump_px > most_rpc_residual_px) {
    task.warn(
        fmt::format("its GeoTIFF is not georeferenced: from module to module the image jumps "
                    "by up to {:.3g} pixels, which neither control points nor rational "
                    "polynomials can say; NetCDF holds every pixel's place",
                    jump_px));
    return;
  }
  std::vector<GroundPoint> points;
  for (const auto& image : image_grid(*task.array, {9, 9})) {
    if (const auto point = ground_at(*task.geometry, *task.array, image)) points.push_back(*point);
  }
  if (points.size() < 4) {
    task.warn("too little of the earth in view to georeference the image");
    return;
  }
  found.control = control_points(points);
  add_polynomials(task, heights_for(task, points), found);
}

std::string in_imagery_form(const ephemeris::Instant& time) {
  std::string text = time.to_string().substr(0, 19);  // YYYY-MM-DDThh:mm:ss
  std::replace(text.begin(), text.end(), 'T', ' ');
  return text;
}

GeoTiff described(const GeoTask& task, const Georeference& georeference, const char* what) {
  GeoTiff job;
  job.map = georeference.map;
  job.control = georeference.control;
  const Camera& camera = *task.geometry->camera;
  const sensor::ImagePoint middle{0.5 * task.array->samples, 0.5 * task.array->lines};
  const double middle_s = sensor::image_time_s(*task.array, middle);
  job.items = {
      {"TIFFTAG_SOFTWARE", "nadir " + task.context->version},
      {"TIFFTAG_IMAGEDESCRIPTION", fmt::format("{}, scenario {}, array {}", what,
                                               task.context->scenario_name, task.array->name)}};
  if (georeference.map) {
    job.items.emplace_back("NADIR_MAP_RESIDUAL_PX",
                           fmt::format("{:.2g}", georeference.map_residual_px));
  }
  if (georeference.rpc) {
    job.rpc = gdal_rpc(georeference.rpc->rpc);
    job.items.emplace_back("NADIR_RPC_RESIDUAL_PX",
                           fmt::format("{:.2g}", georeference.rpc->largest_px));
  }
  if (!camera.platform_name.empty()) {
    job.items.emplace_back("SATELLITEID", camera.platform_name);
  }
  job.items.emplace_back("ACQUISITIONDATETIME",
                         in_imagery_form(task.geometry->time + Seconds{middle_s}));
  for (const BandFigures& band : band_figures(*task.array)) {
    job.bands.push_back({band.name,
                         radiance_unit,
                         1.0,
                         0.0,
                         {{"wavelength", fmt::format("{}", band.centre_um)},
                          {"fwhm", fmt::format("{}", band.fwhm_um)},
                          {"wavelength_units", "Micrometers"},
                          {"CENTRAL_WAVELENGTH_UM", fmt::format("{}", band.centre_um)},
                          {"FWHM_UM", fmt::format("{}", band.fwhm_um)}}});
  }
  return job;
}

}  // namespace

std::vector<BandFigures> band_figures(const sensor::DetectorArray& array) {
  const auto figure = [](double um) { return std::round(um * 1e9) / 1e9; };  // 0.65, not 0.6499...
  std::vector<BandFigures> figures;
  for (const sensor::Band& band : array.bands) {
    figures.push_back({band.name, figure(spectral::centre(band.response).value),
                       figure(spectral::fwhm(band.response).value)});
  }
  return figures;
}

Georeference map_of(const GeoTask& task) {
  Georeference found;
  if (looks_straight_down(*task.geometry->camera, *task.array)) place_on_map(task, found);
  return found;
}

Georeference georeference(const GeoTask& task) {
  Georeference found = map_of(task);
  if (!found.map) place_by_points(task, found);
  return found;
}

std::vector<ProductFile> write_geotiffs(const GeoTask& task, const Georeference& georeference) {
  std::vector<ProductFile> written;
  GeoTiff job = described(task, georeference, "At-aperture spectral radiance, band means");
  job.source = task.with("_radiance.img");
  job.nan_is_no_data = true;
  write_geotiff(task.with("_radiance.tif"), job);
  written.push_back(task.record("radiance GeoTIFF", task.with("_radiance.tif")));
  if (!fs::exists(task.with("_dn.img"))) return written;
  job = described(task, georeference, "Digital numbers; scale and offset give spectral radiance");
  job.source = task.with("_dn.img");
  const auto& all = task.context->calibrations;
  for (std::size_t i = 0; i < job.bands.size(); ++i) {
    if (task.number >= all.size() || i >= all[task.number].size()) continue;
    job.bands[i].scale = all[task.number][i].gain;
    job.bands[i].offset = all[task.number][i].offset;
  }
  write_geotiff(task.with("_dn.tif"), job);
  written.push_back(task.record("DN GeoTIFF", task.with("_dn.tif")));
  return written;
}

TextItems gdal_rpc(const Rpc& rpc) {
  const auto listed = [](const std::array<double, 20>& coefficients) {
    std::string text;
    for (const double value : coefficients) text += (text.empty() ? "" : " ") + digits(value);
    return text;
  };
  return {{"LINE_OFF", digits(rpc.line_off - 0.5)},
          {"SAMP_OFF", digits(rpc.sample_off - 0.5)},
          {"LAT_OFF", digits(rpc.latitude_off)},
          {"LONG_OFF", digits(rpc.longitude_off)},
          {"HEIGHT_OFF", digits(rpc.height_off)},
          {"LINE_SCALE", digits(rpc.line_scale)},
          {"SAMP_SCALE", digits(rpc.sample_scale)},
          {"LAT_SCALE", digits(rpc.latitude_scale)},
          {"LONG_SCALE", digits(rpc.longitude_scale)},
          {"HEIGHT_SCALE", digits(rpc.height_scale)},
          {"LINE_NUM_COEFF", listed(rpc.line_numerator)},
          {"LINE_DEN_COEFF", listed(rpc.line_denominator)},
          {"SAMP_NUM_COEFF", listed(rpc.sample_numerator)},
          {"SAMP_DEN_COEFF", listed(rpc.sample_denominator)}};
}

}  // namespace nadir::sim
