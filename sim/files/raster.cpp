#include "sim/files/raster.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "core/error.hpp"
#include "sim/files/modules.hpp"
#include "sim/modules/rasters/raster_module.hpp"

namespace nadir::sim {
namespace {

const NadirRasterModule& raster_module() {
  const auto& table = load_module<NadirRasterModule>("nadir_rasters", "nadir_raster_module");
  if (table.version != nadir_raster_module_version) {
    throw std::runtime_error("the module nadir_rasters belongs to another version of nadir");
  }
  return table;
}

/// What the module lent, given back at the end.
class LentRaster {
 public:
  LentRaster(const std::filesystem::path& file, int band, bool geodetic,
             const NadirRasterWindow* window)
      : module_{&raster_module()} {
    std::array<char, 1024> message{};
    if (module_->read(file.c_str(), band, geodetic, window, &raster_, message.data(),
                      message.size()) != 0) {
      throw InputError{InputIssue{{file.string(), 0, 0}, message.data(), {}, {}}};
    }
  }
  LentRaster(const LentRaster&) = delete;
  LentRaster& operator=(const LentRaster&) = delete;
  ~LentRaster() { module_->release(&raster_); }

  [[nodiscard]] const NadirRaster& operator*() const { return raster_; }
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(raster_.columns) * static_cast<std::size_t>(raster_.rows);
  }

 private:
  const NadirRasterModule* module_;
  NadirRaster raster_{};
};

}  // namespace

Raster read_raster(const std::filesystem::path& file, int band) {
  const LentRaster lent{file, band, false, nullptr};
  const NadirRaster& from = *lent;
  return {from.columns,
          from.rows,
          from.bands,
          {from.values, from.values + lent.size()},
          from.has_geotransform != 0,
          from.has_projection != 0,
          from.full_scale};
}

std::vector<geometry::Geodetic> locate_in_raster(const std::filesystem::path& file,
                                                 const std::vector<Vec2>& pixels) {
  std::vector<double> x, y;
  for (const Vec2& pixel : pixels) {
    x.push_back(pixel.x);
    y.push_back(pixel.y);
  }
  std::array<char, 1024> message{};
  if (raster_module().locate(file.c_str(), static_cast<int>(pixels.size()), x.data(), y.data(),
                             message.data(), message.size()) != 0) {
    throw InputError{InputIssue{{file.string(), 0, 0}, message.data(), {}, {}}};
  }
  std::vector<geometry::Geodetic> places;
  for (std::size_t i = 0; i < x.size(); ++i) places.push_back({y[i], x[i], 0.0});
  return places;
}

geometry::HeightGrid read_height_grid(const std::filesystem::path& file, double height_offset_m,
                                      const GeodeticBounds* bounds) {
  NadirRasterWindow window{};
  if (bounds) window = {bounds->south_deg, bounds->west_deg, bounds->north_deg, bounds->east_deg};
  const LentRaster lent{file, 1, true, bounds ? &window : nullptr};
  const NadirRaster& from = *lent;
  geometry::HeightGrid grid{from.columns, from.rows, {}};
  grid.posts.reserve(lent.size());
  for (std::size_t i = 0; i < lent.size(); ++i) {
    grid.posts.push_back(
        {from.latitude_deg[i], from.longitude_deg[i], from.values[i] + height_offset_m});
  }
  return grid;
}

}  // namespace nadir::sim
