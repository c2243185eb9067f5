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

template <class T>
constexpr EnviType envi_type = std::is_same_v<T, float>           ? EnviType::float32
                               : std::is_same_v<T, double>        ? EnviType::float64
                               : std::is_same_v<T, std::uint16_t> ? EnviType::uint16
                                                                  : EnviType::uint32;

constexpr std::size_t envi_value_bytes(EnviType type) {
  return type == EnviType::float64 ? 8 : type == EnviType::uint16 ? 2 : 4;
}

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

std::string envi_header_text(const EnviHeader& h, std::size_t bands, EnviType type) {
  std::string text = "ENVI\n";
  text += fmt::format("description = {{{}}}\n", single(h.description));
  text += fmt::format("samples = {}\nlines = {}\nbands = {}\n", h.samples, h.lines, bands);
  text += fmt::format("header offset = 0\nfile type = ENVI Standard\ndata type = {}\n",
                      static_cast<int>(type));
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
  if (!h.gains.empty()) text += "data gain values = " + envi_list(h.gains) + "\n";
  if (!h.offsets.empty()) text += "data offset values = " + envi_list(h.offsets) + "\n";
  for (const auto& [key, value] : h.more) add(text, key.c_str(), value);
  return text;
}

void check_one_a_plane(std::size_t count, std::size_t planes, const char* what) {
  if (count == 0 || count == planes) return;
  throw std::invalid_argument(
      fmt::format("an ENVI image of {} planes got {} {}", planes, count, what));
}

void check_envi_header(const EnviHeader& header, std::size_t planes) {
  if (header.samples < 1 || header.lines < 1 || planes == 0) {
    throw std::invalid_argument("an ENVI image needs at least one sample, line and plane");
  }
  check_one_a_plane(header.band_names.size(), planes, "band names");
  check_one_a_plane(header.wavelength_um.size(), planes, "wavelengths");
  check_one_a_plane(header.fwhm_um.size(), planes, "widths");
  check_one_a_plane(header.gains.size(), planes, "gains");
  check_one_a_plane(header.offsets.size(), planes, "offsets");
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

}  // namespace

std::filesystem::path envi_header_of(const std::filesystem::path& image) {
  return std::filesystem::path{image}.replace_extension(".hdr");
}

struct EnviWriter::State {
  std::filesystem::path path;
  EnviHeader header;
  EnviType type;
  std::vector<std::uint64_t> written;  // bytes, by plane
  AtomicFile file;

  [[nodiscard]] std::uint64_t line_bytes() const {
    return envi_value_bytes(type) * static_cast<std::uint64_t>(header.samples);
  }
  [[nodiscard]] std::uint64_t plane_bytes() const {
    return line_bytes() * static_cast<std::uint64_t>(header.lines);
  }
};

EnviWriter::EnviWriter(const std::filesystem::path& image, EnviHeader header, EnviType type,
                       std::size_t planes) {
  check_envi_header(header, planes);
  state_.reset(new State{image, std::move(header), type, std::vector<std::uint64_t>(planes, 0),
                         AtomicFile{image}});
}

EnviWriter::~EnviWriter() = default;

/// Writing beyond the end leaves a hole that a later strip of an earlier plane fills.
void EnviWriter::write_bytes(std::size_t plane, EnviType type, std::span<const std::byte> bytes) {
  State& s = *state_;
  if (type != s.type) throw std::invalid_argument("an ENVI image has numbers of one type");
  std::uint64_t& done = s.written.at(plane);
  if (bytes.size() % s.line_bytes() != 0 || done + bytes.size() > s.plane_bytes()) {
    throw std::invalid_argument(fmt::format("a plane of {} x {} pixels has {} values",
                                            s.header.samples, s.header.lines,
                                            (done + bytes.size()) / envi_value_bytes(s.type)));
  }
  const std::uint64_t place = plane * s.plane_bytes() + done;
  if (s.file.position() != place) s.file.seek(place);
  s.file.write(bytes);
  done += bytes.size();
}

void EnviWriter::write(std::size_t plane, std::span<const float> lines) {
  write_bytes(plane, EnviType::float32, std::as_bytes(lines));
}
void EnviWriter::write(std::size_t plane, std::span<const double> lines) {
  write_bytes(plane, EnviType::float64, std::as_bytes(lines));
}
void EnviWriter::write(std::size_t plane, std::span<const std::uint16_t> lines) {
  write_bytes(plane, EnviType::uint16, std::as_bytes(lines));
}
void EnviWriter::write(std::size_t plane, std::span<const std::uint32_t> lines) {
  write_bytes(plane, EnviType::uint32, std::as_bytes(lines));
}

void EnviWriter::commit() {
  State& s = *state_;
  for (const std::uint64_t done : s.written) {
    if (done == s.plane_bytes()) continue;
    throw std::logic_error(fmt::format("{} has {} of {} lines", s.path.string(),
                                       done / s.line_bytes(), s.header.lines));
  }
  AtomicFile header_file{envi_header_of(s.path)};
  header_file.write(envi_header_text(s.header, s.written.size(), s.type));
  commit_pair(s.file, header_file);
}

namespace {

template <class T>
void write_whole_envi(const std::filesystem::path& image, const EnviHeader& header,
                      const std::vector<std::span<const T>>& planes) {
  check_envi_header(header, planes.size());
  const auto pixels =
      static_cast<std::size_t>(header.samples) * static_cast<std::size_t>(header.lines);
  for (const auto& plane : planes) {
    if (plane.size() != pixels) {
      throw std::invalid_argument(fmt::format("a plane of {} x {} pixels has {} values",
                                              header.samples, header.lines, plane.size()));
    }
  }
  EnviWriter writer{image, header, envi_type<T>, planes.size()};
  for (std::size_t i = 0; i < planes.size(); ++i) writer.write(i, planes[i]);
  writer.commit();
}

}  // namespace

void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const float>>& planes) {
  write_whole_envi(image, header, planes);
}
void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const double>>& planes) {
  write_whole_envi(image, header, planes);
}
void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const std::uint16_t>>& planes) {
  write_whole_envi(image, header, planes);
}
void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const std::uint32_t>>& planes) {
  write_whole_envi(image, header, planes);
}

}  // namespace nadir::sim
