#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

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

template <class T>
std::vector<std::vector<T>> read_planes(const std::filesystem::path& image, std::size_t pixels,
                                        std::size_t bands) {
  std::ifstream stream{image, std::ios::binary};
  if (!stream) throw InputError{"cannot open the ENVI image " + image.string()};
  const auto expected = bands * pixels * sizeof(T);
  const auto found = std::filesystem::file_size(image);
  if (found != expected) {
    throw InputError{
        fmt::format("{} has {} bytes, its header promises {}", image.string(), found, expected)};
  }
  std::vector<std::vector<T>> planes(bands, std::vector<T>(pixels));
  for (auto& plane : planes) {
    stream.read(reinterpret_cast<char*>(plane.data()),
                static_cast<std::streamsize>(pixels * sizeof(T)));
  }
  if (!stream) throw InputError{"cannot read the ENVI image " + image.string()};
  return planes;
}

}  // namespace

EnviImage read_envi(const std::filesystem::path& image) {
  const Entries entries{envi_header_of(image)};
  check_layout(entries);
  EnviImage result{header_from(entries), {}};
  const auto pixels = static_cast<std::size_t>(result.header.samples) *
                      static_cast<std::size_t>(result.header.lines);
  const auto bands = static_cast<std::size_t>(entries.integer("bands"));
  switch (entries.integer("data type")) {
    case 4:
      result.planes = read_planes<float>(image, pixels, bands);
      break;
    case 13:
      result.planes = read_planes<std::uint32_t>(image, pixels, bands);
      break;
    default:
      entries.fail("data type", "data type must be 4 (float32) or 13 (uint32)");
  }
  return result;
}

}  // namespace nadir::sim
