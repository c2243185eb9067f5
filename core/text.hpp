#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace nadir {

/// The shortest text that reads back as the same double: 0.1 gives "0.1". For error messages.
[[nodiscard]] inline std::string number_text(double value) {
  std::array<char, 32> buffer;  // the longest double, -2.2250738585072014e-308, takes 24
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

[[nodiscard]] inline std::string in_quotes(std::string_view text) {
  std::string quoted{'"'};  // by appending: g++ 12 warns wrongly (PR 105329) about "\"" + string
  quoted.append(text);
  quoted += '"';
  return quoted;
}

}  // namespace nadir
