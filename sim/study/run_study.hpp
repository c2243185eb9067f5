#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/study/analyse.hpp"

namespace nadir::sim {

struct StudyOptions {
  std::filesystem::path scenario;
  std::filesystem::path output;  ///< folder; made where it is missing
  double budget_s = 600.0;       ///< of the clock, for everything
  int pixels = 0;                ///< to study; 0: as the budget allows
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: one per processor
  std::function<void(const std::string&)> tell = [](const std::string&) {};  ///< of progress
};

struct StudyOutcome {
  StudyResult result;
  std::vector<std::string> warnings;
  std::vector<std::filesystem::path> files;  ///< study.csv, study.json, study.html
  double spent_s = 0.0;                      ///< of the budget, interrupted attempts included
  bool measured = false;                     ///< false: all had been measured before
};

/// Studies a scenario, or goes on with a study that was interrupted, and writes its pages.
/// @throws InputError for mistakes in the scenario, std::runtime_error where nothing can be written
[[nodiscard]] StudyOutcome run_study(const StudyOptions& options);

/// "10min", "90s", "1h", "1.5h", "600": seconds. @throws InputError for anything else, or less than
/// a second
[[nodiscard]] double budget_from(const std::string& text);

}  // namespace nadir::sim
