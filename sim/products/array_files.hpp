#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/products/write_products.hpp"
#include "sim/run/image.hpp"

namespace nadir::sim {

/// What the writers of an array's files have in common.
struct ArrayTask {
  const ProductContext* context = nullptr;
  std::filesystem::path stem;  ///< path without the part of the name that tells the products apart
  std::size_t number = 0;      ///< of the array, in the camera where that is known
  /// Of the camera; null where it is not known.
  const sensor::DetectorArray* array = nullptr;
};

/// The task for an array. @param arrival  how many arrays came before
[[nodiscard]] ArrayTask array_task(const ProductContext& context,
                                   const std::filesystem::path& output_dir, const std::string& name,
                                   std::size_t arrival);

/// The planes of an array as ENVI files, strip by strip.
class ArrayEnvi {
 public:
  /// @param first  the first strip, which tells what there is to write
  ArrayEnvi(const ArrayImage& first, const ArrayTask& task);
  ~ArrayEnvi();
  ArrayEnvi(ArrayEnvi&&) noexcept;
  ArrayEnvi& operator=(ArrayEnvi&&) noexcept;

  void take(const ArrayImage& strip);
  /// Gives the files their names and adds them to the list.
  void finish(std::vector<ProductFile>& written);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All planes of an array but the places in one EXR, strip by strip.
class ArrayExr {
 public:
  ArrayExr(const ArrayImage& first, const ArrayTask& task);
  ~ArrayExr();
  ArrayExr(ArrayExr&&) noexcept;
  ArrayExr& operator=(ArrayExr&&) noexcept;

  void take(const ArrayImage& strip);
  void finish(std::vector<ProductFile>& written);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The stem with an ending: `out/oli` and `_error.img` make `out/oli_error.img`.
[[nodiscard]] inline std::filesystem::path with_ending(std::filesystem::path stem,
                                                       const char* ending) {
  return stem += ending;
}

/// The names of the ids 0, 1, ...: the sky and what else there is.
[[nodiscard]] std::vector<std::string> names_with_sky(const std::vector<std::string>& names);

/// What a part of a band's radiance is of the whole; NaN where that is 0. Fills and returns `room`.
enum class LightShare { path, emission, reflection };
[[nodiscard]] const std::vector<float>& light_share(const BandImage& band, LightShare part,
                                                    std::vector<float>& room);

/// When lines were exposed, as keywords with values (s); nothing for a snapshot at time 0.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> line_times(
    const sensor::DetectorArray& array);

/// Back to radiance, of a band; nothing where it is not known.
[[nodiscard]] const sensor::Calibration* calibration_of(const ArrayTask& task, std::size_t band);

/// Whether products are wanted that are made from an array's finished ENVI files.
[[nodiscard]] bool wants_geo_products(const ProductContext& context);

}  // namespace nadir::sim
