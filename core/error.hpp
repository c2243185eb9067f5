#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace nadir {

/// Where in the user's files something stands. Line and column (in bytes) count from 1; 0 means
/// unknown.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

/// One mistake in the input, as a compiler would report it.
struct InputIssue {
  SourceLocation where;
  std::string message;      ///< what was expected and what was found
  std::string hint;         ///< the nearest valid name, or empty
  std::string source_line;  ///< the line of text that `where` points at, or empty
};

/// `file:line:column: error: message`, the source line with a caret, the hint; a newline after
/// each.
[[nodiscard]] std::string format_issue(const InputIssue& issue);

/// The only exception for bad input. Carries every mistake that its reader found.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<InputIssue> issues);
  explicit InputError(InputIssue issue);
  /// A mistake without a location; a reader that knows the location adds it with `located`.
  explicit InputError(std::string message);

  [[nodiscard]] const std::vector<InputIssue>& issues() const noexcept { return issues_; }
  /// The same mistakes; those that had no location yet get `where` and its `source_line`.
  [[nodiscard]] InputError located(const SourceLocation& where,
                                   const std::string& source_line) const;

 private:
  std::vector<InputIssue> issues_;
};

/// The candidate nearest to `name` by edit distance, or empty when none is near enough to be
/// what the user meant (distance at most a third of the name's length or 1, whichever is more, and
/// less than its length). Upper and lower case count as equal; of equals the first wins.
[[nodiscard]] std::string nearest_name(const std::string& name,
                                       const std::vector<std::string>& candidates);

}  // namespace nadir
