#include <cpl_string.h>
#include <gdal_priv.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "gdal_calls.hpp"
#include "writers.hpp"

namespace nadir_rasters {
namespace {

using Array = std::shared_ptr<GDALMDArray>;
using Dimensions = std::vector<std::shared_ptr<GDALDimension>>;

// Read and written at a time: a megabyte or so for the usual swath.
constexpr int lines_per_block = 64;

GDALExtendedDataType type_of(int type) {
  if (type == nadir_text) return GDALExtendedDataType::CreateString();
  if (type == nadir_int32) return GDALExtendedDataType::Create(GDT_Int32);
  return GDALExtendedDataType::Create(type == nadir_float32 ? GDT_Float32 : GDT_Float64);
}

/// @param holder  a group or an array
template <class Holder>
void set_attribute(Holder& holder, const NadirAttribute& wanted) {
  bool done = false;
  if (wanted.text != nullptr) {
    const auto attribute =
        holder.CreateAttribute(wanted.key, {}, GDALExtendedDataType::CreateString());
    done = attribute && attribute->Write(wanted.text);
  } else if (wanted.is_integer != 0) {
    const auto attribute = holder.CreateAttribute(wanted.key, {}, type_of(nadir_int32));
    done = attribute && attribute->Write(static_cast<int>(wanted.number));
  } else {
    const auto attribute = holder.CreateAttribute(wanted.key, {}, type_of(nadir_float64));
    done = attribute && attribute->Write(wanted.number);
  }
  if (!done) fail(std::string{"the attribute "} + wanted.key + " cannot be written");
}

/// Chunks of a block of lines, a plane at a time; deflated.
CPLStringList storage_of(const NadirVariable& wanted, const Dimensions& dimensions) {
  CPLStringList options;
  if (wanted.source == nullptr) return options;
  std::string chunk;
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    const auto size = static_cast<int>(dimensions[i]->GetSize());
    const std::size_t from_end = dimensions.size() - i;
    const int length = from_end == 1 ? std::min(size, 1024)
                                     : (from_end == 2 ? std::min(size, lines_per_block) : 1);
    chunk += (i == 0 ? "" : ",") + std::to_string(length);
  }
  options.SetNameValue("BLOCKSIZE", chunk.c_str());
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("ZLEVEL", "4");
  return options;
}

Array created(GDALGroup& root, const NadirVariable& wanted, const Dimensions& all) {
  Dimensions dimensions;
  for (int i = 0; i < wanted.dimension_count; ++i) {
    dimensions.push_back(all[static_cast<std::size_t>(wanted.dimensions[i])]);
  }
  const CPLStringList options = storage_of(wanted, dimensions);
  Array made = root.CreateMDArray(wanted.name, dimensions, type_of(wanted.type), options.List());
  if (!made) fail(std::string{"the variable "} + wanted.name + " cannot be made");
  if (wanted.nan_is_fill != 0) made->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  for (int i = 0; i < wanted.attribute_count; ++i) set_attribute(*made, wanted.attributes[i]);
  return made;
}

void write_values(GDALMDArray& array, const NadirVariable& wanted) {
  std::vector<GUInt64> start;
  std::vector<std::size_t> count;
  for (const auto& dimension : array.GetDimensions()) {
    start.push_back(0);
    count.push_back(static_cast<std::size_t>(dimension->GetSize()));
  }
  const bool texts = wanted.texts != nullptr;
  const void* from =
      texts ? static_cast<const void*>(wanted.texts) : static_cast<const void*>(wanted.values);
  const auto type = type_of(texts ? nadir_text : nadir_float64);
  if (!array.Write(start.data(), count.data(), nullptr, nullptr, type, from)) {
    fail(std::string{"the variable "} + wanted.name + " cannot be written");
  }
}

/// A block of lines of one plane, on its way from a raster into an array.
class PlaneCopy {
 public:
  PlaneCopy(GDALMDArray& array, GDALDataset& source, const NadirVariable& wanted)
      : array_{&array},
        source_{&source},
        wanted_{&wanted},
        columns_{source.GetRasterXSize()},
        rows_{source.GetRasterYSize()},
        number_{wanted.type == nadir_float32 ? GDT_Float32 : GDT_Float64},
        values_(static_cast<std::size_t>(columns_) * lines_per_block *
                static_cast<std::size_t>(GDALGetDataTypeSizeBytes(number_))) {}

  void copy(int plane) {
    GDALRasterBand* band = source_->GetRasterBand(wanted_->first_plane + plane);
    if (band == nullptr) fail(std::string{"too few planes for the variable "} + wanted_->name);
    for (int row = 0; row < rows_; row += lines_per_block) {
      copy(*band, plane, row, std::min(lines_per_block, rows_ - row));
    }
  }

 private:
  void copy(GDALRasterBand& band, int plane, int row, int rows) {
    if (band.RasterIO(GF_Read, 0, row, columns_, rows, values_.data(), columns_, rows, number_, 0,
                      0, nullptr) != CE_None) {
      fail("the image's pixels cannot be read");
    }
    std::vector<GUInt64> start{static_cast<GUInt64>(row), 0};
    std::vector<std::size_t> count{static_cast<std::size_t>(rows),
                                   static_cast<std::size_t>(columns_)};
    if (wanted_->dimension_count == 3) {
      start.insert(start.begin(), static_cast<GUInt64>(plane));
      count.insert(count.begin(), 1);
    }
    if (!array_->Write(start.data(), count.data(), nullptr, nullptr,
                       GDALExtendedDataType::Create(number_), values_.data())) {
      fail(std::string{"the variable "} + wanted_->name + " cannot be written");
    }
  }

  GDALMDArray* array_;
  GDALDataset* source_;
  const NadirVariable* wanted_;
  int columns_, rows_;
  GDALDataType number_;  // the variable's own: GDAL converts value by value, a hundred times slower
  std::vector<unsigned char> values_;
};

void write_planes(GDALMDArray& array, const NadirVariable& wanted) {
  const std::unique_ptr<GDALDataset> source{
      GDALDataset::Open(wanted.source, GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR)};
  if (!source) fail("the image cannot be read");
  const auto& dimensions = array.GetDimensions();
  const auto planes = wanted.dimension_count == 3 ? static_cast<int>(dimensions[0]->GetSize()) : 1;
  if (static_cast<int>(dimensions.back()->GetSize()) != source->GetRasterXSize() ||
      static_cast<int>(dimensions[dimensions.size() - 2]->GetSize()) != source->GetRasterYSize()) {
    fail(std::string{"the image of the variable "} + wanted.name + " has another size");
  }
  PlaneCopy copy{array, *source, wanted};
  for (int plane = 0; plane < planes; ++plane) copy.copy(plane);
}

}  // namespace

void write_netcdf(const NadirNetCdf& wanted) {
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("netCDF");
  const BlockCache cache;
  if (driver == nullptr) fail("this GDAL has no driver netCDF");
  const std::unique_ptr<GDALDataset> file{
      driver->CreateMultiDimensional(wanted.target, nullptr, nullptr)};
  const auto root = file ? file->GetRootGroup() : nullptr;
  if (!root) fail("the NetCDF file cannot be made");
  for (int i = 0; i < wanted.attribute_count; ++i) set_attribute(*root, wanted.attributes[i]);
  Dimensions dimensions;
  for (int i = 0; i < wanted.dimension_count; ++i) {
    const NadirDimension& from = wanted.dimensions[i];
    dimensions.push_back(
        root->CreateDimension(from.name, "", "", static_cast<GUInt64>(from.size), nullptr));
    if (!dimensions.back()) fail(std::string{"the dimension "} + from.name + " cannot be made");
  }
  // All variables before any values: the file's definitions come first.
  std::vector<Array> arrays;
  for (int i = 0; i < wanted.variable_count; ++i) {
    arrays.push_back(created(*root, wanted.variables[i], dimensions));
  }
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const NadirVariable& from = wanted.variables[i];
    if (from.source != nullptr) {
      write_planes(*arrays[i], from);
    } else {
      write_values(*arrays[i], from);
    }
  }
}

}  // namespace nadir_rasters
