#include "materials/maps/contrast_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/error.hpp"

namespace nadir::materials {
namespace {

/// Count, sum and sum of squares of values.
struct Moments {
  double count = 0.0, sum = 0.0, squares = 0.0;

  void add(double value) {
    count += 1.0;
    sum += value;
    squares += value * value;
  }
  friend Moments operator+(const Moments& a, const Moments& b) {
    return {a.count + b.count, a.sum + b.sum, a.squares + b.squares};
  }
  friend Moments operator-(const Moments& a, const Moments& b) {
    return {a.count - b.count, a.sum - b.sum, a.squares - b.squares};
  }
  /// Standard score of a value. The variance is a difference of sums: 1e-12 of the squares is what
  /// their rounding leaves, and counts as no contrast.
  [[nodiscard]] double score(double value) const {
    if (count == 0.0 || !std::isfinite(value)) return 0.0;
    const double mean = sum / count, variance = squares / count - mean * mean;
    if (!(variance > 1e-12 * squares / count)) return 0.0;
    return (value - mean) / std::sqrt(variance);
  }
};

/// Moments of any rectangle of an image from four sums (Crow, "Summed-area tables for texture
/// mapping", SIGGRAPH 1984).
class MomentTable {
 public:
  MomentTable(const ContrastImage& image, double shift)
      : columns_{image.columns}, rows_{image.rows}, shift_{shift} {
    table_.resize(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1));
    std::size_t pixel = 0;
    for (int row = 0; row < rows_; ++row) {
      Moments line;
      for (int column = 0; column < columns_; ++column, ++pixel) {
        const double value = image.values[pixel];
        if (std::isfinite(value)) line.add(value - shift_);
        table_[index(column + 1, row + 1)] = table_[index(column + 1, row)] + line;
      }
    }
  }

  [[nodiscard]] double score(int column, int row, int half_window, double value) const {
    const int left = std::max(column - half_window, 0), top = std::max(row - half_window, 0);
    const int right = std::min(column + half_window + 1, columns_);
    const int bottom = std::min(row + half_window + 1, rows_);
    const Moments window = table_[index(right, bottom)] - table_[index(left, bottom)] -
                           table_[index(right, top)] + table_[index(left, top)];
    return window.score(value - shift_);
  }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
           static_cast<std::size_t>(column);
  }

  int columns_, rows_;
  double shift_;  // near the mean, so that the sums of squares lose nothing
  std::vector<Moments> table_;
};

/// Finds the spectrum of the nearest score.
class SpectrumPicker {
 public:
  explicit SpectrumPicker(const std::vector<double>& mean_reflectance) {
    Moments moments;
    for (const double value : mean_reflectance) moments.add(value);
    for (const double value : mean_reflectance) score_.push_back(moments.score(value));
    order_.resize(score_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return score_[a] < score_[b]; });
  }

  [[nodiscard]] std::uint16_t nearest(double z) const {
    const auto first_from = [&](double from) {  // the first of equal scores comes first
      return std::lower_bound(order_.begin(), order_.end(), from,
                              [&](std::size_t i, double limit) { return score_[i] < limit; });
    };
    const auto above = first_from(z);
    if (above == order_.begin()) return static_cast<std::uint16_t>(order_.front());
    const auto below = first_from(score_[*std::prev(above)]);
    if (above == order_.end()) return static_cast<std::uint16_t>(*below);
    const double up = score_[*above] - z, down = z - score_[*below];
    const bool take_below = down < up || (down == up && *below < *above);
    return static_cast<std::uint16_t>(take_below ? *below : *above);
  }

 private:
  std::vector<double> score_;
  std::vector<std::size_t> order_;
};

Moments moments_of(const std::vector<float>& values, double shift) {
  Moments all;
  for (const float value : values) {
    if (std::isfinite(value)) all.add(value - shift);
  }
  return all;
}

std::vector<double> scores_in_windows(const ContrastImage& image, double mean, int half_window) {
  const MomentTable table{image, mean};
  const int half = std::min(half_window, std::max(image.columns, image.rows));
  std::vector<double> scores;
  scores.reserve(image.values.size());
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.columns; ++column) {
      scores.push_back(table.score(column, row, half, image.values[scores.size()]));
    }
  }
  return scores;
}

std::vector<double> scores_in_image(const ContrastImage& image, double mean) {
  const Moments all = moments_of(image.values, mean);
  std::vector<double> scores;
  scores.reserve(image.values.size());
  for (const float value : image.values) scores.push_back(all.score(value - mean));
  return scores;
}

}  // namespace

std::vector<std::uint16_t> contrast_choice(const ContrastImage& image,
                                           const std::vector<double>& mean_reflectance,
                                           int half_window) {
  if (mean_reflectance.empty() || mean_reflectance.size() > 65536) {
    throw InputError{"a contrast map needs from 1 to 65536 spectra"};
  }
  const auto pixels =
      static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
  if (image.columns < 0 || image.rows < 0 || image.values.size() != pixels) {
    throw InputError{"a contrast map's picture is not full"};
  }
  const SpectrumPicker picker{mean_reflectance};
  const Moments rough = moments_of(image.values, 0.0);
  const double mean = rough.count > 0.0 ? rough.sum / rough.count : 0.0;
  const std::vector<double> scores =
      half_window > 0 ? scores_in_windows(image, mean, half_window) : scores_in_image(image, mean);
  std::vector<std::uint16_t> choice;
  choice.reserve(pixels);
  for (const double z : scores) choice.push_back(picker.nearest(z));
  return choice;
}

}  // namespace nadir::materials
