#include "sensor/detector/signal_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "sensor/detector/photon_yield.hpp"
#include "sensor/detector/shot_noise.hpp"
#include "sensor/flat_field.hpp"
#include "support/catch.hpp"
#include "support/statistics.hpp"

namespace nadir::sensor {
namespace {

using flat_field::expose;
using flat_field::frame;

constexpr double exposure_s = 0.002;
const spectral::Response red = spectral::BoxResponse{Micrometres{0.63}, Micrometres{0.69}};

/// Photo-electrons with no noise but their own.
Detector clean(double full_well_e = 1e5) {
  PhotonDetector element;
  element.efficiency = 0.5;
  element.area_m2 = 1e-10;
  element.full_well_e = full_well_e;
  Detector detector;
  detector.optics.f_number = 4.0;
  detector.element = element;
  detector.digitiser.bits = 16;
  return detector;
}
PhotonDetector& photons(Detector& detector) { return std::get<PhotonDetector>(detector.element); }

SignalChain chain_of(const Detector& detector, const spectral::Response& response = red) {
  return {frame(8, exposure_s, response), 0, detector, 1};
}

std::string complaint(const DetectorArray& array, const Detector& detector) {
  try {
    const SignalChain chain{array, 0, detector, 1};
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

// Independent of the code: electrons wavelength by wavelength, by the midpoint rule on a radiance
// that is not constant. Gauss's quadrature is exact for it, the rule to 1e-7.
TEST_CASE("electrons are the integral of photons times efficiency", "[sensor][detector]") {
  const spectral::Curve curve{{0.5, 0.55, 0.6}, {0.2, 1.0, 0.4}, spectral::Outside::zero};
  const spectral::Response response = spectral::TabulatedResponse{curve};
  Detector detector = clean();
  detector.optics.transmittance = 0.7;
  detector.optics.obscuration = 0.3;
  double peak = 0.0;
  for (double l = 0.5; l < 0.6; l += 1e-5) peak = std::max(peak, curve.at(Micrometres{l}) / l);
  const int steps = 20000;
  double electrons = 0.0, weighted = 0.0, area = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double l = 0.5 + 0.1 * (i + 0.5) / steps, d = 0.1 / steps;
    const double r = curve.at(Micrometres{l}), radiance = 3.0 + 20.0 * l * l;
    const double irradiance = std::numbers::pi * radiance * 0.7 * (1.0 - 0.09) / (1.0 + 4.0 * 16.0);
    const double eta = 0.5 * r / l / peak;
    const double photon_j = si::planck * si::speed_of_light / (l * 1e-6);
    electrons += exposure_s * 1e-10 * irradiance * eta / photon_j * d;
    weighted += radiance * r * d;
    area += r * d;
  }
  const SignalChain chain = chain_of(detector, response);
  CHECK(chain.electrons_per_radiance() * weighted / area == Approx(electrons).epsilon(1e-5));
}

TEST_CASE("a Gaussian's yield agrees with its table's", "[sensor][detector]") {
  const double fwhm = GENERATE(0.02, 0.3, 0.8);
  const spectral::GaussianResponse g{Micrometres{1.5}, Micrometres{fwhm}};
  const spectral::Support s = spectral::support(spectral::Response{g});
  std::vector<double> w, r;
  for (int i = 0; i <= 4000; ++i) {
    w.push_back(s.lo.value + (s.hi - s.lo).value * i / 4000.0);
    r.push_back(spectral::at(spectral::Response{g}, Micrometres{w.back()}));
  }
  r.front() = r[1];  // rounding may put the ends outside
  r.back() = r[r.size() - 2];
  const spectral::Response table =
      spectral::TabulatedResponse{spectral::Curve{w, r, spectral::Outside::zero}};
  // 1e-6: the trapezoid rule's error, (step / fwhm)^2.
  CHECK(photon_yield(spectral::Response{g}).per_radiance ==
        Approx(photon_yield(table).per_radiance).epsilon(1e-5));
}

// Landsat-8 OLI, band 4, as public notes describe it: 886 mm over 135 mm, 36 um, 3.6 ms, tau 0.70,
// QE 0.80, L = 22: 127,037 electrons, shot-limited SNR 356 (sections 1.6 and 4 of the reference
// notes). 1e-3: their rounding.
TEST_CASE("the red band of an OLI counts 127,037 electrons", "[sensor][detector]") {
  Detector detector = clean(1e6);
  detector.optics.f_number = 0.886 / 0.135;
  detector.optics.transmittance = 0.70;
  photons(detector).efficiency = 0.80;
  photons(detector).area_m2 = 36e-6 * 36e-6;
  const SignalChain chain{frame(8, 3.6e-3, flat_field::constant_efficiency(0.636, 0.673)), 0,
                          detector, 1};
  const double electrons = chain.electrons_per_radiance() * 22.0;
  CHECK(electrons == Approx(127037.0).epsilon(1e-3));
  CHECK(std::sqrt(electrons) == Approx(356.0).epsilon(2e-3));
}

// Landsat-8 TIRS, band 10 (Reuter 2015, Jhabvala 2011, as cited in those notes): f/1.64, tau 0.49,
// 25 um, 3.49 ms, conversion 0.8 %, dark 4e7 e-/s, read 260 e-, well 5e6, 12 bit.
TEST_CASE("band 10 of a TIRS has a NEdT of 0.096 K", "[sensor][detector]") {
  Detector detector = clean(5e6);
  detector.optics.f_number = 1.64;
  detector.optics.transmittance = 0.49;
  detector.digitiser.bits = 12;
  PhotonDetector& element = photons(detector);
  element.efficiency = 0.008;
  element.area_m2 = 25e-6 * 25e-6;
  element.dark_e_s = 4e7;
  element.read_noise_e = 260.0;
  const spectral::Response b10 = flat_field::constant_efficiency(10.6, 11.2);
  const SignalChain chain{frame(8, 3.49e-3, b10), 0, detector, 1};
  const double radiance = band_planck(b10, Kelvin{300.0});
  // The notes give two digits.
  CHECK(chain.electrons_per_radiance() * radiance == Approx(7.2e5).epsilon(0.01));
  const double nedl = chain.noise_equivalent_radiance(radiance);
  CHECK(nedl / band_planck_derivative(b10, Kelvin{300.0}) == Approx(0.096).epsilon(0.01));
}

// The textbook's pi / (4 N^2) is too large by 1 / (4 N^2): sensors' reference notes, 1.6.
TEST_CASE("the cone of an f/1 lens is a fifth less than the textbook's", "[sensor][detector]") {
  const auto textbook = [](double n) { return std::numbers::pi / (4.0 * n * n); };
  CHECK(textbook(1.0) / cone_sr({.f_number = 1.0}) == Approx(1.25).epsilon(1e-14));
  CHECK(textbook(6.4) / cone_sr({.f_number = 6.4}) == Approx(1.0061).epsilon(1e-4));
  // Lens and shield together fill the half space.
  CHECK(cone_sr({.f_number = 1.3}) + shield_sr({.f_number = 1.3}) ==
        Approx(std::numbers::pi).epsilon(1e-14));
}

// A cavity: scene, lens and shield all at one temperature. With a perfect detector (no filter) the
// lens's own light makes up for what it does not transmit: as many electrons as without a lens.
TEST_CASE("inside a cavity a lens cannot be seen", "[sensor][detector]") {
  const spectral::Response band = spectral::BoxResponse{Micrometres{8.0}, Micrometres{12.0}};
  const double radiance = band_planck(band, Kelvin{290.0});
  const auto total = [&](double transmittance) {
    Detector detector = clean(1e12);
    detector.optics.transmittance = transmittance;
    detector.optics.emissivity = 1.0 - transmittance;
    detector.optics.temperature_k = 290.0;
    detector.optics.shield_temperature_k = 290.0;
    const SignalChain chain = chain_of(detector, band);
    return chain.electrons_per_radiance() * radiance + chain.background_electrons();
  };
  CHECK(total(0.6) == Approx(total(1.0)).epsilon(1e-13));
  // ... and the half space: pi B t A eta yield.
  const double expected =
      std::numbers::pi * radiance * exposure_s * 1e-10 * 0.5 * photon_yield(band).per_radiance;
  CHECK(total(0.6) == Approx(expected).epsilon(1e-13));
}

TEST_CASE("a cold filter takes from the lens's light as from the scene's", "[sensor][detector]") {
  const spectral::Response band = spectral::BoxResponse{Micrometres{8.0}, Micrometres{12.0}};
  const auto background = [&](double transmittance) {
    Detector detector = clean(1e12);
    detector.optics.transmittance = transmittance;
    detector.optics.emissivity = 0.2;
    detector.optics.temperature_k = 290.0;
    return chain_of(detector, band).background_electrons();
  };
  CHECK(background(0.4) == Approx(0.5 * background(0.8)).epsilon(1e-13));
}

TEST_CASE("dark current doubles with its temperature", "[sensor][detector]") {
  Detector detector = clean();
  photons(detector).dark_e_s = 5e4;
  photons(detector).dark_doubling_k = 6.0;
  CHECK(chain_of(detector).background_electrons() == Approx(100.0).epsilon(1e-13));
  photons(detector).temperature_k += 12.0;
  CHECK(chain_of(detector).background_electrons() == Approx(400.0).epsilon(1e-13));
}

TEST_CASE("time-delay integration multiplies signal, dark and own light", "[sensor][detector]") {
  Detector detector = clean();
  photons(detector).dark_e_s = 5e4;
  DetectorArray array = frame(8, exposure_s, red);
  array.timing.scan = Pushbroom{0.0, exposure_s};
  const SignalChain one{array, 0, detector, 1};
  array.timing.tdi_stages = 16;
  const SignalChain many{array, 0, detector, 1};
  CHECK(many.electrons_per_radiance() ==
        Approx(16.0 * one.electrons_per_radiance()).epsilon(1e-14));
  CHECK(many.background_electrons() == Approx(16.0 * one.background_electrons()).epsilon(1e-14));
}

TEST_CASE("places on the circle are cosine and sine", "[sensor][detector]") {
  double worst = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double turns = i / 4000.0, angle = 2.0 * std::numbers::pi * turns;
    const Vec2 p = on_circle(turns);
    worst = std::max({worst, std::abs(p.x - std::cos(angle)), std::abs(p.y - std::sin(angle))});
  }
  CHECK(worst < 3e-14);  // the sine's next term: (pi / 4)^15 / 15! = 2e-14
}

// Pearson's test of 20,000 counts; 0.001 is the false alarm, the seed is fixed. A mean wrong by 2 %
// fails it.
TEST_CASE("small counts follow Poisson's distribution", "[sensor][detector]") {
  const double mean = GENERATE(0.2, 3.0, 29.0);
  const int draws = 20000;
  std::vector<double> counts(120, 0.0), expected;
  Rng rng{7};
  for (int i = 0; i < draws; ++i) {
    counts[static_cast<std::size_t>(poisson_by_sum(mean, rng.next()))] += 1.0;
  }
  for (int n = 0; n < 120; ++n) {
    expected.push_back(draws * std::exp(n * std::log(mean) - mean - std::lgamma(n + 1.0)));
  }
  CHECK(support::chi_square_p_value(counts, expected) > 0.001);
}

// Quantile by quantile against the sum of the distribution's terms: the share of draws where the
// two differ, and never by more than one count.
TEST_CASE("large counts agree with Poisson's distribution quantile by quantile",
          "[sensor][detector]") {
  const double mean = GENERATE(32.0, 33.7, 60.0);
  double different = 0.0, greatest = 0.0, bias = 0.0;
  const int quantiles = 4000;
  for (int i = 0; i < quantiles; ++i) {
    const double z = -4.0 + 8.0 * (i + 0.5) / quantiles;
    const double u = 0.5 * std::erfc(-z / std::numbers::sqrt2);
    double term = std::exp(-mean), sum = term, exact = 0.0;
    while (u >= sum && exact < 400.0) {
      exact += 1.0;
      term *= mean / exact;
      sum += term;
    }
    const double difference = poisson_by_normal(mean, z) - exact;
    greatest = std::max(greatest, std::abs(difference));
    const double draws =
        8.0 / quantiles * std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    bias += draws * difference;
    different += draws * std::abs(difference);
  }
  CHECK(greatest <= 1.0);
  CHECK(different < 3e-3);
  CHECK(std::abs(bias) < 5e-3);  // steps of quantiles are 0.01 of a count
}

// 4096 pixels: the standard error of the mean is sigma / 64, of sigma 1.1 %. Four of them.
TEST_CASE("numbers give the radiance back", "[sensor][detector]") {
  Detector detector = clean(2e4);
  detector.digitiser = {.bits = 12, .black_level_dn = 100.0};
  detector.optics.temperature_k = 290.0;
  detector.optics.emissivity = 0.3;
  detector.optics.transmittance = 0.7;
  photons(detector).dark_e_s = 2e5;
  photons(detector).read_noise_e = 20.0;
  const bool warm = GENERATE(false, true);  // the optics' own light counts at 3.5 um only
  const spectral::Response infrared = spectral::BoxResponse{Micrometres{3.5}, Micrometres{3.55}};
  const spectral::Response& band = warm ? infrared : red;
  const DetectorArray array = frame(64, exposure_s, band);
  const SignalChain chain{array, 0, detector, 3};
  const double radiance = 0.4 * chain.saturation_radiance();
  const auto image = expose(array, detector, radiance, 3);
  const Calibration back = chain.calibration();
  const Welford dn = flat_field::statistics(image.dn);
  const double sigma = chain.noise_equivalent_radiance(radiance);
  CHECK(back.gain * dn.mean() + back.offset == Approx(radiance).margin(4.0 * sigma / 64.0));
  CHECK(back.gain * std::sqrt(dn.variance()) == Approx(sigma).epsilon(0.045));
  CHECK(static_cast<double>(image.noise[77]) == Approx(sigma).epsilon(1e-6));  // float
  CHECK(static_cast<double>(image.electrons[77]) ==
        Approx(chain.electrons_per_radiance() * radiance).epsilon(1e-6));
}

// Without noise: a well so large that shot noise is 1e-3 of a step.
TEST_CASE("numbers without noise are within half a step of the radiance", "[sensor][detector]") {
  Detector detector = clean(1e14);
  detector.digitiser.bits = 8;
  const DetectorArray array = frame(4, exposure_s, red);
  SignalChain chain{array, 0, detector, 1};
  std::vector<float> radiance;
  for (int i = 0; i < 4; ++i) {
    radiance.push_back(static_cast<float>(chain.saturation_radiance() * (0.11 + 0.2123 * i)));
  }
  std::vector<std::uint16_t> dn(4);
  chain.expose(radiance, {.dn = dn, .electrons = {}, .noise = {}});
  const Calibration back = chain.calibration();
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(std::abs(back.gain * dn[i] + back.offset - static_cast<double>(radiance[i])) <
          0.501 * back.gain);
  }
}

namespace {

DetectorArray wide_camera() {
  DetectorArray array = frame(41, exposure_s, red);
  array.projection = Perspective{0.01};
  array.pitch_m = 0.0004;  // corners at 39 degrees
  return array;
}

/// Mean radiance of a pixel over many images, by the calibration.
double mean_radiance(const DetectorArray& array, const Detector& detector, double radiance,
                     std::size_t pixel) {
  Welford dn;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    dn.add(expose(array, detector, radiance, seed).dn[pixel]);
  }
  const Calibration back = SignalChain{array, 0, detector, 1}.calibration();
  return back.gain * dn.mean() + back.offset;
}

}  // namespace

// The corner is 20 pixels of 0.4 mm off in x and in y: tan^2 = 2 (8 / 10)^2, cos^4 = 1 / 2.28^2.
TEST_CASE("corners get the fourth power of the cosine, and flat numbers undo it",
          "[sensor][detector]") {
  const double falloff = 1.0 / (2.28 * 2.28);
  const DetectorArray array = wide_camera();
  Detector detector = clean(1e7);
  photons(detector).dark_e_s = 1e8;  // 2e5 electrons: flat numbers must not divide these
  const double radiance = 0.5 * SignalChain{array, 0, detector, 1}.saturation_radiance();
  detector.digitiser.flat = GENERATE(true, false);
  const auto image = expose(array, detector, radiance, 1);
  const double on_axis = SignalChain{array, 0, detector, 1}.electrons_per_radiance() * radiance;
  CHECK(static_cast<double>(image.electrons[20 * 41 + 20]) == Approx(on_axis).epsilon(1e-6));
  CHECK(static_cast<double>(image.electrons[0]) == Approx(falloff * on_axis).epsilon(1e-6));
  // Noise: 0.03 % of an image's pixel there, and 24 images.
  const double expected = detector.digitiser.flat ? radiance : falloff * radiance;
  CHECK(mean_radiance(array, detector, radiance, 0) == Approx(expected).epsilon(0.002));
  CHECK(mean_radiance(array, detector, radiance, 20 * 41 + 20) == Approx(radiance).epsilon(0.002));
  // Electrons of the corner are fewer: the noise is that of an aperture so much smaller.
  const double sigma = std::sqrt(falloff * on_axis + 2e5) / (falloff * on_axis) * radiance;
  CHECK(static_cast<double>(image.noise[0]) == Approx(sigma).epsilon(1e-3));  // and rounding
}

TEST_CASE("the same seed gives the same image, another seed another one", "[sensor][detector]") {
  Detector detector = clean(2e4);
  photons(detector).prnu = 0.02;
  photons(detector).line_noise_e = 5.0;
  const DetectorArray array = frame(16, exposure_s, red);
  const auto a = expose(array, detector, 1.5, 1), b = expose(array, detector, 1.5, 1);
  CHECK(a.dn == b.dn);
  CHECK(a.dn != expose(array, detector, 1.5, 2).dn);
  Detector other = detector;
  other.pattern_seed = 2;
  CHECK(a.dn != expose(array, other, 1.5, 1).dn);
  DetectorArray renamed = array;
  renamed.bands[0].name = "other";
  CHECK(a.dn != expose(renamed, detector, 1.5, 1).dn);
}

// A pixel's number depends on its seed, its place and its own radiance, not on its neighbours'.
TEST_CASE("a pixel's noise does not depend on other pixels", "[sensor][detector]") {
  const Detector detector = clean(2e4);
  const DetectorArray array = frame(3, exposure_s, red);
  SignalChain even{array, 0, detector, 1}, uneven{array, 0, detector, 1};
  std::vector<std::uint16_t> a(3), b(3);
  for (int line = 0; line < 5; ++line) {
    even.expose(std::vector<float>{1.5F, 1.5F, 1.5F}, {.dn = a, .electrons = {}, .noise = {}});
    uneven.expose(std::vector<float>{0.0F, 1.5F, 1.0F}, {.dn = b, .electrons = {}, .noise = {}});
    CHECK(a[1] == b[1]);
  }
}

// 4096 detectors: a share of 0.1 has the standard deviation 0.0047; four of them.
TEST_CASE("dead detectors give nothing, in every image", "[sensor][detector]") {
  Detector detector = clean(2e4);
  detector.dead_share = 0.1;
  detector.digitiser.black_level_dn = 500.0;
  const DetectorArray array = frame(64, exposure_s, red);
  const auto a = expose(array, detector, 1.5, 1), b = expose(array, detector, 1.5, 2);
  double dead = 0.0;
  for (std::size_t i = 0; i < a.dn.size(); ++i) {
    CHECK((a.dn[i] == 0) == (b.dn[i] == 0));
    if (a.dn[i] == 0) dead += 1.0;
  }
  CHECK(dead / 4096.0 == Approx(0.1).margin(0.019));
}

TEST_CASE("a pushbroom's detectors stay with their samples, a whiskbroom's with their lines",
          "[sensor][detector]") {
  Detector detector = clean(1e12);  // no noise to speak of but the pattern
  photons(detector).prnu = 0.05;
  DetectorArray array = frame(16, exposure_s, red);
  const double radiance = 0.5 * SignalChain{array, 0, detector, 1}.saturation_radiance();
  array.timing.scan = Pushbroom{0.0, exposure_s};
  const auto pushed = expose(array, detector, radiance, 1);
  CHECK(std::abs(pushed.dn[3] - pushed.dn[16 * 9 + 3]) <= 1);
  CHECK(std::abs(pushed.dn[3] - pushed.dn[4]) > 20);
  array.timing.scan = Whiskbroom{0.0, exposure_s, 1.0, 4};
  const auto swept = expose(array, detector, radiance, 1);
  CHECK(std::abs(swept.dn[16 * 2 + 3] - swept.dn[16 * 6 + 11]) <= 1);
  CHECK(std::abs(swept.dn[16 * 2] - swept.dn[16 * 3]) > 20);
}

// 2000 lines: the rms of the stripes is known to 2.5 % (correlated by 0.6: 2000 / 2.1 of them are
// independent), their correlation to 0.02. What 64 samples leave of the read noise is 1.6 %.
TEST_CASE("stripes have their rms and their memory", "[sensor][detector]") {
  Detector detector = clean(1e5);
  photons(detector).line_noise_e = 30.0;
  photons(detector).line_correlation = 0.6;
  detector.digitiser.black_level_dn = 1000.0;
  DetectorArray array = frame(64, exposure_s, red);
  array.lines = 2000;
  const auto image = expose(array, detector, 0.0, 5);
  std::vector<double> means;
  for (std::size_t line = 0; line < 2000; ++line) {
    Welford mean;
    for (std::size_t s = 0; s < 64; ++s) mean.add(image.dn[line * 64 + s]);
    means.push_back(mean.mean() - 1000.0);
  }
  double products = 0.0, squares = 0.0;
  for (std::size_t i = 1; i < means.size(); ++i) {
    products += means[i] * means[i - 1];
    squares += means[i] * means[i];
  }
  const double dn_per_electron = (65535.0 - 1000.0) / 1e5;
  CHECK(std::sqrt(squares / 1999.0) == Approx(30.0 * dn_per_electron).epsilon(0.08));
  CHECK(products / squares == Approx(0.6).margin(0.06));
}

TEST_CASE("the converter ends at its last number, the well before it", "[sensor][detector]") {
  Detector detector = clean(2e4);
  detector.digitiser.bits = 10;
  const DetectorArray array = frame(4, exposure_s, red);
  const SignalChain chain{array, 0, detector, 1};
  const auto full = expose(array, detector, 3.0 * chain.saturation_radiance(), 1);
  CHECK(std::all_of(full.dn.begin(), full.dn.end(), [](auto dn) { return dn == 1023; }));
  detector.digitiser.gain_dn_e = 0.02;  // the well gives 400
  const auto half = expose(array, detector, 3.0 * chain.saturation_radiance(), 1);
  CHECK(std::all_of(half.dn.begin(), half.dn.end(), [](auto dn) { return dn == 400; }));
  CHECK(SignalChain{array, 0, detector, 1}.saturation_radiance() ==
        Approx(chain.saturation_radiance()).epsilon(1e-13));
}

TEST_CASE("what is not a number becomes 0", "[sensor][detector]") {
  const DetectorArray array = frame(4, exposure_s, red);
  SignalChain chain{array, 0, clean(), 1};
  std::vector<std::uint16_t> dn(4, 9);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  chain.expose(
      std::vector<float>{std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -1.0F},
      {.dn = dn, .electrons = {}, .noise = {}});
  CHECK(dn == std::vector<std::uint16_t>{0, 0, 0, 0});
}

// 16,384 pixels: sigma to 0.55 %; 2 %. The law holds with the rounding of 12 bits in it.
TEST_CASE("published noise is what the numbers have", "[sensor][detector]") {
  Detector detector;
  detector.element = PublishedNoise{0.02, 0.004};
  detector.digitiser = {.bits = 12, .black_level_dn = 200.0};
  detector.digitiser.saturation = 300.0;
  DetectorArray array = frame(128, 0.0, red);  // needs no exposure
  const double radiance = GENERATE(0.5, 40.0, 220.0);
  const SignalChain chain{array, 0, detector, 1};
  const auto image = expose(array, detector, radiance, 1);
  const Welford dn = flat_field::statistics(image.dn);
  const Calibration back = chain.calibration();
  const double sigma = std::sqrt(0.02 * 0.02 + 0.004 * radiance);
  CHECK(chain.noise_equivalent_radiance(radiance) == Approx(sigma).epsilon(1e-13));
  CHECK(back.gain * std::sqrt(dn.variance()) == Approx(sigma).epsilon(0.02));
  CHECK(back.gain * dn.mean() + back.offset == Approx(radiance).margin(4.0 * sigma / 128.0));
  CHECK(chain.saturation_radiance() == Approx(300.0).epsilon(1e-13));
  CHECK(chain.electrons_per_radiance() == 0.0);
}

TEST_CASE("a moment is too short for photons", "[sensor][detector]") {
  CHECK(complaint(frame(4, 0.0, red), clean()) ==
        "error: array \"frame\" looks for a moment only: a detector that counts photons needs an "
        "exposure (noise by published figures does not)\n");
}

TEST_CASE("figures out of range are refused by name", "[sensor][detector]") {
  const DetectorArray array = frame(4, exposure_s, red);
  Detector detector = clean();
  photons(detector).efficiency = 1.2;
  CHECK(complaint(array, detector) == "error: expected an efficiency in (0, 1], found 1.2\n");
  detector = clean();
  detector.digitiser.bits = 17;
  CHECK(complaint(array, detector) == "error: expected 1 to 16 bits, found 17\n");
  detector = clean();
  detector.optics.temperature_k = 290.0;
  detector.optics.emissivity = 0.3;
  detector.optics.transmittance = 0.8;
  CHECK(
      complaint(array, detector) ==
      "error: expected emissivity and transmittance of warm optics to sum to at most 1, found 0.3 "
      "and 0.8\n");
  detector = clean(10.0);
  photons(detector).dark_e_s = 1e5;
  CHECK(complaint(array, detector) ==
        "error: dark current (200 electrons) and the optics' own light (0) fill the well of 10 in "
        "one exposure\n");
  detector = clean();
  photons(detector).read_noise_e = std::numeric_limits<double>::quiet_NaN();
  CHECK(complaint(array, detector) ==
        "error: expected a read noise, electrons, at least 0, found nan\n");
}

}  // namespace nadir::sensor
