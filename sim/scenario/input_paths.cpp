#include "sim/scenario/input_paths.hpp"

#include <string>
#include <vector>

#include "core/error.hpp"
#include "sim/files/data_directory.hpp"

namespace nadir::sim {

namespace fs = std::filesystem;

InputPaths::InputPaths(const fs::path& named_in) : folder_{fs::absolute(named_in).parent_path()} {}

fs::path InputPaths::absolute(const fs::path& written) const {
  const std::string text = written.string();
  const std::string prefix = "library:";
  if (!text.starts_with(prefix)) return (folder_ / written).lexically_normal();
  return (data_directory() / "library" / text.substr(prefix.size())).lexically_normal();
}

fs::path InputPaths::absolute_or_shipped(const fs::path& written) const {
  const fs::path beside = absolute(written);
  std::error_code error;
  if (fs::exists(beside, error)) return beside;
  const fs::path shipped = (data_directory() / written).lexically_normal();
  // Where neither folder is there, the user's own is the one to speak of.
  const bool is_near = fs::exists(shipped, error) || (fs::exists(shipped.parent_path(), error) &&
                                                      !fs::exists(beside.parent_path(), error));
  return is_near ? shipped : beside;
}

std::string nearest_file(const fs::path& missing) {
  std::vector<std::string> names;
  std::error_code error;
  constexpr std::size_t most = 1000;  // a look around, not a search
  for (fs::directory_iterator entry{missing.parent_path(), error}, end;
       !error && entry != end && names.size() < most; entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  return nearest_name(missing.filename().string(), names);
}

}  // namespace nadir::sim
