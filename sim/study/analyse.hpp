#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "sim/study/pareto.hpp"
#include "sim/study/rate_fit.hpp"
#include "sim/study/study_record.hpp"

namespace nadir::sim {

/// The converged answer: mean of the reference's rounds, which are independent of each other.
struct Reference {
  double paths = 0.0;                               ///< a pixel
  std::vector<std::vector<double>> mean, variance;  ///< by band and pixel; of the mean
  std::vector<std::vector<double>> scale;  ///< max(mean, floor): what errors are relative to
  std::vector<double> floor;               ///< by band, W m^-2 sr^-1 um^-1
  std::vector<double> error;               ///< by band: rms over pixels of error / scale
  std::vector<double> radiance;            ///< by band: mean over pixels
};

/// Errors of one level in one band, relative to max(radiance, floor) of each pixel.
struct BandMeasures {
  double bias = 0.0, bias_error = 0.0;  ///< of the mean over pixels, signed, and standard error
  /// Mean over pixels of the squared bias of a pixel, noise of both sides taken off (it may come
  /// out below 0), and its standard error over pixels.
  double square_bias = 0.0, square_bias_error = 0.0;
  double noise = 0.0;        ///< of one replicate, rms over pixels
  double noise_error = 0.0;  ///< standard error of it
};

/// A row's settings at one number of paths.
struct LevelFigures {
  int samples = 1;  ///< paths of a replicate
  int replicates = 0;
  std::vector<BandMeasures> bands;
  SampleCost cost;
  double paths = 0.0;         ///< of the picture: header.replicates * samples
  double picture_s = 0.0;     ///< predicted wall time of the whole picture
  std::vector<double> error;  ///< by band, of such a picture
  double worst_error = 0.0;   ///< of all bands
};

/// What all levels of a row say together, by band.
struct RowBand {
  double bias = 0.0, bias_error = 0.0;
  double pixel_bias = 0.0;        ///< rms over pixels; 0 where none was seen or there is none
  double pixel_bias_limit = 0.0;  ///< rms below this at 95 % confidence; 0 for an unbiased solver
  double path_noise = 0.0;        ///< of one path
  double top_noise = 0.0;         ///< of a replicate of the highest level
};

struct RowFigures {
  StudyPoint point;
  std::vector<LevelFigures> levels;  ///< ascending in samples
  std::vector<RowBand> bands;
  RateFit rate;       ///< of the noise, rms over bands
  RateFit with_bias;  ///< error^2 = bias^2 + (c N^-p)^2 fitted to the errors against the reference
  std::vector<RatePoint> errors;  ///< that it was fitted to: of one replicate, rms over bands
  double path_cpu_s = 0.0, path_wall_s = 0.0, picture_cpu_s = 0.0, setup_s = 0.0;
  double rays_per_path = 0.0, peak_memory_bytes = 0.0;

  /// Error of a picture of `replicates` times `samples` paths a pixel, by the row's rate.
  [[nodiscard]] double error(std::size_t band, int replicates, double samples) const;
  /// Seconds of a whole picture.
  [[nodiscard]] double picture_s(double paths, int threads) const;
};

/// A point of the trade: a row's level.
struct TradePoint {
  std::size_t row = 0, level = 0;
  CostPoint cost;
};

/// What to ask for to get a picture with at most so much error, in the least time.
struct Recommendation {
  double target = 0.01;
  bool reached = false;  ///< some row measured gets there
  std::string row;
  StudySettings settings;
  int replicates = 4, samples = 1;
  double error = 0.0;        ///< predicted, of the worst band
  double picture_s = 0.0;    ///< predicted, of the whole picture
  std::vector<double> bias;  ///< by band: rms of pixels; for an unbiased solver 0
  double found_error = std::numeric_limits<double>::quiet_NaN();  ///< when it was tried
  std::string reason;
};

struct StudyResult {
  Reference reference;
  std::vector<RowFigures> rows;
  std::vector<TradePoint> points;  ///< all levels of all rows, by the worst band
  std::vector<TradePoint> pareto;  ///< those that no other beats
  std::vector<Recommendation> recommendations;
};

inline constexpr std::array study_targets{0.05, 0.02, 0.01, 0.005};

[[nodiscard]] Reference reference_of(const StudyRecord& record);

/// Figures of one level. `against` replaces the reference where the same random numbers were used
/// (paired rows): then the difference's own spread over pixels is its error.
[[nodiscard]] std::vector<BandMeasures> compare(const StudySample& sample,
                                                const Reference& reference,
                                                const StudySample* paired_with);

/// Everything that follows from what was measured. Pure.
[[nodiscard]] StudyResult analyse(const StudyRecord& record);

/// The row that reaches the target in the least time.
[[nodiscard]] Recommendation recommend(double target, const std::vector<RowFigures>& rows,
                                       const StudyHeader& header);

}  // namespace nadir::sim
