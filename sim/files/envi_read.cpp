#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "core/error.hpp"
#include "sim/files/envi.hpp"

namespace nadir::sim {
namespace {

/// The header's entries by keyword, each with the line that it stands on.
class Entries {
 public:
  explicit Entries(const std::filesystem::path& file);

  [[nodiscard]] std::string text(const std::string& key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::string{} : found->second.value;
  }
  [[nodiscard]] int integer(const std::string& key) const;
  [[nodiscard]] std::vector<std::string> names(const std::string& key) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& key) const;
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;

 private:
  struct Entry {
    std::string value;
    int line = 0;
  };
  std::string file_;
  std::map<std::string, Entry> values_;
};

std::string trimmed_text(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

template <class T>
std::optional<T> number(const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Reads on to the closing brace of a list, counting lines, and leaves what is between the braces.
bool complete_list(std::string& value, std::istream& stream, int& line_number) {
  std::string more;
  while (value.find('}') == std::string::npos && std::getline(stream, more)) {
    value += "\n" + more;
    ++line_number;
  }
  const auto close = value.find('}');
  if (close == std::string::npos) return false;
  value = value.substr(1, close - 1);
  return true;
}

Entries::Entries(const std::filesystem::path& file) : file_{file.string()} {
  std::ifstream stream{file};
  if (!stream) throw InputError{"cannot open the ENVI header " + file_};
  std::string line;
  if (!std::getline(stream, line) || trimmed_text(line) != "ENVI") {
    throw InputError{
        InputIssue{{file_, 1, 1}, "an ENVI header starts with the line ENVI", {}, line}};
  }
  for (int number = 2; std::getline(stream, line); ++number) {
    if (trimmed_text(line).empty()) continue;
    const int first = number;
    const auto equals = line.find('=');
    if (equals == std::string::npos) {
      throw InputError{InputIssue{{file_, first, 1}, "expected keyword = value", {}, line}};
    }
    std::string value = trimmed_text(line.substr(equals + 1));
    if (value.starts_with('{') && !complete_list(value, stream, number)) {
      throw InputError{InputIssue{{file_, first, 1}, "this brace is not closed", {}, line}};
    }
    values_[trimmed_text(line.substr(0, equals))] = {value, first};
  }
}

void Entries::fail(const std::string& key, const std::string& message) const {
  const auto found = values_.find(key);
  const int line = found == values_.end() ? 0 : found->second.line;
  throw InputError{InputIssue{{file_, line, line > 0 ? 1 : 0}, message, {}, {}}};
}

int Entries::integer(const std::string& key) const {
  const auto value = number<int>(text(key));
  if (!value) fail(key, fmt::format("\"{}\" is \"{}\", expected a whole number", key, text(key)));
  return *value;
}

std::vector<std::string> Entries::names(const std::string& key) const {
  std::vector<std::string> items;
  std::istringstream stream{text(key)};
  for (std::string item; std::getline(stream, item, ',');) items.push_back(trimmed_text(item));
  return items;
}

std::vector<double> Entries::numbers(const std::string& key) const {
  std::vector<double> values;
  for (const std::string& item : names(key)) {
    const auto value = number<double>(item);
    if (!value) fail(key, fmt::format("\"{}\" holds \"{}\", expected a number", key, item));
    values.push_back(*value);
  }
  return values;
}

EnviHeader header_from(const Entries& entries) {
  EnviHeader header;
  header.samples = entries.integer("samples");
  header.lines = entries.integer("lines");
  header.description = entries.text("description");
  header.sensor_type = entries.text("sensor type");
  header.acquisition_time = entries.text("acquisition time");
  header.data_units = entries.text("data units");
  header.band_names = entries.names("band names");
  header.wavelength_um = entries.numbers("wavelength");
  header.fwhm_um = entries.numbers("fwhm");
  header.class_names = entries.names("class names");
  header.gains = entries.numbers("data gain values");
  header.offsets = entries.numbers("data offset values");
  header.nan_is_no_data = entries.text("data ignore value") == "nan";
  return header;
}

void check_layout(const Entries& entries) {
  if (entries.text("interleave") != "bsq") entries.fail("interleave", "interleave must be bsq");
  if (entries.integer("byte order") != 0) entries.fail("byte order", "byte order must be 0");
  if (entries.integer("header offset") != 0) {
    entries.fail("header offset", "header offset must be 0");
  }
  for (const char* key : {"samples", "lines", "bands"}) {
    if (entries.integer(key) < 1) entries.fail(key, fmt::format("{} must be at least 1", key));
  }
  const std::string units = entries.text("wavelength units");
  if (!units.empty() && units != "Micrometers") {
    entries.fail("wavelength units", "wavelength units must be Micrometers");
  }
}

EnviType type_from(const Entries& entries) {
  const int type = entries.integer("data type");
  for (const EnviType known :
       {EnviType::float32, EnviType::float64, EnviType::uint16, EnviType::uint32}) {
    if (type == static_cast<int>(known)) return known;
  }
  entries.fail("data type",
               "data type must be 4 (float32), 5 (float64), 12 (uint16) or 13 (uint32)");
}

constexpr std::uint64_t value_bytes(EnviType type) {
  return type == EnviType::float64 ? 8 : type == EnviType::uint16 ? 2 : 4;
}

template <class T>
constexpr bool holds(EnviType type) {
  switch (type) {
    case EnviType::float32:
      return std::is_same_v<T, float>;
    case EnviType::float64:
      return std::is_same_v<T, double>;
    case EnviType::uint16:
      return std::is_same_v<T, std::uint16_t>;
    case EnviType::uint32:
      return std::is_same_v<T, std::uint32_t>;
  }
  return false;
}

}  // namespace

struct EnviReader::State {
  std::filesystem::path path;
  EnviHeader header;
  EnviType type = EnviType::float32;
  std::size_t planes = 0;
  std::ifstream stream;

  [[nodiscard]] std::uint64_t samples() const { return static_cast<std::uint64_t>(header.samples); }
  [[nodiscard]] std::uint64_t lines() const { return static_cast<std::uint64_t>(header.lines); }
};

EnviReader::EnviReader(const std::filesystem::path& image) : state_{std::make_unique<State>()} {
  State& s = *state_;
  const Entries entries{envi_header_of(image)};
  check_layout(entries);
  s.path = image;
  s.header = header_from(entries);
  s.planes = static_cast<std::size_t>(entries.integer("bands"));
  s.type = type_from(entries);
  s.stream.open(image, std::ios::binary);
  if (!s.stream) throw InputError{"cannot open the ENVI image " + image.string()};
  const std::uint64_t expected = s.planes * s.samples() * s.lines() * value_bytes(s.type);
  const auto found = std::filesystem::file_size(image);
  if (found != expected) {
    throw InputError{
        fmt::format("{} has {} bytes, its header promises {}", image.string(), found, expected)};
  }
}

EnviReader::~EnviReader() = default;
EnviReader::EnviReader(EnviReader&&) noexcept = default;
EnviReader& EnviReader::operator=(EnviReader&&) noexcept = default;

const EnviHeader& EnviReader::header() const noexcept { return state_->header; }
EnviType EnviReader::type() const noexcept { return state_->type; }
std::size_t EnviReader::planes() const noexcept { return state_->planes; }

template <class T>
void EnviReader::read_lines(std::size_t plane, int first_line, std::span<T> room) {
  State& s = *state_;
  if (!holds<T>(s.type)) {
    throw std::invalid_argument(s.path.string() + " holds numbers of another type");
  }
  const auto first = static_cast<std::uint64_t>(first_line);
  if (first_line < 0 || plane >= s.planes || room.size() % s.samples() != 0 ||
      first + room.size() / s.samples() > s.lines()) {
    throw std::invalid_argument(fmt::format("{} has no lines from {} on for {} values of plane {}",
                                            s.path.string(), first_line, room.size(), plane));
  }
  const std::uint64_t place = (plane * s.lines() + first) * s.samples() * sizeof(T);
  s.stream.seekg(static_cast<std::streamoff>(place));
  s.stream.read(reinterpret_cast<char*>(room.data()),
                static_cast<std::streamsize>(room.size_bytes()));
  if (!s.stream) throw InputError{"cannot read the ENVI image " + s.path.string()};
}

void EnviReader::read(std::size_t plane, int first_line, std::span<float> room) {
  read_lines(plane, first_line, room);
}
void EnviReader::read(std::size_t plane, int first_line, std::span<double> room) {
  read_lines(plane, first_line, room);
}
void EnviReader::read(std::size_t plane, int first_line, std::span<std::uint16_t> room) {
  read_lines(plane, first_line, room);
}
void EnviReader::read(std::size_t plane, int first_line, std::span<std::uint32_t> room) {
  read_lines(plane, first_line, room);
}

namespace {

template <class T>
std::vector<std::vector<T>> whole_planes(EnviReader& reader) {
  const auto pixels = static_cast<std::size_t>(reader.header().samples) *
                      static_cast<std::size_t>(reader.header().lines);
  std::vector<std::vector<T>> planes(reader.planes(), std::vector<T>(pixels));
  for (std::size_t i = 0; i < planes.size(); ++i) reader.read(i, 0, std::span{planes[i]});
  return planes;
}

EnviPlanes whole_planes(EnviReader& reader) {
  switch (reader.type()) {
    case EnviType::float64:
      return whole_planes<double>(reader);
    case EnviType::uint16:
      return whole_planes<std::uint16_t>(reader);
    case EnviType::uint32:
      return whole_planes<std::uint32_t>(reader);
    case EnviType::float32:
      break;
  }
  return whole_planes<float>(reader);
}

}  // namespace

EnviImage read_envi(const std::filesystem::path& image) {
  EnviReader reader{image};
  EnviPlanes planes = whole_planes(reader);
  return {reader.header(), std::move(planes)};
}

}  // namespace nadir::sim
