#pragma once

#include <filesystem>
#include <set>

namespace nadir::sim {

/// Remembers every file that a run has read, for the report.
class InputFiles {
 public:
  /// Notes the file and hands it on.
  const std::filesystem::path& note(const std::filesystem::path& file) {
    return *files_.insert(file).first;
  }
  [[nodiscard]] const std::set<std::filesystem::path>& all() const noexcept { return files_; }

 private:
  std::set<std::filesystem::path> files_;
};

}  // namespace nadir::sim
