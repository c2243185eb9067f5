#include <fmt/format.h>

#include "sim/scenario/build_camera.hpp"

namespace nadir::sim {
namespace {

OpticsInput build_optics(const CheckedElement& element) {
  return {element.number("f_number"),
          element.number("obscuration"),
          element.number("transmittance"),
          element.number("falloff_power"),
          element.number("temperature_k"),
          element.number("emissivity"),
          element.number("shield_temperature_k")};
}

// ---- blur ---------------------------------------------------------------------------------------

DiffractionInput build_diffraction(const BuildContext& context, const CheckedElement& element,
                                   const ArrayInput& array) {
  const OpticsInput optics = array.optics.value_or(OpticsInput{});
  if (!element.gives("f_number") && !array.optics) {
    context.mistake(element.offset,
                    fmt::format("<diffraction> of array \"{}\" needs an f_number: its own or that "
                                "of <optics>",
                                array.name));
  }
  return {element.find<double>("f_number").value_or(optics.f_number),
          element.find<double>("obscuration").value_or(optics.obscuration)};
}

BlurInput build_blur(const BuildContext& context, const CheckedElement& element,
                     const ArrayInput& array) {
  BlurInput blur;
  if (const auto* aperture = single_child(context, element, {"diffraction", "blur_table"},
                                          "<diffraction> or <blur_table>")) {
    if (aperture->type->name == "diffraction") {
      blur.diffraction = build_diffraction(context, *aperture, array);
    } else {
      blur.table = aperture->find<std::filesystem::path>("file");
    }
  }
  for (const CheckedElement& child : element.children) {
    if (child.type->name != "gaussian_blur") continue;
    const double sigma_x = child.number("sigma_x_um");
    blur.gaussians.push_back({sigma_x, child.find<double>("sigma_y_um").value_or(sigma_x)});
  }
  if (const auto* stray = single_child(context, element, {"stray_light"}, "<stray_light>")) {
    blur.stray = StrayLightInput{stray->number("share"), stray->number("core_um"),
                                 stray->number("slope"), stray->number("reach_um")};
  }
  return blur;
}

// ---- detector -----------------------------------------------------------------------------------

PhotonDetectorInput build_photons(const CheckedElement& element) {
  PhotonDetectorInput photons;
  photons.efficiency = element.number("efficiency");
  photons.area_um2 = element.find<double>("area_um2");
  photons.dark_e_s = element.number("dark_e_s");
  photons.temperature_k = element.number("temperature_k");
  photons.dark_reference_k = element.find<double>("dark_reference_k");
  photons.dark_doubling_k = element.number("dark_doubling_k");
  photons.read_noise_e = element.number("read_noise_e");
  photons.line_noise_e = element.number("line_noise_e");
  photons.line_correlation = element.number("line_correlation");
  photons.flicker_noise_e = element.number("flicker_noise_e");
  photons.prnu = element.number("prnu");
  photons.dsnu_e = element.number("dsnu_e");
  photons.full_well_e = element.number("full_well_e");
  return photons;
}

/// Length of the exposure in the timing's own unit; nothing for detectors that have no shutter.
std::optional<double> exposure_of(const TimingInput& timing) {
  if (const auto* t = std::get_if<GlobalShutterInput>(&timing)) return t->exposure_ms;
  if (const auto* t = std::get_if<RollingShutterInput>(&timing)) return t->exposure_ms;
  if (const auto* t = std::get_if<PushbroomInput>(&timing)) return t->exposure_ms;
  if (const auto* t = std::get_if<WhiskbroomInput>(&timing)) return t->exposure_us;
  return std::nullopt;
}

/// Electrons need an aperture, a pixel's area and a time to be counted in.
void check_photons(const BuildContext& context, const CheckedElement& element,
                   const ArrayInput& array) {
  const auto needs = [&](const std::string& what, const std::string& hint) {
    context.mistake(element.offset,
                    fmt::format("<photon_detector> of array \"{}\" {}", array.name, what), hint);
  };
  if (!array.optics) needs("needs <optics>, with its f_number", "");
  const auto exposure = exposure_of(array.timing);
  if (!exposure) {
    needs("counts in an exposure, which a <bolometer> has not", "use <published_noise>");
  } else if (*exposure <= 0.0) {
    needs("needs an exposure, which its timing does not give",
          "without a timing all detectors see at one moment: add <global_shutter exposure_ms>");
  }
  if (array.pitch_um <= 0.0 && !element.gives("area_um2")) {
    needs("needs area_um2: an orthographic camera's pitch is not that of its detectors", "");
  }
}

void check_black_level(const BuildContext& context, const CheckedElement& element) {
  const auto bits = element.find<int>("bits");
  const double level = element.number("black_level_dn");
  if (!bits || level < (1 << *bits) - 1) return;
  context.mistake(element.where("black_level_dn"),
                  fmt::format("black_level_dn is {}, the largest number of {} bits is {}", level,
                              *bits, (1 << *bits) - 1));
}

std::optional<DetectorInput> build_detector(const BuildContext& context,
                                            const CheckedElement& element,
                                            const ArrayInput& array) {
  const CheckedElement* given =
      single_child(context, element, {"photon_detector", "published_noise"}, "detector");
  if (given == nullptr) return std::nullopt;
  DetectorInput detector;
  detector.where = context.source.locate(given->offset);
  if (given->type->name == "photon_detector") {
    detector.element = build_photons(*given);
    detector.gain_dn_e = given->find<double>("gain_dn_e");
    detector.flat = given->flag("flat");
    check_photons(context, *given, array);
  } else {
    detector.element = PublishedNoiseInput{};
  }
  detector.bits = given->value<int>("bits");
  detector.black_level_dn = given->number("black_level_dn");
  detector.dead_share = given->number("dead_share");
  detector.pattern_seed = given->value<int>("pattern_seed");
  check_black_level(context, *given);
  return detector;
}

// ---- bands against their detector ---------------------------------------------------------------

/// Figures of a band that its array's detector has no use for.
void check_unused_figures(const BuildContext& context, const CheckedElement& band,
                          const std::vector<std::string>& attributes, const char* detector) {
  for (const std::string& attribute : attributes) {
    if (!band.gives(attribute)) continue;
    context.mistake(band.where(attribute),
                    fmt::format("{} of band \"{}\" needs <{}> in its array", attribute,
                                band.value<std::string>("name"), detector));
  }
}

void check_published(const BuildContext& context, const CheckedElement& element, BandInput& band,
                     std::optional<double> saturation) {
  if (band.figures.empty()) {
    context.mistake(element.offset,
                    fmt::format("no figure of noise of band \"{}\", whose array has "
                                "<published_noise>",
                                band.name),
                    "give reference_radiance and snr, or nedt_k, or <snr_at>, <nedt_at> in it");
  }
  if (!band.saturation_radiance && !band.saturation_temperature_k) {
    band.saturation_radiance = saturation;
  }
  if (!band.saturation_radiance && !band.saturation_temperature_k) {
    context.mistake(element.offset,
                    fmt::format("band \"{}\" needs its saturation_radiance or "
                                "saturation_temperature_k, or <published_noise> one for all",
                                band.name));
  }
  if (band.saturation_radiance && band.reference_radiance &&
      *band.saturation_radiance <= *band.reference_radiance) {
    context.mistake(element.where("saturation_radiance"),
                    fmt::format("band \"{}\" saturates at {}, not above its reference_radiance {}",
                                band.name, *band.saturation_radiance, *band.reference_radiance));
  }
}

/// Tells of bands whose figures and the array's detector do not go together.
void check_bands(const BuildContext& context, const CheckedElement& element, ArrayInput& array) {
  const bool any = array.detector.has_value();
  const bool photons = any && std::holds_alternative<PhotonDetectorInput>(array.detector->element);
  std::optional<double> saturation;
  std::vector<const CheckedElement*> bands;
  for (const CheckedElement& child : element.children) {
    if (child.type->name.starts_with("band")) bands.push_back(&child);
    if (child.type->name == "published_noise") {
      saturation = child.find<double>("saturation_radiance");
    }
  }
  for (std::size_t i = 0; i < bands.size(); ++i) {
    if (!photons) {
      check_unused_figures(context, *bands[i], {"efficiency", "transmittance"}, "photon_detector");
    }
    if (any && !photons) {
      check_published(context, *bands[i], array.bands[i], saturation);
      continue;
    }
    check_unused_figures(context, *bands[i],
                         {"snr", "nedt_k", "saturation_radiance", "saturation_temperature_k"},
                         "published_noise");
    if (!bands[i]->children.empty()) {
      context.mistake(bands[i]->children.front().offset,
                      fmt::format("<{}> of band \"{}\" needs <published_noise> in its array",
                                  bands[i]->children.front().type->name, array.bands[i].name));
    }
  }
}

}  // namespace

void build_detection(const BuildContext& context, const CheckedElement& element,
                     ArrayInput& array) {
  if (const auto* optics = single_child(context, element, {"optics"}, "<optics>")) {
    array.optics = build_optics(*optics);
  }
  array.blur = build_blur(context, element, array);
  array.detector = build_detector(context, element, array);
  check_bands(context, element, array);
}

}  // namespace nadir::sim
