#include "sim/files/data_directory.hpp"

#include <cstdlib>
#include <string>

#include "core/error.hpp"

namespace nadir::sim {

namespace fs = std::filesystem;

fs::path data_directory() {
  std::error_code error;
  if (const char* named = std::getenv("NADIR_DATA"); named != nullptr && *named != '\0') {
    if (fs::is_directory(named, error)) return fs::absolute(named).lexically_normal();
    throw InputError{"the environment's NADIR_DATA is \"" + std::string{named} +
                     "\", which is not a folder"};
  }
  // /proc/self/exe rather than argv[0]: the latter may be a bare name found on the search path.
  const fs::path command = fs::read_symlink("/proc/self/exe", error);
  fs::path installed =
      (command.parent_path() / ".." / NADIR_INSTALL_DATADIR / "nadir").lexically_normal();
  if (!command.empty() && fs::is_directory(installed / "library", error)) return installed;
  fs::path source = NADIR_SOURCE_DATA_DIR;
  if (fs::is_directory(source, error)) return source;
  throw InputError{"Nadir's data is neither in " + installed.string() + " nor in " +
                   source.string() + "; name its folder in the environment's NADIR_DATA"};
}

}  // namespace nadir::sim
