#include "sensor/detector/checks.hpp"
#include "sensor/detector/photon_yield.hpp"
#include "sensor/detector/signal_chain.hpp"
#include "sim/run/load_camera_arrays.hpp"

namespace nadir::sim {
namespace {

struct FigureLoader {
  const spectral::Response& response;

  sensor::NoiseFigure operator()(const SnrFigure& figure) const {
    return {figure.radiance, figure.radiance / figure.snr};
  }
  /// sigma = NEdT dL/dT at the scene's temperature
  sensor::NoiseFigure operator()(const NedtFigure& figure) const {
    const Kelvin scene{figure.temperature_k};
    const double slope = sensor::band_planck_derivative(response, scene);
    return {sensor::band_planck(response, scene), figure.nedt_k * slope};
  }
};

sensor::Optics load_optics(const OpticsInput& input, const BandInput& band) {
  return {input.f_number,
          input.obscuration,
          band.transmittance.value_or(input.transmittance),
          input.falloff_power,
          input.temperature_k,
          input.emissivity,
          input.shield_temperature_k};
}

sensor::PhotonDetector load_photons(const PhotonDetectorInput& input, const BandInput& band,
                                    const sensor::DetectorArray& array) {
  constexpr double m2_per_um2 = 1e-12;
  sensor::PhotonDetector photons;
  photons.efficiency = band.efficiency.value_or(input.efficiency);
  photons.area_m2 = input.area_um2 ? *input.area_um2 * m2_per_um2
                                   : array.pitch_m * array.fill_x * array.height_m() * array.fill_y;
  photons.dark_e_s = input.dark_e_s;
  photons.temperature_k = input.temperature_k;
  photons.dark_reference_k = input.dark_reference_k.value_or(input.temperature_k);
  photons.dark_doubling_k = input.dark_doubling_k;
  photons.read_noise_e = input.read_noise_e;
  photons.line_noise_e = input.line_noise_e;
  photons.line_correlation = input.line_correlation;
  photons.flicker_noise_e = input.flicker_noise_e;
  photons.prnu = input.prnu;
  photons.dsnu_e = input.dsnu_e;
  photons.full_well_e = input.full_well_e;
  return photons;
}

sensor::PublishedNoise load_noise(const BandInput& band, const spectral::Response& response) {
  std::vector<sensor::NoiseFigure> figures;
  for (const NoiseFigureInput& figure : band.figures) {
    figures.push_back(std::visit(FigureLoader{response}, figure));
  }
  return sensor::fit_noise(figures);
}

}  // namespace

BandElectronics load_electronics(const ArrayInput& input, const BandInput& band,
                                 const sensor::DetectorArray& array,
                                 const spectral::Response& response) {
  BandElectronics electronics{std::nullopt, band.reference_radiance};
  if (!input.detector) return electronics;
  sensor::Detector detector;
  if (input.optics) detector.optics = load_optics(*input.optics, band);
  detector.digitiser = {input.detector->bits, input.detector->black_level_dn,
                        input.detector->gain_dn_e, 0.0, input.detector->flat};
  detector.dead_share = input.detector->dead_share;
  detector.pattern_seed = static_cast<std::uint64_t>(input.detector->pattern_seed);
  if (const auto* photons = std::get_if<PhotonDetectorInput>(&input.detector->element)) {
    detector.element = load_photons(*photons, band, array);
  } else {
    detector.element = load_noise(band, response);
    detector.digitiser.saturation =
        band.saturation_temperature_k
            ? sensor::band_planck(response, Kelvin{*band.saturation_temperature_k})
            : band.saturation_radiance.value_or(0.0);
  }
  sensor::check(detector);
  electronics.detector = detector;
  return electronics;
}

void check_electronics(const ArrayInput& input, const sensor::DetectorArray& array,
                       const std::vector<BandElectronics>& electronics) {
  ErrorList errors;
  for (std::size_t band = 0; band < electronics.size(); ++band) {
    if (!electronics[band].detector) continue;
    errors.attempt(
        "detector of band " + array.bands[band].name + " of array " + array.name, {}, [&] {
          // What it folds together says whether it can be; any seed does.
          static_cast<void>(sensor::SignalChain{array, band, *electronics[band].detector, 0});
        });
  }
  try {
    errors.throw_if_any();
  } catch (const InputError& error) {
    throw error.located(input.detector->where, {});
  }
}

}  // namespace nadir::sim
