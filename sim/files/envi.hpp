#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// ENVI raster files: planes of numbers one after the other (BSQ, little endian) in `name.img`, and
// a text header beside it in `name.hdr`. Keywords: ENVI header file format, L3Harris Geospatial,
// "ENVI Header Files"; `data units` is ours.

namespace nadir::sim {

/// ENVI's numbers for the types that are written.
enum class EnviType { float32 = 4, float64 = 5, uint16 = 12, uint32 = 13 };

/// What the header says about the planes.
struct EnviHeader {
  int samples = 0, lines = 0;
  std::string description;
  std::string sensor_type;
  std::string acquisition_time;          ///< ISO 8601, UTC
  std::string data_units;                ///< of all planes, or empty where they differ
  std::vector<std::string> band_names;   ///< one a plane; names also go without comma and brace
  std::vector<double> wavelength_um;     ///< one a plane, or none
  std::vector<double> fwhm_um;           ///< one a plane, or none
  std::vector<std::string> class_names;  ///< of the ids 0, 1, ..., or none
  bool nan_is_no_data = false;           ///< whether readers may treat NaN as "nothing there"
  std::vector<double> gains, offsets;    ///< value = gain x number + offset; one a plane, or none
  /// Further keywords with their values, in the order written. Not read back.
  std::vector<std::pair<std::string, std::string>> more{};
};

/// Writes an image of which only some whole lines are in memory at a time. Strips of a plane come
/// in order; planes in any order. Each of the two names appears, with `commit`, only with its whole
/// content, and a new header never stands beside an old image. A comma, brace or line break in a
/// list's name would break the header's syntax and is written as an underscore.
class EnviWriter {
 public:
  /// @throws std::runtime_error when the file cannot be made, std::invalid_argument when there are
  ///         no pixels or the header's lists have not one item a plane
  EnviWriter(const std::filesystem::path& image, EnviHeader header, EnviType type,
             std::size_t planes);
  ~EnviWriter();
  EnviWriter(const EnviWriter&) = delete;
  EnviWriter& operator=(const EnviWriter&) = delete;

  /// The next whole lines of a plane.
  /// @throws std::runtime_error when they cannot be written, std::invalid_argument when they are no
  ///         whole lines, too many, or numbers of another type
  void write(std::size_t plane, std::span<const float> lines);
  void write(std::size_t plane, std::span<const double> lines);
  void write(std::size_t plane, std::span<const std::uint16_t> lines);
  void write(std::size_t plane, std::span<const std::uint32_t> lines);

  /// Gives image and header their names. @throws std::logic_error while lines are missing
  void commit();

 private:
  struct State;
  void write_bytes(std::size_t plane, EnviType type, std::span<const std::byte> bytes);
  std::unique_ptr<State> state_;
};

/// The same for planes that are in memory as a whole.
/// @throws as EnviWriter
void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const float>>& planes);
void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const double>>& planes);
void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const std::uint16_t>>& planes);
void write_envi(const std::filesystem::path& image, const EnviHeader& header,
                const std::vector<std::span<const std::uint32_t>>& planes);

/// Reads images of the kind that EnviWriter writes, some whole lines of a plane at a time.
class EnviReader {
 public:
  /// Reads the header. @throws InputError naming what is missing or not of that kind.
  explicit EnviReader(const std::filesystem::path& image);
  ~EnviReader();
  EnviReader(EnviReader&&) noexcept;
  EnviReader& operator=(EnviReader&&) noexcept;

  [[nodiscard]] const EnviHeader& header() const noexcept;
  [[nodiscard]] EnviType type() const noexcept;
  [[nodiscard]] std::size_t planes() const noexcept;

  /// As many whole lines, from `first_line` on, as there is room for.
  /// @throws InputError when the file cannot be read, std::invalid_argument when there are no such
  ///         lines or the room is of another type than the file
  void read(std::size_t plane, int first_line, std::span<float> room);
  void read(std::size_t plane, int first_line, std::span<double> room);
  void read(std::size_t plane, int first_line, std::span<std::uint16_t> room);
  void read(std::size_t plane, int first_line, std::span<std::uint32_t> room);

 private:
  struct State;
  template <class T>
  void read_lines(std::size_t plane, int first_line, std::span<T> room);
  std::unique_ptr<State> state_;
};

/// The numbers of all planes, by type.
using EnviPlanes =
    std::variant<std::vector<std::vector<float>>, std::vector<std::vector<double>>,
                 std::vector<std::vector<std::uint16_t>>, std::vector<std::vector<std::uint32_t>>>;

/// What `write_envi` wrote.
struct EnviImage {
  EnviHeader header;
  EnviPlanes planes;
};

/// Reads a whole image of the kind that `write_envi` writes.
/// @throws InputError naming what is missing or not of that kind.
[[nodiscard]] EnviImage read_envi(const std::filesystem::path& image);

/// Where the header of an image lies: the same name with the extension `.hdr`.
[[nodiscard]] std::filesystem::path envi_header_of(const std::filesystem::path& image);

}  // namespace nadir::sim
