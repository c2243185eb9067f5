#include "sim/run/map_raster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace nadir::sim {
namespace {

using materials::MapFrame;

/// Places over a raster: its corners, edges and inside.
constexpr int lattice = 5;

struct Placed {
  Vec2 pixel;  ///< from the middle of the raster
  Vec2 ground;
};

std::vector<Placed> placed_lattice(const std::filesystem::path& file, const Raster& raster,
                                   const geometry::LocalFrame& frame) {
  const Vec2 middle{0.5 * raster.columns, 0.5 * raster.rows};
  std::vector<Vec2> pixels;
  for (int j = 0; j < lattice; ++j) {
    for (int i = 0; i < lattice; ++i) {
      pixels.push_back(
          {raster.columns * (i / (lattice - 1.0)), raster.rows * (j / (lattice - 1.0))});
    }
  }
  auto places = locate_in_raster(file, pixels);
  std::vector<Placed> placed;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!std::isfinite(places[i].latitude_deg) || !std::isfinite(places[i].longitude_deg)) {
      throw InputError{InputIssue{
          {file.string(), 0, 0}, "a corner of the raster has no place on the earth", {}, {}}};
    }
    places[i].height_m = frame.origin().height_m;
    const Vec3 at = frame.enu(places[i]);
    placed.push_back({{pixels[i].x - middle.x, pixels[i].y - middle.y}, {at.x, at.y}});
  }
  return placed;
}

/// The affine map with the least squares of errors; over a regular lattice about its middle the
/// unknowns part, and each is a ratio of sums.
MapFrame fitted(const std::vector<Placed>& placed, const Raster& raster) {
  double columns = 0.0, rows = 0.0;  // sums of squares
  Vec2 middle, per_column, per_row;
  for (const auto& [pixel, ground] : placed) {
    columns += pixel.x * pixel.x;
    rows += pixel.y * pixel.y;
    middle = {middle.x + ground.x, middle.y + ground.y};
    per_column = {per_column.x + pixel.x * ground.x, per_column.y + pixel.x * ground.y};
    per_row = {per_row.x + pixel.y * ground.x, per_row.y + pixel.y * ground.y};
  }
  const auto count = static_cast<double>(placed.size());
  MapFrame frame;
  frame.step = {per_column.x / columns, per_row.y / rows};
  frame.lean = {per_row.x / rows, per_column.y / columns};
  const double half_columns = 0.5 * raster.columns, half_rows = 0.5 * raster.rows;
  frame.origin = {middle.x / count - half_columns * frame.step.x - half_rows * frame.lean.x,
                  middle.y / count - half_columns * frame.lean.y - half_rows * frame.step.y};
  return frame;
}

MapFrame georeferenced(const std::filesystem::path& file, const Raster& raster,
                       const MapContext& context) {
  const auto placed = placed_lattice(file, raster, *context.frame);
  const MapFrame frame = fitted(placed, raster);
  double worst = 0.0;
  for (const auto& [pixel, ground] : placed) {
    const Vec2 at = frame.pixels(ground);
    worst = std::max(worst, std::hypot(at.x - pixel.x - 0.5 * raster.columns,
                                       at.y - pixel.y - 0.5 * raster.rows));
  }
  if (!(worst <= 1e6)) {
    throw InputError{
        InputIssue{{file.string(), 0, 0}, "the raster cannot be laid flat at the site", {}, {}}};
  }
  if (worst > 0.5) {
    context.diagnostics->warn(
        fmt::format("{}: the raster's grid is curved in the scene's axes: towards its edges pixels "
                    "are up to {:.1f} of their width off; cut it to the scene",
                    file.string(), worst));
  }
  return frame;
}

MapFrame over_area(const GroundArea& area, const Raster& raster) {
  MapFrame frame;
  frame.origin = {area.west_m, area.north_m};
  frame.step = {(area.east_m - area.west_m) / raster.columns,
                (area.south_m - area.north_m) / raster.rows};
  return frame;
}

}  // namespace

MapFrame map_frame(const MapPlaceInput& place, const std::filesystem::path& file,
                   const Raster& raster, const MapContext& context) {
  MapFrame frame;
  if (const auto* texture = std::get_if<TextureDrape>(&place.drape)) {
    frame = over_area({0.0, 0.0, texture->size_u, texture->size_v}, raster);
    frame.by = MapFrame::By::texture;
  } else if (const auto& area = std::get<GroundDrape>(place.drape).area) {
    frame = over_area(*area, raster);
  } else {
    frame = georeferenced(file, raster, context);
  }
  frame.columns = raster.columns;
  frame.rows = raster.rows;
  frame.repeats = place.repeats;
  return frame;
}

InputError pixel_error(const std::filesystem::path& file, const Raster& raster, std::size_t pixel,
                       const std::string& what, std::string hint) {
  const auto columns = static_cast<std::size_t>(raster.columns);
  return InputError{InputIssue{{file.string(), 0, 0},
                               fmt::format("the pixel in column {}, row {} (the first is 1, 1) {}",
                                           pixel % columns + 1, pixel / columns + 1, what),
                               std::move(hint),
                               {}}};
}

}  // namespace nadir::sim
