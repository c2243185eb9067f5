#include "sim/run/merge_images.hpp"

#include <algorithm>
#include <stdexcept>

#include "sim/run/brightness.hpp"
#include "sim/run/sampling_goal.hpp"

namespace nadir::sim {
namespace {

void check_alike(const ArrayImage& a, const ArrayImage& b) {
  const bool alike = a.samples == b.samples && a.lines == b.lines && a.first_line == b.first_line &&
                     a.first_sample == b.first_sample && a.bands.size() == b.bands.size();
  if (!alike) throw std::invalid_argument("images of different pixels cannot be merged");
}

/// Of each pixel, before and after.
struct PathShares {
  std::vector<double> ours;  // share of the merged paths
  std::vector<std::uint32_t> all;
};

PathShares shares_of(const ArrayImage& into, const ArrayImage& other) {
  PathShares shares;
  for (std::size_t pixel = 0; pixel < into.pixels(); ++pixel) {
    const std::uint32_t a = into.paths_of(pixel), b = other.paths_of(pixel);
    shares.all.push_back(a + b);
    shares.ours.push_back(a + b > 0 ? static_cast<double>(a) / (static_cast<double>(a) + b) : 1.0);
  }
  return shares;
}

void merge_mean(std::vector<float>& into, const std::vector<float>& other,
                const PathShares& shares) {
  if (into.empty() || other.size() != into.size()) return;
  for (std::size_t i = 0; i < into.size(); ++i) {
    const double ours = shares.ours[i];
    if (ours == 1.0) continue;
    const double others = (1.0 - ours) * static_cast<double>(other[i]);
    into[i] =
        static_cast<float>(ours > 0.0 ? ours * static_cast<double>(into[i]) + others : others);
  }
}

void merge_radiance(BandImage& into, const BandImage& other, const ArrayImage& ours,
                    const ArrayImage& theirs) {
  for (std::size_t i = 0; i < into.radiance.size(); ++i) {
    const Estimate both =
        merged({{into.radiance[i], into.standard_error[i]}, ours.paths_of(i)},
               {{other.radiance[i], other.standard_error[i]}, theirs.paths_of(i)});
    into.radiance[i] = static_cast<float>(both.mean);
    into.standard_error[i] = static_cast<float>(both.standard_error);
  }
}

void renew_brightness(BandImage& band, const PathShares& shares,
                      const spectral::BandQuadrature& quadrature) {
  for (std::size_t i = 0; i < band.radiance.size(); ++i) {
    if (shares.ours[i] == 1.0) continue;
    const Estimate kelvin =
        brightness_temperature(quadrature, {band.radiance[i], band.standard_error[i]});
    band.brightness_temperature[i] = static_cast<float>(kelvin.mean);
    band.brightness_temperature_error[i] = static_cast<float>(kelvin.standard_error);
  }
}

}  // namespace

void merge(ArrayImage& into, const ArrayImage& other,
           std::span<const spectral::BandQuadrature> quadratures) {
  check_alike(into, other);
  const PathShares shares = shares_of(into, other);
  for (std::size_t b = 0; b < into.bands.size(); ++b) {
    BandImage& band = into.bands[b];
    const BandImage& more = other.bands[b];
    merge_radiance(band, more, into, other);
    merge_mean(band.shares.path, more.shares.path, shares);
    merge_mean(band.shares.emission, more.shares.emission, shares);
    if (!band.brightness_temperature.empty()) {
      if (b < quadratures.size()) {
        renew_brightness(band, shares, quadratures[b]);
      } else {
        merge_mean(band.brightness_temperature, more.brightness_temperature, shares);
        merge_mean(band.brightness_temperature_error, more.brightness_temperature_error, shares);
      }
    }
    band.dn.clear();
    band.electrons.clear();
    band.noise.clear();
  }
  // Where all pixels of both have as many, one number says it.
  const bool alike = into.pixel_paths.empty() && other.pixel_paths.empty();
  into.paths = shares.all.empty() ? 0 : *std::max_element(shares.all.begin(), shares.all.end());
  if (!alike) into.pixel_paths = shares.all;
}

}  // namespace nadir::sim
