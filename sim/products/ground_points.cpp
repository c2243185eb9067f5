#include "sim/products/ground_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/files/atomic_file.hpp"
#include "sim/files/envi.hpp"

namespace nadir::sim {
namespace {

constexpr double equatorial_radius_m = 6378137.0;  // WGS84
constexpr double polar_radius_m = 6356752.314245;

/// Distance along a line to the ellipsoid whose half axes are longer by a height: within a few
/// centimetres of where that height is, for heights of kilometres. From below that height only
/// lines that rise come to it: the others end in the ground before the far side of the earth.
std::optional<double> nearly(Vec3 from_ecef, Vec3 towards_ecef, double height_m) {
  const double a = equatorial_radius_m + height_m, b = polar_radius_m + height_m;
  const Vec3 o{from_ecef.x / a, from_ecef.y / a, from_ecef.z / b};
  const Vec3 d{towards_ecef.x / a, towards_ecef.y / a, towards_ecef.z / b};
  const double dd = dot(d, d), od = dot(o, d), c = dot(o, o) - 1.0;
  const double root2 = od * od - dd * c;
  if (root2 < 0.0) return std::nullopt;
  const double root = std::sqrt(root2);
  const double near = (-od - root) / dd, far = (-od + root) / dd;
  if (near > 0.0) return near;
  if (far > 0.0 && od > 0.0) return far;
  return std::nullopt;
}

GroundPoint point_of(const ProductGeometry& geometry, sensor::ImagePoint image,
                     const sensor::PathView& view, Vec3 place) {
  return {image, place, geometry.frame.geodetic(place), view.time_s, false};
}

/// Line of sight of a place of the image.
sensor::PathView view_at(const ProductGeometry& geometry, const sensor::DetectorArray& array,
                         sensor::ImagePoint image) {
  return sensor::image_view(array, geometry.camera->platform, image);
}

std::string places_header(const sensor::DetectorArray& array) {
  return fmt::format(
      "ENVI\ndescription = {{Places of pixel centres}}\nsamples = {}\nlines = {}\nbands = 4\n"
      "header offset = 0\nfile type = ENVI Standard\ndata type = 5\ninterleave = bsq\n"
      "byte order = 0\nband names = {{latitude (deg), longitude (deg), height (m), time (s)}}\n",
      array.samples, array.lines);
}

}  // namespace

std::optional<Vec3> at_height(const geometry::LocalFrame& frame, const geometry::Ray& ray,
                              double height_m) {
  const Vec3 from = frame.ecef(ray.origin);
  auto distance = nearly(from, frame.ecef(ray.origin + ray.direction) - from, height_m);
  if (!distance) return std::nullopt;
  Vec3 place = ray.origin + *distance * ray.direction;
  for (int turn = 0; turn < 20; ++turn) {
    const geometry::Geodetic there = frame.geodetic(place);
    const double rise = dot(ray.direction, frame.axes_at(there).z);
    if (std::abs(rise) < 1e-6) return std::nullopt;  // grazes it
    const double step = (height_m - there.height_m) / rise;
    place += step * ray.direction;
    if (std::abs(step) >= 1e-6) continue;
    if (dot(place - ray.origin, ray.direction) < 0.0) return std::nullopt;  // behind the camera
    return place;
  }
  return std::nullopt;
}

std::optional<GroundPoint> ground_at(const ProductGeometry& geometry,
                                     const sensor::DetectorArray& array, sensor::ImagePoint image) {
  const sensor::PathView view = view_at(geometry, array, image);
  if (geometry.surface) {
    if (const auto place = geometry.surface(view.ray)) {
      GroundPoint point = point_of(geometry, image, view, *place);
      point.on_surface = true;
      return point;
    }
  }
  const auto place = at_height(geometry.frame, view.ray, geometry.mean_height_m);
  if (!place) return std::nullopt;
  return point_of(geometry, image, view, *place);
}

std::optional<GroundPoint> ground_at(const ProductGeometry& geometry,
                                     const sensor::DetectorArray& array, sensor::ImagePoint image,
                                     double height_m) {
  const sensor::PathView view = view_at(geometry, array, image);
  const auto place = at_height(geometry.frame, view.ray, height_m);
  if (!place) return std::nullopt;
  return point_of(geometry, image, view, *place);
}

std::vector<sensor::ImagePoint> image_grid(const sensor::DetectorArray& array, GridSize size,
                                           bool inner) {
  const auto at = [inner](int i, int count, int pixels) {
    const double share = inner ? (i + 0.5) / count : (count > 1 ? i / (count - 1.0) : 0.5);
    return share * pixels;
  };
  std::vector<sensor::ImagePoint> grid;
  for (int row = 0; row < size.rows; ++row) {
    for (int column = 0; column < size.columns; ++column) {
      grid.push_back({at(column, size.columns, array.samples), at(row, size.rows, array.lines)});
    }
  }
  return grid;
}

std::vector<GroundPoint> footprint(const ProductGeometry& geometry,
                                   const sensor::DetectorArray& array) {
  constexpr int pieces = 8;  // of each side
  const double width = array.samples, height = array.lines;
  const std::array<Vec2, 5> corners{
      Vec2{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}, {0.0, 0.0}};
  std::vector<GroundPoint> ring;
  for (std::size_t side = 0; side < 4; ++side) {
    for (int i = 0; i < pieces; ++i) {
      const double share = static_cast<double>(i) / pieces;
      const Vec2 a = corners[side], b = corners[side + 1];
      const auto point =
          ground_at(geometry, array, {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
      if (point) ring.push_back(*point);
    }
  }
  return ring;
}

void write_places(const std::filesystem::path& image, const ProductGeometry& geometry,
                  const sensor::DetectorArray& array) {
  const auto columns = static_cast<std::size_t>(array.samples);
  const std::uint64_t plane_bytes = columns * static_cast<std::uint64_t>(array.lines) * 8U;
  std::array<std::vector<double>, 4> row;
  for (auto& values : row) values.resize(columns);
  AtomicFile file{image};
  for (int line = 0; line < array.lines; ++line) {
    for (int sample = 0; sample < array.samples; ++sample) {
      const sensor::ImagePoint at{sample + 0.5, line + 0.5};
      const auto point = ground_at(geometry, array, at);
      const auto i = static_cast<std::size_t>(sample);
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      row[0][i] = point ? point->geodetic.latitude_deg : nan;
      row[1][i] = point ? point->geodetic.longitude_deg : nan;
      row[2][i] = point ? point->geodetic.height_m : nan;
      row[3][i] = point ? point->time_s : sensor::image_time_s(array, at);
    }
    for (std::size_t plane = 0; plane < row.size(); ++plane) {
      file.seek(plane * plane_bytes + static_cast<std::uint64_t>(line) * columns * 8U);
      file.write(std::as_bytes(std::span{row[plane]}));
    }
  }
  write_file(envi_header_of(image), places_header(array));
  file.commit();
}

}  // namespace nadir::sim
