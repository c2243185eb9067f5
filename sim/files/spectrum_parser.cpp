#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "sim/files/spectrum_format.hpp"

namespace nadir::sim {
namespace {

using namespace spectrum_format;

struct KeyEntry {
  std::string_view name;
  bool required;
  bool repeats;
};
constexpr std::array<KeyEntry, 11> key_table{{
    {"nadir-spectrum", true, false},
    {"title", true, false},
    {"quantity", true, false},
    {"unit", true, false},
    {"wavelength", true, false},
    {"source", true, true},
    {"licence", true, true},
    {"made-by", false, false},
    {"extended", false, true},
    {"thinned", false, true},
    {"note", false, true},
}};

constexpr std::string_view spectrum_version_line = "# nadir-spectrum:";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
// A file of another kind has a mistake on every line; a hundred of them say so well enough.
constexpr std::size_t most_mistakes = 100;

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Part of a line, with the place where it starts.
struct Cell {
  std::string_view text;
  int column = 1;
};

std::vector<Cell> split_at_commas(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const std::string_view raw = line.substr(begin, end - begin);
    const std::string_view text = trim(raw);
    const std::size_t indent =
        text.empty() ? 0 : static_cast<std::size_t>(text.data() - raw.data());
    cells.push_back({text, static_cast<int>(begin + indent) + 1});
    begin = end + 1;
  }
  return cells;
}

std::vector<Cell> split_at_blanks(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t begin = line.find_first_not_of(" \t"); begin < line.size();) {
    const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    cells.push_back({line.substr(begin, end - begin), static_cast<int>(begin) + 1});
    begin = line.find_first_not_of(" \t", end);
  }
  return cells;
}

/// The whole token as a finite number.
std::optional<double> strict_number(std::string_view token) {
  double value = 0.0;
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

template <class Table>
std::vector<std::string> names_in(const Table& table) {
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const auto& entry : table) names.emplace_back(entry.name);
  return names;
}

/// Reads one file, line by line, and remembers every mistake.
class SpectrumParser {
 public:
  SpectrumParser(std::string_view text, const std::string& path,
                 std::optional<SpectrumQuantity> plain_as)
      : text_{text}, plain_as_{plain_as} {
    file_.path = path;
    if (text_.substr(0, byte_order_mark.size()) == byte_order_mark) {
      text_.remove_prefix(byte_order_mark.size());
    }
    plain_ = text_.substr(0, spectrum_version_line.size()) != spectrum_version_line;
  }

  SpectrumFile parse() {
    while (issues_.size() < most_mistakes && next_line()) read_line();
    if (issues_.size() < most_mistakes) finish();
    if (issues_.size() >= most_mistakes) add(0, "too many mistakes; reading stopped here");
    if (!issues_.empty()) throw InputError{std::move(issues_)};
    return std::move(file_);
  }

 private:
  void read_line() {
    if (trim(line_).empty()) return;
    if (line_.front() == '#') {
      if (!plain_) read_header_line();
    } else if (!have_names_) {
      if (!plain_) check_header();
      read_names();
    } else {
      read_row();
    }
  }

  bool next_line() {
    if (position_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    line_ = text_.substr(position_, end - position_);
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    position_ = end + 1;
    ++line_number_;
    return true;
  }

  /// Column 0: about the whole file.
  void add(int column, std::string message, std::string hint = {}) {
    InputIssue issue{{file_.path, 0, 0}, std::move(message), std::move(hint), {}};
    if (column > 0) {
      issue.where.line = line_number_;
      issue.where.column = column;
      issue.source_line = std::string{line_};
    }
    issues_.push_back(std::move(issue));
  }

  void read_header_line() {
    if (have_names_) return add(1, "a header line must stand above the row of column names");
    const std::size_t colon = line_.find(':');
    const std::string key{trim(line_.substr(1, std::min(colon, line_.size()) - 1))};
    const int key_column = static_cast<int>(line_.find_first_not_of("# \t")) + 1;
    if (colon == std::string_view::npos) {
      return add(1, "expected a header line \"# key: value\"");
    }
    const auto* known = std::find_if(key_table.begin(), key_table.end(),
                                     [&](const KeyEntry& entry) { return entry.name == key; });
    if (known == key_table.end()) {
      return add(std::max(1, key_column), "unknown header key " + in_quotes(key),
                 did_you_mean(key, names_in(key_table)));
    }
    const std::string_view value = trim(line_.substr(colon + 1));
    if (value.empty()) return add(key_column, "header key " + in_quotes(key) + " has no value");
    const bool repeated = std::find(seen_.begin(), seen_.end(), key) != seen_.end();
    if (repeated && !known->repeats) {
      return add(key_column, "header key " + in_quotes(key) + " is given twice");
    }
    seen_.push_back(key);
    value_column_ = static_cast<int>(value.data() - line_.data()) + 1;
    keep(key, std::string{value});
  }

  static void append(std::string& text, const std::string& more) {
    text += (text.empty() ? "" : "; ") + more;
  }

  void keep(const std::string& key, const std::string& value) {
    if (key == "nadir-spectrum" && value != "1") {
      add(value_column_, "version " + in_quotes(value) + " of the format is not known; expected 1");
    } else if (key == "title") {
      file_.title = value;
    } else if (key == "quantity") {
      keep_quantity(value);
    } else if (key == "unit") {
      keep_unit(value);
    } else if (key == "wavelength" && value != "um, vacuum") {
      add(value_column_, "wavelength is " + in_quotes(value) + "; expected \"um, vacuum\"");
    } else if (key == "source") {
      append(file_.source, value);
    } else if (key == "licence") {
      append(file_.licence, value);
    } else if (key == "made-by") {
      file_.made_by = value;
    } else if (key == "extended" || key == "thinned" || key == "note") {
      file_.notes.push_back(key + ": " + value);
    }
  }

  void keep_quantity(const std::string& value) {
    for (const QuantityEntry& entry : quantity_table) {
      if (entry.name == value) file_.quantity = entry.quantity;
    }
    if (!file_.quantity) {
      return add(value_column_, "unknown quantity " + in_quotes(value),
                 did_you_mean(value, names_in(quantity_table)));
    }
    if (!file_.unit.empty()) check_unit();
  }

  void keep_unit(const std::string& value) {
    file_.unit = value;
    if (file_.quantity) check_unit();
  }

  void check_unit() {
    const std::string_view expected = unit_of(*file_.quantity);
    if (file_.unit == expected) return;
    add(value_column_, "the unit of " + std::string{name_of(*file_.quantity)} + " is " +
                           in_quotes(file_.unit) + "; expected " + in_quotes(expected));
  }

  void check_header() {
    for (const KeyEntry& entry : key_table) {
      const bool seen = std::find(seen_.begin(), seen_.end(), entry.name) != seen_.end();
      if (entry.required && !seen) {
        add(0, "header line \"# " + std::string{entry.name} + ": ...\" is missing");
      }
    }
  }

  [[nodiscard]] std::vector<Cell> cells() const {
    return blanks_ ? split_at_blanks(line_) : split_at_commas(line_);
  }

  void read_names() {
    have_names_ = true;
    blanks_ = plain_ && line_.find(',') == std::string_view::npos;
    const std::vector<Cell> names = cells();
    read_wavelength_name(names.front());
    if (names.size() < 2) add(1, "expected at least one column beside the wavelength");
    for (std::size_t i = 1; i < names.size(); ++i) add_column(names[i]);
  }

  void read_wavelength_name(const Cell& cell) {
    if (cell.text == "wavelength_nm" && plain_) {
      to_um_ = 1e-3;
    } else if (cell.text != "wavelength_um") {
      add(cell.column,
          std::string{"expected a row of column names that starts with \"wavelength_um\""} +
              (plain_ ? " or \"wavelength_nm\"" : "") + ", found " + in_quotes(cell.text));
    }
  }

  void add_column(const Cell& cell) {
    const std::vector<std::string> known = file_.column_names();
    if (cell.text.empty()) {
      add(cell.column, "a column has no name");
    } else if (cell.text.find('#') != std::string_view::npos) {
      add(cell.column, "column name " + in_quotes(cell.text) + " must not hold \"#\"");
    } else if (std::find(known.begin(), known.end(), cell.text) != known.end()) {
      add(cell.column, "column name " + in_quotes(cell.text) + " is given twice");
    }
    file_.columns.push_back({std::string{cell.text}, {}, {}});
  }

  void read_row() {
    const std::vector<Cell> row = cells();
    const std::size_t expected = file_.columns.size() + 1;
    if (row.size() != expected) {
      return add(1, "expected " + std::to_string(expected) + " cells, found " +
                        std::to_string(row.size()));
    }
    const std::optional<double> wavelength_um = read_wavelength(row.front());
    for (std::size_t i = 1; i < row.size(); ++i) {
      if (row[i].text.empty()) continue;
      const std::optional<double> value = read_value(row[i], file_.columns[i - 1].name);
      if (!value || !wavelength_um) continue;
      file_.columns[i - 1].wavelength_um.push_back(*wavelength_um);
      file_.columns[i - 1].value.push_back(*value);
    }
  }

  std::optional<double> read_wavelength(const Cell& cell) {
    const std::optional<double> number = strict_number(cell.text);
    if (!number || *number <= 0.0) {
      add(cell.column, "wavelength is " + in_quotes(cell.text) + "; expected a positive number");
      return std::nullopt;
    }
    const double wavelength_um = *number * to_um_;
    if (wavelength_um <= last_um_) {
      add(cell.column, "wavelength " + std::string{cell.text} +
                           " is not greater than the one before it; rows must ascend");
      return std::nullopt;
    }
    last_um_ = wavelength_um;
    return wavelength_um;
  }

  std::optional<double> read_value(const Cell& cell, const std::string& column) {
    const std::optional<double> value = strict_number(cell.text);
    if (!value) {
      add(cell.column, column + " is " + in_quotes(cell.text) + "; expected a number");
      return std::nullopt;
    }
    const std::optional<SpectrumQuantity> checked = plain_ ? plain_as_ : file_.quantity;
    if (!checked || *checked == SpectrumQuantity::parameter) return value;
    const bool at_most_one = entry_of(*checked).at_most_one;
    if (*value < 0.0 || (at_most_one && *value > 1.0)) {
      add(cell.column, column + " is " + std::string{cell.text} + "; " +
                           std::string{name_of(*checked)} +
                           (at_most_one ? " is from 0 to 1" : " is never negative"));
    }
    return value;
  }

  void finish() {
    if (!have_names_) {
      if (!plain_) check_header();
      return add(0, "the file has no row of column names");
    }
    if (!issues_.empty()) return;  // a column that lost its rows to mistakes is no news
    for (const SpectrumColumn& column : file_.columns) {
      if (column.value.size() >= 2) continue;
      add(0, "column " + in_quotes(column.name) + " has " + std::to_string(column.value.size()) +
                 " values; expected at least 2");
    }
  }

  std::string_view text_;
  std::optional<SpectrumQuantity> plain_as_;
  SpectrumFile file_;
  std::vector<InputIssue> issues_;
  std::vector<std::string> seen_;
  std::string_view line_;
  std::size_t position_ = 0;
  int line_number_ = 0;
  int value_column_ = 1;
  double to_um_ = 1.0;
  double last_um_ = 0.0;
  bool plain_ = false;
  bool blanks_ = false;
  bool have_names_ = false;
};

}  // namespace

SpectrumFile parse_spectrum(std::string_view text, const std::string& path,
                            std::optional<SpectrumQuantity> plain_as) {
  return SpectrumParser{text, path, plain_as}.parse();
}

}  // namespace nadir::sim
