#include "sim/files/instance_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

enum InstanceColumn { east, north, up, yaw, pitch, roll, scale, scale_x, scale_y, scale_z };
constexpr std::array<std::string_view, 11> column_names{"east_m",    "north_m",  "up_m",  "yaw_deg",
                                                        "pitch_deg", "roll_deg", "scale", "scale_x",
                                                        "scale_y",   "scale_z"};

bool is_scale(std::size_t column) { return column >= scale && column <= scale_z; }

class ListParser {
 public:
  ListParser(std::string_view text, const std::string& name) : rest_{text}, issues_{name} {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  std::vector<Placement> parse() {
    if (!next_row()) issues_.add("the list is empty: its first row names the columns");
    read_header();
    issues_.throw_if_any();  // without sound columns every row would be a mistake
    while (next_row()) row();
    issues_.throw_if_any();
    if (placements_.empty()) issues_.add("the list has no rows: it would place nothing");
    issues_.throw_if_any();
    return std::move(placements_);
  }

 private:
  bool next_row() {
    cells_.clear();
    while (cells_.empty() && !rest_.empty()) {
      const std::string_view line = take_line(rest_);
      ++line_;
      const std::string_view content = without_blanks(line);
      if (!content.empty() && content.front() != '#') split(line);
    }
    return !cells_.empty();
  }

  void split(std::string_view line) {
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(',', begin), line.size());
      std::string_view text = without_blanks(line.substr(begin, end - begin));
      if (text.empty()) text = line.substr(begin, 0);  // keeps its place
      cells_.push_back({text, line, line_});
      begin = end + 1;
    }
  }

  void read_header() {
    for (const Token& cell : cells_) {
      const auto found = std::find(column_names.begin(), column_names.end(), cell.text);
      const auto column = static_cast<std::size_t>(found - column_names.begin());
      if (found == column_names.end()) {
        unknown_column(cell);
      } else if (has(column)) {
        issues_.add(cell, "the column \"" + std::string{cell.text} + "\" is there twice");
      }
      columns_.push_back(column);
    }
    if (cells_.empty()) return;
    for (const InstanceColumn required : {east, north}) {
      if (has(required)) continue;
      issues_.add(cells_.front(),
                  "the column \"" + std::string{column_names[required]} + "\" is missing");
    }
    if (has(scale) && (has(scale_x) || has(scale_y) || has(scale_z))) {
      issues_.add(cells_.front(), "give either \"scale\" or \"scale_x\", \"scale_y\", \"scale_z\"");
    }
  }

  [[nodiscard]] bool has(std::size_t column) const {
    return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
  }

  void unknown_column(const Token& cell) {
    const std::vector<std::string> known{column_names.begin(), column_names.end()};
    const std::string nearest = nearest_name(std::string{cell.text}, known);
    issues_.add(cell, "unknown column \"" + std::string{cell.text} + "\"",
                nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
  }

  void row() {
    if (cells_.size() != columns_.size()) {
      issues_.add(cells_.front(), "expected " + std::to_string(columns_.size()) + " cells, found " +
                                      std::to_string(cells_.size()));
      return;
    }
    std::array<double, column_names.size()> values{0, 0, 0, 0, 0, 0, 1, 1, 1, 1};
    Placement placement;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      values[columns_[i]] = number(cells_[i], columns_[i]);
    }
    placement.position = {values[east], values[north], values[up]};
    placement.yaw_deg = values[yaw];
    placement.pitch_deg = values[pitch];
    placement.roll_deg = values[roll];
    placement.scale = values[scale] * Vec3{values[scale_x], values[scale_y], values[scale_z]};
    placement.line = line_;
    placements_.push_back(placement);
  }

  double number(const Token& cell, std::size_t column) {
    const auto value = strict_number_in<double>(cell.text);
    const std::string name{column_names[column]};
    if (!value) {
      issues_.add(cell, "expected a finite number for " + name + ", found \"" +
                            std::string{cell.text} + "\"");
    } else if (is_scale(column) && !(std::abs(*value) >= 1e-6 && std::abs(*value) <= 1e6)) {
      issues_.add(cell, name + " must lie between 1e-6 and 1e6, or their negatives");
    }
    return value.value_or(1.0);
  }

  std::string_view rest_;
  FileIssues issues_;
  int line_ = 0;
  std::vector<Token> cells_;
  std::vector<std::size_t> columns_;
  std::vector<Placement> placements_;
};

/// Sine and cosine of an angle in degrees, exact at multiples of 90.
std::pair<double, double> sine_cosine(double angle_deg) {
  const double quarters = std::nearbyint(angle_deg / 90.0);
  const double rest = (angle_deg - 90.0 * quarters) * (std::numbers::pi / 180.0);
  const double s = std::sin(rest), c = std::cos(rest);
  switch (static_cast<int>(std::remainder(quarters, 4.0))) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case -1:
      return {-c, s};
    default:
      return {-s, -c};
  }
}

}  // namespace

Affine affine(const Placement& placement) {
  const auto [sy, cy] = sine_cosine(placement.yaw_deg);
  const auto [sp, cp] = sine_cosine(placement.pitch_deg);
  const auto [sr, cr] = sine_cosine(placement.roll_deg);
  const Mat3 yaw_turn{{cy, -sy, 0.0}, {sy, cy, 0.0}, {0.0, 0.0, 1.0}};  // clockwise from above
  const Mat3 pitch_turn{{1.0, 0.0, 0.0}, {0.0, cp, sp}, {0.0, -sp, cp}};
  const Mat3 roll_turn{{cr, 0.0, -sr}, {0.0, 1.0, 0.0}, {sr, 0.0, cr}};
  return {yaw_turn * pitch_turn * roll_turn * scaling(placement.scale), placement.position};
}

std::vector<Affine> flatten(const std::vector<Affine>& outer, const std::vector<Affine>& inner) {
  std::vector<Affine> all;
  all.reserve(outer.size() * inner.size());
  for (const Affine& o : outer) {
    for (const Affine& i : inner) all.push_back(o * i);
  }
  return all;
}

std::vector<Placement> parse_instance_list(std::string_view text, const std::string& name) {
  return ListParser{text, name}.parse();
}

std::vector<Placement> read_instance_list(const std::filesystem::path& file) {
  return parse_instance_list(read_bytes(file), file.string());
}

}  // namespace nadir::sim
