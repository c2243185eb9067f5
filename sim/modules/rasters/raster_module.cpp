#include "raster_module.hpp"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "gdal_calls.hpp"
#include "writers.hpp"

namespace {

using nadir_rasters::fail;
using nadir_rasters::told;

struct Pixels {
  std::vector<double> values, latitude_deg, longitude_deg;
};

/// Part of the raster, in pixels.
struct Cut {
  int column = 0, row = 0, columns = 0, rows = 0;
};

std::unique_ptr<GDALDataset> open(const char* path) {
  GDALAllRegister();
  std::unique_ptr<GDALDataset> dataset{
      GDALDataset::Open(path, GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR)};
  if (!dataset) fail("the raster cannot be read");
  return dataset;
}

class ToGeodetic {
 public:
  explicit ToGeodetic(GDALDataset& dataset) {
    const OGRSpatialReference* from = dataset.GetSpatialRef();
    if (!from || from->IsEmpty()) {
      throw std::runtime_error(
          "the raster has no coordinate system, so it cannot be placed on the earth");
    }
    if (dataset.GetGeoTransform(transform_) != CE_None) {
      throw std::runtime_error(
          "the raster has no geotransform: where its pixels lie in its coordinate system is not "
          "known");
    }
    OGRSpatialReference own{*from}, wgs84;
    own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    conversion_.reset(OGRCreateCoordinateTransformation(&own, &wgs84));
    if (!conversion_) fail("the raster's coordinate system cannot be taken to WGS84");
  }

  /// Centres of the pixels of one row. Where there is no conversion: NaN.
  void row(const Cut& cut, int row, double* longitude_deg, double* latitude_deg) {
    for (int i = 0; i < cut.columns; ++i) {
      longitude_deg[i] = cut.column + i + 0.5;
      latitude_deg[i] = row + 0.5;
    }
    places(cut.columns, longitude_deg, latitude_deg);
  }

  /// Turns places in pixels (x: column, y: row) into longitude and latitude.
  void places(int count, double* x, double* y) {
    const auto size = static_cast<std::size_t>(count);
    good_.assign(size, 0);
    for (std::size_t i = 0; i < size; ++i) {
      const double column = x[i], row = y[i];
      x[i] = transform_[0] + column * transform_[1] + row * transform_[2];
      y[i] = transform_[3] + column * transform_[4] + row * transform_[5];
    }
    conversion_->Transform(count, x, y, nullptr, good_.data());
    for (std::size_t i = 0; i < size; ++i) {
      if (good_[i]) continue;
      x[i] = y[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }

 private:
  struct Destroy {
    void operator()(OGRCoordinateTransformation* t) const {
      OGRCoordinateTransformation::DestroyCT(t);
    }
  };
  double transform_[6] = {};
  std::unique_ptr<OGRCoordinateTransformation, Destroy> conversion_;
  std::vector<int> good_;
};

/// NaN where the file has no value; scale and offset applied.
std::vector<double> read_values(GDALRasterBand& band, const Cut& cut) {
  const auto count = static_cast<std::size_t>(cut.columns) * static_cast<std::size_t>(cut.rows);
  std::vector<double> values(count);
  if (band.RasterIO(GF_Read, cut.column, cut.row, cut.columns, cut.rows, values.data(), cut.columns,
                    cut.rows, GDT_Float64, 0, 0, nullptr) != CE_None) {
    fail("the raster's pixels cannot be read");
  }
  int has_no_data = 0;
  const double no_data = band.GetNoDataValue(&has_no_data);
  const double scale = band.GetScale(), offset = band.GetOffset();
  for (double& value : values) {
    const bool missing = (has_no_data && value == no_data) || !std::isfinite(value);
    value = missing ? std::numeric_limits<double>::quiet_NaN() : value * scale + offset;
  }
  return values;
}

bool is_inside(const NadirRasterWindow& w, double longitude_deg, double latitude_deg) {
  // Degrees east of the window's western side, whatever turn either is counted in.
  const auto east_of_west = [&](double lon) {
    const double turned = std::fmod(lon - w.west_deg, 360.0);
    return turned < 0.0 ? turned + 360.0 : turned;
  };
  double width = w.east_deg - w.west_deg;
  if (width < 0.0) width += 360.0;
  return latitude_deg >= w.south_deg && latitude_deg <= w.north_deg &&
         east_of_west(longitude_deg) <= width;
}

/// The smallest part that holds all pixels whose centres lie in the window, and one more all round.
Cut cut_to(const NadirRasterWindow& window, ToGeodetic& to_geodetic, const Cut& all) {
  std::vector<double> longitude(static_cast<std::size_t>(all.columns)), latitude(longitude.size());
  int left = all.columns, right = -1, top = all.rows, bottom = -1;
  for (int row = 0; row < all.rows; ++row) {
    to_geodetic.row(all, row, longitude.data(), latitude.data());
    for (int column = 0; column < all.columns; ++column) {
      const auto i = static_cast<std::size_t>(column);
      if (!is_inside(window, longitude[i], latitude[i])) continue;
      left = std::min(left, column);
      right = std::max(right, column);
      top = std::min(top, row);
      bottom = row;
    }
  }
  if (right < 0)
    throw std::runtime_error("the raster has no pixel in the bounds that are asked for");
  left = std::max(0, left - 1);
  top = std::max(0, top - 1);
  right = std::min(all.columns - 1, right + 1);
  bottom = std::min(all.rows - 1, bottom + 1);
  return {left, top, right - left + 1, bottom - top + 1};
}

double full_scale(GDALRasterBand& band) {
  if (band.GetRasterDataType() == GDT_Byte) return 255.0;
  return band.GetRasterDataType() == GDT_UInt16 ? 65535.0 : 0.0;
}

void read(const char* path, int band_number, bool geodetic, const NadirRasterWindow* window,
          NadirRaster& out) {
  const std::unique_ptr<GDALDataset> dataset = open(path);
  out.bands = dataset->GetRasterCount();
  if (band_number < 1 || band_number > out.bands) {
    throw std::runtime_error("the raster has " + std::to_string(out.bands) +
                             " bands, so there is no band " + std::to_string(band_number));
  }
  out.has_geotransform = dataset->GetGeoTransform(out.geotransform) == CE_None;
  const OGRSpatialReference* reference = dataset->GetSpatialRef();
  out.has_projection = reference && !reference->IsEmpty();

  auto pixels = std::make_unique<Pixels>();
  Cut cut{0, 0, dataset->GetRasterXSize(), dataset->GetRasterYSize()};
  std::unique_ptr<ToGeodetic> to_geodetic;
  if (geodetic) {
    to_geodetic = std::make_unique<ToGeodetic>(*dataset);
    if (window) cut = cut_to(*window, *to_geodetic, cut);
    out.geotransform[0] += cut.column * out.geotransform[1] + cut.row * out.geotransform[2];
    out.geotransform[3] += cut.column * out.geotransform[4] + cut.row * out.geotransform[5];
  }
  pixels->values = read_values(*dataset->GetRasterBand(band_number), cut);
  out.full_scale = full_scale(*dataset->GetRasterBand(band_number));
  if (to_geodetic) {
    pixels->latitude_deg.resize(pixels->values.size());
    pixels->longitude_deg.resize(pixels->values.size());
    for (int row = 0; row < cut.rows; ++row) {
      const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(cut.columns);
      to_geodetic->row(cut, cut.row + row, &pixels->longitude_deg[first],
                       &pixels->latitude_deg[first]);
    }
    out.latitude_deg = pixels->latitude_deg.data();
    out.longitude_deg = pixels->longitude_deg.data();
  }
  out.columns = cut.columns;
  out.rows = cut.rows;
  out.values = pixels->values.data();
  out.owner = pixels.release();
}

int read_entry(const char* path, int band, int geodetic, const NadirRasterWindow* window,
               NadirRaster* out, char* message, std::size_t message_size) {
  *out = NadirRaster{};
  const int result =
      told([&] { read(path, band, geodetic != 0, window, *out); }, message, message_size);
  if (result != 0) *out = NadirRaster{};
  return result;
}

int locate_entry(const char* path, int count, double* column, double* row, char* message,
                 std::size_t message_size) {
  return told([&] { ToGeodetic{*open(path)}.places(count, column, row); }, message, message_size);
}

void release_entry(NadirRaster* raster) {
  delete static_cast<Pixels*>(raster->owner);
  *raster = NadirRaster{};
}

int project_entry(const char* coordinates, int count, double* x, double* y, char* message,
                  std::size_t message_size) {
  return told([&] { nadir_rasters::project(coordinates, count, x, y); }, message, message_size);
}

int geotiff_entry(const NadirGeoTiff* wanted, char* message, std::size_t message_size) {
  return told([&] { nadir_rasters::write_geotiff(*wanted); }, message, message_size);
}

int netcdf_entry(const NadirNetCdf* wanted, char* message, std::size_t message_size) {
  return told([&] { nadir_rasters::write_netcdf(*wanted); }, message, message_size);
}

constexpr NadirRasterModule table{nadir_raster_module_version,
                                  read_entry,
                                  release_entry,
                                  locate_entry,
                                  project_entry,
                                  geotiff_entry,
                                  netcdf_entry};

}  // namespace

extern "C" __attribute__((visibility("default"))) const NadirRasterModule* nadir_raster_module(
    void) {
  return &table;
}
