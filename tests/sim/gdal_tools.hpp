#pragma once

#include <cstdlib>
#include <string>

#include "sim/scratch_folder.hpp"

// GDAL's own programs, to read what was written: of the package gdal-bin, which not every machine
// has.

namespace nadir::sim::support {

inline bool has_gdal_tools() {
  static const bool there = std::system("gdalinfo --version >/dev/null 2>&1") == 0;
  return there;
}

struct ToolResult {
  int status = -1;
  std::string out, err;
};

/// @param input  given to it; may be empty
inline ToolResult run_tool(const std::string& line, const std::string& input = {}) {
  const ScratchFolder scratch;
  std::ofstream{scratch / "in"} << input;
  const int status = std::system((line + " <" + (scratch / "in").string() + " >" +
                                  (scratch / "out").string() + " 2>" + (scratch / "err").string())
                                     .c_str());
  return {status, content_of(scratch / "out"), content_of(scratch / "err")};
}

}  // namespace nadir::sim::support
