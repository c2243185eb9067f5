#include "sim/products/envi_products.hpp"

#include <fmt/format.h>

#include <string>

namespace nadir::sim {
namespace {

constexpr const char* envi_radiance_units = "W m-2 sr-1 um-1";
// Longer lists of names would make headers of megabytes, which readers refuse.
constexpr std::size_t most_class_names = 10'000;

using BandPlane = std::vector<float> BandImage::*;

/// Makes the files of one array.
class ProductMaker {
 public:
  ProductMaker(const ArrayImage& image, const ArrayTask& task) : image_{image}, task_{task} {}

  void add_radiance();
  void add_truth();
  void add_ids();
  void add_fractions();
  void add_place();
  void add_temperature();
  void add_dn();
  void add_noise();
  void add_electrons();
  void add_effects();
  void add_bias();
  void add_paths();
  [[nodiscard]] std::vector<EnviProduct> take() { return std::move(products_); }

 private:
  [[nodiscard]] EnviProduct product(const char* kind, const char* ending, EnviType type,
                                    const std::string& what) const;
  void name_plane(EnviProduct& product, std::size_t band, const char* suffix) const;
  void add_band_planes(EnviProduct& product, BandPlane plane, const char* suffix) const;
  /// A file with a plane of every band that has it.
  void add_bands(EnviProduct product, BandPlane plane, const char* units);
  void add_shares(EnviProduct& product, LightShare part, const char* suffix) const;
  void keep(EnviProduct product) {
    if (!product.planes.empty()) products_.push_back(std::move(product));
  }

  const ArrayImage& image_;
  const ArrayTask& task_;
  std::vector<EnviProduct> products_;
};

template <class Number>
PlaneSource truth_source(std::vector<Number> TruthImage::*plane) {
  return [plane](const ArrayImage& strip, std::vector<float>&) -> StripPlane {
    return std::span<const Number>{strip.truth.*plane};
  };
}

PlaneSource band_source(std::size_t band, BandPlane plane) {
  return [band, plane](const ArrayImage& strip, std::vector<float>&) -> StripPlane {
    return std::span<const float>{strip.bands[band].*plane};
  };
}

template <class Number>
std::string plane_title(const TruthPlane<Number>& plane) {
  const std::string unit = plane.unit;
  return unit.empty() ? plane.name : fmt::format("{} ({})", plane.name, unit);
}

EnviProduct ProductMaker::product(const char* kind, const char* ending, EnviType type,
                                  const std::string& what) const {
  const ProductContext& context = *task_.context;
  EnviProduct made{kind, ending, type, {}, {}};
  EnviHeader& header = made.header;
  header.samples = image_.samples;
  header.lines = image_.image_lines();
  header.description = fmt::format("{}, scenario {}", what, context.scenario_name);
  header.sensor_type = fmt::format("array {} simulated by nadir {}", image_.name, context.version);
  header.acquisition_time = context.time_utc;
  if (task_.array != nullptr) header.more = line_times(*task_.array);
  return made;
}

void ProductMaker::name_plane(EnviProduct& product, std::size_t band, const char* suffix) const {
  const BandImage& b = image_.bands[band];
  product.header.band_names.push_back(b.name + suffix);
  product.header.wavelength_um.push_back(b.centre_um);
  product.header.fwhm_um.push_back(b.fwhm_um);
}

void ProductMaker::add_band_planes(EnviProduct& product, BandPlane plane,
                                   const char* suffix) const {
  for (std::size_t band = 0; band < image_.bands.size(); ++band) {
    if ((image_.bands[band].*plane).empty()) continue;
    name_plane(product, band, suffix);
    product.planes.push_back(band_source(band, plane));
  }
}

void ProductMaker::add_bands(EnviProduct product, BandPlane plane, const char* units) {
  product.header.data_units = units;
  add_band_planes(product, plane, "");
  keep(std::move(product));
}

void ProductMaker::add_radiance() {
  add_bands(product("radiance", "_radiance.img", EnviType::float32,
                    "At-aperture spectral radiance, band means"),
            &BandImage::radiance, envi_radiance_units);
  add_bands(product("standard error", "_error.img", EnviType::float32,
                    "Standard error of the spectral radiance"),
            &BandImage::standard_error, envi_radiance_units);
}

void ProductMaker::add_bias() {
  add_bands(product("systematic error", "_bias.img", EnviType::float32,
                    "Bound of the error that sampling does not show"),
            &BandImage::bias, envi_radiance_units);
}

void ProductMaker::add_paths() {
  if (image_.pixel_paths.empty()) return;
  EnviProduct paths =
      product("paths", "_paths.img", EnviType::uint32, "Paths that the pixel was sampled with");
  paths.header.band_names = {"paths"};
  paths.planes.emplace_back([](const ArrayImage& strip, std::vector<float>&) -> StripPlane {
    return std::span<const std::uint32_t>{strip.pixel_paths};
  });
  keep(std::move(paths));
}

void ProductMaker::add_truth() {
  EnviProduct truth = product("truth", "_truth.img", EnviType::float32,
                              "Truth planes, means over the pixel's surface; NaN: only sky");
  truth.header.nan_is_no_data = true;
  for (const auto& plane : truth_planes) {
    if ((image_.truth.*plane.values).empty()) continue;
    truth.header.band_names.push_back(plane_title(plane));
    truth.planes.push_back(truth_source(plane.values));
  }
  keep(std::move(truth));
}

void ProductMaker::add_ids() {
  EnviProduct material =
      product("material", "_material.img", EnviType::uint32, "Material of the pixel's majority");
  material.header.class_names = names_with_sky(image_.truth.material_names);
  std::string names;
  for (std::size_t id = 0; id < material.header.class_names.size(); ++id) {
    names += fmt::format("{}{} {}", id == 0 ? "" : ", ", id, material.header.class_names[id]);
  }
  material.header.description += ": " + names;
  material.header.band_names = {"material"};
  material.planes = {truth_source(&TruthImage::material)};
  keep(std::move(material));
  if (image_.truth.object.empty()) return;

  EnviProduct object =
      product("object", "_object.img", EnviType::uint32, "Object of the pixel's majority, 0: sky");
  if (image_.truth.object_names.size() < most_class_names) {
    object.header.class_names = names_with_sky(image_.truth.object_names);
  }
  object.header.band_names = {"object"};
  object.planes = {truth_source(&TruthImage::object)};
  keep(std::move(object));
}

void ProductMaker::add_fractions() {
  EnviProduct fractions = product("fractions", "_fractions.img", EnviType::float32,
                                  "Share of every material in the pixel's paths");
  const std::vector<std::string> names = names_with_sky(image_.truth.material_names);
  for (std::size_t i = 0; i < image_.truth.fractions.size(); ++i) {
    fractions.header.band_names.push_back(names.at(i));
    fractions.planes.emplace_back([i](const ArrayImage& strip, std::vector<float>&) -> StripPlane {
      return std::span<const float>{strip.truth.fractions[i]};
    });
  }
  keep(std::move(fractions));
}

void ProductMaker::add_place() {
  EnviProduct place = product("place", "_place.img", EnviType::float64,
                              "Where (WGS84) and when (after the acquisition time) the pixel "
                              "looked; NaN: only sky");
  place.header.nan_is_no_data = true;
  for (const auto& plane : place_planes) {
    if ((image_.truth.*plane.values).empty()) continue;
    place.header.band_names.push_back(plane_title(plane));
    place.planes.push_back(truth_source(plane.values));
  }
  keep(std::move(place));
}

void ProductMaker::add_temperature() {
  EnviProduct temperature = product("brightness temperature", "_temperature.img", EnviType::float32,
                                    "Brightness temperature of the band, then its standard error");
  temperature.header.data_units = "K";
  temperature.header.nan_is_no_data = true;
  add_band_planes(temperature, &BandImage::brightness_temperature, " (K)");
  add_band_planes(temperature, &BandImage::brightness_temperature_error, " error (K)");
  keep(std::move(temperature));
}

void ProductMaker::add_dn() {
  EnviProduct numbers = product("digital numbers", "_dn.img", EnviType::uint16,
                                "Digital numbers; gain x number + offset is the radiance in "
                                "W m-2 sr-1 um-1");
  numbers.header.data_units = "DN";
  bool calibrated = true;
  for (std::size_t band = 0; band < image_.bands.size(); ++band) {
    if (image_.bands[band].dn.empty()) continue;
    name_plane(numbers, band, "");
    numbers.planes.emplace_back([band](const ArrayImage& strip, std::vector<float>&) -> StripPlane {
      return std::span<const std::uint16_t>{strip.bands[band].dn};
    });
    const sensor::Calibration* calibration = calibration_of(task_, band);
    calibrated = calibrated && calibration != nullptr;
    if (!calibrated) continue;
    numbers.header.gains.push_back(calibration->gain);
    numbers.header.offsets.push_back(calibration->offset);
  }
  if (!calibrated) numbers.header.gains = numbers.header.offsets = {};
  keep(std::move(numbers));
}

void ProductMaker::add_noise() {
  add_bands(product("noise", "_noise.img", EnviType::float32,
                    "Standard deviation of the sensor's own noise, as radiance"),
            &BandImage::noise, envi_radiance_units);
}

void ProductMaker::add_electrons() {
  add_bands(product("electrons", "_electrons.img", EnviType::float32,
                    "Photo-electrons without noise, dark current and the optics' own light"),
            &BandImage::electrons, "electrons");
}

void ProductMaker::add_shares(EnviProduct& product, LightShare part, const char* suffix) const {
  for (std::size_t band = 0; band < image_.bands.size(); ++band) {
    const EffectShares& shares = image_.bands[band].shares;
    if (shares.path.empty() || shares.emission.empty()) continue;
    name_plane(product, band, suffix);
    product.planes.emplace_back(
        [band, part](const ArrayImage& strip, std::vector<float>& room) -> StripPlane {
          return std::span<const float>{light_share(strip.bands[band], part, room)};
        });
  }
}

void ProductMaker::add_effects() {
  const bool alike = image_.pixel_paths.empty();  // else they are a plane of their own
  const std::string what = "Shares of the band's radiance";
  EnviProduct effects =
      product("effects", "_effects.img", EnviType::float32,
              alike ? fmt::format("{}; {} paths a pixel", what, image_.paths) : what);
  effects.header.nan_is_no_data = true;
  if (alike) effects.header.more.emplace_back("paths per pixel", std::to_string(image_.paths));
  add_shares(effects, LightShare::path, " path");
  add_shares(effects, LightShare::emission, " emission");
  add_shares(effects, LightShare::reflection, " reflection");
  keep(std::move(effects));
}

}  // namespace

std::vector<EnviProduct> envi_products(const ArrayImage& first, const ArrayTask& task) {
  const ProductsInput& wanted = task.context->wanted;
  ProductMaker maker{first, task};
  maker.add_radiance();
  maker.add_bias();
  maker.add_paths();
  if (wanted.envi && wanted.truth) {
    maker.add_truth();
    maker.add_ids();
    if (wanted.fractions) maker.add_fractions();
  }
  if (wanted.truth || wants_geo_products(*task.context)) maker.add_place();
  maker.add_dn();
  if (!wanted.envi) return maker.take();  // what other products are made from
  maker.add_temperature();
  maker.add_noise();
  if (wanted.electrons) maker.add_electrons();
  if (wanted.statistics) maker.add_effects();
  return maker.take();
}

}  // namespace nadir::sim
