#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sensor/camera/detector_array.hpp"
#include "sensor/detector/detector.hpp"
#include "sensor/detector/fixed_pattern.hpp"
#include "sensor/detector/line_noise.hpp"

namespace nadir::sensor {

/// Back to radiance: L = gain DN + offset, W m^-2 sr^-1 um^-1.
struct Calibration {
  double gain = 1.0, offset = 0.0;
};

/// From a band's radiance at the aperture to digital numbers: focal-plane irradiance, electrons,
/// noise, full well, conversion. All linear parts are folded into a few numbers beforehand.
///
/// Lines must come in order (stripes have a memory); the numbers of a pixel depend on (seed,
/// pixel) alone.
class SignalChain {
 public:
  /// @throws InputError for figures out of range
  SignalChain(const DetectorArray& array, std::size_t band, const Detector& detector,
              std::uint64_t noise_seed);

  struct Line {
    std::span<std::uint16_t> dn;
    std::span<float> electrons;  ///< noise-free signal, without dark and background; may be empty
    std::span<float> noise;      ///< sigma of the sensor's own noise, as radiance; may be empty
  };
  /// One line of the image. @param radiance  one a sample; not finite gives DN 0
  void expose(std::span<const float> radiance, const Line& out);

  [[nodiscard]] Calibration calibration() const noexcept;
  /// Standard deviation of the noise that changes from image to image (shot, dark, read, stripes,
  /// quantisation) at a radiance, on the axis; as radiance. What the second rounding of flat
  /// numbers adds is the mean over the image: nothing on the axis, all of it little beside.
  [[nodiscard]] double noise_equivalent_radiance(double radiance) const noexcept;
  /// Electrons per unit of radiance on the axis; 0 where only noise is published.
  [[nodiscard]] double electrons_per_radiance() const noexcept;
  [[nodiscard]] double background_electrons() const noexcept;  ///< dark and the optics' own light
  /// Radiance that fills the well or the converter's range, whichever is less.
  [[nodiscard]] double saturation_radiance() const noexcept;

 private:
  /// Photo-electrons, all linear parts folded together.
  struct Photons {
    double per_radiance = 0.0;  ///< electrons on the axis
    double background = 0.0;    ///< electrons of the optics' own light
    double dark = 0.0;          ///< electrons
    double read = 0.0;
    LineNoise::Rms line{};
    double full_well = 0.0;
    double dn_per_electron = 0.0;
  };
  /// Published noise: radiance per DN, and the variance's two terms.
  struct Published {
    double radiance_per_dn = 0.0;
    double constant = 0.0, slope = 0.0;
  };
  struct Pixel {
    double dn = 0.0, electrons = 0.0, noise = 0.0;
  };

  using Element = std::variant<Photons, Published>;

  [[nodiscard]] static Photons folded(const DetectorArray& array, std::size_t band,
                                      const Detector& detector);
  [[nodiscard]] static Element element_of(const DetectorArray& array, std::size_t band,
                                          const Detector& detector);
  [[nodiscard]] Pixel pixel(const Photons& photons, double radiance, std::size_t sample) const;
  [[nodiscard]] Pixel pixel(const Published& published, double radiance, std::size_t sample) const;
  [[nodiscard]] double sigma(const Photons& photons, double radiance, double falloff) const;
  [[nodiscard]] double sigma(const Published& published, double radiance) const;
  /// Variance of the converter's noise, DN^2, before the fall-off is taken out.
  [[nodiscard]] static double converted_variance(const Photons& photons, double radiance,
                                                 double falloff);
  /// Mean square that the second rounding of flat numbers adds, DN^2.
  [[nodiscard]] double second_rounding(const Photons& photons, double radiance,
                                       double falloff) const noexcept;
  [[nodiscard]] double digitised(double dn) const noexcept;
  /// Electrons of a pixel. @param own  its random numbers
  [[nodiscard]] double shot(double mean, double normal, std::uint64_t own) const noexcept;
  void next_line();

  Element element_;
  double black_dn_ = 0.0, top_dn_ = 0.0;
  bool flat_ = true;
  bool noisy_ = true;
  FixedPattern pattern_;
  FallOff falloff_;
  std::vector<double> falloff_over_image_;  ///< at places spread over it; empty: 1 everywhere
  std::uint64_t noise_key_, line_key_ = 0;
  int line_ = -1;  ///< the current one
  LineNoise line_noise_;
  double of_line_ = 0.0;  ///< noise of the current line, electrons
};

}  // namespace nadir::sensor
