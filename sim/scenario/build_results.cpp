#include <fmt/format.h>

#include <algorithm>

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

}  // namespace

void build_results(const BuildContext& context, const CheckedElement& root, Scenario& scenario) {
  if (const CheckedElement* sampling = root.child("sampling")) {
    scenario.sampling = {sampling->value<int>("replicates"),
                         sampling->value<int>("samples_per_replicate"),
                         sampling->value<int>("wavelengths_per_band")};
  }
  if (const CheckedElement* products = root.child("products")) {
    scenario.products = {products->flag("envi"),
                         products->flag("exr"),
                         products->flag("quick_look"),
                         products->flag("truth"),
                         products->flag("truth_temperature"),
                         products->value<std::vector<std::string>>("quick_look_bands")};
    check_quick_look(context, *products, scenario);
    if (scenario.products.truth_temperature && !scenario.products.truth) {
      context.mistake(
          products->where("truth_temperature"),
          "truth_temperature=\"true\" asks for a plane that truth=\"false\" leaves out");
    }
  }
}

}  // namespace nadir::sim
