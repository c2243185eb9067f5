#include "sim/files/view_table_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/text.hpp"
#include "sim/files/number_table.hpp"

namespace nadir::sim {
namespace {

constexpr double first_view_px = 0.5;   // of the first pixel, in image coordinates
constexpr double view_slack_px = 1e-6;  // of coordinates, pixels: their rounding in the file

InputError view_mistake(const std::string& name, int line, const std::string& message) {
  return InputError{InputIssue{{name, line, 0}, message, {}, {}}};
}

/// Distinct coordinates along one axis of the image, each with the line that has it first.
using Nodes = std::map<double, int>;

/// The spacing of nodes that begin at the first pixel's centre and are evenly spaced.
double step_of(const Nodes& nodes, const std::string& axis, const std::string& name) {
  const auto [first, first_line] = *nodes.begin();
  if (std::abs(first - first_view_px) > view_slack_px) {
    throw view_mistake(name, first_line,
                       "the first " + axis + " is " + nadir::number_text(first) +
                           ", expected 0.5, the centre of the first pixel");
  }
  if (nodes.size() == 1) return 1.0;
  const double step = (nodes.rbegin()->first - first) / static_cast<double>(nodes.size() - 1);
  double expected = first;
  for (const auto& [place, line] : nodes) {
    if (std::abs(place - expected) > view_slack_px * static_cast<double>(nodes.size())) {
      throw view_mistake(name, line,
                         axis + " " + nadir::number_text(place) +
                             " is not on an even grid: " + std::to_string(nodes.size()) +
                             " from 0.5 to " + nadir::number_text(nodes.rbegin()->first) +
                             " have one at " + nadir::number_text(expected));
    }
    expected += step;
  }
  return step;
}

/// Line of sight of a row: x, y, z in camera axes, or angles from the axis.
Vec3 sight(const NumberTable& table, const NumberTable::Row& row, const std::string& name) {
  constexpr double radians_per_degree = std::numbers::pi / 180.0;
  const Vec3 towards =
      table.has("x")
          ? Vec3{table.value(row, "x", 0.0), table.value(row, "y", 0.0), table.value(row, "z", 0.0)}
          : Vec3{std::tan(table.value(row, "across_deg", 0.0) * radians_per_degree),
                 std::tan(table.value(row, "along_deg", 0.0) * radians_per_degree), 1.0};
  constexpr double least_length = 1e-6;  // less is a missing value, not a direction
  if (!(length(towards) > least_length)) {
    throw view_mistake(name, row.line, "the direction x, y, z has no length");
  }
  return normalised(towards);
}

void check_columns(const NumberTable& table, const std::string& name) {
  const bool has_vector = table.has("x") && table.has("y") && table.has("z");
  const bool has_angles = table.has("across_deg") && table.has("along_deg");
  const bool any_vector = table.has("x") || table.has("y") || table.has("z");
  const bool any_angle = table.has("across_deg") || table.has("along_deg");
  const bool one_kind = (has_vector && !any_angle) || (has_angles && !any_vector);
  if (one_kind) return;
  throw view_mistake(name, 0,
                     "lines of sight are given by the columns x, y and z, or by across_deg and "
                     "along_deg");
}

Nodes nodes_of(const NumberTable& table, const std::string& axis) {
  Nodes nodes;
  for (const NumberTable::Row& row : table.rows()) {
    nodes.emplace(table.value(row, axis, first_view_px), row.line);
  }
  return nodes;
}

/// Number of the node at a coordinate of an axis that `step_of` has passed.
std::size_t node_at(double coordinate, double step) {
  return static_cast<std::size_t>(std::lround((coordinate - first_view_px) / step));
}

/// Fills the grid from the rows, which may stand in any order.
void read_rows(const NumberTable& table, const std::string& name, sensor::ViewTable& views) {
  const auto samples = static_cast<std::size_t>(views.samples);
  std::vector<int> told(samples * static_cast<std::size_t>(views.lines), 0);  // by which line
  views.directions.assign(told.size(), Vec3{});
  for (const NumberTable::Row& row : table.rows()) {
    const std::size_t column =
        node_at(table.value(row, "sample", first_view_px), views.sample_step);
    const std::size_t rank = node_at(table.value(row, "line", first_view_px), views.line_step);
    const std::size_t node = rank * samples + column;
    if (told[node] != 0) {
      throw view_mistake(name, row.line,
                         "this pixel is there already, in line " + std::to_string(told[node]));
    }
    told[node] = row.line;
    views.directions[node] = sight(table, row, name);
  }
  const auto missing = std::find(told.begin(), told.end(), 0);
  if (missing == told.end()) return;
  const auto node = static_cast<std::size_t>(missing - told.begin());
  const auto coordinate = [](std::size_t number, double step) {
    return nadir::number_text(first_view_px + static_cast<double>(number) * step);
  };
  throw view_mistake(name, 0,
                     "the grid lacks the pixel at sample " +
                         coordinate(node % samples, views.sample_step) + ", line " +
                         coordinate(node / samples, views.line_step));
}

}  // namespace

sensor::ViewTable parse_view_table(std::string_view text, const std::string& name) {
  constexpr double most_pixels = 1e6, most_deg = 89.0;
  const NumberTable table{text,
                          name,
                          {{"sample", true, 0.0, most_pixels},
                           {"line", false, 0.0, most_pixels},
                           {"x"},
                           {"y"},
                           {"z"},
                           {"across_deg", false, -most_deg, most_deg},
                           {"along_deg", false, -most_deg, most_deg}}};
  check_columns(table, name);
  const Nodes samples = nodes_of(table, "sample"), lines = nodes_of(table, "line");
  if (samples.size() < 2) throw view_mistake(name, 0, "a view table needs at least two samples");
  sensor::ViewTable views;
  views.samples = static_cast<int>(samples.size());
  views.lines = static_cast<int>(lines.size());
  views.sample_step = step_of(samples, "sample", name);
  views.line_step = step_of(lines, "line", name);
  read_rows(table, name, views);
  return views;
}

sensor::ViewTable read_view_table(const std::filesystem::path& file) {
  return parse_view_table(read_bytes(file), file.string());
}

}  // namespace nadir::sim
