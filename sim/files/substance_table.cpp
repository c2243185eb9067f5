#include "sim/files/substance_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/text.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

enum class SubstanceColumn {
  substance,
  conductivity,
  density,
  specific_heat,
  solar_absorptance,
  emissivity,
  checked,
  source
};

struct SubstanceRule {
  SubstanceColumn column;
  const char* name;
  bool required;
  double min = 0.0, max = 0.0;  ///< of numbers
};

/// What matter can have, with room on both sides: aerogel to diamond, aerogel to osmium, lead to
/// hydrogen.
constexpr std::array<SubstanceRule, 8> substance_columns{{
    {SubstanceColumn::substance, "substance", true},
    {SubstanceColumn::conductivity, "conductivity_w_m_k", true, 1e-3, 5e3},
    {SubstanceColumn::density, "density_kg_m3", true, 0.5, 25e3},
    {SubstanceColumn::specific_heat, "specific_heat_j_kg_k", true, 50.0, 20e3},
    {SubstanceColumn::solar_absorptance, "solar_absorptance", false, 0.0, 1.0},
    {SubstanceColumn::emissivity, "emissivity", false, 0.0, 1.0},
    {SubstanceColumn::checked, "checked", false},
    {SubstanceColumn::source, "source", false},
}};

struct TableCell {
  Token at;          ///< quotation marks included
  std::string text;  ///< without them
};

/// Takes the next cell off `rest`, which is a part of `line`.
TableCell take_cell(std::string_view& rest, const Token& line, FileIssues& issues) {
  const std::string_view start = rest.substr(std::min(rest.find_first_not_of(" \t"), rest.size()));
  if (start.empty() || start.front() != '"') {
    const std::size_t end = std::min(rest.find(','), rest.size());
    const std::string_view whole = rest.substr(0, end), text = without_blanks(whole);
    rest.remove_prefix(end);
    return {{text.empty() ? whole.substr(0, 0) : text, line.line_text, line.line},
            std::string{text}};
  }
  TableCell cell{{start, line.line_text, line.line}, {}};
  std::size_t i = 1;
  for (; i < start.size(); ++i) {
    if (start[i] == '"' && (i + 1 == start.size() || start[i + 1] != '"')) break;
    if (start[i] == '"') ++i;  // two of them stand for one
    cell.text += start[i];
  }
  if (i >= start.size()) issues.add(cell.at, "the quotation mark is not closed on its line");
  rest = start.substr(std::min(i + 1, start.size()));
  cell.at.text = start.substr(0, start.size() - rest.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  if (!rest.empty() && rest.front() != ',') {
    issues.add({rest.substr(0, 1), line.line_text, line.line},
               "expected a comma after the quotation mark");
    rest = {};
  }
  return cell;
}

std::vector<TableCell> quoted_cells(const Token& line, FileIssues& issues) {
  std::vector<TableCell> cells;
  std::string_view rest = line.line_text;
  cells.push_back(take_cell(rest, line, issues));
  while (!rest.empty()) {
    rest.remove_prefix(1);  // the comma
    cells.push_back(take_cell(rest, line, issues));
  }
  return cells;
}

/// Layers name substances in XML and on command lines: one plain word each.
bool is_plain_name(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-' || c == '.';
  });
}

class SubstanceReader {
 public:
  SubstanceReader(std::string_view text, const std::string& name) : rest_{text}, issues_{name} {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  SubstanceTable read() {
    while (const auto line = next()) {
      const std::vector<TableCell> cells = quoted_cells(*line, issues_);
      if (columns_.empty()) {
        read_names(cells);
        issues_.throw_if_any();  // without sound columns every row would be a mistake
      } else if (cells.size() != columns_.size()) {
        issues_.add(cells.front().at, "expected " + std::to_string(columns_.size()) +
                                          " cells, found " + std::to_string(cells.size()));
      } else {
        read_row(cells);
      }
    }
    if (columns_.empty()) issues_.add("the table is empty: its first row names the columns");
    if (!columns_.empty() && table_.empty()) issues_.add("the table has no rows");
    issues_.throw_if_any();
    return std::move(table_);
  }

 private:
  std::optional<Token> next() {
    while (!rest_.empty()) {
      const std::string_view line = take_line(rest_);
      ++number_;
      const std::string_view content = without_blanks(line);
      if (!content.empty() && content.front() != '#') return Token{content, line, number_};
    }
    return std::nullopt;
  }

  void read_names(const std::vector<TableCell>& cells) {
    std::vector<std::string> known;
    for (const SubstanceRule& rule : substance_columns) known.emplace_back(rule.name);
    for (const TableCell& cell : cells) {
      const auto found = std::find(known.begin(), known.end(), cell.text);
      if (found == known.end()) {
        const std::string nearest = nearest_name(cell.text, known);
        issues_.add(cell.at, "unknown column " + in_quotes(cell.text),
                    nearest.empty() ? "" : "did you mean " + in_quotes(nearest) + "?");
        columns_.push_back(nullptr);
        continue;
      }
      const SubstanceRule* rule =
          &substance_columns[static_cast<std::size_t>(found - known.begin())];
      if (std::count(columns_.begin(), columns_.end(), rule) > 0) {
        issues_.add(cell.at, "the column " + in_quotes(cell.text) + " is there twice");
      }
      columns_.push_back(rule);
    }
    for (const SubstanceRule& rule : substance_columns) {
      if (!rule.required || std::count(columns_.begin(), columns_.end(), &rule) > 0) continue;
      issues_.add(cells.front().at, "the column " + in_quotes(rule.name) + " is missing");
    }
  }

  void read_row(const std::vector<TableCell>& cells) {
    std::string name;
    ListedSubstance listed;
    for (std::size_t i = 0; i < cells.size(); ++i) read_cell(*columns_[i], cells[i], name, listed);
    const TableCell& at = cells[name_column()];
    if (!is_plain_name(name)) {
      issues_.add(at.at, "expected the name of a substance: letters, digits, \"_\", \"-\", \".\"");
    } else if (!table_.emplace(name, std::move(listed)).second) {
      issues_.add(at.at, "the substance " + in_quotes(name) + " is there twice");
    }
  }

  [[nodiscard]] std::size_t name_column() const {
    return static_cast<std::size_t>(
        std::find(columns_.begin(), columns_.end(), &substance_columns.front()) - columns_.begin());
  }

  void read_cell(const SubstanceRule& rule, const TableCell& cell, std::string& name,
                 ListedSubstance& listed) {
    switch (rule.column) {
      case SubstanceColumn::substance:
        name = cell.text;
        break;
      case SubstanceColumn::conductivity:
        listed.substance.conductivity_w_m_k = number(rule, cell);
        break;
      case SubstanceColumn::density:
        listed.substance.density_kg_m3 = number(rule, cell);
        break;
      case SubstanceColumn::specific_heat:
        listed.substance.specific_heat_j_kg_k = number(rule, cell);
        break;
      case SubstanceColumn::solar_absorptance:
        if (!cell.text.empty()) listed.solar_absorptance = number(rule, cell);
        break;
      case SubstanceColumn::emissivity:
        if (!cell.text.empty()) listed.emissivity = number(rule, cell);
        break;
      case SubstanceColumn::checked:
        listed.checked = cell.text;
        break;
      case SubstanceColumn::source:
        listed.source = cell.text;
        break;
    }
  }

  double number(const SubstanceRule& rule, const TableCell& cell) {
    const auto value = strict_number_in<double>(cell.text);
    if (!value) {
      issues_.add(cell.at, std::string{"expected a finite number for "} + rule.name + ", found " +
                               in_quotes(cell.text));
    } else if (*value < rule.min || *value > rule.max) {
      issues_.add(cell.at, std::string{rule.name} + " must lie from " + number_text(rule.min) +
                               " to " + number_text(rule.max));
    }
    return value.value_or(0.0);
  }

  std::string_view rest_;
  FileIssues issues_;
  int number_ = 0;
  std::vector<const SubstanceRule*> columns_;  // of the file, in its order
  SubstanceTable table_;
};

/// Text as a cell, in quotation marks where it needs them.
std::string as_cell(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted{'"'};
  for (const char c : text) quoted += c == '"' ? std::string{"\"\""} : std::string{c};
  return quoted + '"';
}

std::string as_cell(const std::optional<double>& value) {
  return value ? number_text(*value) : std::string{};
}

}  // namespace

SubstanceTable parse_substances(std::string_view text, const std::string& name) {
  return SubstanceReader{text, name}.read();
}

SubstanceTable read_substances(const std::filesystem::path& file) {
  const std::string text = read_bytes(file);
  return parse_substances(text, file.string());
}

const ListedSubstance& find_substance(const SubstanceTable& table, const std::string& substance,
                                      const SourceLocation& where) {
  const auto found = table.find(substance);
  if (found != table.end()) return found->second;
  std::vector<std::string> names;
  std::string all;
  for (const auto& [name, unused] : table) {
    names.push_back(name);
    all += (all.empty() ? "known are: " : ", ") + name;
  }
  const std::string nearest = nearest_name(substance, names);
  throw InputError{InputIssue{where,
                              "there is no substance " + in_quotes(substance) + " in the table",
                              nearest.empty() ? all : "did you mean " + in_quotes(nearest) + "?",
                              {}}};
}

std::string substances_text(const SubstanceTable& table, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) text += "# " + comment + "\n";
  for (const SubstanceRule& rule : substance_columns) {
    text += (rule.column == SubstanceColumn::substance ? "" : ",") + std::string{rule.name};
  }
  text += "\n";
  for (const auto& [name, row] : table) {
    text += name + "," + number_text(row.substance.conductivity_w_m_k) + "," +
            number_text(row.substance.density_kg_m3) + "," +
            number_text(row.substance.specific_heat_j_kg_k) + "," + as_cell(row.solar_absorptance) +
            "," + as_cell(row.emissivity) + "," + as_cell(row.checked) + "," + as_cell(row.source) +
            "\n";
  }
  return text;
}

}  // namespace nadir::sim
