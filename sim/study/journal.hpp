#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/study/study_record.hpp"

namespace nadir::sim {

/// The file in which a study keeps what it has measured, line by line, so that it can be killed at
/// any moment: JSON objects, one a line, the first of them the header. What a kill cut off is
/// thrown away when the file is opened again.
class StudyJournal {
 public:
  /// Opens a study's file. What it holds is kept if its header is of the same version, inputs,
  /// bands and seed as `header` (whose other values it then replaces); otherwise it is begun anew.
  /// @param same_pixels  the number of pixels was asked for and must be the same
  /// @throws std::runtime_error with the system's reason
  StudyJournal(std::filesystem::path file, const StudyHeader& header, bool same_pixels);
  ~StudyJournal();
  StudyJournal(const StudyJournal&) = delete;
  StudyJournal& operator=(const StudyJournal&) = delete;

  [[nodiscard]] const StudyRecord& record() const noexcept { return record_; }
  /// Something was there to go on from.
  [[nodiscard]] bool resumed() const noexcept { return resumed_; }

  void add_header(const StudyHeader& header);  ///< while nothing else is there
  void add_reference(StudySample round, double spent_s);
  void add_run(StudyRun run, double spent_s);
  void add_confirmation(StudyRun run, double spent_s);
  void add_skip(StudySkip skip, double spent_s);
  void add_picture(StudyPicture picture, double spent_s);
  void set_array_shown(std::string name);
  void finish(double budget_s, double spent_s, const std::vector<std::string>& warnings);
  /// Forgets pictures and skips: a larger budget makes them again.
  void reopen();

 private:
  void append(const std::string& line);

  std::filesystem::path file_;
  StudyRecord record_;
  int descriptor_ = -1;
  bool resumed_ = false;
};

/// The record that a file holds; none where there is no file or no whole header in it.
/// @param whole_bytes  if given, how much of the file is whole lines
[[nodiscard]] std::optional<StudyRecord> read_record(const std::filesystem::path& file,
                                                     std::size_t* whole_bytes = nullptr);

}  // namespace nadir::sim
