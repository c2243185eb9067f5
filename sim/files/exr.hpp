#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace nadir::sim {

/// Floats, or unsigned ids.
using ExrValues = std::variant<std::span<const float>, std::span<const std::uint32_t>>;

/// One plane of a multi-channel EXR.
struct ExrChannel {
  std::string name;  ///< dots make layers: `radiance.B4`
  ExrValues values;  ///< row-major
};

/// What stands in the header beside the channels.
using ExrAttribute = std::variant<std::string, std::vector<std::string>, std::vector<float>, int>;

struct ExrImage {
  int samples = 0, lines = 0;
  std::vector<ExrChannel> channels;
  std::map<std::string, ExrAttribute> attributes;
};

/// A channel of a file that is written strip by strip.
struct ExrChannelKind {
  std::string name;
  bool ids = false;  ///< unsigned integers rather than floats
};

/// Writes an image of which only some whole lines are in memory at a time, with lossless ZIP
/// compression, 32 bits a value; how the lines are cut into strips does not show in the bytes. The
/// name appears, with `commit`, only with the whole file.
class ExrWriter {
 public:
  struct Layout {
    int samples = 0, lines = 0;
    std::vector<ExrChannelKind> channels;
    std::map<std::string, ExrAttribute> attributes{};
  };
  /// @throws std::runtime_error when the file cannot be made, std::invalid_argument when there are
  ///         no pixels or two channels share a name
  ExrWriter(const std::filesystem::path& file, const Layout& layout);
  ~ExrWriter();
  ExrWriter(const ExrWriter&) = delete;
  ExrWriter& operator=(const ExrWriter&) = delete;

  /// The next whole lines, row-major, of all channels in the layout's order.
  /// @throws std::runtime_error when they cannot be written, std::invalid_argument when they are no
  ///         whole lines, too many, or of another kind
  void write(const std::vector<ExrValues>& strip);
  /// @throws std::logic_error while lines are missing
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes the image with lossless ZIP compression, 32 bits a value. The name appears only with the
/// whole file.
/// @throws std::runtime_error when the file cannot be written, std::invalid_argument when sizes
///         do not agree or two channels share a name.
void write_exr(const std::filesystem::path& file, const ExrImage& image);

/// A file read back, each channel with values of its own.
struct ExrContents {
  int samples = 0, lines = 0;
  std::map<std::string, std::variant<std::vector<float>, std::vector<std::uint32_t>>> channels;
  std::map<std::string, ExrAttribute> attributes;  ///< those of the kinds of ExrAttribute
};

/// Reads all channels of a single-part scan-line EXR; half-precision channels become floats.
/// @throws std::runtime_error when the file cannot be read.
[[nodiscard]] ExrContents read_exr(const std::filesystem::path& file);

}  // namespace nadir::sim
