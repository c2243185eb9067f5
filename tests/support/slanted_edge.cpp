#include "support/slanted_edge.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace nadir::support {
namespace {

struct Edge {
  double at_top = 0.0, a_line = 0.0;
  [[nodiscard]] double at(int line) const { return at_top + a_line * line; }
};

double value(const EdgeImage& image, int sample, int line) {
  return image.values[static_cast<std::size_t>(line) * static_cast<std::size_t>(image.samples) +
                      static_cast<std::size_t>(sample)];
}

/// Centroid of a line's derivative, of what lies near an expected place.
double centroid(const EdgeImage& image, int line, double expected, double reach) {
  double sum = 0.0, weighted = 0.0;
  for (int i = 0; i + 1 < image.samples; ++i) {
    const double place = i + 0.5;
    if (std::abs(place - expected) > reach) continue;
    // A Hamming window about the edge: far from it there is but noise.
    const double window = 0.54 + 0.46 * std::cos(std::numbers::pi * (place - expected) / reach);
    const double slope = window * (value(image, i + 1, line) - value(image, i, line));
    sum += slope;
    weighted += slope * place;
  }
  return weighted / sum;
}

/// Least squares through the centroids.
Edge straight(const EdgeImage& image, const Edge& expected, double reach) {
  double s = 0.0, sy = 0.0, sx = 0.0, syy = 0.0, sxy = 0.0;
  for (int line = 0; line < image.lines; ++line) {
    const double x = centroid(image, line, expected.at(line), reach);
    s += 1.0;
    sy += line;
    sx += x;
    syy += static_cast<double>(line) * line;
    sxy += x * line;
  }
  const double slope = (s * sxy - sx * sy) / (s * syy - sy * sy);
  return {(sx - slope * sy) / s, slope};
}

/// Values by distance from the edge, at the middles of the bins.
std::vector<double> edge_spread(const EdgeImage& image, const Edge& edge, int bins_a_pixel) {
  // Only distances that every line has: elsewhere the bins would not be filled evenly.
  const double first = std::max(-edge.at(0), -edge.at(image.lines - 1)) - 0.5 / bins_a_pixel;
  const double last = image.samples - 1 - std::max(edge.at(0), edge.at(image.lines - 1));
  const auto bins = static_cast<std::size_t>((last - first) * bins_a_pixel);
  std::vector<double> sum(bins), place(bins), count(bins);
  for (int line = 0; line < image.lines; ++line) {
    for (int i = 0; i < image.samples; ++i) {
      const double at = (i - edge.at(line) - first) * bins_a_pixel;
      if (at < 0.0 || at >= static_cast<double>(bins)) continue;
      const auto bin = static_cast<std::size_t>(at);
      sum[bin] += value(image, i, line);
      place[bin] += at;
      count[bin] += 1.0;
    }
  }
  for (std::size_t b = 0; b < bins; ++b) {
    // One that no pixel fell into is like the one before; the slope below moves it.
    sum[b] = count[b] > 0.0 || b == 0 ? sum[b] / count[b] : sum[b - 1];
    place[b] = count[b] > 0.0 || b == 0 ? place[b] / count[b] : place[b - 1];
  }
  // A bin's pixels need not lie about its middle: moved there along the slope to its neighbours.
  std::vector<double> spread = sum;
  for (std::size_t b = 1; b + 1 < bins; ++b) {
    const double slope = (sum[b + 1] - sum[b - 1]) / (place[b + 1] - place[b - 1]);
    spread[b] += slope * (static_cast<double>(b) + 0.5 - place[b]);
  }
  return spread;
}

double sinc(double x) {
  const double a = std::numbers::pi * x;
  return std::abs(a) < 1e-8 ? 1.0 : std::sin(a) / a;
}

/// Of the mean of so many pixels that lie evenly in a bin.
double mean_transfer(double pixels, double bin_cycles) {
  return sinc(bin_cycles) / sinc(bin_cycles / pixels);
}

}  // namespace

EdgeResponse edge_response(const EdgeImage& image, const std::vector<double>& cycles_per_pixel,
                           int bins_a_pixel) {
  Edge edge{0.5 * (image.samples - 1), 0.0};
  edge = straight(image, edge, 0.5 * image.samples);
  // Again with a window that follows the edge and reaches as far to both sides.
  edge = straight(image, edge, 0.4 * image.samples);
  const std::vector<double> spread = edge_spread(image, edge, bins_a_pixel);
  const double height = spread.back() - spread.front();
  const double pixels_a_bin = static_cast<double>(image.lines) / bins_a_pixel;
  EdgeResponse response{edge.at_top, edge.a_line, {}};
  for (const double f : cycles_per_pixel) {
    std::complex<double> sum = 0.0;
    for (std::size_t b = 0; b + 1 < spread.size(); ++b) {
      const double phase = -2.0 * std::numbers::pi * f * static_cast<double>(b) / bins_a_pixel;
      sum += (spread[b + 1] - spread[b]) * std::polar(1.0, phase);
    }
    const double bin = f / bins_a_pixel;
    const double own = mean_transfer(std::max(1.0, pixels_a_bin), bin) * sinc(bin);
    response.modulation.push_back(std::abs(sum / height) / own);
  }
  return response;
}

}  // namespace nadir::support
