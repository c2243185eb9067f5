#include "sim/study/conduct.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <set>

#include "core/error.hpp"
#include "core/random.hpp"
#include "sim/study/study_points.hpp"

namespace nadir::sim {
namespace {

constexpr int row_replicates = 8;        // variances of a pixel to 50 %, of 64 pixels to 7 %
constexpr int few_replicates = 4;        // where eight are not affordable
constexpr int reference_replicates = 8;  // of each round
constexpr int least_pixels = 64, most_pixels = 400;
constexpr int level_step = 4;  // each level has so many times the paths of the last
constexpr int most_level_samples = 4096;
constexpr int most_rounds = 64;
constexpr int row_pilot_pixels = 8;  // by which a row's cost is told before it is measured
// A reference of fewer paths a pixel than that is not converged for anybody.
constexpr double wanted_reference_paths = 2048.0;
// Writing pages and loading the encoder of pictures, and the most of a short budget for it.
constexpr double pages_s = 0.8, pages_share = 0.12;
// What is predicted from a few pixels may be so much too little.
constexpr double caution = 1.15;

constexpr std::uint64_t reference_stream = 0x7265666572656e63ULL;
constexpr std::uint64_t confirmation_stream = 0x636f6e6669726d61ULL;

int power_of_two_below(double number) {
  int power = 1;
  while (2.0 * power <= number) power *= 2;
  return power;
}

/// Pixels of the study, all arrays together.
double study_pixel_count(const StudyHeader& header) {
  double all = 0.0;
  for (const int count : header.pixels_of_array) all += count;
  return all;
}

double predicted_s(const SampleCost& cost, double paths) {
  return cost.setup_s + cost.path_wall_s * paths;
}

/// The largest level that a row has; null where it has none.
const StudySample* last_level(const StudyRecord& record, const std::string& key) {
  const StudySample* last = nullptr;
  for (const StudyRun& run : record.runs) {
    if (run.key != key) continue;
    if (last == nullptr || run.sample.request.samples > last->request.samples) last = &run.sample;
  }
  return last;
}

/// How many rows an interrupted study was done with: those before the last that it touched.
std::size_t rows_done(const StudyRecord& record, const std::vector<StudyPoint>& points) {
  if (record.extended) return 0;
  std::size_t done = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string key = key_of(points[i].settings);
    if (last_level(record, key) != nullptr) done = i;
  }
  return done;
}

bool is_skipped(const StudyRecord& record, const std::string& key) {
  return std::any_of(record.skips.begin(), record.skips.end(),
                     [&](const StudySkip& skip) { return skip.key == key; });
}

/// Enough for the errors to be told from the reference's own.
int level_limit(const StudyRecord& record) {
  double paths = 0.0;
  for (const StudySample& round : record.reference) paths += round.paths();
  return std::clamp(static_cast<int>(paths / row_replicates / 2.0), 1, most_level_samples);
}

}  // namespace

StudySchedule schedule_of(double loaded_s, double budget_s) {
  const double all = std::max(0.0, budget_s - loaded_s);
  const double left = all - std::min(pages_s, pages_share * all);
  StudySchedule schedule;
  schedule.reference_s = loaded_s + reference_share * left;
  schedule.rows_s = schedule.reference_s + rows_share * left;
  schedule.confirmations_s = schedule.rows_s + confirmation_share * left;
  schedule.pictures_s = schedule.confirmations_s + pictures_share * left;
  return schedule;
}

PixelPlan plan_pixels(double path_s, double reference_s, int wanted, std::uint64_t image_pixels) {
  const double paths = reference_s / std::max(path_s, 1e-12);
  PixelPlan plan;
  const double affordable = paths / wanted_reference_paths;
  plan.pixels =
      wanted > 0
          ? wanted
          : static_cast<int>(std::clamp(affordable, double{least_pixels}, double{most_pixels}));
  plan.pixels = static_cast<int>(
      std::min(static_cast<double>(plan.pixels), static_cast<double>(image_pixels)));
  // Eight rounds or more: enough to stop in time, few enough to profit from good points.
  plan.reference_samples =
      power_of_two_below(std::min(4096.0, paths / plan.pixels / reference_replicates / 8.0));
  return plan;
}

std::uint64_t level_seed(std::uint64_t seed, int samples) {
  return mix(seed, static_cast<std::uint64_t>(samples));
}

void StudyConduct::run(StudyJournal& journal) const {
  measure_reference(journal);
  measure_rows(journal);
  extend_rows(journal);
  confirm(journal);
}

void StudyConduct::measure_reference(StudyJournal& journal) const {
  const StudyHeader header = journal.record().header;
  const StudySettings settings = reference_settings(header.scope.scenario);
  while (journal.record().reference.size() < most_rounds) {
    const std::size_t round = journal.record().reference.size();
    const double last_s = round > 0 ? journal.record().reference.back().cost.wall_s : 0.0;
    // Two rounds at least: without a second there is no check of the first's standard error.
    if (round >= 2 && time() + caution * last_s > schedule.reference_s) break;
    tell(fmt::format("reference: round {}", round + 1));
    journal.add_reference(probe(settings, {reference_replicates, header.reference_samples,
                                           mix(header.seed ^ reference_stream, round), 0}),
                          time());
  }
}

void StudyConduct::measure_rows(StudyJournal& journal) const {
  const auto points = study_points(journal.record().header.scope);
  double weights = 0.0;
  for (const StudyPoint& point : points) weights += point.weight;
  const std::size_t done = rows_done(journal.record(), points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const StudyPoint& point = points[i];
    const double now = time();
    const double share = std::max(0.0, schedule.rows_s - now) * point.weight / weights;
    weights -= point.weight;
    if (i < done || is_skipped(journal.record(), key_of(point.settings))) continue;
    tell(fmt::format("row: {}", point.name));
    try {
      measure_row(point, now + share, journal);
    } catch (const InputError& error) {  // wavelengths or air that the scene's spectra do not serve
      const InputIssue& issue = error.issues().front();
      journal.add_skip({key_of(point.settings), issue.message}, time());
    }
  }
}

void StudyConduct::extend_rows(StudyJournal& journal) const {
  const StudyResult result = analyse(journal.record());
  for (const Recommendation& advice : result.recommendations) {
    for (const RowFigures& row : result.rows) {
      if (advice.reached && row.point.name == advice.row) {
        measure_levels(row.point, schedule.rows_s, journal);
      }
    }
  }
}

void StudyConduct::measure_row(const StudyPoint& point, double until_s,
                               StudyJournal& journal) const {
  const StudyHeader& header = journal.record().header;
  const std::string key = key_of(point.settings);
  if (last_level(journal.record(), key) != nullptr) {  // of an interrupted study
    measure_levels(point, until_s, journal);
    return;
  }
  const double prepare_s = preparation_s(point.settings);
  if (time() + caution * prepare_s >= std::max(until_s, 0.5 * (time() + schedule.rows_s))) {
    journal.add_skip({key, prepare_s > 0.0 ? fmt::format("its air alone would have taken about "
                                                         "{:.3g} s",
                                                         prepare_s)
                                           : std::string{"the budget was used up"}},
                     time());
    return;
  }
  const StudySample pilot =
      probe(point.settings, {few_replicates, 1, level_seed(header.seed, 0), row_pilot_pixels});
  const double pixels = study_pixel_count(header);
  const double left_s = schedule.rows_s - time();
  for (const int replicates : {row_replicates, few_replicates}) {
    if (point.paired && replicates != row_replicates) break;
    const double cost_s = caution * predicted_s(pilot.cost, replicates * pixels);
    // A row may take what later ones leave it, but not half of what all of them have.
    if (cost_s > std::max(until_s - time(), 0.5 * left_s)) continue;
    StudyRun first{key, probe(point.settings, {replicates, 1, level_seed(header.seed, 1), 0})};
    journal.add_run(std::move(first), time());
    measure_levels(point, until_s, journal);
    return;
  }
  const double least_s = predicted_s(pilot.cost, few_replicates * pixels);
  journal.add_skip({key, fmt::format("would have taken {:.3g} s of the {:.3g} s left", least_s,
                                     std::max(0.0, left_s))},
                   time());
}

void StudyConduct::measure_levels(const StudyPoint& point, double until_s,
                                  StudyJournal& journal) const {
  const StudyHeader& header = journal.record().header;
  const std::string key = key_of(point.settings);
  const double pixels = study_pixel_count(header);
  const int limit = level_limit(journal.record());
  for (;;) {
    const StudySample& last = *last_level(journal.record(), key);
    const int samples = level_step * last.request.samples, replicates = last.request.replicates;
    if (samples > limit) return;
    const double paths = pixels * replicates * samples;
    if (time() + caution * predicted_s(last.cost, paths) > until_s) return;
    StudyRun run{key,
                 probe(point.settings, {replicates, samples, level_seed(header.seed, samples), 0})};
    journal.add_run(std::move(run), time());
  }
}

void StudyConduct::confirm(StudyJournal& journal) const {
  const StudyResult result = analyse(journal.record());
  const StudyHeader& header = journal.record().header;
  std::set<std::pair<std::string, int>> done;
  for (const StudyRun& run : journal.record().confirmations) {
    done.insert({run.key, run.sample.request.samples});
  }
  for (const Recommendation& advice : result.recommendations) {
    if (!advice.reached) continue;
    const std::string key = key_of(advice.settings);
    if (!done.insert({key, advice.samples}).second) continue;
    const auto row = std::find_if(result.rows.begin(), result.rows.end(),
                                  [&](const RowFigures& r) { return r.point.name == advice.row; });
    const double paths = study_pixel_count(header) * advice.replicates * advice.samples;
    if (time() + caution * (row->setup_s + row->path_wall_s * paths) > schedule.confirmations_s) {
      continue;
    }
    tell(fmt::format("trying what is recommended for {:g} %", 100.0 * advice.target));
    const std::uint64_t seed =
        mix(header.seed ^ confirmation_stream, static_cast<std::uint64_t>(advice.samples));
    journal.add_confirmation(
        {key, probe(advice.settings, {advice.replicates, advice.samples, seed, 0})}, time());
  }
}

}  // namespace nadir::sim
