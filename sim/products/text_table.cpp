#include "sim/products/text_table.hpp"

#include <algorithm>

namespace nadir::sim {
namespace {

constexpr std::size_t table_gap = 2;
constexpr std::size_t least_last_column = 20;

using CellLines = std::vector<std::string>;

std::vector<std::size_t> column_widths(const std::vector<TextColumn>& columns,
                                       const std::vector<std::vector<std::string>>& rows,
                                       std::size_t width) {
  std::vector<std::size_t> widths;
  std::size_t used = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::size_t widest = columns[i].head.size();
    for (const auto& row : rows) {
      for (const std::string& line : broken_at_spaces(row[i], columns[i].most_width)) {
        widest = std::max(widest, line.size());
      }
    }
    widths.push_back(widest);
    if (i + 1 < columns.size()) used += widest + table_gap;
  }
  const std::size_t left = width > used ? width - used : 0;
  if (!widths.empty()) {
    widths.back() = std::min(widths.back(), std::max(left, least_last_column));
  }
  return widths;
}

std::string padded(const std::string& text, const TextColumn& column, std::size_t width) {
  const std::string space(width > text.size() ? width - text.size() : 0, ' ');
  return column.to_the_right ? space + text : text + space;
}

void add_table_row(const std::vector<std::string>& row, const std::vector<TextColumn>& columns,
                   const std::vector<std::size_t>& widths, std::string& text) {
  std::vector<CellLines> cells;
  std::size_t height = 1;
  for (std::size_t i = 0; i < row.size(); ++i) {
    cells.push_back(broken_at_spaces(row[i], widths[i]));
    height = std::max(height, cells.back().size());
  }
  for (std::size_t k = 0; k < height; ++k) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0) line += std::string(table_gap, ' ');
      line += padded(k < cells[i].size() ? cells[i][k] : "", columns[i], widths[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
}

}  // namespace

std::vector<std::string> broken_at_spaces(const std::string& text, std::size_t width) {
  if (width == 0 || text.size() <= width) return {text};
  std::vector<std::string> lines(1);
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    std::string& line = lines.back();
    if (line.empty()) {
      line = word;
    } else if (line.size() + 1 + word.size() <= width) {
      line += " " + word;
    } else {
      lines.push_back(word);
    }
    at = end + 1;
  }
  return lines;
}

std::string text_table(const std::vector<TextColumn>& columns,
                       const std::vector<std::vector<std::string>>& rows, std::size_t width) {
  const auto widths = column_widths(columns, rows, width);
  std::string text;
  std::vector<std::string> heads;
  for (const TextColumn& column : columns) heads.push_back(column.head);
  add_table_row(heads, columns, widths, text);
  for (const auto& row : rows) add_table_row(row, columns, widths, text);
  return text;
}

}  // namespace nadir::sim
