#include "sim/files/particle_tables.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/quantity.hpp"
#include "core/text.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

using atmosphere::ParticleOptics;
using atmosphere::ParticleTables;
using Cells = std::vector<Token>;

/// A section as it stands: what the columns stand for, and rows of labels and numbers.
struct Section {
  struct Row {
    Cells labels;
    std::vector<double> values;
  };
  Token at;
  std::vector<double> columns;
  std::vector<Row> rows;
};

struct SectionKind {
  std::string_view name;
  std::vector<std::string_view> labels;
  double min, max;  // of the column heads
};

const std::array<SectionKind, 4>& section_kinds() {
  static const std::array<SectionKind, 4> kinds{{{"optics", {"kind", "quantity"}, 1e-3, 1e4},
                                                 {"haze", {"profile"}, 0.0, 1e4},
                                                 {"phase_functions", {"number"}, 0.0, 180.0},
                                                 {"phase_choice", {"kind"}, 1e-3, 1e4}}};
  return kinds;
}

Cells cells_of(std::string_view line, int number) {
  Cells cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::string_view text = without_blanks(line.substr(begin, end - begin));
    if (text.empty()) text = line.substr(begin, 0);  // keeps its place
    cells.push_back({text, line, number});
    begin = end + 1;
  }
  return cells;
}

/// Text into sections of numbers.
class SectionParser {
 public:
  SectionParser(std::string_view text, FileIssues& issues) : rest_{text}, issues_{issues} {}

  std::map<std::string_view, Section> parse() {
    if (!take_line(rest_).starts_with("# nadir-particles: 1")) {
      issues_.add("expected a first line \"# nadir-particles: 1\"");
      issues_.throw_if_any();
    }
    for (int number = 2; !rest_.empty(); ++number) {
      const std::string_view line = take_line(rest_);
      const std::string_view content = without_blanks(line);
      if (content.empty() || content.front() == '#') continue;
      if (content.front() == '[') {
        begin_section({content, line, number});
      } else if (kind_ != nullptr) {
        add_row(cells_of(line, number));
      }
    }
    for (const SectionKind& kind : section_kinds()) {
      if (!sections_.contains(kind.name)) {
        issues_.add("the section [" + std::string{kind.name} + "] is missing");
      }
    }
    issues_.throw_if_any();
    return std::move(sections_);
  }

 private:
  void begin_section(const Token& head) {
    kind_ = nullptr;
    for (const SectionKind& kind : section_kinds()) {
      if (head.text == "[" + std::string{kind.name} + "]") kind_ = &kind;
    }
    if (kind_ == nullptr) {
      issues_.add(head,
                  "unknown section: they are [optics], [haze], [phase_functions] and "
                  "[phase_choice]");
    } else if (!sections_.emplace(kind_->name, Section{head, {}, {}}).second) {
      issues_.add(head, "the section is there twice");
      kind_ = nullptr;
    }
  }

  void add_row(const Cells& cells) {
    Section& section = sections_.at(kind_->name);
    const std::size_t labels = kind_->labels.size();
    if (section.columns.empty()) {
      add_columns(cells, section);
    } else if (cells.size() != labels + section.columns.size()) {
      issues_.add(cells.front(), "expected " + std::to_string(labels + section.columns.size()) +
                                     " cells, found " + std::to_string(cells.size()));
    } else {
      Section::Row row{{cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(labels)}, {}};
      for (std::size_t i = labels; i < cells.size(); ++i) row.values.push_back(number(cells[i]));
      section.rows.push_back(std::move(row));
    }
  }

  void add_columns(const Cells& cells, Section& section) {
    for (std::size_t i = 0; i < kind_->labels.size(); ++i) {
      if (i < cells.size() && cells[i].text == kind_->labels[i]) continue;
      issues_.add(cells[std::min(i, cells.size() - 1)],
                  "expected \"" + std::string{kind_->labels[i]} + "\"");
      kind_ = nullptr;  // its rows would all be mistakes
      return;
    }
    for (std::size_t i = kind_->labels.size(); i < cells.size(); ++i) {
      const double value = number(cells[i]);
      const bool ascends = section.columns.empty() || value > section.columns.back();
      if (!ascends || value < kind_->min || value > kind_->max) {
        issues_.add(cells[i], "expected a number from " + number_text(kind_->min) + " to " +
                                  number_text(kind_->max) + ", greater than the one before it");
      }
      section.columns.push_back(value);
    }
    if (section.columns.size() < 2) issues_.add(cells.back(), "expected two columns or more");
  }

  double number(const Token& cell) {
    const auto value = strict_number_in<double>(cell.text);
    if (!value || *value < -1.0) {
      issues_.add(cell,
                  "expected a number, found \"" + std::string{cell.text.substr(0, 40)} + "\"");
    }
    return value.value_or(0.0);
  }

  std::string_view rest_;
  FileIssues& issues_;
  const SectionKind* kind_ = nullptr;
  std::map<std::string_view, Section> sections_;
};

/// Sections into tables.
class TableBuilder {
 public:
  TableBuilder(const std::map<std::string_view, Section>& sections, FileIssues& issues)
      : sections_{sections}, issues_{issues} {}

  ParticleTables build() {
    optics();
    haze();
    phase_functions();
    phase_choice();
    complete();
    issues_.throw_if_any();
    return std::move(tables_);
  }

 private:
  using Column = std::vector<double> ParticleOptics::*;

  void optics() {
    const Section& section = sections_.at("optics");
    static const std::map<std::string_view, Column> quantities{
        {"extinction", &ParticleOptics::extinction},
        {"absorption", &ParticleOptics::absorption},
        {"asymmetry", &ParticleOptics::asymmetry}};
    tables_.wavelength_um = section.columns;
    for (const Section::Row& row : section.rows) {
      const auto quantity = quantities.find(row.labels[1].text);
      if (quantity == quantities.end()) {
        issues_.add(row.labels[1], "expected \"extinction\", \"absorption\" or \"asymmetry\"");
        continue;
      }
      auto& values = tables_.kinds[std::string{row.labels[0].text}].*(quantity->second);
      if (!values.empty()) issues_.add(row.labels[0], "this row is there twice");
      values = row.values;
      const bool asymmetry = quantity->first == "asymmetry";
      check(row, asymmetry ? -0.999 : 0.0, asymmetry ? 0.999 : 1e3);
    }
  }

  void haze() {
    const Section& section = sections_.at("haze");
    tables_.height_km = section.columns;
    if (section.columns.front() != 0.0) issues_.add(section.at, "heights must begin at 0 km");
    for (const Section::Row& row : section.rows) {
      check(row, 0.0, 1e6);
      if (!tables_.haze.emplace(std::string{row.labels[0].text}, row.values).second) {
        issues_.add(row.labels[0], "this row is there twice");
      }
    }
  }

  void phase_functions() {
    const Section& section = sections_.at("phase_functions");
    if (section.columns.front() != 0.0 || section.columns.back() != 180.0) {
      issues_.add(section.at, "scattering angles must reach from 0 to 180 deg");
    }
    for (const double angle : section.columns) {
      tables_.phase_angle_rad.push_back(degrees(angle).value);
    }
    for (const Section::Row& row : section.rows) {
      const auto number = strict_number_in<double>(row.labels[0].text);
      const int index = static_cast<int>(tables_.phase_functions.size());
      if (!number || !number_of_.emplace(*number, index).second) {
        issues_.add(row.labels[0], "expected a number that no other row has");
      }
      check(row, 1e-30, 1e30);
      tables_.phase_functions.push_back(row.values);
    }
  }

  void phase_choice() {
    const Section& section = sections_.at("phase_choice");
    tables_.phase_wavelength_um = section.columns;
    for (const Section::Row& row : section.rows) {
      const auto kind = tables_.kinds.find(std::string{row.labels[0].text});
      if (kind == tables_.kinds.end() || !kind->second.phase.empty()) {
        issues_.add(row.labels[0], "expected a kind of [optics], each once");
        continue;
      }
      for (const double value : row.values) kind->second.phase.push_back(chosen(row, value));
    }
  }

  int chosen(const Section::Row& row, double value) {
    const auto found = number_of_.find(value);
    if (found != number_of_.end()) return found->second;
    issues_.add(row.labels[0], "there is no phase function " + number_text(value));
    return 0;
  }

  /// What Particles looks up must be there, whole.
  void complete() {
    for (const auto& [name, optics] : tables_.kinds) {
      if (optics.extinction.empty() || optics.absorption.empty() || optics.asymmetry.empty()) {
        issues_.add("the kind \"" + name + "\" lacks extinction, absorption or asymmetry");
      }
    }
    for (const std::string& name : atmosphere::required_kinds()) {
      const auto found = tables_.kinds.find(name);
      if (found == tables_.kinds.end()) issues_.add("the kind \"" + name + "\" is missing");
    }
    for (const std::string& name : atmosphere::required_haze()) {
      if (!tables_.haze.contains(name)) issues_.add("the profile \"" + name + "\" is missing");
    }
    check_humid_pairs();
  }

  /// Haze that takes up water is interpolated between its rows: all scatter by tables, or none.
  void check_humid_pairs() {
    for (const char* const type : {"rural", "urban", "maritime", "tropospheric"}) {
      std::optional<bool> tabulated;
      for (const char* const humidity : {"_0", "_70", "_80", "_99"}) {
        const auto row = tables_.kinds.find(std::string{type} + humidity);
        if (row == tables_.kinds.end()) continue;
        const bool has = !row->second.phase.empty();
        if (tabulated.value_or(has) != has) {
          issues_.add("[phase_choice] must have all humidities of \"" + std::string{type} +
                      "\" or none");
        }
        tabulated = has;
      }
    }
  }

  void check(const Section::Row& row, double min, double max) {
    for (const double value : row.values) {
      if (value >= min && value <= max) continue;
      issues_.add(row.labels[0], "values of this row must lie from " + number_text(min) + " to " +
                                     number_text(max) + ", found " + number_text(value));
      return;
    }
  }

  const std::map<std::string_view, Section>& sections_;
  FileIssues& issues_;
  std::map<double, int> number_of_;
  ParticleTables tables_;
};

}  // namespace

ParticleTables parse_particle_tables(std::string_view text, const std::string& name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  FileIssues issues{name};
  const auto sections = SectionParser{text, issues}.parse();
  for (const auto& [section_name, section] : sections) {
    if (section.columns.size() < 2 || section.rows.empty()) {
      issues.add(section.at, "the section has no rows");
    }
  }
  issues.throw_if_any();
  return TableBuilder{sections, issues}.build();
}

ParticleTables read_particle_tables(const std::filesystem::path& file) {
  return parse_particle_tables(read_bytes(file), file.string());
}

}  // namespace nadir::sim
