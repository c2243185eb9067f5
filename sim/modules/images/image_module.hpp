#pragma once

#include <cstddef>
#include <cstdint>

// The seam between the simulator and the module that holds OpenImageIO. Plain C types only: no
// exception, string or allocation crosses it. The module sees no file; bytes come and go in memory,
// so that how files reach the disc is decided in one place.

extern "C" {

struct NadirPicture {
  std::int32_t width, height;
  std::int32_t channels;  // 1 or 3
  std::int32_t bits;      // 8 or 16
  const std::uint16_t* values;
  const char* const* text;  // key, value, key, value, ...
  std::size_t text_count;   // of pairs
};

/// Where a function puts its result, called once on success. `state` is the caller's.
typedef void (*NadirBytesSink)(void* state, const std::uint8_t* bytes, std::size_t count);
typedef void (*NadirPictureSink)(void* state, const NadirPicture* picture);

/// A function returns 0, or not 0 with the reason in `error`, a text cut to `error_size` bytes with
/// its closing zero.
struct NadirImageModule {
  std::uint32_t version;
  int (*encode_png)(const NadirPicture* picture, NadirBytesSink sink, void* state, char* error,
                    std::size_t error_size);
  int (*decode_png)(const std::uint8_t* bytes, std::size_t count, NadirPictureSink sink,
                    void* state, char* error, std::size_t error_size);
};

typedef const NadirImageModule* (*NadirImageModuleFunction)();
}

/// Changes with every change of the structures above.
inline constexpr std::uint32_t nadir_image_module_version = 1;
/// The one symbol that the module exports.
inline constexpr const char* nadir_image_module_symbol = "nadir_image_module";
