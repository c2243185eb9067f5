#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

// What the readers of meshes and lists share: whole files, tokens with a place, strict numbers.

namespace nadir::sim {

/// A word of a file, and where it stands.
struct Token {
  std::string_view text;
  std::string_view line_text;  ///< the whole line, without its end
  int line = 0;
};

/// The bytes of a file. @throws InputError if it cannot be read
[[nodiscard]] std::string read_bytes(const std::filesystem::path& file);

/// Takes the first line off `rest`, without its end (LF, CR LF or CR).
[[nodiscard]] std::string_view take_line(std::string_view& rest);

[[nodiscard]] std::string_view without_blanks(std::string_view text);

/// The text's beginning in quotation marks, for messages: a line of another kind of file has no
/// end.
[[nodiscard]] std::string start_in_quotes(std::string_view text);

/// The whole of `text` as a finite number: no blank, no plus sign, nothing behind it.
template <class Number>
[[nodiscard]] std::optional<Number> strict_number_in(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if constexpr (std::is_floating_point_v<Number>) {
    if (!std::isfinite(value)) return std::nullopt;
  }
  return value;
}

/// Gathers the mistakes of one file. The first 20 are kept, the others counted: a file of another
/// kind has one on every line.
class FileIssues {
 public:
  explicit FileIssues(std::string file) : file_{std::move(file)} {}
  void add(const Token& at, std::string message, std::string hint = {});
  void add(std::string message);
  [[nodiscard]] bool empty() const { return issues_.empty(); }
  void throw_if_any() const;

 private:
  void keep(InputIssue issue);

  std::string file_;
  std::vector<InputIssue> issues_;
  std::size_t left_out_ = 0;
};

}  // namespace nadir::sim
