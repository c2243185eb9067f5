#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfStringVectorAttribute.h>

#include <stdexcept>

#include "sim/files/exr.hpp"

namespace nadir::sim {
namespace {

template <class Kind>
void keep(const char* name, const Imf::Attribute& attribute, ExrContents& contents) {
  if (const auto* found = dynamic_cast<const Kind*>(&attribute)) {
    contents.attributes[name] = found->value();
  }
}

void keep_attributes(const Imf::Header& header, ExrContents& contents) {
  for (auto i = header.begin(); i != header.end(); ++i) {
    keep<Imf::StringAttribute>(i.name(), i.attribute(), contents);
    keep<Imf::StringVectorAttribute>(i.name(), i.attribute(), contents);
    keep<Imf::FloatVectorAttribute>(i.name(), i.attribute(), contents);
    keep<Imf::IntAttribute>(i.name(), i.attribute(), contents);
  }
}

/// Room for a channel, and a slice that makes OpenEXR fill it. The slice's base is where pixel
/// (0, 0) would lie, which a data window that starts elsewhere puts outside of the room.
template <class T>
Imf::Slice make_room(ExrContents& contents, const char* name, Imf::PixelType type,
                     const Imath::Box2i& window) {
  auto& values = contents.channels[name].emplace<std::vector<T>>();
  values.resize(static_cast<std::size_t>(contents.samples) *
                static_cast<std::size_t>(contents.lines));
  return Imf::Slice::Make(type, values.data(), window);
}

void read_channels(Imf::InputFile& input, const Imath::Box2i& window, ExrContents& contents) {
  const Imf::ChannelList& channels = input.header().channels();
  Imf::FrameBuffer frame;
  for (auto i = channels.begin(); i != channels.end(); ++i) {
    const bool ids = i.channel().type == Imf::UINT;
    frame.insert(i.name(), ids ? make_room<std::uint32_t>(contents, i.name(), Imf::UINT, window)
                               : make_room<float>(contents, i.name(), Imf::FLOAT, window));
  }
  input.setFrameBuffer(frame);
  input.readPixels(window.min.y, window.max.y);
}

}  // namespace

ExrContents read_exr(const std::filesystem::path& file) {
  try {
    Imf::InputFile input{file.c_str()};
    const Imath::Box2i window = input.header().dataWindow();
    ExrContents contents;
    contents.samples = window.max.x - window.min.x + 1;
    contents.lines = window.max.y - window.min.y + 1;
    keep_attributes(input.header(), contents);
    read_channels(input, window, contents);
    return contents;
  } catch (const std::exception& failure) {
    throw std::runtime_error("cannot read " + file.string() + ": " + failure.what());
  }
}

}  // namespace nadir::sim
