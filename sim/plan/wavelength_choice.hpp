#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "sim/plan/camera_plan.hpp"
#include "sim/plan/effect_plan.hpp"
#include "spectral/response.hpp"

// How many wavelengths a band needs: Gauss quadrature with few of them against a dense grid, for
// all light that the scene may send. docs/wavelengths.md.

namespace nadir::sim {

/// The fewest wavelengths that integrate every band, by array and band, and the error they leave.
struct WavelengthChoice {
  BandNodes nodes;
  ByBand error;  ///< largest of all the scene's spectra against the dense grid, relative
};

/// Something of a scene over wavelength in um: a reflectance, an irradiance, a transmittance.
using SpectralFunction = std::function<double(double)>;

/// What the light of a band is made of.
struct BandLight {
  /// Light that reaches the sensor: a product of functions, by their numbers. A band's quadrature
  /// knows some at its nodes, others by their mean over the interval that a node stands for
  /// (spectral::interval_edges), as it is with gases and the irradiance of bodies.
  struct Product {
    std::vector<std::size_t> at_nodes, over_intervals;
    double scale = 1.0;
    /// Errors of the same kin are summed with their signs, of several kins without: what gases take
    /// of a surface's heat they add by their own.
    int kin = 0;
    static constexpr int kins = 3;
  };
  /// What a pixel sees: some products together.
  struct Pixel {
    std::vector<std::size_t> products;
    double floor = 0.0;  ///< errors count against max(radiance, floor)
    int scale = 0;       ///< which pixels' radiances it may be compared with
  };

  std::vector<SpectralFunction> functions;  ///< finite and >= 0 over the band
  std::vector<double> knots_um{};           ///< where functions bend; in any order
  std::vector<Product> products;
  std::vector<Pixel> pixels;
};

/// The error of a band's quadrature by number of wavelengths.
class BandErrors {
 public:
  static constexpr int most = 32;         ///< wavelengths of a band
  static constexpr int least_grid = 400;  ///< points of the dense grid, knots come on top

  /// Both are kept by reference.
  BandErrors(const spectral::Response& response, const BandLight& light);

  /// Of all pixels the largest
  ///     sum over kins |sum over products (quadrature - dense)| / max(sum of dense, floor)
  /// @param count  1 .. 32
  [[nodiscard]] double of(int count);
  /// The larger of this error and the next number's (of 32: the one before): what is small by
  /// chance, where an error crosses zero, is not relied upon.
  [[nodiscard]] double stated(int count);
  /// Band means of the products by the dense grid.
  [[nodiscard]] const std::vector<double>& means() const noexcept { return means_; }

 private:
  [[nodiscard]] double computed(int count) const;
  [[nodiscard]] std::vector<double> by_quadrature(int count) const;
  [[nodiscard]] double mean_over(std::size_t function, double lo, double hi) const;
  [[nodiscard]] double grown_at(std::size_t function, double at) const;

  const spectral::Response* response_;
  const BandLight* light_;
  std::vector<double> grid_um_;
  std::vector<std::vector<double>> values_;  // by function and place of the grid
  std::vector<std::vector<double>> grown_;   // integrals from the grid's begin, where means are due
  std::vector<double> means_;
  std::vector<double> known_;  // errors by number, -1: not computed yet
};

/// The smallest number of wavelengths whose stated error is at most `share`; where none is, the
/// number with the smallest.
struct CountChoice {
  int count = 1;
  double error = 0.0;  ///< stated
};
[[nodiscard]] CountChoice choose_count(BandErrors& errors, double share);

}  // namespace nadir::sim
