#include "gdal_calls.hpp"

#include <cpl_error.h>
#include <gdal.h>

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

BlockCache::BlockCache() : before_{GDALGetCacheMax64()} { GDALSetCacheMax64(256LL << 20); }
BlockCache::~BlockCache() { GDALSetCacheMax64(before_); }

}  // namespace nadir_rasters
