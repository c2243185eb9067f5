#include "sim/files/band_tables.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {

namespace {

using atmosphere::BandRun;
using atmosphere::BandSet;
using atmosphere::BandTables;
using atmosphere::EvenRun;
using atmosphere::Gas;
using atmosphere::Level;
using atmosphere::Profile;

constexpr std::array<std::string_view, atmosphere::gas_count> gas_names{
    "h2o", "co2", "o3", "n2o", "co", "ch4", "o2", "no", "so2", "no2", "nh3", "hno3"};

/// The words of a text, line by line, comments passed over.
class WordReader {
 public:
  WordReader(std::string name, std::string_view text, char separator)
      : name_{std::move(name)}, rest_{text}, separator_{separator} {}

  /// The next word of the current line; empty at its end.
  [[nodiscard]] std::string_view word() {
    while (!line_.empty() && line_.front() == ' ') line_.remove_prefix(1);
    const std::size_t end = std::min(line_.find(separator_), line_.size());
    const std::string_view found = line_.substr(0, end);
    line_.remove_prefix(std::min(end + 1, line_.size()));
    return found;
  }
  /// On to the next line that says something; false at the end of the text.
  [[nodiscard]] bool next_line() {
    while (!rest_.empty()) {
      whole_ = line_ = take_line(rest_);
      ++number_;
      if (!line_.empty() && line_.front() != '#') return true;
    }
    return false;
  }
  [[nodiscard]] bool line_ended() {
    while (!line_.empty() && line_.front() == ' ') line_.remove_prefix(1);
    return line_.empty();
  }
  [[nodiscard]] double number() {
    const std::string_view text = word();
    const auto value = strict_number_in<double>(text);
    if (!value) fail("expected a finite number, found \"" + std::string{text} + "\"", text);
    return *value;
  }
  [[noreturn]] void fail(const std::string& message, std::string_view at = {}) const {
    const int column = at.empty() ? 0 : static_cast<int>(at.data() - whole_.data()) + 1;
    throw InputError{InputIssue{{name_, number_, column}, message, {}, std::string{whole_}}};
  }

 private:
  std::string name_;
  std::string_view rest_, line_, whole_;
  char separator_;
  int number_ = 0;
};

Gas gas_of(const WordReader& words, std::string_view name) {
  const auto found = std::find(gas_names.begin(), gas_names.end(), name);
  if (found == gas_names.end()) words.fail("unknown gas \"" + std::string{name} + "\"", name);
  return static_cast<Gas>(found - gas_names.begin());
}

/// Calls `use` with the name and the figures of every run of a file.
void read_runs(const std::filesystem::path& file,
               const std::function<void(const WordReader&, std::string_view, EvenRun)>& use) {
  const std::string text = read_bytes(file);
  WordReader words{file.string(), text, ' '};
  while (words.next_line()) {
    if (words.word() != "run") words.fail("expected \"run NAME FIRST STEP COUNT\"");
    const std::string_view name = words.word();
    EvenRun run{words.number(), words.number(), {}};
    const double count = words.number();
    if (!(run.first >= 0.0) || !(run.step > 0.0) || !(count >= 2.0 && count <= 1e5)) {
      words.fail("a run begins at 0 or above, has a step above 0 and 2 to 100000 figures");
    }
    run.values.reserve(static_cast<std::size_t>(count));
    while (static_cast<double>(run.values.size()) < count) {
      if (words.line_ended() && !words.next_line()) words.fail("the file ends within a run");
      run.values.push_back(words.number());
    }
    if (!words.line_ended()) words.fail("more figures than the run says");
    use(words, name, std::move(run));
  }
}

std::vector<BandSet> read_sets(const std::filesystem::path& file) {
  const std::string text = read_bytes(file);
  WordReader words{file.string(), text, ','};
  std::vector<BandSet> sets;
  if (!words.next_line()) words.fail("the file is empty");
  while (words.next_line()) {  // below the names of the columns
    BandSet set;
    set.gas = gas_of(words, words.word());
    set.number = static_cast<int>(words.number());
    set.a = words.number();
    set.n = words.number();
    set.m = words.number();
    for (double& k : set.k) k = words.number();
    for (double& weight : set.weight) weight = words.number();
    if (!words.line_ended()) words.fail("too many cells");
    if (!(set.a > 0.0 && set.a <= 1.0)) words.fail("the exponent a must lie above 0 and up to 1");
    double sum = 0.0;
    for (const double weight : set.weight) sum += weight;
    if (!(sum > 0.999 && sum < 1.001)) words.fail("the weights do not sum to 1");
    for (double& weight : set.weight) weight /= sum;  // their rounding
    sets.push_back(set);
  }
  return sets;
}

std::vector<BandRun> read_bands(const std::filesystem::path& file,
                                const std::vector<BandSet>& sets) {
  std::vector<BandRun> bands;
  read_runs(file, [&](const WordReader& words, std::string_view name, EvenRun run) {
    const std::size_t slash = std::min(name.find('/'), name.size());
    const auto number = strict_number_in<int>(name.substr(std::min(slash + 1, name.size())));
    const Gas gas = gas_of(words, name.substr(0, slash));
    const auto set = std::find_if(sets.begin(), sets.end(), [&](const BandSet& s) {
      return number && s.gas == gas && s.number == *number;
    });
    if (set == sets.end()) words.fail("no set \"" + std::string{name} + "\" in gas_sets.csv");
    bands.push_back({static_cast<int>(set - sets.begin()), std::move(run)});
  });
  return bands;
}

void read_continua(const std::filesystem::path& file, BandTables& tables) {
  const std::map<std::string_view, EvenRun*> known{
      {"h2o/self296", &tables.self_296},    {"h2o/self260", &tables.self_260},
      {"h2o/foreign", &tables.foreign},     {"n2/continuum", &tables.nitrogen},
      {"o2/strength", &tables.oxygen},      {"o2/per_k", &tables.oxygen_per_k},
      {"o2/per_k2", &tables.oxygen_per_k2}, {"o3/visible", &tables.ozone_visible},
      {"o3/c0", &tables.ozone_c0},          {"o3/c1", &tables.ozone_c1},
      {"o3/c2", &tables.ozone_c2},          {"o3/far", &tables.ozone_far}};
  read_runs(file, [&](const WordReader& words, std::string_view name, EvenRun run) {
    if (name == "hno3/bands") {
      tables.nitric_acid.push_back(std::move(run));
      return;
    }
    const auto found = known.find(name);
    if (found == known.end()) words.fail("unknown run \"" + std::string{name} + "\"");
    if (!found->second->values.empty()) words.fail("a run is there twice");
    *found->second = std::move(run);
  });
  for (const auto& [name, run] : known) {
    if (run->values.empty()) {
      throw InputError{InputIssue{
          {file.string(), 0, 0}, "the run \"" + std::string{name} + "\" is missing", {}, {}}};
    }
  }
}

std::vector<Profile> read_profiles(const std::filesystem::path& file) {
  const std::string text = read_bytes(file);
  WordReader words{file.string(), text, ','};
  std::vector<Profile> profiles;
  if (!words.next_line()) words.fail("the file is empty");
  while (words.next_line()) {  // below the names of the columns
    const std::string name{words.word()};
    if (profiles.empty() || profiles.back().name != name) profiles.push_back({name, {}, 500.0});
    Level level{words.number(), words.number(), words.number(), {}};
    for (double& ppmv : level.ppmv) ppmv = words.number();
    if (!words.line_ended()) words.fail("too many cells");
    profiles.back().levels.push_back(level);
  }
  for (const Profile& profile : profiles) check(profile);
  return profiles;
}

}  // namespace

BandTables read_band_tables(const std::filesystem::path& folder) {
  BandTables tables;
  tables.sets = read_sets(folder / "gas_sets.csv");
  tables.bands = read_bands(folder / "gas_bands.txt", tables.sets);
  read_continua(folder / "gas_continua.txt", tables);
  tables.standard = read_profiles(folder / "standard_profiles.csv");
  return tables;
}

}  // namespace nadir::sim
