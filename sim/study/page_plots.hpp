#pragma once
// Private to this folder: the plots of a study's page.

#include <string>
#include <vector>

#include "sim/study/analyse.hpp"

namespace nadir::sim {

/// Rows that get a colour of their own: the path solver, the scenario's settings, what is
/// recommended, what lies on the front; seven at most, by their number in the result.
[[nodiscard]] std::vector<std::size_t> key_rows(const StudyResult& result);

/// Error against time, one plot an array, by the worst of its bands.
[[nodiscard]] std::string trade_plots(const StudyRecord& record, const StudyResult& result);

/// Error against paths, with the fitted law.
[[nodiscard]] std::string convergence_plot(const StudyResult& result);

/// "0.34 s", "12 s", "3 min 20 s", "2 h 05 min".
[[nodiscard]] std::string readable_time(double seconds);

}  // namespace nadir::sim
