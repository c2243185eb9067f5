#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/sampler.hpp"
#include "core/vec.hpp"
#include "spectral/response.hpp"

namespace nadir::sensor {

/// Diffraction by a circular aperture with a round obscuration in its middle.
struct DiffractionSpread {
  double f_number = 0.0;     ///< focal length over the aperture's diameter, > 0
  double obscuration = 0.0;  ///< diameter of the obscured part over the aperture's, [0, 1)
};
/// Blur of the optics, standard deviations on the focal plane.
struct GaussianSpread {
  double sigma_x_m = 0.0, sigma_y_m = 0.0;  ///< >= 0
};
/// Measured or computed elsewhere: a picture of a point for each of some wavelengths.
struct TabulatedSpread {
  struct Slice {
    double wavelength_um = 0.0;
    std::vector<double> weights;  ///< row-major, y down; >= 0, their sum 1
  };
  int columns = 0, rows = 0;  ///< the middle of the picture is the point's ideal place
  double pitch_m = 0.0;  ///< of the weights on the focal plane; each is spread evenly over its cell
  std::vector<Slice> slices;  ///< ascending in wavelength; bands weight them, linear between
};
/// A share of the light that comes from far around: scatter, ghosts. Density falls off as
/// (1 + (r / core)^2)^-slope out to `reach`.
struct StraySpread {
  double share = 0.0;  ///< of the light, [0, 1)
  double core_m = 0.0, slope = 1.5, reach_m = 0.0;
};

/// What blurs the image of a point, all of it one after the other (convolved); stray light then
/// takes the place of all of it for its share of the light. Effects that are sampled by themselves
/// (the detector's area, motion, jitter, time-delay integration) must not be in it.
struct SpreadDescription {
  std::optional<DiffractionSpread> diffraction;
  std::vector<GaussianSpread> gaussians;
  std::optional<TabulatedSpread> table;  ///< not together with diffraction
  std::optional<StraySpread> stray;
};

/// The point-spread function of an array's bands, ready to be drawn from.
///
/// One path serves all bands of an array, though diffraction and tables differ with wavelength:
/// displacements are drawn from the mean of the bands' functions, and `weights` says how much the
/// path counts in each band. Where all bands have one function the weights are 1.
class PointSpread {
 public:
  /// @throws InputError for figures out of range, a table that does not sum to one within 1e-3, or
  ///         diffraction and a table together
  PointSpread(const SpreadDescription& description, const std::vector<spectral::Response>& bands);

  struct Draw {
    /// On the focal plane, x right, y down: from the detector's place to the ideal place of the
    /// light that it gets, so against the way that the optics throw light.
    Vec2 displacement_m;
    float core_x_m = 0.0F, core_y_m = 0.0F;  ///< the part that depends on the band, along that way
    bool stray = false;
  };
  static constexpr std::uint32_t dimensions = 5;  ///< points of the sampler that it uses
  /// @param first  the first of them
  [[nodiscard]] Draw draw(const Sampler& numbers, std::uint32_t first) const noexcept;

  /// Whether bands have different functions.
  [[nodiscard]] bool depends_on_band() const noexcept { return depends_on_band_; }
  /// How much a path counts in each band: mean 1 over draws, at most the number of bands.
  void weights(const Draw& draw, std::span<double> by_band) const noexcept;

  /// Modulation at a frequency on the focal plane, cycles per metre; closed forms where there are.
  [[nodiscard]] double mtf(std::size_t band, Vec2 frequency_per_m) const;
  [[nodiscard]] const SpreadDescription& description() const noexcept { return description_; }

 private:
  struct Tables;
  SpreadDescription description_;
  std::shared_ptr<const Tables> tables_;
  bool depends_on_band_ = false;
};

}  // namespace nadir::sensor
