#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nadir::sim {

/// Where modules may lie, in the order in which they are looked for: the environment variable
/// NADIR_MODULES if set, and nothing else; otherwise the folder of the executable, the installed
/// place beside it (../lib/nadir), and the folder above it (test programs of the build tree).
[[nodiscard]] std::vector<std::filesystem::path> module_directories();

/// The first of them that holds `lib<module>.so`.
/// @throws std::runtime_error that lists the places, when none does.
[[nodiscard]] std::filesystem::path module_directory(const std::string& module);

/// Loads lib<module>.so on first use and gives the address of what it exports as `symbol`.
/// Thread-safe; a module stays loaded until the program ends.
/// @throws std::runtime_error with the loader's own words.
[[nodiscard]] void* module_symbol(const std::string& module, const std::string& symbol);

/// The table that the function `symbol` of a module returns.
template <class Table>
[[nodiscard]] const Table& load_module(const std::string& module, const std::string& symbol) {
  return *reinterpret_cast<const Table* (*)()>(module_symbol(module, symbol))();
}

}  // namespace nadir::sim
