#pragma once

#include <string>

namespace nadir::sim {

/// A relative accuracy from text: "1%", "0.5 %" or "0.01". 0 < accuracy <= 1.
/// @throws InputError for anything else
[[nodiscard]] double parse_accuracy(const std::string& text);

/// Seconds from text: "90", "60s", "10min", "1h30min", "1.5 h"; units h, min, s, each at most once
/// and in this order; a number without a unit is seconds and stands alone. Greater than 0 and at
/// most a year.
/// @throws InputError for anything else
[[nodiscard]] double parse_duration(const std::string& text);

/// Seconds as people write them: "0.42 s", "12 s", "3 min 20 s", "1 h 30 min".
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace nadir::sim
