#include "sim/products/write_products.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "sim/files/png.hpp"
#include "sim/products/array_files.hpp"
#include "sim/products/quick_look.hpp"

namespace nadir::sim {
namespace {

/// Letters, digits, point, dash, underscore and what is not ASCII stay; no leading point.
std::string file_name(const std::string& array) {
  std::string name = array.empty() ? "array" : array;
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       c == '.' || c == '-' || c == '_' || byte >= 0x80;
    if (!plain) c = '_';
  }
  if (name.front() == '.') name.front() = '_';
  return name;
}

void check_plane(const ArrayImage& image, const std::string& plane, std::size_t size) {
  if (size == image.pixels()) return;
  throw std::invalid_argument(fmt::format("array {}: {} has {} values for {} pixels", image.name,
                                          plane, size, image.pixels()));
}

void check(const ArrayImage& image, bool truth) {
  if (image.samples < 1 || image.lines < 1 || image.bands.empty()) {
    throw std::invalid_argument("array " + image.name + " has no pixels or no bands");
  }
  for (const BandImage& band : image.bands) {
    check_plane(image, "the radiance of " + band.name, band.radiance.size());
    check_plane(image, "the error of " + band.name, band.standard_error.size());
  }
  if (!truth) return;
  check_plane(image, "material", image.truth.material.size());
  check_plane(image, "range", image.truth.range_m.size());
  check_plane(image, "temperature", image.truth.temperature_k.size());
  check_plane(image, "sun elevation", image.truth.sun_elevation_deg.size());
  check_plane(image, "shadow", image.truth.shadow_fraction.size());
}

void check_names(const std::vector<ArrayImage>& images) {
  std::set<std::string> names;
  for (const ArrayImage& image : images) {
    if (!names.insert(file_name(image.name)).second) {
      throw std::invalid_argument("two arrays would write the files of " + file_name(image.name));
    }
  }
}

/// Whether the array has the bands that the scenario wants to see.
bool write_quick_look(const ArrayImage& image, const ProductContext& context,
                      const std::filesystem::path& stem, std::vector<ProductFile>& written) {
  const std::string& title = context.title.empty() ? context.scenario_name : context.title;
  const QuickLook look = quick_look(
      image, {title, context.time_utc, "nadir " + context.version, context.quick_look_bands});
  const auto file = with_ending(stem, ".png");
  write_png(file, look.picture);
  written.push_back({"quick look", image.name, file, std::filesystem::file_size(file)});
  return look.bands_as_wanted;
}

void warn_of_invalid_pixels(const ArrayImage& image, Diagnostics* diagnostics) {
  if (diagnostics == nullptr) return;
  const auto invalid = std::count_if(image.bands.begin(), image.bands.end(), [](const auto& band) {
    return std::any_of(band.radiance.begin(), band.radiance.end(),
                       [](float v) { return !std::isfinite(v); });
  });
  if (invalid == 0) return;
  diagnostics->warn(
      fmt::format("array {}: {} of {} bands hold pixels whose radiance is no finite number",
                  image.name, invalid, image.bands.size()));
}

}  // namespace

std::vector<ProductFile> write_products(const std::vector<ArrayImage>& images,
                                        const ProductContext& context,
                                        const std::filesystem::path& output_dir) {
  check_names(images);
  for (const ArrayImage& image : images) check(image, context.truth);
  std::filesystem::create_directories(output_dir);

  std::vector<ProductFile> written;
  bool shown_as_wanted = !context.quick_look;
  for (const ArrayImage& image : images) {
    const auto stem = output_dir / file_name(image.name);
    if (context.envi) write_array_envi(image, context, stem, written);
    if (context.exr) write_array_exr(image, context, stem, written);
    if (context.quick_look && write_quick_look(image, context, stem, written)) {
      shown_as_wanted = true;
    }
    warn_of_invalid_pixels(image, context.diagnostics);
  }
  // With several arrays it is enough that one has the bands: the others show their own.
  if (!shown_as_wanted && context.diagnostics != nullptr) {
    context.diagnostics->warn(
        "no array has the bands wanted for the quick look; each shows bands of its own");
  }
  return written;
}

}  // namespace nadir::sim
