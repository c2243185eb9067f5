#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "core/statistics.hpp"
#include "sensor/camera/detector_array.hpp"
#include "sensor/detector/signal_chain.hpp"
#include "spectral/response.hpp"

// Cameras that look at an even field, and the statistics of what they deliver.

namespace nadir::sensor::flat_field {

/// A frame behind parallel lines of sight: no fall-off towards the corners.
inline DetectorArray frame(int size, double exposure_s, const spectral::Response& response) {
  DetectorArray array;
  array.name = "frame";
  array.samples = size;
  array.lines = size;
  array.projection = Orthographic{};
  array.pitch_m = 1.0;
  array.bands.push_back({"band", response});
  array.timing.exposure_s = exposure_s;
  return array;
}

/// A response that a constant quantum efficiency gives: proportional to the wavelength.
inline spectral::Response constant_efficiency(double lo_um, double hi_um) {
  return spectral::TabulatedResponse{
      spectral::Curve{{lo_um, hi_um}, {lo_um / hi_um, 1.0}, spectral::Outside::zero}};
}

constexpr double exposure_s = 0.002;
inline const spectral::Response red = spectral::BoxResponse{Micrometres{0.63}, Micrometres{0.69}};

/// Photo-electrons with no noise but their own.
inline Detector clean(double full_well_e = 1e5) {
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
inline PhotonDetector& photons(Detector& detector) {
  return std::get<PhotonDetector>(detector.element);
}

struct Image {
  std::vector<std::uint16_t> dn;
  std::vector<float> electrons, noise;
};

/// All lines of an image of an even field.
inline Image expose(const DetectorArray& array, const Detector& detector, double radiance,
                    std::uint64_t seed) {
  const auto samples = static_cast<std::size_t>(array.samples);
  const std::size_t pixels = samples * static_cast<std::size_t>(array.lines);
  Image image{std::vector<std::uint16_t>(pixels), std::vector<float>(pixels),
              std::vector<float>(pixels)};
  const std::vector<float> line(samples, static_cast<float>(radiance));
  SignalChain chain{array, 0, detector, seed};
  for (std::size_t first = 0; first < pixels; first += samples) {
    chain.expose(line, {.dn = std::span{image.dn}.subspan(first, samples),
                        .electrons = std::span{image.electrons}.subspan(first, samples),
                        .noise = std::span{image.noise}.subspan(first, samples)});
  }
  return image;
}

template <class Number>
Welford statistics(const std::vector<Number>& values) {
  Welford sum;
  for (const Number value : values) sum.add(static_cast<double>(value));
  return sum;
}

/// Mean and temporal variance by the difference of two images, which cancels what is fixed.
/// EMVA Standard 1288, release 3.1 (2016), equations (12) to (17).
struct Temporal {
  double mean = 0.0, variance = 0.0;
};
inline Temporal temporal(const std::vector<std::uint16_t>& a, const std::vector<std::uint16_t>& b) {
  Welford difference, sum;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference.add(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    sum.add(0.5 * (static_cast<double>(a[i]) + static_cast<double>(b[i])));
  }
  return {sum.mean(), 0.5 * difference.variance()};
}

}  // namespace nadir::sensor::flat_field
