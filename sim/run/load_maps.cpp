#include "sim/run/load_maps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>

#include "materials/maps/contrast_choice.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/map_raster.hpp"

namespace nadir::sim {
namespace {

using materials::MaterialMap;

/// Fractions are printed with few decimals: 1e-3 forgives that, and is below what anyone measures.
constexpr double fraction_tolerance = 1e-3;

std::uint32_t material_index(int material) { return static_cast<std::uint32_t>(material); }

class MapReader {
 public:
  MapReader(const MaterialMapInput& input, const std::vector<materials::Material>& all,
            const MapContext& context)
      : input_{input}, materials_{all}, context_{context} {}

  MaterialMap read() {
    std::visit([&](const auto& rule) { fill(rule); }, input_.rule);
    return std::move(map_);
  }

 private:
  void place(const Raster& raster) {
    map_.frame = map_frame(input_.place, input_.raster, raster, context_);
  }

  void fill(const ChoicesInput& rule) {
    const Raster raster = read_raster(input_.raster, rule.band);
    place(raster);
    std::map<double, std::uint16_t> layer_of;
    std::vector<double> known;
    for (const ChoicesInput::Choice& choice : rule.choices) {
      layer_of.emplace(choice.value, static_cast<std::uint16_t>(map_.materials.size()));
      map_.materials.push_back(material_index(choice.material));
      known.push_back(choice.value);
    }
    map_.choice.reserve(raster.values.size());
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
      const double value = raster.values[i];
      const auto layer = std::isnan(value) ? layer_of.end() : layer_of.find(value);
      if (layer == layer_of.end()) throw unlisted(raster, i, known);
      map_.choice.push_back(layer->second);
    }
  }

  [[nodiscard]] InputError unlisted(const Raster& raster, std::size_t pixel,
                                    const std::vector<double>& known) const {
    const double value = raster.values[pixel];
    if (std::isnan(value)) {
      return pixel_error(
          input_.raster, raster, pixel,
          fmt::format("has no value, so that map {} gives it no material", input_.name));
    }
    return pixel_error(
        input_.raster, raster, pixel,
        fmt::format("holds {}, for which map {} has no <choice>", value, input_.name),
        fmt::format("choices are: {}", fmt::join(known, ", ")));
  }

  void fill(const FractionsInput& rule) {
    std::vector<Raster> bands;
    for (const FractionsInput::Fraction& fraction : rule.fractions) {
      bands.push_back(read_raster(input_.raster, fraction.band));
      map_.materials.push_back(material_index(fraction.material));
    }
    place(bands.front());
    const std::size_t pixels = bands.front().values.size();
    map_.cumulative.reserve(pixels * bands.size());
    for (std::size_t i = 0; i < pixels; ++i) add_fractions(bands, i);
  }

  void add_fractions(const std::vector<Raster>& bands, std::size_t pixel) {
    double sum = 0.0;
    for (const Raster& band : bands) {
      const double share = band.values[pixel];
      if (!(share >= -fraction_tolerance && share <= 1.0 + fraction_tolerance)) {
        throw pixel_error(input_.raster, band, pixel,
                          std::isnan(share)
                              ? fmt::format("has no value in a band of map {}", input_.name)
                              : fmt::format("holds the fraction {:.6g} in a band of map {}; "
                                            "fractions are from 0 to 1",
                                            share, input_.name));
      }
      sum += std::max(share, 0.0);
    }
    if (std::abs(sum - 1.0) > fraction_tolerance) {
      throw pixel_error(
          input_.raster, bands.front(), pixel,
          fmt::format("has fractions that sum to {:.6g}, not to 1, in map {}", sum, input_.name));
    }
    double running = 0.0;  // adds up as `sum` did, so that the last share ends at exactly 1
    for (const Raster& band : bands) {
      running += std::max(band.values[pixel], 0.0);
      map_.cumulative.push_back(static_cast<float>(running / sum));
    }
  }

  void fill(const ContrastInput& rule) {
    const Raster raster = read_raster(input_.raster, rule.band);
    place(raster);
    std::vector<double> reflectance;
    for (const int material : rule.materials) {
      map_.materials.push_back(material_index(material));
      reflectance.push_back(materials_[static_cast<std::size_t>(material)].reflectance->mean(
          Micrometres{rule.band_low_um}, Micrometres{rule.band_high_um}));
    }
    materials::ContrastImage image{raster.columns, raster.rows, {}};
    image.values.reserve(raster.values.size());
    for (const double value : raster.values) image.values.push_back(static_cast<float>(value));
    map_.choice = materials::contrast_choice(image, reflectance, rule.half_window_pixels);
  }

  const MaterialMapInput& input_;
  const std::vector<materials::Material>& materials_;
  MapContext context_;
  MaterialMap map_;
};

}  // namespace

std::vector<MaterialMap> load_maps(const Scenario& scenario,
                                   const std::vector<materials::Material>& materials,
                                   const geometry::LocalFrame& frame, InputFiles& files,
                                   Diagnostics& diagnostics) {
  std::vector<MaterialMap> maps;
  ErrorList errors;
  for (const MaterialMapInput& input : scenario.maps) {
    errors.attempt("map " + input.name, scenario.file.string(), [&] {
      files.note(input.raster);
      maps.push_back(MapReader{input, materials, {&frame, &diagnostics}}.read());
    });
  }
  errors.throw_if_any();
  return maps;
}

}  // namespace nadir::sim
