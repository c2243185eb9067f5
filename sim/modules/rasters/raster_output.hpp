#pragma once
// What the program hands to the module `nadir_rasters` to be written. Plain C types only; all
// pointers belong to the caller and are read before the call returns.

extern "C" {

struct NadirText {
  const char* key;
  const char* value;
};
struct NadirTexts {
  const NadirText* items;
  int count;
};

/// A place of the image, in pixels ((0.5, 0.5) is the centre of the first), and of the earth.
struct NadirGroundControl {
  double sample, line;
  double longitude_deg, latitude_deg, height_m;  ///< WGS84
};

struct NadirGeoTiffBand {
  const char* description;
  const char* unit;
  double scale, offset;  ///< value = scale stored + offset; 1 and 0: not written
  NadirTexts items;      ///< metadata
};

/// A cloud-optimised GeoTIFF made from another raster file, in bounded memory.
struct NadirGeoTiff {
  const char* source;
  const char* target;
  const char* coordinates;  ///< of the geotransform, in any form GDAL reads; null: none
  double geotransform[6];   ///< pixel corner to those coordinates, GDAL's order
  const NadirGroundControl* control;
  int controls;                   ///< excludes a geotransform
  NadirTexts rpc;                 ///< GDAL's names of rational polynomial coefficients, or none
  NadirTexts items;               ///< metadata
  const NadirGeoTiffBand* bands;  ///< as many as the source has
  int band_count;
  int nan_is_no_data;
};

/// An attribute of a NetCDF variable: a text, or a number where `text` is null.
struct NadirAttribute {
  const char* key;
  const char* text;
  double number;
  int is_integer;
};

struct NadirDimension {
  const char* name;
  int size;
};

enum { nadir_float32 = 0, nadir_float64 = 1, nadir_int32 = 2, nadir_text = 3 };

/// A variable: its values as they are, or from planes of a raster file.
struct NadirVariable {
  const char* name;
  int dimensions[3];  ///< indices into the file's, slowest first
  int dimension_count;
  int type;
  const double* values;      ///< all of them; null: from `texts` or `source`
  const char* const* texts;  ///< of type nadir_text
  const char* source;        ///< its last two dimensions are the file's rows and columns
  int first_plane;           ///< of the source, from 1; one for each index of a third dimension
  int nan_is_fill;
  const NadirAttribute* attributes;
  int attribute_count;
};

/// A NetCDF file (version 4, deflated), written by blocks of lines.
struct NadirNetCdf {
  const char* target;
  const NadirDimension* dimensions;
  int dimension_count;
  const NadirVariable* variables;
  int variable_count;
  const NadirAttribute* attributes;
  int attribute_count;
};
}
