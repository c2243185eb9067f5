#include "sensor/optics/system_mtf.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace nadir::sensor {
namespace {

constexpr double circle = 2.0 * std::numbers::pi;

/// sin(pi x) / (pi x), without its sign.
double modulation_of_box(double x) {
  const double a = std::numbers::pi * x;
  return std::abs(a) < 1e-8 ? 1.0 : std::abs(std::sin(a) / a);
}

/// N equal samples `shift` pixels from one to the next.
double modulation_of_comb(int stages, double shift, double frequency) {
  const double a = std::numbers::pi * shift * frequency;
  if (std::abs(std::sin(a)) < 1e-9) return 1.0;
  return std::abs(std::sin(stages * a) / (stages * std::sin(a)));
}

/// Pixels by which the ground's image shifts from row to row of the time-delay integration,
/// against the rows.
double stage_shift(const DetectorArray& array, const MtfQuestion& question) {
  const auto* broom = std::get_if<Pushbroom>(&array.timing.scan);
  if (broom == nullptr) return 0.0;
  const double moved = question.motion_px_per_s * broom->line_period_s;
  if (!question.along) return moved;
  return array.timing.tdi_reversed ? moved + 1.0 : moved - 1.0;
}

double jitter_px(const DetectorArray& array, const Platform& platform, bool along) {
  const auto* lens = std::get_if<Perspective>(&array.projection);
  if (lens == nullptr) return 0.0;
  // A turn about x moves the image along y, and the other way round.
  const Vec3 rms = platform.jitter().white_rms_rad();
  const double moved_m = lens->focal_length_m * (along ? rms.x : rms.y);
  return moved_m / (along ? array.height_m() : array.pitch_m);
}

using Modulation = std::function<double(double cycles_per_pixel)>;

class SystemTerms {
 public:
  explicit SystemTerms(const std::vector<double>& frequencies) {
    mtf_.cycles_per_pixel = frequencies;
    mtf_.total.assign(frequencies.size(), 1.0);
  }
  void add(const char* name, const Modulation& modulation) {
    MtfTerm term{name, {}};
    for (std::size_t i = 0; i < mtf_.total.size(); ++i) {
      term.values.push_back(modulation(mtf_.cycles_per_pixel[i]));
      mtf_.total[i] *= term.values.back();
    }
    mtf_.terms.push_back(std::move(term));
  }
  [[nodiscard]] SystemMtf take() { return std::move(mtf_); }

 private:
  SystemMtf mtf_;
};

}  // namespace

SystemMtf system_mtf(const DetectorArray& array, const Platform& platform,
                     const MtfQuestion& question, const std::vector<double>& cycles_per_pixel) {
  SystemTerms terms{cycles_per_pixel};
  const bool along = question.along;
  const double pitch_m = along ? array.height_m() : array.pitch_m;
  if (array.spread) {
    terms.add("optics", [&](double f) {
      const double per_m = f / pitch_m;
      return array.spread->mtf(question.band, along ? Vec2{0.0, per_m} : Vec2{per_m, 0.0});
    });
  }
  const double fill = along ? array.fill_y : array.fill_x;
  terms.add("detector", [&](double f) { return modulation_of_box(fill * f); });
  const double smear = question.motion_px_per_s * array.timing.exposure_s;
  if (smear != 0.0) terms.add("smear", [&](double f) { return modulation_of_box(smear * f); });
  // What a detector with memory sees has an exponential tail; its transform is a low pass.
  const double lag = question.motion_px_per_s * array.timing.lag_s;
  if (lag != 0.0) {
    terms.add("lag", [&](double f) { return 1.0 / std::hypot(1.0, circle * lag * f); });
  }
  const double shift = stage_shift(array, question);
  if (array.timing.tdi_stages > 1 && shift != 0.0) {
    terms.add("time-delay integration",
              [&](double f) { return modulation_of_comb(array.timing.tdi_stages, shift, f); });
  }
  const double sigma = jitter_px(array, platform, along);
  if (sigma > 0.0) {
    terms.add("jitter",
              [&](double f) { return std::exp(-0.5 * circle * circle * sigma * sigma * f * f); });
  }
  return terms.take();
}

}  // namespace nadir::sensor
