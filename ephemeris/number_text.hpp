#pragma once

#include <array>
#include <charconv>
#include <string>

namespace nadir::ephemeris {

/// A number for a message: the shortest decimals that read back as the same double.
[[nodiscard]] inline std::string number_text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

}  // namespace nadir::ephemeris
