#include <fmt/format.h>

#include "sim/scenario/build_camera.hpp"

namespace nadir::sim {
namespace {

BoxBand build_box_band(const BuildContext& context, const CheckedElement& element,
                       const std::string& name) {
  const auto lo = element.find<double>("lo_um"), hi = element.find<double>("hi_um");
  if (lo && hi && *lo >= *hi) {
    context.mistake(
        element.where("hi_um"),
        fmt::format("band \"{}\" must end after it begins: lo_um is {}, hi_um {}", name, *lo, *hi));
  }
  return {lo.value_or(0.0), hi.value_or(0.0)};
}

GaussianBand build_gaussian_band(const BuildContext& context, const CheckedElement& element,
                                 const std::string& name) {
  const auto centre = element.find<double>("centre_um"), fwhm = element.find<double>("fwhm_um");
  if (centre && fwhm && *fwhm >= *centre) {
    context.mistake(element.where("fwhm_um"),
                    fmt::format("band \"{}\" is wider than its wavelength", name));
  }
  return {centre.value_or(0.0), fwhm.value_or(0.0)};
}

TabulatedBand build_tabulated_band(const CheckedElement& element) {
  const auto response = element.value<SpectralInput>("response");
  const auto* file = std::get_if<std::filesystem::path>(&response.source);
  return {file != nullptr ? *file : std::filesystem::path{}, response.column,
          element.value<std::string>("response_kind") == "quantum"};
}

/// Figures of noise from attributes and children.
void build_figures(const BuildContext& context, const CheckedElement& element, BandInput& band) {
  if (const auto snr = element.find<double>("snr")) {
    if (!element.gives("reference_radiance")) {
      context.mistake(element.where("snr"),
                      fmt::format("snr of band \"{}\" needs its reference_radiance", band.name));
    }
    band.figures.push_back(SnrFigure{band.reference_radiance.value_or(0.0), *snr});
  }
  constexpr double usual_scene_k = 300.0;
  if (const auto nedt = element.find<double>("nedt_k")) {
    band.figures.push_back(NedtFigure{usual_scene_k, *nedt});
  }
  for (const CheckedElement& child : element.children) {
    if (child.type->name == "snr_at") {
      band.figures.push_back(SnrFigure{child.number("radiance"), child.number("snr")});
    } else {
      band.figures.push_back(NedtFigure{child.number("temperature_k"), child.number("nedt_k")});
    }
  }
}

}  // namespace

BandInput build_band(const BuildContext& context, const CheckedElement& element) {
  BandInput band;
  band.name = element.value<std::string>("name");
  band.where = context.source.locate(element.offset);
  if (element.type->name == "band_box") {
    band.response = build_box_band(context, element, band.name);
  } else if (element.type->name == "band_gaussian") {
    band.response = build_gaussian_band(context, element, band.name);
  } else {
    band.response = build_tabulated_band(element);
  }
  band.reference_radiance = element.find<double>("reference_radiance");
  band.saturation_radiance = element.find<double>("saturation_radiance");
  band.saturation_temperature_k = element.find<double>("saturation_temperature_k");
  band.efficiency = element.find<double>("efficiency");
  band.transmittance = element.find<double>("transmittance");
  build_figures(context, element, band);
  if (band.saturation_radiance && band.saturation_temperature_k) {
    context.mistake(element.where("saturation_temperature_k"),
                    "give either saturation_radiance or saturation_temperature_k, not both");
  }
  return band;
}

}  // namespace nadir::sim
