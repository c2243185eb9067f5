#include "sim/products/sensor_sheet.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sensor/detector/photon_yield.hpp"
#include "sim/products/sheet_geometry.hpp"
#include "sim/run/error_list.hpp"

namespace nadir::sim {
namespace {

constexpr double infrared_um = 3.0;  // bands centred beyond have a NEdT
constexpr Kelvin nedt_scene{300.0};
constexpr int mtf_steps = 50;  // to Nyquist

std::vector<double> mtf_frequencies() {
  std::vector<double> all;
  for (int i = 0; i <= 2 * mtf_steps; ++i) all.push_back(0.5 * i / mtf_steps);
  return all;
}

void set_noise(const sensor::SignalChain& chain, const spectral::Response& response,
               sensor::BandFigures& figures) {
  figures.saturation = chain.saturation_radiance();
  if (figures.reference_radiance) {
    figures.nedl = chain.noise_equivalent_radiance(*figures.reference_radiance);
    figures.snr = *figures.reference_radiance / *figures.nedl;
  }
  if (figures.centre_um > infrared_um) {
    const double radiance = sensor::band_planck(response, nedt_scene);
    figures.nedt_k =
        sensor::nedt(response, chain.noise_equivalent_radiance(radiance), nedt_scene).value;
  }
}

BandSheet band_sheet(const Camera& camera, std::size_t array_index, std::size_t band_index,
                     const SheetGeometry& geometry) {
  const sensor::DetectorArray& array = camera.arrays[array_index];
  const sensor::Band& band = array.bands[band_index];
  BandSheet sheet;
  sensor::BandFigures& figures = sheet.figures;
  figures.array = array.name;
  figures.band = band.name;
  figures.centre_um = spectral::centre(band.response).value;
  figures.fwhm_um = spectral::fwhm(band.response).value;
  figures.gsd_x_m = geometry.gsd_x_m;
  figures.gsd_y_m = geometry.gsd_y_m;
  figures.swath_m = geometry.swath_m;
  sheet.exposure_s = array.timing.exposure_s;
  sheet.motion = geometry.motion;
  const std::vector<double> frequencies = mtf_frequencies();
  sheet.mtf_x =
      system_mtf(array, camera.platform, {band_index, false, geometry.motion.x_px_s}, frequencies);
  sheet.mtf_y =
      system_mtf(array, camera.platform, {band_index, true, geometry.motion.y_px_s}, frequencies);
  figures.mtf_nyquist_x = sheet.mtf_x.total[mtf_steps];
  figures.mtf_nyquist_y = sheet.mtf_y.total[mtf_steps];
  if (array_index >= camera.electronics.size()) return sheet;
  const auto& electronics = camera.electronics[array_index];
  if (band_index >= electronics.size()) return sheet;
  figures.reference_radiance = electronics[band_index].reference_radiance;
  const auto& detector = electronics[band_index].detector;
  if (detector) {
    set_noise(sensor::SignalChain{array, band_index, *detector, 0}, band.response, figures);
  }
  return sheet;
}

}  // namespace

SensorSheet sensor_sheet(const Camera& camera, const SheetGround& ground) {
  if (!std::isfinite(ground.height_m) || !(ground.height_m > 0.0)) {
    throw InputError{"expected a positive height of the camera over the ground, found " +
                     number_text(ground.height_m) + " m"};
  }
  SensorSheet sheet;
  sheet.instrument = camera.instrument_name;
  sheet.platform = camera.platform_name;
  sheet.height_m = ground.height_m;
  ErrorList errors;
  for (std::size_t a = 0; a < camera.arrays.size(); ++a) {
    const sensor::DetectorArray& array = camera.arrays[a];
    const SheetGeometry geometry = sheet_geometry(array, camera.platform, ground);
    if (a == 0) sheet.ground_speed_m_s = geometry.ground_speed_m_s;
    for (std::size_t b = 0; b < array.bands.size(); ++b) {
      errors.attempt("band " + array.bands[b].name + " of array " + array.name, {},
                     [&] { sheet.bands.push_back(band_sheet(camera, a, b, geometry)); });
    }
  }
  errors.throw_if_any();
  return sheet;
}

}  // namespace nadir::sim
