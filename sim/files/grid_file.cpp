#include "sim/files/grid_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <utility>

#include "core/text.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

static_assert(std::endian::native == std::endian::little, "grids are read as they lie in memory");

enum class NrrdType { uint8, uint16, float32, float64 };
constexpr std::array<std::pair<std::string_view, NrrdType>, 11> nrrd_types{
    {{"float", NrrdType::float32},
     {"double", NrrdType::float64},
     {"uchar", NrrdType::uint8},
     {"unsigned char", NrrdType::uint8},
     {"uint8", NrrdType::uint8},
     {"uint8_t", NrrdType::uint8},
     {"ushort", NrrdType::uint16},
     {"unsigned short", NrrdType::uint16},
     {"unsigned short int", NrrdType::uint16},
     {"uint16", NrrdType::uint16},
     {"uint16_t", NrrdType::uint16}}};

std::size_t size_of(NrrdType type) {
  constexpr std::array<std::size_t, 4> sizes{1, 2, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

struct NrrdHeader {
  std::array<int, 3> sizes{};
  NrrdType type = NrrdType::float32;
  std::string_view body;
};

class NrrdParser {
 public:
  NrrdParser(std::string_view bytes, const std::string& name) : rest_{bytes}, issues_{name} {}

  NrrdHeader parse() {
    if (!next() || !line_.text.starts_with("NRRD000")) {
      issues_.add("this is no NRRD file: its first line is not \"NRRD0001\" to \"NRRD0005\"");
      issues_.throw_if_any();
    }
    bool ended = false;
    while (!ended && next()) {
      if (line_.text.empty()) {
        ended = true;
      } else if (line_.text.front() != '#') {
        field();
      }
    }
    if (!ended) issues_.add("the header has no end: an empty line before the data is missing");
    check_fields();
    issues_.throw_if_any();
    header_.body = rest_;
    return header_;
  }

 private:
  bool next() {
    if (rest_.empty()) return false;
    const std::string_view text = take_line(rest_);
    line_ = {text, text, line_.line + 1};
    return true;
  }

  void field() {
    const std::size_t colon = line_.text.find(':');
    if (colon == std::string_view::npos) {
      issues_.add(line_, "expected \"field: value\", found " + start_in_quotes(line_.text));
      return;
    }
    if (line_.text.substr(colon).starts_with(":=")) return;  // a user's own pair
    const std::string_view name = without_blanks(line_.text.substr(0, colon));
    const Token value{without_blanks(line_.text.substr(colon + 1)), line_.line_text, line_.line};
    if (value.text.empty()) {
      issues_.add(line_, "the field " + start_in_quotes(name) + " has no value");
      return;
    }
    if (known_field(name, value)) fields_.insert(std::string{name});
  }

  /// Whether the field is one of those that the data cannot be read without.
  bool known_field(std::string_view name, const Token& value) {
    if (name == "type") {
      type(value);
    } else if (name == "dimension") {
      expect(value, "3", "a grid has dimension 3");
    } else if (name == "sizes") {
      sizes(value);
    } else if (name == "encoding") {
      expect(value, "raw", "only encoding raw is supported");
    } else if (name == "endian") {
      expect(value, "little", "only little-endian data is supported");
    } else {
      refuse(name, value);
      return false;
    }
    return true;
  }

  void expect(const Token& value, std::string_view wanted, const std::string& rule) {
    if (value.text != wanted) {
      issues_.add(value, rule + ", found " + start_in_quotes(value.text),
                  "write it anew, for instance with `unu save -f nrrd -e raw -en little`");
    }
  }

  /// Other fields say where the grid lies and what it means; a few move the data elsewhere.
  void refuse(std::string_view name, const Token& value) {
    if (name == "data file" || name == "datafile") {
      issues_.add(value, "data in a file of its own is not supported: it must follow the header");
    } else if ((name == "line skip" || name == "lineskip" || name == "byte skip" ||
                name == "byteskip") &&
               value.text != "0") {
      issues_.add(value, "skipping is not supported: the data must follow the header's empty line");
    }
  }

  void type(const Token& value) {
    const auto found = std::find_if(nrrd_types.begin(), nrrd_types.end(),
                                    [&](const auto& entry) { return entry.first == value.text; });
    if (found == nrrd_types.end()) {
      issues_.add(value, "expected type float, double, uint8 or uint16, found " +
                             start_in_quotes(value.text));
      return;
    }
    header_.type = found->second;
  }

  void sizes(const Token& value) {
    std::string_view left = value.text;
    for (int& size : header_.sizes) {
      left = without_blanks(left);
      const std::string_view word = left.substr(0, left.find_first_of(" \t"));
      left.remove_prefix(word.size());
      const auto number = strict_number_in<int>(word);
      // 65536 cells along one axis: all three together stay within 64 bits.
      if (!number || *number < 1 || *number > 65536) {
        issues_.add(value,
                    "expected three sizes from 1 to 65536, found " + start_in_quotes(value.text));
        return;
      }
      size = *number;
    }
    if (!without_blanks(left).empty()) {
      issues_.add(value, "expected three sizes, found more: " + start_in_quotes(value.text));
    }
  }

  void check_fields() {
    for (const char* name : {"type", "dimension", "sizes", "encoding"}) {
      if (!fields_.contains(name)) missing(name);
    }
    if (size_of(header_.type) > 1 && !fields_.contains("endian")) missing("endian");
  }
  void missing(const std::string& name) { issues_.add("the header has no field \"" + name + "\""); }

  std::string_view rest_;
  FileIssues issues_;
  Token line_{};
  NrrdHeader header_;
  std::set<std::string, std::less<>> fields_;
};

template <class Number>
double as(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return static_cast<double>(number);
}

double value_at(const NrrdHeader& header, std::size_t index) {
  const char* const bytes = header.body.data() + index * size_of(header.type);
  switch (header.type) {
    case NrrdType::uint8:
      return as<std::uint8_t>(bytes);
    case NrrdType::uint16:
      return as<std::uint16_t>(bytes);
    case NrrdType::float32:
      return as<float>(bytes);
    case NrrdType::float64:
      break;
  }
  return as<double>(bytes);
}

std::string place_of(const NrrdHeader& header, std::size_t index) {
  const auto columns = static_cast<std::size_t>(header.sizes[0]);
  const auto rows = static_cast<std::size_t>(header.sizes[1]);
  return "column " + std::to_string(index % columns + 1) + ", row " +
         std::to_string(index / columns % rows + 1) + ", layer " +
         std::to_string(index / columns / rows + 1);
}

std::size_t cells_of(const NrrdHeader& header, FileIssues& issues) {
  const auto [columns, rows, layers] = header.sizes;
  const std::size_t cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) *
                            static_cast<std::size_t>(layers);
  const std::size_t bytes = cells * size_of(header.type);
  if (header.body.size() != bytes) {
    issues.add("the header promises " + std::to_string(columns) + " x " + std::to_string(rows) +
               " x " + std::to_string(layers) + " = " + std::to_string(cells) + " values of " +
               std::to_string(size_of(header.type)) + " bytes, " + std::to_string(bytes) +
               " in all; " + std::to_string(header.body.size()) + " bytes follow it");
  }
  issues.throw_if_any();
  return cells;
}

}  // namespace

radiometry::ScalarGrid parse_grid(std::string_view bytes, const std::string& name) {
  const NrrdHeader header = NrrdParser{bytes, name}.parse();
  FileIssues issues{name};
  const std::size_t cells = cells_of(header, issues);
  radiometry::ScalarGrid grid{header.sizes[0], header.sizes[1], header.sizes[2], {}};
  grid.value.reserve(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    const double value = value_at(header, i);
    // A double may be finite and overflow the grid's float.
    const auto kept = static_cast<float>(value);
    if (!(value >= 0.0) || !std::isfinite(kept)) {
      issues.add("the value in " + place_of(header, i) + " is " + number_text(value) +
                 "; it must be finite and not negative");
    }
    grid.value.push_back(kept);
  }
  issues.throw_if_any();
  return grid;
}

radiometry::ScalarGrid read_grid(const std::filesystem::path& file) {
  return parse_grid(read_bytes(file), file.string());
}

}  // namespace nadir::sim
