#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "gdal_calls.hpp"
#include "writers.hpp"

namespace nadir_rasters {
namespace {

using Dataset = std::unique_ptr<GDALDataset>;

GDALDriver& driver(const char* name) {
  GDALAllRegister();
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName(name);
  if (found == nullptr) fail(std::string{"this GDAL has no driver "} + name);
  return *found;
}

OGRSpatialReference reference_of(const char* coordinates) {
  OGRSpatialReference reference;
  if (reference.SetFromUserInput(coordinates) != OGRERR_NONE) {
    fail(std::string{"unknown coordinate system "} + coordinates);
  }
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

template <class Holder>
void set_metadata(Holder& holder, const NadirTexts& texts) {
  for (int i = 0; i < texts.count; ++i) {
    holder.SetMetadataItem(texts.items[i].key, texts.items[i].value);
  }
}

/// A band of the source by reference: nothing is read before the copy.
void refer(GDALRasterBand& band, const char* source, int number) {
  char* name = CPLEscapeString(source, -1, CPLES_XML);
  const std::string xml = "<SimpleSource><SourceFilename relativeToVRT=\"0\">" + std::string{name} +
                          "</SourceFilename><SourceBand>" + std::to_string(number) +
                          "</SourceBand></SimpleSource>";
  CPLFree(name);
  if (band.SetMetadataItem("source_0", xml.c_str(), "new_vrt_sources") != CE_None) {
    fail("the image cannot be referred to");
  }
}

void describe(GDALRasterBand& band, const NadirGeoTiffBand& wanted, bool nan_is_no_data) {
  band.SetDescription(wanted.description);
  if (wanted.unit != nullptr) band.SetUnitType(wanted.unit);
  if (wanted.scale != 1.0 || wanted.offset != 0.0) {
    band.SetScale(wanted.scale);
    band.SetOffset(wanted.offset);
  }
  if (nan_is_no_data) band.SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  set_metadata(band, wanted.items);
}

void set_control(GDALDataset& dataset, const NadirGeoTiff& wanted) {
  std::vector<GDAL_GCP> points(static_cast<std::size_t>(wanted.controls));
  GDALInitGCPs(wanted.controls, points.data());
  for (int i = 0; i < wanted.controls; ++i) {
    GDAL_GCP& point = points[static_cast<std::size_t>(i)];
    const NadirGroundControl& from = wanted.control[i];
    point.dfGCPPixel = from.sample;
    point.dfGCPLine = from.line;
    point.dfGCPX = from.longitude_deg;
    point.dfGCPY = from.latitude_deg;
    point.dfGCPZ = from.height_m;
  }
  const OGRSpatialReference wgs84 = reference_of("EPSG:4326");
  const CPLErr done = dataset.SetGCPs(wanted.controls, points.data(), &wgs84);
  GDALDeinitGCPs(wanted.controls, points.data());
  if (done != CE_None) fail("ground control points cannot be set");
}

void place(GDALDataset& dataset, const NadirGeoTiff& wanted) {
  if (wanted.coordinates != nullptr) {
    const OGRSpatialReference reference = reference_of(wanted.coordinates);
    double transform[6];
    for (int i = 0; i < 6; ++i) transform[i] = wanted.geotransform[i];
    if (dataset.SetSpatialRef(&reference) != CE_None ||
        dataset.SetGeoTransform(transform) != CE_None) {
      fail("the geotransform cannot be set");
    }
  } else if (wanted.controls > 0) {
    set_control(dataset, wanted);
  }
  CPLStringList rpc;
  for (int i = 0; i < wanted.rpc.count; ++i) {
    rpc.SetNameValue(wanted.rpc.items[i].key, wanted.rpc.items[i].value);
  }
  if (rpc.Count() > 0) dataset.SetMetadata(rpc.List(), "RPC");
}

Dataset described(const NadirGeoTiff& wanted) {
  const Dataset source{GDALDataset::Open(wanted.source, GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR)};
  if (!source) fail("the image cannot be read");
  if (source->GetRasterCount() != wanted.band_count) fail("the image has other bands");
  Dataset made{driver("VRT").Create("", source->GetRasterXSize(), source->GetRasterYSize(), 0,
                                    GDT_Float32, nullptr)};
  if (!made) fail("the image cannot be described");
  for (int i = 0; i < wanted.band_count; ++i) {
    if (made->AddBand(source->GetRasterBand(i + 1)->GetRasterDataType(), nullptr) != CE_None) {
      fail("a band cannot be added");
    }
    GDALRasterBand& band = *made->GetRasterBand(i + 1);
    refer(band, wanted.source, i + 1);
    describe(band, wanted.bands[i], wanted.nan_is_no_data != 0);
  }
  set_metadata(*made, wanted.items);
  place(*made, wanted);
  return made;
}

}  // namespace

void write_geotiff(const NadirGeoTiff& wanted) {
  GDALDriver& cog = driver("COG");
  const BlockCache cache;
  const Dataset made = described(wanted);
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "YES");  // of differences, by type of number
  options.SetNameValue("OVERVIEW_RESAMPLING", "AVERAGE");
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  const Dataset written{
      cog.CreateCopy(wanted.target, made.get(), FALSE, options.List(), nullptr, nullptr)};
  if (!written) fail("the GeoTIFF cannot be written");
}

void project(const char* coordinates, int count, double* x, double* y) {
  const OGRSpatialReference to = reference_of(coordinates), wgs84 = reference_of("EPSG:4326");
  const std::unique_ptr<OGRCoordinateTransformation> conversion{
      OGRCreateCoordinateTransformation(&wgs84, &to)};
  if (!conversion) fail("no conversion from WGS84 to the coordinate system");
  std::vector<int> good(static_cast<std::size_t>(count), 0);
  conversion->Transform(count, x, y, nullptr, good.data());
  for (int i = 0; i < count; ++i) {
    if (!good[static_cast<std::size_t>(i)]) x[i] = y[i] = std::nan("");
  }
}

}  // namespace nadir_rasters
