#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "core/error.hpp"

// What a scenario or a sensor file says of a camera.

namespace nadir::sim {

struct BoxBand {
  double lo_um = 0.0, hi_um = 0.0;
};
struct GaussianBand {
  double centre_um = 0.0, fwhm_um = 0.0;
};
struct TabulatedBand {
  std::filesystem::path file;
  std::string column;
};
struct BandInput {
  std::string name;
  std::variant<BoxBand, GaussianBand, TabulatedBand> response;
};

struct ArrayInput {
  std::string name;
  int samples = 0, lines = 0;  ///< columns and rows of the detector
  double pitch_um = 0.0;       ///< perspective: centre to centre on the focal plane
  double offset_x_um = 0.0, offset_y_um = 0.0;  ///< of the array's centre on the focal plane
  double ground_pitch_m = 0.0;                  ///< orthographic: centre to centre across the beam
  double offset_x_m = 0.0, offset_y_m = 0.0;    ///< orthographic: of the array's centre
  std::vector<BandInput> bands;
};

struct CameraInput {
  bool orthographic = false;
  double focal_length_mm = 0.0;  ///< perspective only
  std::vector<ArrayInput> arrays;
};

}  // namespace nadir::sim
