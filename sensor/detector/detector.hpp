#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "spectral/curve.hpp"

namespace nadir::sensor {

/// The way of the light behind the aperture.
struct Optics {
  double f_number = 0.0;       ///< > 0
  double obscuration = 0.0;    ///< linear, diameter over diameter, [0, 1)
  double transmittance = 1.0;  ///< of the lens and filters at the band's peak, (0, 1]
  double falloff_power = 4.0;  ///< n of cos^n; 0: no fall-off towards the corners
  // Own emission; matters beyond 3 um.
  double temperature_k = 0.0;  ///< of lens and mirrors; 0: they emit nothing
  double emissivity = 0.0;     ///< of the lens, [0, 1]; usually 1 - transmittance of its mirrors
  double shield_temperature_k = 0.0;  ///< of what the detector sees beside the lens; 0: nothing
};

/// A detector that counts photo-electrons.
struct PhotonDetector {
  double efficiency = 0.0;  ///< electrons per photon at the peak, (0, 1]
  double area_m2 = 0.0;     ///< sensitive, of one pixel
  double dark_e_s = 0.0;    ///< dark current at dark_reference_k
  double temperature_k = 293.15, dark_reference_k = 293.15;
  double dark_doubling_k = 7.0;   ///< dark current doubles every so many K
  double read_noise_e = 0.0;      ///< rms
  double line_noise_e = 0.0;      ///< rms of the stripes from line to line
  double line_correlation = 0.0;  ///< of a stripe with the next line's, [0, 1)
  double flicker_noise_e = 0.0;   ///< 1/f noise from line to line: rms (line_noise.hpp)
  double prnu = 0.0;              ///< rms over detectors, relative
  double dsnu_e = 0.0;            ///< rms over detectors
  double full_well_e = 0.0;       ///< > 0
};

/// Only published noise is known: variance of the radiance = alpha^2 + beta L.
struct PublishedNoise {
  double alpha = 0.0;  ///< W m^-2 sr^-1 um^-1
  double beta = 0.0;   ///< W m^-2 sr^-1 um^-1
};

/// A figure that noise is fitted to.
struct NoiseFigure {
  double radiance = 0.0;  ///< band mean, W m^-2 sr^-1 um^-1
  double sigma = 0.0;     ///< of it, same unit
};
/// The law through one figure (half of the variance at it from each term: see docs) or the best one
/// through several, neither term negative.
/// @throws InputError for figures that are not positive
[[nodiscard]] PublishedNoise fit_noise(const std::vector<NoiseFigure>& figures);

/// Numbers that leave the instrument.
struct Digitiser {
  int bits = 12;                      ///< 1 .. 16
  double black_level_dn = 0.0;        ///< added before the conversion
  std::optional<double> gain_dn_e{};  ///< DN per electron; none: the full well fills the range
  double saturation = 0.0;            ///< of PublishedNoise: radiance of the largest number, > 0
  bool flat = true;                   ///< fall-off towards the corners is taken out of the numbers
};

/// All that turns a band's radiance into numbers.
struct Detector {
  Optics optics;
  std::variant<PhotonDetector, PublishedNoise> element;
  Digitiser digitiser;
  double dead_share = 0.0;  ///< of detectors that give nothing, [0, 1)
  std::uint64_t pattern_seed =
      1;              ///< of what stays from image to image: PRNU, DSNU, dead detectors
  bool noisy = true;  ///< without: numbers as the mean of many images has them, but for rounding
};

}  // namespace nadir::sensor
