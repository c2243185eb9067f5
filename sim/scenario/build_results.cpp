#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "sim/files/text_tokens.hpp"
#include "sim/scenario/build_context.hpp"

namespace nadir::sim {
namespace {

/// One band, or three of the same array.
void check_quick_look(const BuildContext& context, const CheckedElement& products,
                      const Scenario& scenario) {
  const std::vector<std::string>& wanted = scenario.products.quick_look_bands;
  if (wanted.empty() || scenario.camera.arrays.empty()) return;
  const std::size_t offset = products.where("quick_look_bands");
  if (wanted.size() == 2) context.mistake(offset, "a quick look has one band or three, not two");
  std::vector<std::string> known;
  bool together = false;
  for (const ArrayInput& array : scenario.camera.arrays) {
    const auto has = [&](const std::string& name) {
      return std::any_of(array.bands.begin(), array.bands.end(),
                         [&](const BandInput& band) { return band.name == name; });
    };
    together |= std::all_of(wanted.begin(), wanted.end(), has);
    for (const BandInput& band : array.bands) known.push_back(band.name);
  }
  bool all_known = true;
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    context.mistake(offset, fmt::format("the camera has no band \"{}\"", name),
                    suggestion(name, known));
    all_known = false;
  }
  if (all_known && !together) {
    context.mistake(offset, "the bands of a quick look must be bands of one array");
  }
}

/// Of the words that the schema allows.
BandNodes band_nodes(const std::string& word) {
  // What the schema refused has its mistake noted and arrives here as an empty word.
  return word == "auto" ? BandNodes{0} : BandNodes{strict_number_in<int>(word).value_or(4)};
}

ProductsInput products_of(const CheckedElement& element) {
  ProductsInput products;
  products.envi = element.flag("envi");
  products.exr = element.flag("exr");
  products.quick_look = element.flag("quick_look");
  products.truth = element.flag("truth");
  products.truth_temperature = element.flag("truth_temperature");
  products.quick_look_bands = element.value<std::vector<std::string>>("quick_look_bands");
  products.geotiff = element.flag("geotiff");
  products.netcdf = element.flag("netcdf");
  products.sidecars = element.flag("sidecars");
  products.electrons = element.flag("electrons");
  products.statistics = element.flag("statistics");
  products.sky_view = element.flag("sky_view");
  products.fractions = element.flag("fractions");
  products.keep_samples = element.flag("keep_samples");
  return products;
}

/// No plane of the truth may be asked for where there is none.
void check_truth(const BuildContext& context, const CheckedElement& element,
                 const ProductsInput& products) {
  if (products.truth) return;
  for (const auto& [name, wanted] :
       {std::pair{"truth_temperature", products.truth_temperature},
        std::pair{"sky_view", products.sky_view}, std::pair{"fractions", products.fractions}}) {
    if (!wanted) continue;
    context.mistake(
        element.where(name),
        fmt::format("{}=\"true\" asks for a plane that truth=\"false\" leaves out", name));
  }
}

/// Electrons need a detector that counts them; published noise knows of none.
void check_electrons(const BuildContext& context, const CheckedElement& element,
                     const Scenario& scenario) {
  const auto& arrays = scenario.camera.arrays;
  if (!scenario.products.electrons || arrays.empty()) return;
  const auto counts = [](const ArrayInput& array) {
    return array.detector && std::holds_alternative<PhotonDetectorInput>(array.detector->element);
  };
  if (std::any_of(arrays.begin(), arrays.end(), counts)) return;
  const bool detects = std::any_of(arrays.begin(), arrays.end(), [](const ArrayInput& array) {
    return array.detector.has_value();
  });
  context.mistake(element.where("electrons"),
                  detects
                      ? "the camera's detectors are known by published noise: none counts electrons"
                      : "electrons=\"true\", but no array of the camera has a detector");
}

}  // namespace

void build_results(const BuildContext& context, const CheckedElement& root, Scenario& scenario) {
  if (const CheckedElement* sampling = root.child("sampling")) {
    scenario.sampling = {sampling->value<int>("replicates"),
                         sampling->value<int>("samples_per_replicate"),
                         band_nodes(sampling->value<std::string>("wavelengths_per_band"))};
  }
  if (const CheckedElement* products = root.child("products")) {
    scenario.products = products_of(*products);
    check_quick_look(context, *products, scenario);
    check_truth(context, *products, scenario.products);
    check_electrons(context, *products, scenario);
  }
}

}  // namespace nadir::sim
