#pragma once

#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>

// How the module's entries call GDAL: errors become text.

namespace nadir_rasters {

/// GDAL's words for the last failure, after our own.
[[noreturn]] void fail(const std::string& what);

/// GDAL prints its errors unless told not to; here they travel as text.
class QuietErrors {
 public:
  QuietErrors();
  ~QuietErrors();
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;
};

/// While images are written GDAL may keep 256 MB of blocks: its own choice, a twentieth of the
/// machine's memory, would make what a run needs depend on the machine. 512 lines of 25,000 pixels
/// and five bands of floats fit, so that no line is read twice.
class BlockCache {
 public:
  BlockCache();
  ~BlockCache();
  BlockCache(const BlockCache&) = delete;
  BlockCache& operator=(const BlockCache&) = delete;

 private:
  long long before_;
};

/// Runs the work of an entry; what it throws travels as text.
template <class Work>
int told(const Work& work, char* message, std::size_t message_size) {
  try {
    const QuietErrors quiet;
    work();
    return 0;
  } catch (const std::exception& error) {
    std::snprintf(message, message_size, "%s", error.what());
  } catch (...) {
    std::snprintf(message, message_size, "unknown failure in the raster module");
  }
  return 1;
}

}  // namespace nadir_rasters
