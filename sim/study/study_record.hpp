#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/study/study_points.hpp"
#include "sim/study/study_sample.hpp"

namespace nadir::sim {

/// A file that a study depends on.
struct StudyInput {
  std::string path, sha256;
  [[nodiscard]] bool operator==(const StudyInput&) const = default;
};

/// What a study is of: with another of these, nothing that was measured serves.
struct StudyHeader {
  std::string version;
  std::string scenario, title, time_utc;  ///< file, heading, date of the picture
  std::vector<StudyInput> inputs;         ///< the scenario and all that it names
  std::vector<StudyBand> bands;
  std::vector<int> pixels_of_array;  ///< that are studied
  int pixels_asked = 0;              ///< by the user; 0: as the budget allowed
  std::vector<std::uint64_t> image_pixels;
  std::uint64_t seed = 1;
  int replicates = 4;  ///< of the pictures whose error is told
  int threads = 1;
  std::string processor;
  StudyScope scope;
  int samples = 1;            ///< of a replicate, as the scenario has them
  int reference_samples = 1;  ///< paths of a replicate in each of the reference's rounds
};

/// One level of a row: its settings at one number of paths.
struct StudyRun {
  std::string key;  ///< of the settings
  StudySample sample;
};

/// A row that the budget did not reach.
struct StudySkip {
  std::string key, reason;
};

/// A small picture of the whole scene.
struct StudyPicture {
  std::string label;
  std::string settings;                 ///< readable
  int width = 0, height = 0, step = 1;  ///< every step-th sample of every step-th line
  double paths = 0.0;                   ///< a pixel
  double error = 0.0;                   ///< of its pixels, median over the picture, relative
  double wall_s = 0.0;                  ///< it took
  double picture_s = 0.0;               ///< all pixels would take
  std::string png_base64;
};

/// All that a study has measured so far.
struct StudyRecord {
  StudyHeader header;
  std::vector<StudySample> reference;  ///< rounds with random numbers of their own
  std::vector<StudyRun> runs;
  std::vector<StudyRun> confirmations;
  std::vector<StudySkip> skips;
  std::vector<StudyPicture> pictures;
  std::string array_shown;         ///< in the pictures
  bool extended = false;           ///< by a larger budget than it was finished with
  double spent_s = 0.0;            ///< of the budget
  double finished_budget_s = 0.0;  ///< the largest budget that was used to its end; 0: none
  std::vector<std::string> warnings;
};

}  // namespace nadir::sim
