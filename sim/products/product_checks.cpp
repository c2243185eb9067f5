#include "sim/products/product_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace nadir::sim {
namespace {

/// Goes through all planes that an image can have, in one order.
class PlaneChecker {
 public:
  explicit PlaneChecker(const ArrayImage& image) : image_{image} {}

  void must(const std::string& plane, std::size_t size) {
    list_.filled.push_back(true);
    if (size == image_.pixels()) return;
    throw std::invalid_argument(fmt::format("array {}: {} has {} values for {} pixels", image_.name,
                                            plane, size, image_.pixels()));
  }
  void may(const std::string& plane, std::size_t size) {
    if (size > 0) return must(plane, size);
    list_.filled.push_back(false);
  }
  [[nodiscard]] PlaneList take() { return std::move(list_); }

 private:
  const ArrayImage& image_;
  PlaneList list_;
};

void check_band_planes(PlaneChecker& checker, const BandImage& band) {
  checker.must("the radiance of " + band.name, band.radiance.size());
  checker.must("the error of " + band.name, band.standard_error.size());
  checker.may("the brightness temperature of " + band.name, band.brightness_temperature.size());
  checker.may("the brightness temperature's error of " + band.name,
              band.brightness_temperature_error.size());
  checker.may("the path radiance of " + band.name, band.shares.path.size());
  checker.may("the emission of " + band.name, band.shares.emission.size());
  checker.may("the systematic error of " + band.name, band.bias.size());
  checker.may("the digital numbers of " + band.name, band.dn.size());
  checker.may("the electrons of " + band.name, band.electrons.size());
  checker.may("the noise of " + band.name, band.noise.size());
}

// Range, temperature, sun elevation and shadow are there wherever the truth is.
constexpr std::size_t certain_truth_planes = 4;

void check_truth_planes(PlaneChecker& checker, const TruthImage& truth, bool wanted) {
  const auto check = [&](bool certain, const std::string& plane, std::size_t size) {
    certain&& wanted ? checker.must(plane, size) : checker.may(plane, size);
  };
  check(true, "material", truth.material.size());
  check(false, "object", truth.object.size());
  for (std::size_t i = 0; i < truth_planes.size(); ++i) {
    const auto& plane = truth_planes[i];
    check(i < certain_truth_planes, plane.name, (truth.*plane.values).size());
  }
  for (const auto& plane : place_planes) check(false, plane.name, (truth.*plane.values).size());
  for (const auto& plane : truth.fractions) check(false, "a material's fraction", plane.size());
}

void check_fractions(const ArrayImage& image) {
  const std::size_t found = image.truth.fractions.size();
  const std::size_t expected = 1 + image.truth.material_names.size();
  if (found == 0 || found == expected) return;
  throw std::invalid_argument(
      fmt::format("array {}: {} planes of fractions for the sky and {} materials", image.name,
                  found, expected - 1));
}

}  // namespace

PlaneList check_planes(const ArrayImage& image, bool truth) {
  if (image.samples < 1 || image.lines < 1 || image.bands.empty()) {
    throw std::invalid_argument("array " + image.name + " has no pixels or no bands");
  }
  PlaneChecker checker{image};
  for (const BandImage& band : image.bands) check_band_planes(checker, band);
  checker.may("the paths", image.pixel_paths.size());
  check_truth_planes(checker, image.truth, truth);
  check_fractions(image);
  return checker.take();
}

void check_first_strip(const ArrayImage& strip) {
  if (strip.first_line == 0) return;
  throw std::invalid_argument(
      fmt::format("array {} begins with line {}, not 0", strip.name, strip.first_line));
}

std::string product_file_name(const std::string& array) {
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

}  // namespace nadir::sim
