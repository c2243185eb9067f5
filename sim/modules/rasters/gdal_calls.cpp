#include "gdal_calls.hpp"

#include <cpl_error.h>

namespace nadir_rasters {

void fail(const std::string& what) {
  const std::string words = CPLGetLastErrorMsg();
  throw std::runtime_error(words.empty() ? what : what + ": " + words);
}

QuietErrors::QuietErrors() {
  CPLPushErrorHandler(CPLQuietErrorHandler);
  CPLErrorReset();
}

QuietErrors::~QuietErrors() { CPLPopErrorHandler(); }

}  // namespace nadir_rasters
