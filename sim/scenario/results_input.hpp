#pragma once

#include <string>
#include <vector>

#include "sim/scenario/band_nodes.hpp"

// How much work a picture gets, and which files are written.

namespace nadir::sim {

struct SamplingInput {
  int replicates = 4;             ///< independent scramblings that yield the standard error, >= 4
  int samples_per_replicate = 2;  ///< paths per pixel and replicate
  BandNodes wavelengths_per_band = 4;  ///< nodes of each band's Gauss quadrature
};

struct ProductsInput {
  bool envi = true, exr = true, quick_look = true, truth = true;
  bool truth_temperature = false;  ///< solve heat for the truth plane even if no band sees it
  std::vector<std::string>
      quick_look_bands;      ///< red, green, blue, or one; empty: chosen for the user
  bool geotiff = false;      ///< cloud-optimised GeoTIFF of radiance, and of DN where there are
  bool netcdf = false;       ///< CF swath
  bool sidecars = true;      ///< STAC item, CSM image support data
  bool electrons = false;    ///< noise-free electrons, where there is a detector
  bool statistics = false;   ///< paths a pixel, share of each effect
  bool sky_view = false;     ///< the truth plane that costs a ray a path
  bool fractions = false;    ///< share of every material in every pixel
  bool keep_samples = true;  ///< the journal of tiles outlives the run: to be extended and merged
};

}  // namespace nadir::sim
