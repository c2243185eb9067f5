#include "sim/files/exr.hpp"

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

struct Plane {
  Imf::PixelType type;
  const void* data;
  std::size_t count;
};

Plane plane_of(const ExrChannel& channel) {
  return std::visit(Overloaded{[](std::span<const float> v) {
                                 return Plane{Imf::FLOAT, v.data(), v.size()};
                               },
                               [](std::span<const std::uint32_t> v) {
                                 return Plane{Imf::UINT, v.data(), v.size()};
                               }},
                    channel.values);
}

/// OpenEXR wants a pointer that it may write to even for output; it only reads.
Imf::Slice slice_of(const Plane& plane, int samples) {
  constexpr std::size_t value_bytes = 4;
  return {plane.type, static_cast<char*>(const_cast<void*>(plane.data)), value_bytes,
          value_bytes * static_cast<std::size_t>(samples)};
}

void check(const ExrImage& image) {
  if (image.samples < 1 || image.lines < 1 || image.channels.empty()) {
    throw std::invalid_argument("an EXR image needs at least one sample, line and channel");
  }
  const auto pixels =
      static_cast<std::size_t>(image.samples) * static_cast<std::size_t>(image.lines);
  for (const ExrChannel& channel : image.channels) {
    if (plane_of(channel).count != pixels) {
      throw std::invalid_argument("the EXR channel " + channel.name + " has the wrong size");
    }
  }
}

}  // namespace

void write_exr(const std::filesystem::path& file, const ExrImage& image) {
  check(image);
  Imf::Header header{image.samples, image.lines};
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, attribute] : image.attributes) insert(header, name, attribute);

  Imf::FrameBuffer frame;
  for (const ExrChannel& channel : image.channels) {
    if (header.channels().findChannel(channel.name) != nullptr) {
      throw std::invalid_argument("two EXR channels are named " + channel.name);
    }
    const Plane plane = plane_of(channel);
    header.channels().insert(channel.name, Imf::Channel{plane.type});
    frame.insert(channel.name, slice_of(plane, image.samples));
  }

  AtomicFile target{file};
  AtomicStream stream{target};
  {
    Imf::OutputFile output{stream, header};
    output.setFrameBuffer(frame);
    output.writePixels(image.lines);
  }  // the line table is written when `output` closes
  stream.rethrow_failure();
  target.commit();
}

}  // namespace nadir::sim
