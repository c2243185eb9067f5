#include "sim/files/spectrum_file.hpp"

#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "sim/files/spectrum_format.hpp"

namespace nadir::sim {

using spectrum_format::did_you_mean;
using spectrum_format::entry_of;
using spectrum_format::joined;

namespace {

/// n and k of a complex refractive index share a file.
SpectrumQuantity quantity_of(SpectrumQuantity file, const std::string& column) {
  return file == SpectrumQuantity::refractive_index && column == "k"
             ? SpectrumQuantity::extinction_coefficient
             : file;
}

}  // namespace

std::string_view name_of(SpectrumQuantity quantity) noexcept { return entry_of(quantity).name; }
std::string_view unit_of(SpectrumQuantity quantity) noexcept { return entry_of(quantity).unit; }

std::vector<std::string> SpectrumFile::column_names() const {
  std::vector<std::string> names;
  for (const SpectrumColumn& c : columns) names.push_back(c.name);
  return names;
}

const SpectrumColumn& SpectrumFile::column(const std::string& name) const {
  if (name.empty() && columns.size() == 1) return columns.front();
  for (const SpectrumColumn& c : columns) {
    if (c.name == name) return c;
  }
  const std::vector<std::string> names = column_names();
  if (name.empty()) {
    throw InputError{InputIssue{
        {path, 0, 0},
        "the file has " + std::to_string(columns.size()) + " columns; name one as file.csv#column",
        "columns are: " + joined(names),
        {}}};
  }
  throw InputError{InputIssue{
      {path, 0, 0}, "there is no column " + in_quotes(name), did_you_mean(name, names), {}}};
}

SpectrumFile read_spectrum_file(const std::filesystem::path& path,
                                std::optional<SpectrumQuantity> plain_as) {
  std::error_code ignored;  // a folder opens as a stream on Linux, and reads as an empty file
  std::ifstream stream{path, std::ios::binary};
  if (!stream || std::filesystem::is_directory(path, ignored)) {
    throw InputError{InputIssue{{path.string(), 0, 0}, "the file cannot be opened", {}, {}}};
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return parse_spectrum(std::move(text).str(), path.string(), plain_as);
}

spectral::Curve curve_in(const SpectrumFile& file, const std::string& column,
                         SpectrumQuantity expected, spectral::Outside outside) {
  const SpectrumColumn& chosen = file.column(column);
  if (!file.quantity) return {chosen.wavelength_um, chosen.value, outside};
  const SpectrumQuantity found = quantity_of(*file.quantity, chosen.name);
  if (found != expected) {
    const std::string holder =
        found == *file.quantity ? "the file" : "column " + in_quotes(chosen.name);
    throw InputError{InputIssue{{file.path, 0, 0},
                                holder + " holds " + std::string{name_of(found)} + "; expected " +
                                    std::string{name_of(expected)},
                                {},
                                {}}};
  }
  return {chosen.wavelength_um, chosen.value, outside};
}

spectral::Curve read_curve(const std::filesystem::path& path, const std::string& column,
                           SpectrumQuantity expected, spectral::Outside outside) {
  return curve_in(read_spectrum_file(path, expected), column, expected, outside);
}

SpectrumReference parse_spectrum_reference(const std::string& text) {
  const std::size_t mark = text.rfind('#');
  if (mark == std::string::npos) return {text, {}};
  return {text.substr(0, mark), text.substr(mark + 1)};
}

}  // namespace nadir::sim
