#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <system_error>

#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "sim/scenario/read_scenario.hpp"

// What the tests of the scenario reader share: the three good scenarios and small changes to them.

namespace nadir::test {

inline std::filesystem::path data_folder() {
  return std::filesystem::path{NADIR_SOURCE_DIR} / "tests/sim/data/scenario";
}

inline std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw std::runtime_error{"cannot read " + file.string()};
  return {std::istreambuf_iterator<char>{stream}, std::istreambuf_iterator<char>{}};
}

inline std::string minimal_text() { return file_text(data_folder() / "minimal.xml"); }
inline std::string full_text() { return file_text(data_folder() / "full.xml"); }
inline std::string warm_text() { return file_text(data_folder() / "warm.xml"); }

/// A folder of its own for one test, since tests run side by side; gone when the test ends.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "nadir_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error{"cannot make a folder"};
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// The temperature that a material states; NaN where it comes from elsewhere.
inline double kelvin_of(const sim::MaterialInput& material) {
  const auto* constant = std::get_if<sim::ConstantTemperatureInput>(&material.temperature);
  return constant != nullptr ? constant->kelvin : std::numeric_limits<double>::quiet_NaN();
}

/// `text` with the first `from` replaced; a test whose `from` is not there is itself wrong.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error{"the text holds no " + from};
  return text.replace(at, from.size(), to);
}

/// The mistakes of a text that stands in the data folder, formatted; empty for a good one.
inline std::string mistakes(const std::string& text, const std::string& name = "test.xml") {
  Diagnostics diagnostics;
  try {
    static_cast<void>(sim::parse_scenario(text, data_folder() / name, diagnostics));
    return {};
  } catch (const InputError& error) {
    const std::string folder = data_folder().string() + "/";
    std::string all = error.what();
    for (std::size_t at = all.find(folder); at != std::string::npos; at = all.find(folder)) {
      all.erase(at, folder.size());
    }
    return all;
  }
}

/// `error: ...` of every mistake, one a line, with line and column before it.
inline std::string mistake_lines(const std::string& text) {
  Diagnostics diagnostics;
  try {
    static_cast<void>(sim::parse_scenario(text, data_folder() / "test.xml", diagnostics));
    return {};
  } catch (const InputError& error) {
    std::string lines;
    for (const InputIssue& issue : error.issues()) {
      lines += std::to_string(issue.where.line) + ":" + std::to_string(issue.where.column) + ": " +
               issue.message + (issue.hint.empty() ? "" : " (" + issue.hint + ")") + "\n";
    }
    return lines;
  }
}

}  // namespace nadir::test
