#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace nadir::sim {

/// A column of a table for people.
struct TextColumn {
  std::string head;
  bool to_the_right = false;   ///< numbers
  std::size_t most_width = 0;  ///< wider text goes on in the next line; 0: as wide as it is
};

/// Lines of a table whose columns are as wide as they need to be, two spaces between them. What is
/// wider than its column's limit is broken at spaces.
/// @param rows   of as many cells as there are columns
/// @param width  of the whole; the last column takes what is left, at least 20
[[nodiscard]] std::string text_table(const std::vector<TextColumn>& columns,
                                     const std::vector<std::vector<std::string>>& rows,
                                     std::size_t width);

/// Text broken at spaces into lines no wider than `width`, but for words that are. At least one.
[[nodiscard]] std::vector<std::string> broken_at_spaces(const std::string& text, std::size_t width);

}  // namespace nadir::sim
