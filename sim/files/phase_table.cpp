#include "sim/files/phase_table.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/quantity.hpp"
#include "core/text.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

class TableParser {
 public:
  TableParser(std::string_view text, const std::string& name) : rest_{text}, issues_{name} {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  materials::TabulatedPhase parse() {
    if (!next_row()) issues_.add("the table is empty: its first row is angle_deg and wavelengths");
    issues_.throw_if_any();
    header();
    issues_.throw_if_any();
    while (next_row()) row();
    check_ends();
    issues_.throw_if_any();
    return transposed();
  }

 private:
  bool next_row() {
    cells_.clear();
    while (cells_.empty() && !rest_.empty()) {
      const std::string_view line = take_line(rest_);
      ++line_;
      const std::string_view content = without_blanks(line);
      if (content.empty() || content.front() == '#') continue;
      for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        std::string_view text = without_blanks(line.substr(begin, end - begin));
        if (text.empty()) text = line.substr(begin, 0);  // keeps its place
        cells_.push_back({text, line, line_});
        begin = end + 1;
      }
    }
    return !cells_.empty();
  }

  void header() {
    if (cells_.front().text != "angle_deg" || cells_.size() < 2) {
      issues_.add(cells_.front(), "expected \"angle_deg\" and one or more wavelengths in um");
      return;
    }
    double last = 0.0;
    for (std::size_t i = 1; i < cells_.size(); ++i) {
      const auto um = strict_number_in<double>(cells_[i].text);
      if (!um || *um <= last) {
        issues_.add(cells_[i], "expected a wavelength in um, greater than the one before it");
      }
      last = um.value_or(last);
      table_.wavelength_um.push_back(last);
    }
  }

  void row() {
    const std::size_t expected = table_.wavelength_um.size() + 1;
    if (cells_.size() != expected) {
      issues_.add(cells_.front(), "expected " + std::to_string(expected) + " cells, found " +
                                      std::to_string(cells_.size()));
      return;
    }
    const auto angle = strict_number_in<double>(cells_.front().text);
    if (!angle || *angle < 0.0 || *angle > 180.0 ||
        (!angles_.empty() && *angle <= angles_.back())) {
      issues_.add(cells_.front(),
                  "expected an angle from 0 to 180 deg, greater than the one before it");
    }
    last_ = cells_.front();
    angles_.push_back(angle.value_or(angles_.empty() ? 0.0 : angles_.back()));
    for (std::size_t i = 1; i < cells_.size(); ++i) rows_.push_back(value(cells_[i]));
  }

  double value(const Token& cell) {
    const auto number = strict_number_in<double>(cell.text);
    if (cell.text.empty()) {
      issues_.add(cell, "a phase table has no holes: expected a number");
    } else if (!number || *number < 0.0) {
      issues_.add(cell, "expected a number that is not negative, found \"" +
                            std::string{cell.text.substr(0, 40)} + "\"");
    }
    return number.value_or(0.0);
  }

  void check_ends() {
    if (angles_.size() < 2) {
      issues_.add("the table has fewer than two angles");
    } else if (angles_.front() != 0.0 || angles_.back() != 180.0) {
      issues_.add(last_, "angles must reach from 0 to 180 deg, found " +
                             number_text(angles_.front()) + " to " + number_text(angles_.back()));
    }
  }

  materials::TabulatedPhase transposed() {
    for (const double angle : angles_) table_.angle_rad.push_back(degrees(angle).value);
    const std::size_t columns = table_.wavelength_um.size();
    for (std::size_t column = 0; column < columns; ++column) {
      for (std::size_t i = 0; i < angles_.size(); ++i) {
        table_.value.push_back(rows_[i * columns + column]);
      }
    }
    return std::move(table_);
  }

  std::string_view rest_;
  FileIssues issues_;
  int line_ = 0;
  std::vector<Token> cells_;
  Token last_{};
  std::vector<double> angles_, rows_;
  materials::TabulatedPhase table_;
};

}  // namespace

materials::TabulatedPhase parse_phase_table(std::string_view text, const std::string& name) {
  return TableParser{text, name}.parse();
}

materials::TabulatedPhase read_phase_table(const std::filesystem::path& file) {
  return parse_phase_table(read_bytes(file), file.string());
}

}  // namespace nadir::sim
