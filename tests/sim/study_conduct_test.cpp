#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "sim/scratch_folder.hpp"
#include "sim/study/conduct.hpp"
#include "sim/study/run_study.hpp"
#include "sim/study/study_page.hpp"
#include "sim/study/study_pixels.hpp"
#include "sim/study/study_tables.hpp"
#include "sim/study_support.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using support::conduct_synthetic;
using support::synthetic_header;
using support::SyntheticScene;

/// A whole study of the synthetic scene.
StudyRecord studied(SyntheticScene scene, double budget_s) {
  const support::ScratchFolder folder;
  const StudyHeader header = synthetic_header();
  StudyJournal journal{folder / "study.rows", header, false};
  journal.add_header(header);
  conduct_synthetic(scene, journal, budget_s);
  return journal.record();
}

const RowFigures& row_called(const StudyResult& result, const std::string& name) {
  const auto row = std::find_if(result.rows.begin(), result.rows.end(),
                                [&](const auto& r) { return r.point.name == name; });
  REQUIRE(row != result.rows.end());
  return *row;
}

TEST_CASE("a study tells bias from noise and finds the rate", "[sim][study]") {
  const double rate = GENERATE(0.5, 0.8);
  CAPTURE(rate);
  SyntheticScene scene;
  scene.rate = rate;
  const StudyResult result = analyse(studied(scene, 20.0));
  const RowFigures& path = row_called(result, "path solver");
  REQUIRE(path.levels.size() >= 3);
  for (const RowBand& band : path.bands) {
    CHECK(std::abs(band.bias) < 4.0 * band.bias_error);               // 2 bands: 1e-4 by chance
    CHECK(band.path_noise == Approx(scene.path_noise).epsilon(0.1));  // 64 x 7 degrees of freedom
    CHECK(band.pixel_bias == 0.0);
  }
  CHECK(path.rate.rate == Approx(rate).margin(4.0 * path.rate.rate_uncertainty));
  CHECK(path.rate.rate_uncertainty < 0.05);
  // Three bounces of four: 3 % of every pixel is lost.
  const RowFigures& scenario = row_called(result, "scenario");
  for (const RowBand& band : scenario.bands) {
    CHECK(band.bias == Approx(-0.03).margin(4.0 * band.bias_error));
    CHECK(band.pixel_bias == Approx(0.03).epsilon(0.05));  // noise of reference and row: 1 %
    CHECK(band.pixel_bias_limit > band.pixel_bias);
  }
  CHECK(scenario.path_cpu_s == Approx(10.0 * path.path_cpu_s).epsilon(1e-9));
}

TEST_CASE("the recommendation is the cheapest row that meets the target", "[sim][study]") {
  const StudyRecord record = studied({}, 20.0);
  const StudyResult result = analyse(record);
  REQUIRE(result.recommendations.size() == study_targets.size());
  for (const Recommendation& advice : result.recommendations) {
    CAPTURE(advice.target, advice.row, advice.reason);
    REQUIRE(advice.reached);
    CHECK(advice.error <= advice.target);
    const RowFigures& chosen = row_called(result, advice.row);
    for (const RowFigures& row : result.rows) {
      if (row.point.paired) continue;
      for (const LevelFigures& level : row.levels) {  // no level that was measured beats it
        const bool certain = std::all_of(row.bands.begin(), row.bands.end(), [&](const auto& b) {
          return b.pixel_bias_limit < advice.target;
        });
        if (certain && level.worst_error <= advice.target) {
          CHECK(level.picture_s >= 0.999 * advice.picture_s);
        }
      }
    }
    // One path fewer in each replicate would miss it.
    double fewer = 0.0;
    for (std::size_t b = 0; b < chosen.bands.size(); ++b) {
      fewer = std::max(fewer, chosen.error(b, advice.replicates, advice.samples - 1.0));
    }
    if (advice.samples > 1) CHECK(fewer > advice.target);
    // 0.03 of bias rules three bounces out, and noise of 0.1 a path makes it cheaper for 5 %.
    if (advice.target < 0.03)
      CHECK(std::abs(SyntheticScene{}.bias(advice.settings)) < advice.target);
    if (std::isfinite(advice.found_error)) CHECK(advice.found_error < 1.25 * advice.target);
  }
}

TEST_CASE("a row whose bias cannot be excluded is not recommended", "[sim][study]") {
  StudyResult result = analyse(studied({}, 20.0));
  std::vector<RowFigures> rows{row_called(result, "scenario")};
  for (RowBand& band : rows[0].bands) band.pixel_bias = 0.0, band.pixel_bias_limit = 0.03;
  CHECK_FALSE(recommend(0.02, rows, synthetic_header()).reached);
  CHECK(recommend(0.05, rows, synthetic_header()).reached);
}

TEST_CASE("a study ends within its budget, however dear its paths", "[sim][study]") {
  const double path_s = GENERATE(1e-7, 1e-5, 1e-4);
  const double budget_s = GENERATE(10.0, 60.0);
  CAPTURE(path_s, budget_s);
  SyntheticScene scene;
  scene.path_s = path_s;
  const support::ScratchFolder folder;
  StudyHeader header = synthetic_header();
  header.reference_samples =
      plan_pixels(path_s, reference_share * budget_s, 64, 10000).reference_samples;
  StudyJournal journal{folder / "study.rows", header, false};
  journal.add_header(header);
  conduct_synthetic(scene, journal, budget_s);
  const StudySchedule schedule = schedule_of(0.0, budget_s);
  CHECK(scene.clock_s <= schedule.confirmations_s);
  CHECK_FALSE(journal.record().runs.empty());
  // What is not there is told.
  for (const StudyPoint& point : study_points(header.scope)) {
    const std::string key = key_of(point.settings);
    const auto is = [&](const auto& entry) { return entry.key == key; };
    const auto& runs = journal.record().runs;
    const auto& skips = journal.record().skips;
    CHECK(
        (std::any_of(runs.begin(), runs.end(), is) || std::any_of(skips.begin(), skips.end(), is)));
  }
}

TEST_CASE("an interrupted study goes on and measures no row twice", "[sim][study]") {
  const support::ScratchFolder folder;
  const auto file = folder / "study.rows";
  const StudyHeader header = synthetic_header();
  int calls = 0;
  std::size_t runs = 0;
  {
    SyntheticScene scene;
    scene.die_after = 100;  // in the midst of the rows: the reference has at most 64 rounds
    StudyJournal journal{file, header, false};
    CHECK_FALSE(journal.resumed());
    journal.add_header(header);
    CHECK_THROWS_AS(conduct_synthetic(scene, journal, 5.0), SyntheticScene::Killed);
    calls = scene.calls;
    runs = journal.record().runs.size();
    REQUIRE(runs > 2);
  }
  std::ofstream{file, std::ios::app} << R"({"kind":"run","spent_s":1,"key":"half a li)";
  SyntheticScene scene;
  StudyJournal journal{file, header, false};
  REQUIRE(journal.resumed());
  CHECK(journal.record().runs.size() == runs);  // the half line is gone
  CHECK(journal.record().spent_s > 0.0);
  scene.clock_s = journal.record().spent_s;
  const auto before = journal.record().runs;
  conduct_synthetic(scene, journal, 5.0);
  const auto& all = journal.record().runs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const bool twice = all[i].key == all[j].key &&
                         all[i].sample.request.samples == all[j].sample.request.samples;
      CHECK_FALSE(twice);
    }
  }
  for (std::size_t i = 0; i < before.size(); ++i)
    CHECK(before[i].sample.mean == all[i].sample.mean);
  CHECK(scene.calls > 0);
  CHECK(calls > 0);

  // Read from the file once more it is the same to the last bit.
  const auto read = read_record(file);
  REQUIRE(read.has_value());
  REQUIRE(read->runs.size() == all.size());
  CHECK(read->runs.back().sample.variance == all.back().sample.variance);
  CHECK(study_json(*read, analyse(*read)) ==
        study_json(journal.record(), analyse(journal.record())));
}

TEST_CASE("another scenario, seed or version begins a study anew", "[sim][study]") {
  const support::ScratchFolder folder;
  const auto file = folder / "study.rows";
  const StudyHeader header = synthetic_header();
  const auto resumes = [&](const StudyHeader& with, bool same_pixels) {
    {
      StudyJournal first{file, header, false};
      if (!first.resumed()) first.add_header(header);
    }
    return StudyJournal{file, with, same_pixels}.resumed();
  };
  CHECK(resumes(header, true));
  StudyHeader other = header;
  other.inputs[0].sha256 = "01";
  CHECK_FALSE(resumes(other, false));
  other = header;
  other.seed = 2;
  CHECK_FALSE(resumes(other, false));
  other = header;
  other.version = "2";
  CHECK_FALSE(resumes(other, false));
  other = header;
  other.pixels_asked = 80;
  CHECK(resumes(other, false));
  CHECK_FALSE(resumes(other, true));
}

/// Lines of a text, fields of a line of a CSV without line ends inside fields.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool inside = false;
  for (const char c : line) {
    if (c == '"') inside = !inside;
    if (c == ',' && !inside) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

TEST_CASE("the tables of a study are whole", "[sim][study]") {
  StudyRecord record = studied({}, 20.0);
  record.warnings = {"a \"warning\" with \xff in it"};
  const StudyResult result = analyse(record);
  const std::string csv = study_csv(record, result);
  std::size_t lines = 0, columns = 0;
  for (std::size_t at = 0; at < csv.size(); ++lines) {
    const std::size_t end = csv.find("\r\n", at);
    REQUIRE(end != std::string::npos);
    const auto fields = fields_of(csv.substr(at, end - at));
    if (lines == 0) columns = fields.size();
    CHECK(fields.size() == columns);
    at = end + 2;
  }
  std::size_t levels = 0;
  for (const RowFigures& row : result.rows) levels += row.levels.size();
  CHECK(lines == 1 + 2 * levels);

  const auto json = nlohmann::json::parse(study_json(record, result));
  for (const char* key : {"rows", "pareto", "recommendations", "reference", "rate", "bands"}) {
    CAPTURE(key);
    CHECK(json.contains(key));
  }
  CHECK(json.at("recommendations").size() == 4);
  CHECK(json.at("rows").size() == result.rows.size());
  CHECK(json.at("rows").at(0).at("name") == "path solver");
}

TEST_CASE("the page escapes what it is told and names no address", "[sim][study]") {
  StudyRecord record = studied({}, 20.0);
  record.warnings = {"<script>alert(1)</script>"};
  const std::string page = study_page(record, analyse(record));
  CHECK(page.find("Made up, &lt;b&gt; &amp; &quot;quoted&quot;") != std::string::npos);
  CHECK(page.find("<script") == std::string::npos);
  CHECK(page.find("http:") == std::string::npos);
  CHECK(page.find("https:") == std::string::npos);
  CHECK(page.find("nan") == std::string::npos);
  CHECK(page.find("<svg") != std::string::npos);
}

TEST_CASE("a page can be written before anything was measured", "[sim][study]") {
  StudyRecord record;
  record.header = synthetic_header();
  const StudyResult result = analyse(record);
  CHECK(result.rows.empty());
  CHECK(study_page(record, result).find("</html>") != std::string::npos);
  CHECK_NOTHROW(nlohmann::json::parse(study_json(record, result)));
}

TEST_CASE("pixels are stratified: one in each cell, none twice", "[sim][study]") {
  const auto places = stratified_pixels({100, 100}, 100, 5);
  REQUIRE(places.size() == 100);
  std::vector<int> cells(100, 0);
  for (const StudyPixel& p : places)
    ++cells[static_cast<std::size_t>(p.line / 10 * 10 + p.sample / 10)];
  CHECK(std::all_of(cells.begin(), cells.end(), [](int count) { return count == 1; }));
  CHECK(stratified_pixels({100, 100}, 100, 6) != places);
  CHECK(stratified_pixels({3, 2}, 100, 5).size() == 6);
  CHECK(stratified_pixels({1000, 1}, 64, 5).size() == 64);
  CHECK(stratified_pixels({1, 1000}, 64, 5).size() == 64);
  CHECK(stratified_pixels({7, 13}, 64, 5).size() == 64);
}

TEST_CASE("small images get pixels of their own", "[sim][study]") {
  CHECK(share_pixels({{1000, 1000}, {10, 10}}, 80) == std::vector<int>{80, 10});
  CHECK(share_pixels({{1000, 1000}, {2, 2}}, 80) == std::vector<int>{80, 4});
  CHECK(share_pixels({{5, 5}}, 80) == std::vector<int>{25});
}

TEST_CASE("budgets are read with their units", "[sim][study]") {
  CHECK(budget_from("10min") == 600.0);
  CHECK(budget_from("90s") == 90.0);
  CHECK(budget_from("1.5h") == 5400.0);
  CHECK(budget_from("45") == 45.0);
  for (const char* bad : {"", "min", "10 minutes", "-5s", "0", "nan", "inf", "1e999"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(budget_from(bad), InputError);
  }
}

TEST_CASE("study points are different and begin with what everybody asks for", "[sim][study]") {
  StudyScope scope = synthetic_header().scope;
  scope.layered_air = true;
  const auto points = study_points(scope);
  CHECK(points[0].name == "path solver");
  CHECK(points[0].unbiased());
  CHECK(points[1].name == "scenario");
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      CHECK(points[i].name != points[j].name);
      CHECK(key_of(points[i].settings) != key_of(points[j].settings));
    }
  }
  // Each group that is to be swept is there.
  for (const char* group : {"method", "known good", "path bounces", "wavelengths", "air", "bounces",
                            "top-up", "samples", "quads", "decay"}) {
    CAPTURE(group);
    CHECK(
        std::any_of(points.begin(), points.end(), [&](const auto& p) { return p.group == group; }));
  }
}

}  // namespace
}  // namespace nadir::sim
