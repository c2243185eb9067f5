#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace nadir::sim {

/// The text of a file that turns byte offsets into lines and columns. A byte order mark is left
/// out.
class SourceText {
 public:
  SourceText(std::string file, std::string text);

  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  [[nodiscard]] std::string_view text() const noexcept { return text_; }
  /// Line and column count from 1; columns count bytes, as compilers do.
  [[nodiscard]] SourceLocation locate(std::size_t offset) const;
  [[nodiscard]] std::string line(int number) const;
  [[nodiscard]] InputIssue issue(std::size_t offset, std::string message,
                                 std::string hint = {}) const;

 private:
  std::string file_;
  std::string text_;
  std::vector<std::size_t> line_starts_;
};

/// @throws InputError for a file that does not exist, cannot be read or is larger than 64 MB
[[nodiscard]] SourceText read_source_text(const std::filesystem::path& file);

}  // namespace nadir::sim
