#include "sensor/detector/fixed_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/random.hpp"
#include "sensor/detector/shot_noise.hpp"

namespace nadir::sensor {
namespace {

/// 64 bits of a name: FNV-1a (Fowler, Noll, Vo; draft-eastlake-fnv).
std::uint64_t name_bits(std::string_view name) noexcept {
  std::uint64_t bits = 0xCBF29CE484222325ULL;
  for (const char c : name) {
    bits = (bits ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  }
  return bits;
}

}  // namespace

std::uint64_t band_key(std::uint64_t seed, const DetectorArray& array, std::size_t band) noexcept {
  const std::uint64_t of_array = mix(mix(0, seed), name_bits(array.name));
  return band < array.bands.size() ? mix(of_array, name_bits(array.bands[band].name)) : of_array;
}

FixedPattern::FixedPattern(const DetectorArray& array, std::uint64_t key, const Rms& rms)
    : key_{key}, rms_{rms} {
  if (std::holds_alternative<Pushbroom>(array.timing.scan)) layout_ = Layout::row;
  if (const auto* whiskbroom = std::get_if<Whiskbroom>(&array.timing.scan)) {
    layout_ = Layout::column;
    rows_ = std::max(whiskbroom->lines_per_scan, 1);
  }
  const auto samples = static_cast<std::size_t>(array.samples);
  gain_.assign(samples, 1.0);
  offset_.assign(samples, 0.0);
  dead_.assign(samples, 0);
}

std::uint64_t FixedPattern::detector(std::size_t sample, int line) const noexcept {
  if (layout_ == Layout::row) return sample;
  if (layout_ == Layout::column) return static_cast<std::uint64_t>(line % rows_);
  return (static_cast<std::uint64_t>(line) << 32U) + sample;
}

void FixedPattern::line(int line) {
  const bool same = layout_ == Layout::row ? current_ >= 0 : line == current_;
  const bool none = rms_.gain == 0.0 && rms_.offset == 0.0 && rms_.dead_share == 0.0;
  if (same || none) return;
  current_ = line;
  for (std::size_t i = 0; i < gain_.size(); ++i) {
    const std::uint64_t own = mix(key_, detector(i, line));
    const Vec2 z = normal_pair(mix(own, 0), mix(own, 1));
    gain_[i] = std::max(1.0 + rms_.gain * z.x, 0.0);
    offset_[i] = rms_.offset * z.y;
    dead_[i] = to_unit(mix(own, 2)) < rms_.dead_share ? 1 : 0;
  }
}

FallOff::FallOff(const DetectorArray& array, double power)
    : array_{array}, power_{power}, values_(static_cast<std::size_t>(array.samples), 1.0) {
  array_.bands.clear();
  const auto* lens = std::get_if<Perspective>(&array.projection);
  if (lens != nullptr && power > 0.0) focal_length_m_ = lens->focal_length_m;
  same_every_line_ = std::holds_alternative<Pushbroom>(array.timing.scan);
}

void FallOff::line(int line) {
  if (focal_length_m_ == 0.0 || (same_every_line_ && filled_)) return;
  filled_ = true;
  const double per_f2 = 1.0 / (focal_length_m_ * focal_length_m_);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Vec2 p = focal_place(array_, {static_cast<double>(i) + 0.5, line + 0.5});
    const double cos2 = 1.0 / (1.0 + (p.x * p.x + p.y * p.y) * per_f2);
    values_[i] = power_ == 4.0 ? cos2 * cos2 : std::pow(cos2, 0.5 * power_);
  }
}

}  // namespace nadir::sensor
