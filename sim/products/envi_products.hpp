#pragma once

#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "sim/files/envi.hpp"
#include "sim/products/array_files.hpp"

namespace nadir::sim {

/// The numbers of one plane of a strip.
using StripPlane = std::variant<std::span<const float>, std::span<const double>,
                                std::span<const std::uint16_t>, std::span<const std::uint32_t>>;
/// Where a file's plane comes from. @param room  for planes that are computed
using PlaneSource = std::function<StripPlane(const ArrayImage& strip, std::vector<float>& room)>;

/// One ENVI file of an array.
struct EnviProduct {
  const char* kind = "";    ///< as ProductFile has it
  const char* ending = "";  ///< of the name
  EnviType type = EnviType::float32;
  EnviHeader header{};
  std::vector<PlaneSource> planes{};
};

/// The files that the context asks for and whose planes the array has.
[[nodiscard]] std::vector<EnviProduct> envi_products(const ArrayImage& first,
                                                     const ArrayTask& task);

}  // namespace nadir::sim
