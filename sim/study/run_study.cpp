#include "sim/study/run_study.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <system_error>

#include "core/error.hpp"
#include "sim/files/atomic_file.hpp"
#include "sim/run/tiles.hpp"
#include "sim/study/conduct.hpp"
#include "sim/study/study_page.hpp"
#include "sim/study/study_pictures.hpp"
#include "sim/study/study_tables.hpp"
#include "sim/study/study_world.hpp"

namespace nadir::sim {
namespace {

constexpr const char* rows_file = "study.rows";
constexpr std::uint64_t pilot_stream = 0x70696c6f74000000ULL;
constexpr int pixel_pilot = 32;

double clock_s() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && std::filesystem::is_directory(folder)) return;
  throw InputError{InputIssue{
      {folder.string(), 0, 0}, "this folder cannot be made", "name another with --output", {}}};
}

/// What a finished study measured, where nothing that it depends on has changed since.
std::optional<StudyRecord> finished_record(const StudyOptions& options) {
  auto record = read_record(options.output / rows_file);
  if (!record || record->header.version != NADIR_VERSION || record->header.seed != options.seed ||
      record->finished_budget_s < options.budget_s ||
      record->header.scenario != options.scenario.string()) {
    return std::nullopt;
  }
  if (options.pixels > 0 && options.pixels != record->header.pixels_asked) return std::nullopt;
  std::vector<std::string> paths;
  for (const StudyInput& input : record->header.inputs) paths.push_back(input.path);
  try {
    if (digests_of(paths) != record->header.inputs) return std::nullopt;
  } catch (const std::runtime_error&) {
    return std::nullopt;  // a file is gone: loading will say which
  }
  return record;
}

StudyOutcome write_pages(const StudyRecord& record, const StudyOptions& options) {
  StudyOutcome outcome;
  outcome.result = analyse(record);
  outcome.warnings = record.warnings;
  outcome.spent_s = record.spent_s;
  const auto put = [&](const char* name, const std::string& text) {
    outcome.files.push_back(options.output / name);
    write_file(outcome.files.back(), text);
  };
  put("study.csv", study_csv(record, outcome.result));
  put("study.json", study_json(record, outcome.result));
  put("study.html", study_page(record, outcome.result));
  return outcome;
}

/// Chooses how many pixels, by what a path costs.
void choose_study_pixels(StudyWorld& world, StudyHeader& header, const StudyOptions& options,
                         double reference_s) {
  const auto sizes = world.image_sizes();
  std::uint64_t all = 0;
  for (const ImageSize& size : sizes) all += size.pixels();
  header.pixels_of_array = share_pixels(sizes, pixel_pilot);
  world.choose_pixels(header);
  const StudySample pilot = world.sample(reference_settings(header.scope.scenario),
                                         {4, 4, header.seed ^ pilot_stream, 0});
  const PixelPlan plan = plan_pixels(pilot.cost.path_wall_s, reference_s, options.pixels, all);
  header.pixels_of_array = share_pixels(sizes, plan.pixels);
  header.reference_samples = plan.reference_samples;
}

}  // namespace

double budget_from(const std::string& text) {
  double number = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const std::string unit{rest, end};
  const double factor = unit.empty() || unit == "s"    ? 1.0
                        : unit == "min" || unit == "m" ? 60.0
                        : unit == "h"                  ? 3600.0
                                                       : 0.0;
  const double seconds = factor * number;
  if (error != std::errc{} || !(seconds >= 1.0) || !std::isfinite(seconds)) {
    throw InputError{"--budget is \"" + text +
                     "\"; expected a time of a second or more: 90s, 10min, 1h"};
  }
  return seconds;
}

StudyOutcome run_study(const StudyOptions& options) {
  const double start_s = clock_s();
  const ThreadLimit limit{options.threads};
  if (const auto record = finished_record(options)) return write_pages(*record, options);
  Diagnostics diagnostics;
  options.tell("loading the scene");
  StudyWorld world{{options.scenario, options.seed, options.threads}, diagnostics};
  StudyHeader header = world.header();
  header.scenario = options.scenario.string();
  header.pixels_asked = options.pixels;
  make_folder(options.output);
  StudyJournal journal{options.output / rows_file, header, options.pixels > 0};
  const double before_s = journal.record().spent_s;
  const StudyTime time = [=] { return before_s + clock_s() - start_s; };
  const double loaded_s = time();
  const StudySchedule schedule = schedule_of(clock_s() - start_s, options.budget_s);
  if (!journal.resumed()) {
    choose_study_pixels(world, header, options, schedule.reference_s - loaded_s);
    journal.add_header(header);
  } else if (journal.record().finished_budget_s > 0.0) {
    journal.reopen();
  }
  world.choose_pixels(journal.record().header);
  StudyConduct conduct;
  conduct.probe = [&](const StudySettings& settings, const SamplingRequest& request) {
    return world.sample(settings, request);
  };
  conduct.time = time;
  conduct.schedule = schedule;
  conduct.preparation_s = [&](const StudySettings& s) { return world.preparation_s(s); };
  conduct.tell = options.tell;
  conduct.run(journal);
  if (journal.record().pictures.empty()) {
    options.tell("pictures");
    const StudyResult result = analyse(journal.record());
    make_pictures(world, result, time, std::max(schedule.pictures_s, time()), options.output,
                  journal);
  }
  journal.finish(options.budget_s, time(), diagnostics.messages());
  StudyOutcome outcome = write_pages(journal.record(), options);
  outcome.measured = true;
  return outcome;
}

}  // namespace nadir::sim
