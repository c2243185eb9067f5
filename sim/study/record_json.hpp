#pragma once
// Private to this folder: JSON of what a study keeps.

#include <nlohmann/json.hpp>

#include "sim/study/study_record.hpp"

namespace nadir::sim {

[[nodiscard]] nlohmann::ordered_json json_of(const StudySettings& settings);
[[nodiscard]] nlohmann::ordered_json json_of(const StudyHeader& header);
[[nodiscard]] nlohmann::ordered_json json_of(const StudySample& sample);
[[nodiscard]] nlohmann::ordered_json json_of(const StudyPicture& picture);

/// @throws nlohmann::json::exception where something is missing
[[nodiscard]] StudyHeader header_from(const nlohmann::ordered_json& json);
[[nodiscard]] StudySample sample_from(const nlohmann::ordered_json& json);
[[nodiscard]] StudyPicture picture_from(const nlohmann::ordered_json& json);

}  // namespace nadir::sim
