#pragma once

#include <filesystem>

namespace nadir::sim {

/// Where the shipped data lies (library/, schema/, the demo scenarios): the folder that NADIR_DATA
/// names; else share/nadir beside the command's own folder, as installed; else the source tree's
/// scenes/, for programs that run from a build folder.
/// @throws InputError where none of them exists
[[nodiscard]] std::filesystem::path data_directory();

}  // namespace nadir::sim
