#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "image_module.hpp"

namespace {

void check(bool fine, const std::string& reason) {
  if (!fine) throw std::runtime_error(reason.empty() ? "OpenImageIO gave no reason" : reason);
}

/// The one exit for errors: an exception must not cross into the other library.
template <class Work>
int guarded(char* error, std::size_t error_size, const Work& work) {
  try {
    work();
    return 0;
  } catch (const std::exception& failure) {
    const std::size_t length = std::min(std::strlen(failure.what()), error_size - 1);
    std::memcpy(error, failure.what(), length);
    error[length] = '\0';
    return 1;
  }
}

OIIO::ImageSpec spec_of(const NadirPicture& picture) {
  OIIO::ImageSpec spec{picture.width, picture.height, picture.channels,
                       picture.bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8};
  spec.attribute("oiio:ColorSpace", "sRGB");
  for (std::size_t i = 0; i < picture.text_count; ++i) {
    spec.attribute(picture.text[2 * i], picture.text[2 * i + 1]);
  }
  return spec;
}

/// OpenImageIO would read 16-bit values as fractions of 65535 when it writes 8 bits, so 8-bit
/// pictures are narrowed here.
bool write_values(OIIO::ImageOutput& output, const NadirPicture& picture) {
  if (picture.bits == 16) return output.write_image(OIIO::TypeDesc::UINT16, picture.values);
  const auto count = static_cast<std::size_t>(picture.width) *
                     static_cast<std::size_t>(picture.height) *
                     static_cast<std::size_t>(picture.channels);
  std::vector<std::uint8_t> narrow(count);
  std::transform(picture.values, picture.values + count, narrow.begin(),
                 [](std::uint16_t value) { return static_cast<std::uint8_t>(value); });
  return output.write_image(OIIO::TypeDesc::UINT8, narrow.data());
}

int encode_png(const NadirPicture* picture, NadirBytesSink sink, void* state, char* error,
               std::size_t error_size) {
  return guarded(error, error_size, [&] {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput target{bytes};
    const auto output = OIIO::ImageOutput::create("memory.png", &target);
    check(output != nullptr, OIIO::geterror());
    check(output->open("memory.png", spec_of(*picture)), output->geterror());
    check(write_values(*output, *picture), output->geterror());
    check(output->close(), output->geterror());
    sink(state, bytes.data(), bytes.size());
  });
}

/// Reads as 16 bits, then undoes the widening of 8-bit values (x 257).
std::vector<std::uint16_t> read_values(OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
  std::vector<std::uint16_t> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  check(input.read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT16, values.data()), input.geterror());
  if (spec.format == OIIO::TypeDesc::UINT8) {
    for (auto& value : values) value = static_cast<std::uint16_t>(value / 257);
  }
  return values;
}

int decode_png(const std::uint8_t* bytes, std::size_t count, NadirPictureSink sink, void* state,
               char* error, std::size_t error_size) {
  return guarded(error, error_size, [&] {
    OIIO::Filesystem::IOMemReader source{const_cast<std::uint8_t*>(bytes), count};
    const auto input = OIIO::ImageInput::open("memory.png", nullptr, &source);
    check(input != nullptr, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    check(spec.nchannels == 1 || spec.nchannels == 3, "the PNG has neither 1 nor 3 channels");
    const std::vector<std::uint16_t> values = read_values(*input, spec);
    const int bits = spec.format == OIIO::TypeDesc::UINT8 ? 8 : 16;
    const NadirPicture picture{
        spec.width, spec.height, spec.nchannels, bits, values.data(), nullptr, 0};
    sink(state, &picture);
  });
}

}  // namespace

extern "C" [[gnu::visibility("default")]] const NadirImageModule* nadir_image_module() {
  static constexpr NadirImageModule table{nadir_image_module_version, encode_png, decode_png};
  return &table;
}
