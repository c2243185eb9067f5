#include "sim/files/png.hpp"

#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "sim/files/atomic_file.hpp"
#include "sim/files/modules.hpp"
#include "sim/modules/images/image_module.hpp"

namespace nadir::sim {
namespace {

const NadirImageModule& image_module() {
  const auto& table = load_module<NadirImageModule>("nadir_images", nadir_image_module_symbol);
  if (table.version != nadir_image_module_version) {
    throw std::runtime_error("the module nadir_images belongs to another version of nadir");
  }
  return table;
}

void check(const PngImage& image) {
  const bool sizes = image.width > 0 && image.height > 0;
  const bool kind =
      (image.channels == 1 || image.channels == 3) && (image.bits == 8 || image.bits == 16);
  const auto count = static_cast<std::size_t>(image.width) *
                     static_cast<std::size_t>(image.height) *
                     static_cast<std::size_t>(image.channels);
  if (!sizes || !kind || image.values.size() != count) {
    throw std::invalid_argument("a PNG's sizes do not agree");
  }
}

/// A PNG's plain text is Latin-1 (PNG specification, 11.3.4.3): bytes beyond ASCII, two to four for
/// a character of UTF-8, become one question mark.
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) result += c;
    if (byte >= 0xC0) result += '?';
  }
  return result;
}

using ErrorText = std::array<char, 512>;

void check_result(int result, const char* action, const std::filesystem::path& file,
                  const ErrorText& error) {
  if (result == 0) return;
  throw std::runtime_error(std::string{"cannot "} + action + " " + file.string() + ": " +
                           error.data());
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw std::runtime_error("cannot open " + file.string());
  return {std::istreambuf_iterator<char>{stream}, {}};
}

// Called by the module, through which no exception may pass: running out of memory ends here.
void keep_bytes(void* state, const std::uint8_t* bytes, std::size_t count) noexcept {
  static_cast<std::string*>(state)->assign(reinterpret_cast<const char*>(bytes), count);
}

void keep_picture(void* state, const NadirPicture* picture) noexcept {
  auto& image = *static_cast<PngImage*>(state);
  image.width = picture->width;
  image.height = picture->height;
  image.channels = picture->channels;
  image.bits = picture->bits;
  const auto count = static_cast<std::size_t>(image.width) *
                     static_cast<std::size_t>(image.height) *
                     static_cast<std::size_t>(image.channels);
  image.values.assign(picture->values, picture->values + count);
}

}  // namespace

void write_png(const std::filesystem::path& file, const PngImage& image) {
  check(image);
  std::vector<std::string> texts;
  for (const auto& [key, value] : image.text) {
    texts.push_back(plain(key));
    texts.push_back(plain(value));
  }
  std::vector<const char*> pointers;
  pointers.reserve(texts.size());
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  const NadirPicture picture{image.width,         image.height,    image.channels,   image.bits,
                             image.values.data(), pointers.data(), image.text.size()};
  std::string bytes;
  ErrorText error{};
  check_result(image_module().encode_png(&picture, keep_bytes, &bytes, error.data(), error.size()),
               "encode", file, error);
  write_file(file, bytes);
}

PngImage read_png(const std::filesystem::path& file) {
  const std::string bytes = bytes_of(file);
  PngImage image;
  ErrorText error{};
  check_result(
      image_module().decode_png(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(),
                                keep_picture, &image, error.data(), error.size()),
      "decode", file, error);
  return image;
}

}  // namespace nadir::sim
