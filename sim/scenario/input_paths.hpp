#pragma once

#include <filesystem>

namespace nadir::sim {

/// Turns the paths of a file into absolute ones: `library:x` lies in the shipped library, anything
/// else beside the file that names it.
class InputPaths {
 public:
  /// @param named_in  the scenario or library that holds the paths
  explicit InputPaths(const std::filesystem::path& named_in);

  /// @throws InputError for `library:` where the shipped data cannot be found
  [[nodiscard]] std::filesystem::path absolute(const std::filesystem::path& written) const;
  /// The same for what may lie in the shipped data by its own name as well: there, if it is not
  /// beside the file that names it.
  [[nodiscard]] std::filesystem::path absolute_or_shipped(
      const std::filesystem::path& written) const;

 private:
  std::filesystem::path folder_;
};

/// The name in the same folder that is most like the missing file's, or empty.
[[nodiscard]] std::string nearest_file(const std::filesystem::path& missing);

}  // namespace nadir::sim
