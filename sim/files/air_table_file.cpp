#include "sim/files/air_table_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <fstream>

#include "core/error.hpp"
#include "sim/files/air_table_layout.hpp"
#include "sim/files/air_table_lines.hpp"
#include "sim/files/atomic_file.hpp"
#include "sim/files/hash.hpp"

namespace nadir::sim {
namespace {

using atmosphere::AirTable;

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

/// A text on one line: what would break it is escaped.
std::string on_one_line(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += "\\n";
    } else if (c == '\r') {
      result += "\\r";
    } else if (c == '\\') {
      result += "\\\\";
    } else {
      result += c;
    }
  }
  return result;
}

void numbers(std::string& head, const std::string& key, const std::vector<double>& values) {
  head += key + " =";
  // The shortest text that reads back as the same double.
  for (const double value : values) head += fmt::format(" {}", value);
  head += '\n';
}

void view_head(std::string& head, const std::string& prefix, const AirTable::View& view) {
  head += fmt::format("{}height_m = {}\n", prefix, view.height_m);
  numbers(head, prefix + "zenith_rad", view.zenith_rad);
  numbers(head, prefix + "azimuth_rad", view.azimuth_rad);
  numbers(head, prefix + "share", view.share);
}

std::string keys(const AirTable& table, const std::string& inputs) {
  std::string head = "made_by = " + on_one_line(table.made_by) + "\n";
  for (const std::string& note : table.notes) head += "note = " + on_one_line(note) + "\n";
  if (!inputs.empty()) head += "inputs = " + inputs + "\n";
  head += fmt::format("interpolation_error = {}\n", table.interpolation_error);
  head += fmt::format("top_m = {}\nground_m = {}\n", table.top_m, table.ground_m);
  head += fmt::format("kinds = {}\nangles = {}\nlanes = {}\nbodies = {}\nviews = {}\n", table.kinds,
                      table.phase_grid.size(), table.lanes.size(), table.bodies.size(),
                      table.views.size());
  for (std::size_t i = 0; i < table.bodies.size(); ++i) {
    const AirTable::Body& body = table.bodies[i];
    head += fmt::format("body.{}.name = {}\n", i, on_one_line(body.name));
    head += fmt::format("body.{}.zenith_rad = {}\n", i, body.zenith_rad);
    head += fmt::format("body.{}.azimuth_rad = {}\n", i, body.azimuth_rad);
  }
  view_head(head, "sky.", table.sky);
  for (std::size_t i = 0; i < table.views.size(); ++i) {
    view_head(head, fmt::format("view.{}.", i), table.views[i]);
  }
  return head;
}

std::string lane_lines(const AirTable& table) {
  std::string lines;
  for (const AirTable::Lane& lane : table.lanes) {
    lines += fmt::format("lane = {} {} {} {} {}\n", lane.wavelength_um, lane.absorption.lo_um,
                         lane.absorption.hi_um, lane.absorption.term, lane.weight);
  }
  return lines;
}

/// Appends the numbers and says where they lie. Arrays without values are left out.
struct Payload {
  std::string* lines;
  std::string* bytes;

  template <class Number>
  void operator()(const std::string& name, const std::vector<Number>& values,
                  const AirShape& shape) const {
    if (values.empty()) return;
    std::string sizes;
    for (const AirAxis& axis : shape) {
      sizes += fmt::format("{}{}", sizes.empty() ? "" : "x", axis.size);
    }
    *lines +=
        fmt::format("array = {} float{} {} {}\n", name, 8 * sizeof(Number), sizes, bytes->size());
    const std::size_t start = bytes->size();
    bytes->resize(start + values.size() * sizeof(Number));
    std::memcpy(bytes->data() + start, values.data(), values.size() * sizeof(Number));
  }
};

/// The whole file in one read: a table is megabytes, and a run waits for it.
std::string whole(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary | std::ios::ate};
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : -1;
  // A folder opens, but does not read.
  if (size < 0 || std::filesystem::is_directory(file)) {
    throw InputError{InputIssue{{file.string(), 0, 0}, "the file cannot be read", {}, {}}};
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.seekg(0);
  stream.read(bytes.data(), size);
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

}  // namespace

std::string air_table_bytes(const AirTableFile& file) {
  check(file.table);
  std::string lines, payload;
  for_each_array(file.table, Payload{&lines, &payload});
  std::string head = air_table_magic + fmt::format("{}\n", air_table_version);
  head += keys(file.table, file.inputs);
  head += lines;
  head += lane_lines(file.table);
  head += fmt::format("payload_bytes = {}\npayload_sha256 = {}\n", payload.size(),
                      digest_bytes(payload).sha256);
  head += fmt::format("head_sha256 = {}\n", digest_bytes(head).sha256);
  return head + payload;
}

AirTableFile read_air_table(const std::filesystem::path& file) {
  return parse_air_table(whole(file), file.string());
}

void write_air_table(const std::filesystem::path& destination, const AirTableFile& file) {
  write_file(destination, air_table_bytes(file));
}

std::string air_table_head(const AirTable& table) { return keys(table, {}) + lane_lines(table); }

namespace {

/// The indices of a value, by the array's axes.
std::string indices(const AirShape& shape, std::size_t index) {
  std::vector<std::size_t> at(shape.size());
  for (std::size_t axis = shape.size(); axis-- > 0;) {
    at[axis] = index % shape[axis].size;
    index /= shape[axis].size;
  }
  std::string text;
  for (std::size_t axis = 0; axis < shape.size(); ++axis) {
    text += fmt::format("{}{}={}", axis == 0 ? "" : " ", shape[axis].name, at[axis]);
  }
  return text;
}

}  // namespace

std::string air_table_csv(const AirTable& table) {
  std::string text = "array,indices,value\n";
  for_each_array(table, [&](const std::string& name, const auto& values, const AirShape& shape) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      text += fmt::format("{},{},{}\n", name, indices(shape, i), values[i]);
    }
  });
  return text;
}

}  // namespace nadir::sim
