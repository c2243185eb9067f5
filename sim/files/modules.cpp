#include "sim/files/modules.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <map>
#include <mutex>
#include <stdexcept>

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;

std::string library_name(const std::string& module) { return "lib" + module + ".so"; }

std::string last_words() {
  const char* words = dlerror();
  return words ? words : "no reason given";
}

void* open_module(const std::string& module) {
  const fs::path path = module_directory(module) / library_name(module);
  // RTLD_LOCAL: GDAL's and OpenImageIO's crowd of symbols stay out of each other's way.
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error{"cannot load the module: " + last_words()};
  return handle;
}

void* loaded(const std::string& module) {
  static std::mutex mutex;
  static std::map<std::string, void*> handles;
  const std::scoped_lock lock{mutex};
  void*& handle = handles[module];
  if (!handle) handle = open_module(module);
  return handle;
}

}  // namespace

std::vector<fs::path> module_directories() {
  if (const char* given = std::getenv("NADIR_MODULES"); given && *given) return {given};
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  return {folder, folder.parent_path() / NADIR_INSTALL_LIBDIR / "nadir", folder.parent_path()};
}

fs::path module_directory(const std::string& module) {
  std::string places;
  for (const fs::path& folder : module_directories()) {
    std::error_code ignored;
    if (fs::exists(folder / library_name(module), ignored)) return folder;
    places += "\n  " + folder.string();
  }
  throw std::runtime_error{"the module " + library_name(module) + " is in none of these folders:" +
                           places + "\n(the environment variable NADIR_MODULES names another)"};
}

void* module_symbol(const std::string& module, const std::string& symbol) {
  void* handle = loaded(module);
  dlerror();
  void* address = dlsym(handle, symbol.c_str());
  if (!address) throw std::runtime_error{"the module does not fit this program: " + last_words()};
  return address;
}

}  // namespace nadir::sim
