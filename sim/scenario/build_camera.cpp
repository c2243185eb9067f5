#include <fmt/format.h>

#include "sim/scenario/build_context.hpp"

namespace nadir::sim {
namespace {

BandInput build_band(const BuildContext& context, const CheckedElement& element) {
  BandInput band;
  band.name = element.value<std::string>("name");
  if (element.type->name == "band_box") {
    const auto lo = element.find<double>("lo_um"), hi = element.find<double>("hi_um");
    if (lo && hi && *lo >= *hi) {
      context.mistake(element.where("hi_um"),
                      fmt::format("band \"{}\" must end after it begins: lo_um is {}, hi_um {}",
                                  band.name, *lo, *hi));
    }
    band.response = BoxBand{lo.value_or(0.0), hi.value_or(0.0)};
  } else if (element.type->name == "band_gaussian") {
    const auto centre = element.find<double>("centre_um"), fwhm = element.find<double>("fwhm_um");
    if (centre && fwhm && *fwhm >= *centre) {
      context.mistake(element.where("fwhm_um"),
                      fmt::format("band \"{}\" is wider than its wavelength", band.name));
    }
    band.response = GaussianBand{centre.value_or(0.0), fwhm.value_or(0.0)};
  } else {
    const auto response = element.value<SpectralInput>("response");
    const auto* file = std::get_if<std::filesystem::path>(&response.source);
    band.response =
        TabulatedBand{file != nullptr ? *file : std::filesystem::path{}, response.column};
  }
  return band;
}

ArrayInput build_array(const BuildContext& context, const CheckedElement& element) {
  ArrayInput array{element.value<std::string>("name"), element.value<int>("samples"),
                   element.value<int>("lines"),        element.number("pitch_um"),
                   element.number("offset_x_um"),      element.number("offset_y_um"),
                   element.number("ground_pitch_m"),   element.number("offset_x_m"),
                   element.number("offset_y_m"),       {}};
  std::vector<const CheckedElement*> bands;
  for (const CheckedElement& band : element.children) {
    bands.push_back(&band);
    array.bands.push_back(build_band(context, band));
  }
  context.check_unique(bands, "band");
  return array;
}

}  // namespace

void build_camera(const BuildContext& context, const CheckedElement& element, Scenario& scenario) {
  if (element.children.empty()) return;
  const CheckedElement& projection = element.children.front();
  scenario.camera.orthographic = projection.type->name == "orthographic";
  scenario.camera.focal_length_mm = projection.number("focal_length_mm");
  std::vector<const CheckedElement*> arrays;
  for (const CheckedElement& array : projection.children) {
    arrays.push_back(&array);
    scenario.camera.arrays.push_back(build_array(context, array));
  }
  context.check_unique(arrays, "array");
}

}  // namespace nadir::sim
