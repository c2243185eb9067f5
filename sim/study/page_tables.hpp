#pragma once
// Private to this folder: the tables of a study's page.

#include <string>

#include "sim/study/analyse.hpp"

namespace nadir::sim {

[[nodiscard]] std::string recommendation_table(const StudyRecord& record,
                                               const StudyResult& result);
/// The Pareto front in figures: error in a given time, time for a given error.
[[nodiscard]] std::string front_table(const StudyResult& result);
/// Bias, noise, cost and memory of every row.
[[nodiscard]] std::string row_table(const StudyRecord& record, const StudyResult& result);
/// What wavelengths and air change.
[[nodiscard]] std::string paired_table(const StudyRecord& record, const StudyResult& result);
[[nodiscard]] std::string skipped_table(const StudyRecord& record);

}  // namespace nadir::sim
