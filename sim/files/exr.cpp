#include "sim/files/exr.hpp"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfStringVectorAttribute.h>

#include <exception>
#include <optional>
#include <stdexcept>

#include "sim/files/atomic_file.hpp"

namespace nadir::sim {
namespace {

/// Sends OpenEXR's bytes into the temporary file. OpenEXR comes back to the front to fill in its
/// table of line offsets.
class AtomicStream final : public Imf::OStream {
 public:
  explicit AtomicStream(AtomicFile& file) : Imf::OStream{file.destination().c_str()}, file_{file} {}
  void write(const char bytes[], int count) override {
    try {
      file_.write(std::string_view{bytes, static_cast<std::size_t>(count)});
    } catch (...) {
      failure_ = std::current_exception();
      throw;
    }
  }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }
  /// OpenEXR writes the line table in a destructor, which swallows what `write` throws.
  void rethrow_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  AtomicFile& file_;
  std::exception_ptr failure_;
};

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

void insert(Imf::Header& header, const std::string& name, const ExrAttribute& attribute) {
  std::visit(Overloaded{[&](const std::string& v) { header.insert(name, Imf::StringAttribute{v}); },
                        [&](const std::vector<std::string>& v) {
                          header.insert(name, Imf::StringVectorAttribute{v});
                        },
                        [&](const std::vector<float>& v) {
                          header.insert(name, Imf::FloatVectorAttribute{v});
                        },
                        [&](int v) { header.insert(name, Imf::IntAttribute{v}); }},
             attribute);
}

struct ExrPlane {
  const void* data = nullptr;
  std::size_t count = 0;
};

ExrPlane exr_plane_of(const ExrValues& values) {
  return std::visit([](auto span) { return ExrPlane{span.data(), span.size()}; }, values);
}

Imf::PixelType pixel_type(bool ids) { return ids ? Imf::UINT : Imf::FLOAT; }

Imf::Header exr_header_of(const ExrWriter::Layout& layout) {
  if (layout.samples < 1 || layout.lines < 1 || layout.channels.empty()) {
    throw std::invalid_argument("an EXR image needs at least one sample, line and channel");
  }
  Imf::Header header{layout.samples, layout.lines};
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, attribute] : layout.attributes) insert(header, name, attribute);
  for (const auto& [name, ids] : layout.channels) {
    if (header.channels().findChannel(name) != nullptr) {
      throw std::invalid_argument("two EXR channels are named " + name);
    }
    header.channels().insert(name, Imf::Channel{pixel_type(ids)});
  }
  return header;
}

}  // namespace

struct ExrWriter::State {
  State(const std::filesystem::path& path, const Layout& l)
      : header{exr_header_of(l)}, layout{l}, target{path}, stream{target} {
    output.emplace(stream, header);
  }

  /// Lines in a channel's strip. @throws std::invalid_argument for what is not its next lines
  [[nodiscard]] int lines_of(std::size_t channel, const ExrValues& values) const {
    const ExrChannelKind& kind = layout.channels[channel];
    const auto samples = static_cast<std::size_t>(layout.samples);
    const std::size_t count = exr_plane_of(values).count;
    const auto left = static_cast<std::size_t>(layout.lines - next_line);
    const bool fits = count % samples == 0 && count / samples <= left;
    if (!fits || kind.ids != std::holds_alternative<std::span<const std::uint32_t>>(values)) {
      throw std::invalid_argument("the EXR channel " + kind.name + " has the wrong size");
    }
    return static_cast<int>(count / samples);
  }

  Imf::Header header;
  Layout layout;
  AtomicFile target;
  AtomicStream stream;
  std::optional<Imf::OutputFile> output;
  int next_line = 0;
};

ExrWriter::ExrWriter(const std::filesystem::path& file, const Layout& layout)
    : state_{std::make_unique<State>(file, layout)} {}

ExrWriter::~ExrWriter() = default;

void ExrWriter::write(const std::vector<ExrValues>& strip) {
  State& s = *state_;
  if (strip.size() != s.layout.channels.size()) {
    throw std::invalid_argument("an EXR strip has not the file's channels");
  }
  const int lines = s.lines_of(0, strip[0]);
  if (lines == 0) return;
  const Imath::Box2i window{{0, s.next_line}, {s.layout.samples - 1, s.next_line + lines - 1}};
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < strip.size(); ++i) {
    const auto& [name, ids] = s.layout.channels[i];
    if (s.lines_of(i, strip[i]) != lines) {
      throw std::invalid_argument("the EXR channel " + name + " has the wrong size");
    }
    // OpenEXR wants a pointer that it may write to even for output; it only reads.
    void* data = const_cast<void*>(exr_plane_of(strip[i]).data);
    frame.insert(name, Imf::Slice::Make(pixel_type(ids), data, window));
  }
  s.output->setFrameBuffer(frame);
  s.output->writePixels(lines);
  s.next_line += lines;
}

void ExrWriter::commit() {
  State& s = *state_;
  if (s.next_line != s.layout.lines) {
    throw std::logic_error(s.target.destination().string() + " has " + std::to_string(s.next_line) +
                           " of " + std::to_string(s.layout.lines) + " lines");
  }
  s.output.reset();  // writes the table of lines
  s.stream.rethrow_failure();
  s.target.commit();
}

void write_exr(const std::filesystem::path& file, const ExrImage& image) {
  ExrWriter::Layout layout{image.samples, image.lines, {}, image.attributes};
  std::vector<ExrValues> values;
  const auto pixels =
      static_cast<std::size_t>(image.samples) * static_cast<std::size_t>(image.lines);
  for (const ExrChannel& channel : image.channels) {
    if (exr_plane_of(channel.values).count != pixels) {
      throw std::invalid_argument("the EXR channel " + channel.name + " has the wrong size");
    }
    layout.channels.push_back(
        {channel.name, std::holds_alternative<std::span<const std::uint32_t>>(channel.values)});
    values.push_back(channel.values);
  }
  ExrWriter writer{file, layout};
  writer.write(values);
  writer.commit();
}

}  // namespace nadir::sim
