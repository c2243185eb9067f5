#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.hpp"

namespace nadir::sim {

/// One lamp of a list: where it stands, and what it has that others of the list have not.
struct ListedLamp {
  Vec3 position;         ///< east, north, up, m
  double yaw_deg = 0.0;  ///< turned clockwise, seen from above
  std::optional<double> lumens;
  std::optional<double> colour_temperature_k;
  int line = 0;  ///< of the list, for messages
};

/// A table of lamps: CSV with the columns `east_m` and `north_m`, and where wanted `up_m`,
/// `yaw_deg`, `lumens`, `colour_temperature_k`.
/// @throws InputError with every mistake of the file
[[nodiscard]] std::vector<ListedLamp> read_lamp_list(const std::filesystem::path& file);
/// The same from text; `name` stands in messages.
[[nodiscard]] std::vector<ListedLamp> parse_lamp_list(std::string_view text,
                                                      const std::string& name);

}  // namespace nadir::sim
