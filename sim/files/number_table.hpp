#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/text_tokens.hpp"

namespace nadir::sim {

/// A column that a table of numbers may have.
struct NumberColumn {
  std::string name;
  bool required = false;
  double min = -1e300, max = 1e300;
  /// Of cells that are no plain numbers (moments); throws InputError for what it does not know.
  std::function<double(std::string_view)> read{};
};

/// A CSV table of numbers: the first row names the columns, in any order. Blank lines and lines
/// that start with # are passed over.
class NumberTable {
 public:
  /// @throws InputError with every mistake of the text, each with line and column; a table without
  ///         a row is a mistake as well
  NumberTable(std::string_view text, const std::string& name, std::vector<NumberColumn> known);

  struct Row {
    int line = 0;
    std::vector<double> values;  ///< in the order of the file's columns
    std::string_view text{};     ///< of the whole line, in the text that was read
  };
  [[nodiscard]] const std::vector<Row>& rows() const noexcept { return rows_; }
  [[nodiscard]] bool has(std::string_view column) const noexcept;
  /// The row's value in that column, or `otherwise` where the table has none.
  [[nodiscard]] double value(const Row& row, std::string_view column, double otherwise) const;
  /// Where the row's value stands, for messages, as long as the text lives; the row's beginning for
  /// a column that the table lacks.
  [[nodiscard]] Token cell(const Row& row, std::string_view column) const;
  /// The first name in the row of names.
  [[nodiscard]] const Token& header() const noexcept { return header_; }

 private:
  using Cells = std::vector<Token>;

  [[nodiscard]] static Cells next_row(std::string_view& rest, int& line);
  [[nodiscard]] static Cells cells_of(std::string_view whole, int line);
  void read_header(const Cells& cells, FileIssues& issues);
  void read_row(const Cells& cells, FileIssues& issues);
  [[nodiscard]] double number(const Token& cell, const NumberColumn& column,
                              FileIssues& issues) const;

  std::vector<NumberColumn> known_;
  std::vector<std::size_t> columns_;  // of the file: index into known_
  std::vector<Row> rows_;
  Token header_;
};

}  // namespace nadir::sim
