#include "materials/scattering/coated_base.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace nadir::materials {
namespace {

using spectral::Spectrum;
using spectral::SpectrumSum;

/// Mean over the hemisphere, weighted with the cosine: the midpoint rule in the square of the
/// sine, finer than the table it reads.
Spectrum cosine_mean(const AlbedoTable& coat, int lanes) {
  constexpr int rows = 64, columns = 32;
  SpectrumSum sum{lanes};
  for (int i = 0; i < rows; ++i) {
    const double sine_sq = (i + 0.5) / rows, sine = std::sqrt(sine_sq);
    for (int j = 0; j < columns; ++j) {
      const double azimuth = 2.0 * std::numbers::pi * (j + 0.5) / columns;
      sum.add(
          coat.at({sine * std::cos(azimuth), sine * std::sin(azimuth), std::sqrt(1.0 - sine_sq)})
              .reflectance);
    }
  }
  return sum.spectrum(1.0 / (rows * columns));
}

}  // namespace

CoatedBase::CoatedBase(std::shared_ptr<const AlbedoTable> coat, const Spectrum& reflectance)
    : coat_{std::move(coat)},
      reflectance_{reflectance},
      scale_{reflectance.count()},
      black_{reflectance.max() <= 0.0F} {
  constexpr double closed = 1e-5;  // a coat that reflects all but the rounding of its table
  const Spectrum mean = cosine_mean(*coat_, reflectance.count());
  for (int lane = 0; lane < reflectance.count(); ++lane) {
    const double let_in = 1.0 - static_cast<double>(mean[lane]);
    if (let_in < closed) continue;
    scale_[lane] =
        static_cast<float>(static_cast<double>(reflectance[lane]) * std::numbers::inv_pi / let_in);
  }
}

Spectrum CoatedBase::through(Vec3 w) const noexcept {
  return Spectrum{scale_.count(), 1.0F} - coat_->at(w).reflectance;
}

Spectrum CoatedBase::eval(Vec3 wi, const Spectrum& through_o) const noexcept {
  if (black_) return Spectrum{scale_.count()};
  return through(wi) * through_o * scale_;
}

Spectrum CoatedBase::albedo(const Spectrum& through_o) const noexcept {
  return Spectrum{scale_.count(), 1.0F} - through_o + reflectance_ * through_o;
}

double CoatedBase::coat_share(const Spectrum& through_o) const noexcept {
  if (black_) return 1.0;
  const double facets = 1.0 - static_cast<double>(through_o.mean());
  const double base = static_cast<double>((reflectance_ * through_o).mean());
  return facets + base > 0.0 ? facets / (facets + base) : 1.0;
}

}  // namespace nadir::materials
