#pragma once

#include <string>

#include "sim/study/analyse.hpp"

namespace nadir::sim {

/// The study as a table: one line a row, level and band (RFC 4180, a header with units).
[[nodiscard]] std::string study_csv(const StudyRecord& record, const StudyResult& result);

/// All of it for programs (RFC 8259): `reference`, `rows`, `pareto`, `recommendations`, `rate`, ...
/// Numbers that are not finite are null. docs/study.md explains the keys.
[[nodiscard]] std::string study_json(const StudyRecord& record, const StudyResult& result);

}  // namespace nadir::sim
