#pragma once

#include <span>
#include <string_view>

// What is fed with arbitrary bytes. Each reader must either read them or say what is wrong by an
// InputError: anything else that it throws, a crash or a sanitizer's report is a bug.

namespace nadir::fuzz {

struct Target {
  std::string_view name;  ///< also of its corpus
  void (*feed)(std::string_view bytes);
};

[[nodiscard]] std::span<const Target> targets();
/// Null where there is none of that name.
[[nodiscard]] const Target* find_target(std::string_view name);

}  // namespace nadir::fuzz
