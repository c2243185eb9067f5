#include "sim/files/number_table.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace nadir::sim {

NumberTable::NumberTable(std::string_view text, const std::string& name,
                         std::vector<NumberColumn> known)
    : known_{std::move(known)} {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  FileIssues issues{name};
  int line = 0;
  const Cells header = next_row(text, line);
  if (header.empty()) issues.add("the table is empty: its first row names the columns");
  read_header(header, issues);
  issues.throw_if_any();  // without sound columns every row would be a mistake
  for (Cells cells = next_row(text, line); !cells.empty(); cells = next_row(text, line)) {
    read_row(cells, issues);
  }
  issues.throw_if_any();
  if (rows_.empty()) issues.add("the table has no rows");
  issues.throw_if_any();
}

/// The cells of the next line that holds any; none at the end.
NumberTable::Cells NumberTable::next_row(std::string_view& rest, int& line) {
  while (!rest.empty()) {
    const std::string_view whole = take_line(rest);
    ++line;
    const std::string_view content = without_blanks(whole);
    if (content.empty() || content.front() == '#') continue;
    return cells_of(whole, line);
  }
  return {};
}

NumberTable::Cells NumberTable::cells_of(std::string_view whole, int line) {
  Cells cells;
  for (std::size_t begin = 0; begin <= whole.size();) {
    const std::size_t end = std::min(whole.find(',', begin), whole.size());
    std::string_view text = without_blanks(whole.substr(begin, end - begin));
    if (text.empty()) text = whole.substr(begin, 0);  // keeps its place
    cells.push_back({text, whole, line});
    begin = end + 1;
  }
  return cells;
}

void NumberTable::read_header(const Cells& cells, FileIssues& issues) {
  if (!cells.empty()) header_ = cells.front();
  std::vector<std::string> names;
  for (const NumberColumn& column : known_) names.push_back(column.name);
  for (const Token& cell : cells) {
    const std::string name{cell.text};
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      const std::string nearest = nearest_name(name, names);
      issues.add(cell, "unknown column \"" + name + "\"",
                 nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
    } else if (has(name)) {
      issues.add(cell, "the column \"" + name + "\" is there twice");
    }
    columns_.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  for (const NumberColumn& column : known_) {
    if (cells.empty() || !column.required || has(column.name)) continue;
    issues.add(cells.front(), "the column \"" + column.name + "\" is missing");
  }
}

void NumberTable::read_row(const Cells& cells, FileIssues& issues) {
  if (cells.size() != columns_.size()) {
    issues.add(cells.front(), "expected " + std::to_string(columns_.size()) + " cells, found " +
                                  std::to_string(cells.size()));
    return;
  }
  Row row{cells.front().line, {}, cells.front().line_text};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    row.values.push_back(number(cells[i], known_[columns_[i]], issues));
  }
  rows_.push_back(std::move(row));
}

double NumberTable::number(const Token& cell, const NumberColumn& column,
                           FileIssues& issues) const {
  if (column.read) {
    try {
      return column.read(cell.text);
    } catch (const InputError& error) {
      issues.add(cell, column.name + ": " + error.issues().front().message);
      return 0.0;
    }
  }
  const auto value = strict_number_in<double>(cell.text);
  if (!value) {
    issues.add(cell, "expected a finite number for " + column.name + ", found \"" +
                         std::string{cell.text} + "\"");
  } else if (*value < column.min || *value > column.max) {
    issues.add(cell, column.name + " must lie from " + nadir::number_text(column.min) + " to " +
                         nadir::number_text(column.max));
  }
  return value.value_or(0.0);
}

bool NumberTable::has(std::string_view column) const noexcept {
  return std::any_of(columns_.begin(), columns_.end(), [&](std::size_t index) {
    return index < known_.size() && known_[index].name == column;
  });
}

double NumberTable::value(const Row& row, std::string_view column, double otherwise) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (known_[columns_[i]].name == column) return row.values[i];
  }
  return otherwise;
}

Token NumberTable::cell(const Row& row, std::string_view column) const {
  const Cells cells = cells_of(row.text, row.line);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (known_[columns_[i]].name == column) return cells[i];
  }
  return cells.front();
}

}  // namespace nadir::sim
