#include "sim/scenario/schema_parts.hpp"

// What stands in a camera's array: bands, timing, modules, optics, blur, detector.

namespace nadir::sim {
namespace {

constexpr const char* radiance_unit = "W m^-2 sr^-1 um^-1";

/// Wavelengths for which the Planck function and the spectra are tested.
NumberType wavelength() { return from_to(0.2, 20.0); }
/// Radiance per um: the sun's own disc is 3e7.
NumberType band_radiance() { return above_to(0.0, 1e8); }
NumberType noise_ratio() { return above_to(0.0, 1e6); }
NumberType noise_kelvin() { return above_to(0.0, 100.0); }
NumberType electrons() { return from_to(0.0, 1e12); }
NumberType period() { return above_to(0.0, 1e7); }
NumberType duration() { return from_to(0.0, 1e7); }
NumberType f_number() { return above_to(0.0, 1e4); }
NumberType obscuration() { return {0.0, 1.0, false, true}; }
/// Blur of an orthographic camera spans metres.
NumberType blur_um() { return from_to(0.0, 1e9); }

// ---- bands --------------------------------------------------------------------------------------

/// A band: its name, what is its own, then figures that all kinds may have.
ElementType band(const std::string& name, const std::string& doc, std::vector<Attribute> own) {
  std::vector<Attribute> attributes = {required("name", NameType{}, "", "Unique in its array.")};
  for (Attribute& attribute : own) attributes.push_back(std::move(attribute));
  for (Attribute& attribute : std::vector<Attribute>{
           optional("reference_radiance", band_radiance(), radiance_unit, "no figures at one",
                    "Of the band, at which data sheets give SNR and noise."),
           optional("snr", noise_ratio(), "", "figures say, or nedt_k",
                    "Signal over noise at reference_radiance; for published_noise."),
           optional("nedt_k", noise_kelvin(), "K", "figures say, or snr",
                    "Noise-equivalent temperature difference at 300 K; for published_noise."),
           optional("saturation_radiance", band_radiance(), radiance_unit,
                    "as published_noise says",
                    "Radiance of the largest number; for published_noise."),
           optional("saturation_temperature_k", above_to(0.0, 6000.0), "K",
                    "as published_noise says",
                    "Temperature of the black body that gives the largest number."),
           optional("efficiency", above_to(0.0, 1.0), "", "as photon_detector says",
                    "Electrons a photon at the band's peak; for photon_detector."),
           optional("transmittance", above_to(0.0, 1.0), "", "as optics says",
                    "Of lens and filter at the band's peak; for photon_detector.")}) {
    attributes.push_back(std::move(attribute));
  }
  return {.id = name,
          .name = name,
          .doc = doc,
          .attributes = std::move(attributes),
          .content = Content::list,
          .children = {{"snr_at"}, {"nedt_at"}}};
}

std::vector<ElementType> bands() {
  return {
      band("band", "A band whose relative response is a column of a file.",
           {required("response", ColumnType{}, "", "Relative spectral response."),
            defaulted("response_kind", EnumerationType{{"radiance", "quantum"}}, "", "radiance",
                      "radiance: it weights radiance, as published responses do. quantum: "
                      "electrons a photon, which is multiplied by the wavelength.")}),
      band("band_box", "A band of response 1 between two wavelengths.",
           {required("lo_um", wavelength(), "um", "Least wavelength."),
            required("hi_um", wavelength(), "um", "Greatest wavelength.")}),
      band("band_gaussian", "A band of Gaussian response.",
           {required("centre_um", wavelength(), "um", "Wavelength of the peak."),
            required("fwhm_um", above_to(0.0, 10.0), "um", "Full width at half maximum.")}),
      {.id = "snr_at",
       .name = "snr_at",
       .doc = "A published figure of the band's noise; several of them give its law.",
       .attributes = {required("radiance", band_radiance(), radiance_unit, "Of the band."),
                      required("snr", noise_ratio(), "", "Signal over noise.")}},
      {.id = "nedt_at",
       .name = "nedt_at",
       .doc = "A published figure of the band's noise; several of them give its law.",
       .attributes = {required("temperature_k", above_to(0.0, 6000.0), "K", "Of the scene."),
                      required("nedt_k", noise_kelvin(), "K",
                               "Noise-equivalent temperature difference.")}},
  };
}

// ---- timing -------------------------------------------------------------------------------------

Attribute start() {
  return optional("start_s", from_to(-1e6, 1e6), "s",
                  "the middle of the image is at the scenario's time",
                  "Centre of the first line's exposure, after the scenario's time.");
}

std::vector<ElementType> timings() {
  const Attribute line_period = required("line_period_ms", period(), "ms", "From line to line.");
  return {
      {.id = "global_shutter",
       .name = "global_shutter",
       .doc = "All detectors at once.",
       .attributes = {defaulted("exposure_ms", duration(), "ms", "0", "Length of the exposure."),
                      defaulted("delay_ms", from_to(-1e9, 1e9), "ms", "0",
                                "Of its centre after the scenario's time.")}},
      {.id = "rolling_shutter",
       .name = "rolling_shutter",
       .doc = "Line after line of one frame.",
       .attributes = {line_period,
                      defaulted("exposure_ms", duration(), "ms", "0",
                                "Of each line; may be longer than the line period."),
                      start()}},
      {.id = "pushbroom",
       .name = "pushbroom",
       .doc = "One row of detectors; the image's lines come by the platform's motion.",
       .attributes = {line_period,
                      defaulted("exposure_ms", duration(), "ms", "0",
                                "Of each line, at most the line period."),
                      start(),
                      defaulted("tdi_stages", IntegerType{1, 4096}, "", "1",
                                "Rows that add up the same ground (time-delay integration)."),
                      defaulted("tdi_direction", EnumerationType{{"ahead", "behind"}}, "", "ahead",
                                "Which way the charge moves. ahead: towards -y, with the ground's "
                                "image, as y looks ahead. behind: the other way, for a platform "
                                "that flies backwards, towards -y.")}},
      {.id = "whiskbroom",
       .name = "whiskbroom",
       .doc = "A column of detectors that a scanning mount sweeps across.",
       .attributes = {required("sample_period_us", period(), "us", "From sample to sample."),
                      required("scan_period_ms", period(), "ms", "From sweep to sweep."),
                      required("lines_per_scan", IntegerType{1, 4096}, "",
                               "Detectors in the column: lines of one sweep."),
                      defaulted("exposure_us", duration(), "us", "0",
                                "Of each sample, at most the sample period."),
                      start()}},
      {.id = "bolometer",
       .name = "bolometer",
       .doc = "Detectors without a shutter that follow the light with a lag.",
       .attributes = {required("time_constant_ms", period(), "ms",
                               "What came before counts by exp(-age / time constant)."),
                      defaulted("line_period_us", duration(), "us", "0",
                                "From line to line of the read-out; 0: all at once."),
                      start()}},
  };
}

// ---- focal plane, optics, blur ------------------------------------------------------------------

std::vector<ElementType> optics() {
  const NumberType offset = from_to(-1e6, 1e6);
  return {
      {.id = "module",
       .name = "module",
       .doc = "A part of the array that was cut and mounted by itself. All of them together have "
              "each sample once.",
       .attributes = {required("first_sample", IntegerType{0, 99999}, "", "From 0."),
                      required("samples", IntegerType{1, 100000}, "", "Its columns."),
                      defaulted("offset_x_um", offset, "um", "0",
                                "From where a perfect array has it, to image right."),
                      defaulted("offset_y_um", offset, "um", "0", "The same, to image down."),
                      defaulted("rotation_deg", from_to(-45.0, 45.0), "deg", "0",
                                "About its middle, from x to y.")}},
      {.id = "optics",
       .name = "optics",
       .doc = "The way of the light behind the aperture.",
       .attributes = {required("f_number", f_number(), "",
                               "Focal length over the aperture's diameter."),
                      defaulted("obscuration", obscuration(), "", "0",
                                "Diameter of the obscured middle over the aperture's."),
                      defaulted("transmittance", above_to(0.0, 1.0), "", "1",
                                "Of lenses, mirrors and filters at the bands' peaks."),
                      defaulted("falloff_power", from_to(0.0, 20.0), "", "4",
                                "n of the fall-off cos^n towards the corners."),
                      defaulted("temperature_k", temperature(), "K", "0",
                                "Of lenses and mirrors, which emit; 0: nothing."),
                      defaulted("emissivity", from_to(0.0, 1.0), "", "0", "Of lenses and mirrors."),
                      defaulted("shield_temperature_k", temperature(), "K", "0",
                                "Of what the detector sees beside the lens; 0: nothing.")}},
  };
}

std::vector<ElementType> blurs() {
  return {
      {.id = "diffraction",
       .name = "diffraction",
       .doc = "Blur by the aperture, for each band's own wavelengths.",
       .attributes = {optional("f_number", f_number(), "", "that of optics",
                               "Focal length over the aperture's diameter."),
                      optional("obscuration", obscuration(), "", "that of optics, or 0",
                               "Diameter of the obscured middle over the aperture's.")}},
      {.id = "gaussian_blur",
       .name = "gaussian_blur",
       .doc = "Blur of the optics on the focal plane; several add up.",
       .attributes = {required("sigma_x_um", blur_um(), "um", "Standard deviation along x."),
                      optional("sigma_y_um", blur_um(), "um", "sigma_x_um",
                               "Standard deviation along y.")}},
      {.id = "blur_table",
       .name = "blur_table",
       .doc = "The image of a point as it was measured or computed, in place of diffraction.",
       .attributes = {required("file", PathType{{".csv", ".txt", ".psf"}}, "",
                               "docs/formats.md, Point spread tables.")}},
      {.id = "stray_light",
       .name = "stray_light",
       .doc = "A share of the light that comes from far around, by scatter and ghosts.",
       .attributes = {required("share", NumberType{0.0, 1.0, false, true}, "", "Of the light."),
                      required("core_um", above_to(0.0, 1e9), "um",
                               "Its density falls like (1 + (r / core)^2)^-slope."),
                      defaulted("slope", above_to(0.0, 20.0), "", "1.5", "See core_um."),
                      required("reach_um", above_to(0.0, 1e9), "um", "No farther than this.")}},
  };
}

// ---- detectors ----------------------------------------------------------------------------------

/// A detector: what is its own, then how its numbers are made.
ElementType detector(const std::string& name, const std::string& doc, std::vector<Attribute> own) {
  for (Attribute& attribute : std::vector<Attribute>{
           defaulted("bits", IntegerType{1, 16}, "", "12", "Of the digital numbers."),
           defaulted("black_level_dn", from_to(0.0, 65535.0), "DN", "0",
                     "Added before the conversion."),
           defaulted("dead_share", obscuration(), "", "0", "Of detectors that give nothing."),
           defaulted("pattern_seed", IntegerType{0, 2147483647}, "", "1",
                     "Of what stays from image to image: unequal and dead detectors.")}) {
    own.push_back(std::move(attribute));
  }
  return {.id = name, .name = name, .doc = doc, .attributes = std::move(own)};
}

std::vector<ElementType> detectors() {
  return {
      detector(
          "photon_detector", "A detector that counts photo-electrons; needs optics.",
          {required("efficiency", above_to(0.0, 1.0), "",
                    "Electrons a photon at the bands' peaks."),
           optional("area_um2", above_to(0.0, 1e10), "um^2", "pitch times fill",
                    "Sensitive, of one pixel; an orthographic camera needs it."),
           defaulted("dark_e_s", from_to(0.0, 1e15), "e- s^-1", "0",
                     "Dark current of a pixel at dark_reference_k."),
           defaulted("temperature_k", above_to(0.0, 1000.0), "K", "293.15", "Of the detector."),
           optional("dark_reference_k", above_to(0.0, 1000.0), "K", "temperature_k",
                    "Temperature that dark_e_s was measured at."),
           defaulted("dark_doubling_k", above_to(0.0, 1000.0), "K", "7",
                     "Dark current doubles every so many kelvin."),
           defaulted("read_noise_e", electrons(), "e-", "0", "Standard deviation."),
           defaulted("line_noise_e", electrons(), "e-", "0",
                     "Standard deviation of stripes from line to line."),
           defaulted("line_correlation", obscuration(), "", "0",
                     "Of a stripe with the next line's."),
           defaulted("flicker_noise_e", electrons(), "e-", "0",
                     "Standard deviation of 1/f noise from line to line."),
           defaulted("prnu", from_to(0.0, 1.0), "", "0",
                     "Unequal response of detectors, relative standard deviation."),
           defaulted("dsnu_e", electrons(), "e-", "0",
                     "Unequal dark signal of detectors, standard deviation."),
           required("full_well_e", above_to(0.0, 1e12), "e-", "Most electrons that a pixel holds."),
           optional("gain_dn_e", above_to(0.0, 1e6), "DN e-^-1", "the full well fills the range",
                    "Digital number an electron."),
           defaulted("flat", boolean(), "", "true",
                     "The fall-off towards the corners is taken out of the numbers.")}),
      detector("published_noise",
               "A detector of which only figures of noise are published: by snr or nedt_k of its "
               "bands, or by snr_at and nedt_at in them.",
               {optional("saturation_radiance", band_radiance(), radiance_unit,
                         "every band needs its own",
                         "Radiance of the largest number, of bands that say nothing else.")}),
  };
}

}  // namespace

std::vector<ElementType> schema_of_camera_parts() {
  std::vector<ElementType> all;
  for (auto&& part : {bands(), timings(), optics(), blurs(), detectors()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace nadir::sim
