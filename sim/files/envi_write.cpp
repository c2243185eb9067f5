#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <stdexcept>
#include <type_traits>

#include "sim/files/atomic_file.hpp"
#include "sim/files/envi.hpp"

namespace nadir::sim {
namespace {

// ENVI's numbers for the type of a value.
template <class T>
constexpr int data_type = std::is_same_v<T, float> ? 4 : 13;

static_assert(std::endian::native == std::endian::little,
              "planes are written as they lie in memory, and the header says little endian");

std::string without_syntax(std::string text) {
  const auto breaks = [](char c) {
    return c == ',' || c == '{' || c == '}' || c == '\n' || c == '\r';
  };
  std::replace_if(text.begin(), text.end(), breaks, '_');
  return text;
}

/// A value that is no list may hold commas.
std::string single(std::string text) {
  const auto breaks = [](char c) { return c == '{' || c == '}' || c == '\n' || c == '\r'; };
  std::replace_if(text.begin(), text.end(), breaks, '_');
  return text;
}

std::string envi_list(const std::vector<std::string>& items) {
  std::string text = "{";
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += (i == 0 ? "" : ", ") + without_syntax(items[i]);
  }
  return text + "}";
}

/// The shortest digits that read back as the same double.
std::string envi_list(const std::vector<double>& items) {
  return fmt::format("{{{}}}", fmt::join(items, ", "));
}

void add(std::string& text, const char* key, const std::string& value) {
  if (!value.empty()) text += fmt::format("{} = {}\n", key, single(value));
}

std::string header_text(const EnviHeader& h, std::size_t bands, int type) {
  std::string text = "ENVI\n";
  text += fmt::format("description = {{{}}}\n", single(h.description));
  text += fmt::format("samples = {}\nlines = {}\nbands = {}\n", h.samples, h.lines, bands);
  text += fmt::format("header offset = 0\nfile type = ENVI Standard\ndata type = {}\n", type);
  text += "interleave = bsq\nbyte order = 0\n";
  add(text, "sensor type", h.sensor_type);
  add(text, "acquisition time", h.acquisition_time);
  if (!h.data_units.empty()) {
    add(text, "data units", h.data_units);
    text += fmt::format("z plot titles = {{{}, {}}}\n",
                        h.wavelength_um.empty() ? "Band" : "Wavelength (um)",
                        without_syntax(h.data_units));
  }
  if (!h.band_names.empty()) text += "band names = " + envi_list(h.band_names) + "\n";
  if (!h.wavelength_um.empty()) {
    text += "wavelength units = Micrometers\nwavelength = " + envi_list(h.wavelength_um) + "\n";
  }
  if (!h.fwhm_um.empty()) text += "fwhm = " + envi_list(h.fwhm_um) + "\n";
  if (!h.class_names.empty()) {
    text += fmt::format("classes = {}\nclass names = {}\n", h.class_names.size(),
                        envi_list(h.class_names));
  }
  if (h.nan_is_no_data) text += "data ignore value = nan\n";
  return text;
}

void check_one_a_plane(std::size_t count, std::size_t planes, const char* what) {
  if (count == 0 || count == planes) return;
  throw std::invalid_argument(
      fmt::format("an ENVI image of {} planes got {} {}", planes, count, what));
}

template <class T>
void check_sizes(const EnviHeader& header, const std::vector<std::span<const T>>& planes) {
  if (header.samples < 1 || header.lines < 1 || planes.empty()) {
    throw std::invalid_argument("an ENVI image needs at least one sample, line and plane");
  }
  const auto pixels =
      static_cast<std::size_t>(header.samples) * static_cast<std::size_t>(header.lines);
  for (const auto& plane : planes) {
    if (plane.size() != pixels) {
      throw std::invalid_argument(fmt::format("a plane of {} x {} pixels has {} values",
                                              header.samples, header.lines, plane.size()));
    }
  }
  check_one_a_plane(header.band_names.size(), planes.size(), "band names");
  check_one_a_plane(header.wavelength_um.size(), planes.size(), "wavelengths");
  check_one_a_plane(header.fwhm_um.size(), planes.size(), "widths");
}

/// Both files are whole on the disc before either takes its name. The old header goes first:
/// a run that dies here leaves an image without header, which no reader takes for the old one.
void commit_pair(AtomicFile& image, AtomicFile& header) {
  image.finish();
  header.finish();
  std::filesystem::remove(header.destination());
  image.commit();
  header.commit();
}

template <class T>
void write(const std::filesystem::path& image, const EnviHeader& header,
           const std::vector<std::span<const T>>& planes) {
  check_sizes(header, planes);
  AtomicFile image_file{image};
  for (const auto& plane : planes) image_file.write(std::as_bytes(plane));
  AtomicFile header_file{envi_header_of(image)};
  header_file.write(header_text(header, planes.size(), data_type<T>));
  commit_pair(image_file, header_file);
}

}  // namespace

std::filesystem::path envi_header_of(const std::filesystem::path& image) {
  return std::filesystem::path{image}.replace_extension(".hdr");
}

void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const float>>& planes) {
  write(image, header, planes);
}

void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const std::uint32_t>>& planes) {
  write(image, header, planes);
}

}  // namespace nadir::sim
