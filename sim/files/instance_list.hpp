#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/transform.hpp"
#include "core/vec.hpp"

namespace nadir::sim {

/// Where an object stands and how it is turned, in the axes of what holds it (east, north, up).
struct Placement {
  Vec3 position;           ///< m
  double yaw_deg = 0.0;    ///< azimuth of the object's nose (its y axis): clockwise from north
  double pitch_deg = 0.0;  ///< nose up, about the object's x axis
  double roll_deg = 0.0;   ///< right side (x) down, about the object's y axis
  Vec3 scale{1.0, 1.0, 1.0};
  int line = 0;  ///< of the list, for messages; 0 where there is none
};

/// Object axes to the holder's axes: scale first, then roll, pitch and yaw, then the position;
/// linear = Rz(-yaw) Rx(pitch) Ry(roll) diag(scale), R right-handed. Multiples of 90 degrees exact.
[[nodiscard]] Affine affine(const Placement& placement);

/// Every inner placement inside every outer one: outer * inner, the outer index slowest.
[[nodiscard]] std::vector<Affine> flatten(const std::vector<Affine>& outer,
                                          const std::vector<Affine>& inner);

/// A table of placements: CSV, first row the names of the columns, in any order.
///
/// `east_m` and `north_m` are required; `up_m`, `yaw_deg`, `pitch_deg`, `roll_deg` are 0 where they
/// are missing, `scale` (or `scale_x`, `scale_y`, `scale_z`) 1. Blank lines
/// and lines that start with # are passed over.
/// A list without a row places nothing and is a mistake as well.
/// @throws InputError with every mistake of the file (20 in full), each with line and column
[[nodiscard]] std::vector<Placement> read_instance_list(const std::filesystem::path& file);

/// The same from text; `name` stands in messages.
[[nodiscard]] std::vector<Placement> parse_instance_list(std::string_view text,
                                                         const std::string& name);

}  // namespace nadir::sim
