#pragma once

#include <optional>
#include <string_view>

namespace nadir::sim {

/// The text without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The whole of `text` as a decimal number: sign, digits with at most one point, exponent. Nothing
/// for anything else: no hexadecimal, no comma, no nan or inf, no number past the double range. A
/// number too small for a double is 0.
[[nodiscard]] std::optional<double> strict_number(std::string_view text);

/// The whole of `text` as a sign and digits, within int.
[[nodiscard]] std::optional<int> strict_integer(std::string_view text);

}  // namespace nadir::sim
