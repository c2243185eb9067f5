#pragma once

#include <filesystem>
#include <optional>

#include "sim/scenario/camera_input.hpp"
#include "sim/scenario/issues.hpp"

namespace nadir::sim {

/// Reads and checks a sensor file; adds its mistakes, which name the file, to `issues`.
/// Nothing where the file cannot be taken apart at all.
[[nodiscard]] std::optional<SensorInput> read_sensor(const std::filesystem::path& file,
                                                     Issues& issues);

/// Reads and checks a sensor file.
/// @throws InputError that lists every mistake of the file with line and column
[[nodiscard]] SensorInput read_sensor_file(const std::filesystem::path& file);

/// Whether the file's root says that it is a sensor file.
/// @throws InputError for a file that cannot be read or is not well-formed XML
[[nodiscard]] bool is_sensor_file(const std::filesystem::path& file);

}  // namespace nadir::sim
