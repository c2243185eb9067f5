#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/air_runs.hpp"
#include "sim/files/uvspec_output.hpp"

// What an input file of uvspec says about its output.

namespace nadir::sim {

enum class UvspecUnit { per_nm, per_cm };

struct UvspecInput {
  bool thermal = false;
  bool black_ground = true;  ///< albedo 0
  bool cold_ground = false;  ///< thermal: so cold that it emits nothing
  double sun_zenith_deg = 0.0, sun_phi_deg = 0.0;
  std::vector<double> umu, phi_deg;
  std::vector<double> level_m;       ///< above sea level, as in `zout`
  std::vector<std::string> columns;  ///< of `output_user`, or empty
  UvspecUnit unit = UvspecUnit::per_nm;
  double band_cm = 1.0;  ///< thermal: cm^-1 that the output is summed over
};

/// @throws InputError with file and line
[[nodiscard]] UvspecInput parse_uvspec_input(const NamedText& input, double top_m);

}  // namespace nadir::sim
