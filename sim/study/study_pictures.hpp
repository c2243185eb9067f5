#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "sim/study/journal.hpp"
#include "sim/study/picture_plan.hpp"
#include "sim/study/study_world.hpp"

namespace nadir::sim {

/// Renders and keeps the pictures along the curve, all of them or (where there is no time) none.
/// @param folder  in which a picture's file may stand for a moment
void make_pictures(StudyWorld& world, const StudyResult& result, const StudyTime& time,
                   double until_s, const std::filesystem::path& folder, StudyJournal& journal);

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::span<const unsigned char> bytes);

}  // namespace nadir::sim
