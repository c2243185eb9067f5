#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/constants.hpp"
#include "sensor/flat_field.hpp"
#include "support/catch.hpp"

// The photon transfer method of EMVA Standard 1288 (release 3.1, 2016), sections 6 to 8, applied to
// simulated images of a camera with the results that the standard's reference implementation
// documents as its example (github.com/EMVA1288/emva1288).

namespace nadir::sensor {
namespace {

/// The example's published results.
namespace published {
constexpr double gain = 0.280769280926;        // K, DN per electron
constexpr double efficiency = 0.451356082834;  // QE
constexpr double dark_sigma_dn = 3.07341849276;
constexpr double dark_sigma_e = 10.8980275235;
constexpr double least_photons = 25.3600660517;  // u_p_min, at a signal-to-noise ratio of 1
constexpr double most_photons = 30957.0;         // u_p_sat
constexpr double most_electrons = 13972.6302563;
constexpr double greatest_snr = 118.205880802;
constexpr double dynamic_range = 1220.69871336;
constexpr double responsivity = 0.126726922819;  // R, DN per photon
}  // namespace published

constexpr double wavelength_um = 0.55, width_um = 1e-4;  // the standard's light has one wavelength
constexpr double exposure_s = 0.01, f_number = 4.0;
constexpr double prnu = 0.008, dsnu_e = 6.0;

Detector example_camera() {
  PhotonDetector element;
  element.efficiency = published::efficiency;
  element.area_m2 = 2.5e-11;
  element.read_noise_e = published::dark_sigma_e;
  element.prnu = prnu;
  element.dsnu_e = dsnu_e;
  element.full_well_e = published::most_electrons;
  Detector detector;
  detector.optics.f_number = f_number;
  detector.element = element;
  detector.digitiser = {.bits = 12, .black_level_dn = 40.0, .gain_dn_e = published::gain};
  return detector;
}

DetectorArray camera(int size) {
  return flat_field::frame(size, exposure_s,
                           flat_field::constant_efficiency(wavelength_um - 0.5 * width_um,
                                                           wavelength_um + 0.5 * width_um));
}

/// Photons on a pixel in an exposure, per unit of radiance: pi / (1 + 4 N^2) A t dlambda lambda /
/// hc, worked out here without the code under test.
double photons_per_radiance() {
  const double irradiance = std::numbers::pi / (1.0 + 4.0 * f_number * f_number) * width_um;
  const double photon_j = si::planck * si::speed_of_light / (wavelength_um * 1e-6);
  return irradiance * 2.5e-11 * exposure_s / photon_j;
}

struct Level {
  double photons = 0.0;
  flat_field::Temporal measured{};
};

Level level(const DetectorArray& array, double photons, std::uint64_t seed) {
  const double radiance = photons / photons_per_radiance();
  return {photons,
          flat_field::temporal(flat_field::expose(array, example_camera(), radiance, seed).dn,
                               flat_field::expose(array, example_camera(), radiance, seed + 1).dn)};
}

/// Twenty levels from dark to 70 % of saturation, the part that the standard fits.
std::vector<Level> levels() {
  const DetectorArray array = camera(128);
  std::vector<Level> all;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const double photons = 0.7 * published::most_photons * static_cast<double>(i) / 19.0;
    all.push_back(level(array, photons, 2 * i));
  }
  return all;
}

struct Slopes {
  double variance_per_dn = 0.0, dn_per_photon = 0.0;
};
/// Least squares through the dark level, equations (19) and (22).
Slopes slopes(const std::vector<Level>& all) {
  double yy = 0.0, yv = 0.0, pp = 0.0, py = 0.0;
  for (const Level& one : all) {
    const double y = one.measured.mean - all.front().measured.mean;
    yy += y * y;
    yv += y * (one.measured.variance - all.front().measured.variance);
    pp += one.photons * one.photons;
    py += one.photons * y;
  }
  return {yv / yy, py / pp};
}

/// Mean of `count` images, pixel by pixel, and the mean of their temporal variances.
struct Stack {
  std::vector<double> mean;
  double temporal_variance = 0.0;
};
Stack stack(double photons, int count) {
  const DetectorArray array = camera(128);
  std::vector<Welford> pixels(128 * 128);
  for (int i = 0; i < count; ++i) {
    const auto image = flat_field::expose(array, example_camera(), photons / photons_per_radiance(),
                                          static_cast<std::uint64_t>(1000 + i));
    for (std::size_t p = 0; p < pixels.size(); ++p) pixels[p].add(image.dn[p]);
  }
  Stack found;
  Welford variance;
  for (const Welford& pixel : pixels) {
    found.mean.push_back(pixel.mean());
    variance.add(pixel.variance());
  }
  found.temporal_variance = variance.mean();
  return found;
}

/// Variance from detector to detector, freed from what the temporal noise leaves in the mean of so
/// many images: equation (28).
double spatial_variance(const Stack& images, int count) {
  return flat_field::statistics(images.mean).variance() - images.temporal_variance / count;
}

}  // namespace

// 128 x 128 pixels: a variance is known to 1.1 %, the slope through 20 of them to 0.3 %; 1 % is
// what the standard is meant to reach. The dark noise is known to 0.6 %.
TEST_CASE("photon transfer returns gain, efficiency and read noise", "[sensor][detector]") {
  const std::vector<Level> all = levels();
  const Slopes fit = slopes(all);
  const double gain = fit.variance_per_dn, efficiency = fit.dn_per_photon / gain;
  CHECK(gain == Approx(published::gain).epsilon(0.01));
  CHECK(fit.dn_per_photon == Approx(published::responsivity).epsilon(0.001));
  CHECK(efficiency == Approx(published::efficiency).epsilon(0.01));
  const double dark_sigma_dn = std::sqrt(all.front().measured.variance);
  CHECK(dark_sigma_dn == Approx(published::dark_sigma_dn).epsilon(0.03));
  const double dark_sigma_e = std::sqrt(all.front().measured.variance - 1.0 / 12.0) / gain;
  CHECK(dark_sigma_e == Approx(published::dark_sigma_e).epsilon(0.03));
  const double least_photons = (dark_sigma_dn / gain + 0.5) / efficiency;
  CHECK(least_photons == Approx(published::least_photons).epsilon(0.03));
  CHECK(std::sqrt(published::most_electrons) ==
        Approx(published::greatest_snr).epsilon(1e-9));  // SNR_max = sqrt(u_e.sat)
  CHECK(published::most_photons / least_photons == Approx(published::dynamic_range).epsilon(0.03));
}

// 16,384 detectors give a standard deviation to 0.55 %; 16 images and their correction add 0.3 %.
TEST_CASE("stacks of dark and half-full images return DSNU and PRNU", "[sensor][detector]") {
  constexpr int count = 16;
  const Stack dark = stack(0.0, count), half = stack(0.5 * published::most_photons, count);
  const double dark_variance = spatial_variance(dark, count);
  CHECK(std::sqrt(dark_variance) / published::gain == Approx(dsnu_e).epsilon(0.03));
  const double signal =
      flat_field::statistics(half.mean).mean() - flat_field::statistics(dark.mean).mean();
  CHECK(std::sqrt(spatial_variance(half, count) - dark_variance) / signal ==
        Approx(prnu).epsilon(0.03));
}

// The standard takes saturation from the greatest temporal variance. Detectors differ by 0.8 % and
// counts by 0.85 %: the most sensitive ones are full, and the variance falls, two to four standard
// deviations of both (2.3 to 4.7 %) below the well. Levels are 0.5 % apart.
TEST_CASE("the temporal variance peaks where the well is full", "[sensor][detector]") {
  const DetectorArray array = camera(64);
  Level fullest;
  for (std::uint64_t i = 0; i <= 40; ++i) {
    const double share = 0.9 + 0.005 * static_cast<double>(i);
    const Level one = level(array, share * published::most_photons, 5000 + 2 * i);
    if (one.measured.variance > fullest.measured.variance) fullest = one;
  }
  const double electrons = (fullest.measured.mean - 40.0) / published::gain;
  CHECK(electrons == Approx(published::most_electrons).epsilon(0.05));
  // What is over-exposed twice has the well's number, to the read noise of the mean.
  const Level over = level(array, 2.0 * published::most_photons, 9000);
  CHECK(over.measured.mean ==
        Approx(40.0 + published::gain * published::most_electrons).epsilon(2e-4));
}

// EMVA 1288, section 6.8: deviation from the straight line between 5 and 95 % of saturation. The
// standard error of a level's mean is at most sqrt(13,972 + 112^2) / 128 / level < 0.02 %.
TEST_CASE("the mean signal is linear in the light", "[sensor][detector]") {
  const DetectorArray array = camera(128);
  const double dark = level(array, 0.0, 1).measured.mean;
  for (std::uint64_t i = 1; i <= 9; ++i) {
    const double photons = 0.1 * static_cast<double>(i) * published::most_photons;
    const double expected = published::responsivity * photons;
    // PRNU is the same in each level: its mean over detectors differs from 1 by 0.008 / 128.
    CHECK(level(array, photons, 100 + 2 * i).measured.mean - dark ==
          Approx(expected).epsilon(1e-3));
  }
}

}  // namespace nadir::sensor
