#pragma once

#include <string>

#include "sim/study/analyse.hpp"

namespace nadir::sim {

/// The study as one HTML page that needs nothing else: no network, no other file, no script.
[[nodiscard]] std::string study_page(const StudyRecord& record, const StudyResult& result);

}  // namespace nadir::sim
