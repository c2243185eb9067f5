#include "sim/study/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "sim/study/record_json.hpp"

namespace nadir::sim {
namespace {

using LineJson = nlohmann::ordered_json;

[[noreturn]] void journal_failed(const std::filesystem::path& file, const char* action) {
  throw std::runtime_error{file.string() + ": cannot " + action + ": " +
                           std::generic_category().message(errno)};
}

StudyRun run_from(const LineJson& line) { return {line.at("key"), sample_from(line.at("sample"))}; }

/// A larger budget measures more and ends anew.
void forget_end(StudyRecord& record) {
  record.skips.clear();
  record.pictures.clear();
  record.confirmations.clear();
  record.finished_budget_s = 0.0;
  record.extended = true;
}

/// Adds what one line says. @throws nlohmann::json::exception for a line that is not ours
void take_line(const LineJson& line, StudyRecord& record) {
  const std::string kind = line.at("kind");
  record.spent_s = line.value("spent_s", record.spent_s);
  if (kind == "header") record.header = header_from(line.at("header"));
  if (kind == "reference") record.reference.push_back(sample_from(line.at("sample")));
  if (kind == "run") record.runs.push_back(run_from(line));
  if (kind == "confirmation") record.confirmations.push_back(run_from(line));
  if (kind == "skip") record.skips.push_back({line.at("key"), line.at("reason")});
  if (kind == "picture") record.pictures.push_back(picture_from(line.at("picture")));
  if (kind == "array_shown") record.array_shown = line.at("name");
  if (kind == "finished") {
    record.finished_budget_s = line.at("budget_s");
    record.warnings = line.at("warnings").get<std::vector<std::string>>();
  }
  if (kind == "reopened") {
    forget_end(record);
  }
}

bool same_bands(const std::vector<StudyBand>& a, const std::vector<StudyBand>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].array != b[i].array || a[i].name != b[i].name) return false;
  }
  return true;
}

bool header_serves(const StudyHeader& kept, const StudyHeader& wanted, bool same_pixels) {
  return kept.version == wanted.version && kept.inputs == wanted.inputs &&
         same_bands(kept.bands, wanted.bands) && kept.seed == wanted.seed &&
         key_of(kept.scope.scenario) == key_of(wanted.scope.scenario) &&
         (!same_pixels || kept.pixels_asked == wanted.pixels_asked);
}

}  // namespace

std::optional<StudyRecord> read_record(const std::filesystem::path& file,
                                       std::size_t* whole_bytes) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) return std::nullopt;
  const std::string text{std::istreambuf_iterator<char>{stream}, {}};
  StudyRecord record;
  std::size_t at = 0;
  bool any = false;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', at)) {
    try {
      take_line(LineJson::parse(std::string_view{text}.substr(at, end - at)), record);
    } catch (const nlohmann::json::exception&) {
      break;  // cut off, or not ours: nothing after it is believed
    }
    any = true;
    at = end + 1;
  }
  if (whole_bytes != nullptr) *whole_bytes = at;
  if (!any || record.header.bands.empty()) return std::nullopt;
  return record;
}

StudyJournal::StudyJournal(std::filesystem::path file, const StudyHeader& header, bool same_pixels)
    : file_{std::move(file)} {
  std::size_t whole = 0;
  auto kept = read_record(file_, &whole);
  resumed_ = kept && header_serves(kept->header, header, same_pixels);
  if (resumed_) record_ = std::move(*kept);
  descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor_ < 0) journal_failed(file_, "open");
  const auto size = static_cast<off_t>(resumed_ ? whole : 0);
  if (::ftruncate(descriptor_, size) != 0 || ::lseek(descriptor_, size, SEEK_SET) != size) {
    ::close(descriptor_);
    journal_failed(file_, "cut");
  }
}

StudyJournal::~StudyJournal() { ::close(descriptor_); }

// Not synced to the disc: what was written survives the process, if not the machine.
void StudyJournal::append(const std::string& line) {
  const std::string whole = line + "\n";
  std::size_t done = 0;
  while (done < whole.size()) {
    const auto written = ::write(descriptor_, whole.data() + done, whole.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) journal_failed(file_, "write");
    done += static_cast<std::size_t>(written);
  }
}

void StudyJournal::add_header(const StudyHeader& header) {
  append(LineJson{{"kind", "header"}, {"header", json_of(header)}}.dump());
  record_.header = header;
}

void StudyJournal::add_reference(StudySample round, double spent_s) {
  append(LineJson{{"kind", "reference"}, {"spent_s", spent_s}, {"sample", json_of(round)}}.dump());
  record_.reference.push_back(std::move(round));
  record_.spent_s = spent_s;
}

void StudyJournal::add_run(StudyRun run, double spent_s) {
  append(LineJson{
      {"kind", "run"}, {"spent_s", spent_s}, {"key", run.key}, {"sample", json_of(run.sample)}}
             .dump());
  record_.runs.push_back(std::move(run));
  record_.spent_s = spent_s;
}

void StudyJournal::add_confirmation(StudyRun run, double spent_s) {
  append(LineJson{{"kind", "confirmation"},
                  {"spent_s", spent_s},
                  {"key", run.key},
                  {"sample", json_of(run.sample)}}
             .dump());
  record_.confirmations.push_back(std::move(run));
  record_.spent_s = spent_s;
}

void StudyJournal::add_skip(StudySkip skip, double spent_s) {
  append(
      LineJson{{"kind", "skip"}, {"spent_s", spent_s}, {"key", skip.key}, {"reason", skip.reason}}
          .dump());
  record_.skips.push_back(std::move(skip));
  record_.spent_s = spent_s;
}

void StudyJournal::add_picture(StudyPicture picture, double spent_s) {
  append(LineJson{{"kind", "picture"}, {"spent_s", spent_s}, {"picture", json_of(picture)}}.dump());
  record_.pictures.push_back(std::move(picture));
  record_.spent_s = spent_s;
}

void StudyJournal::set_array_shown(std::string name) {
  append(LineJson{{"kind", "array_shown"}, {"name", name}}.dump());
  record_.array_shown = std::move(name);
}

void StudyJournal::finish(double budget_s, double spent_s,
                          const std::vector<std::string>& warnings) {
  append(LineJson{
      {"kind", "finished"}, {"spent_s", spent_s}, {"budget_s", budget_s}, {"warnings", warnings}}
             .dump(-1, ' ', false, LineJson::error_handler_t::replace));
  record_.spent_s = spent_s;
  record_.finished_budget_s = budget_s;
  record_.warnings = warnings;
}

void StudyJournal::reopen() {
  append(LineJson{{"kind", "reopened"}}.dump());
  forget_end(record_);
}

}  // namespace nadir::sim
