#include "atmosphere/make/path_light.hpp"

#include <algorithm>
#include <cmath>

#include "atmosphere/transfer/mean_fade.hpp"

namespace nadir::atmosphere {
namespace {

/// int_0^1 s exp(-x s) ds for x >= 0
double mean_far(double x) noexcept {
  if (x < 1e-2) return 0.5 - x * (1.0 / 3.0 - x * (0.125 - x * (1.0 / 30.0 - x / 144.0)));
  return (1.0 - (1.0 + x) * std::exp(-x)) / (x * x);
}

/// int_0^1 f(s) exp(-x s) ds for f that runs exponentially from one value to another; evenly where
/// it starts or ends in the dark.
double faded(double from, double to, double x) noexcept {
  if (from > 1e-30 && to > 1e-30) return from * mean_fade(x + std::log(from / to));
  const double far = mean_far(x);
  return from * (mean_fade(x) - far) + to * far;
}

/// A beam's transmittance within a layer, by that at all levels; see StepEnd for top.
double beam_at(const std::vector<double>& levels, int layer, double top) noexcept {
  const auto k = static_cast<std::size_t>(layer);
  const double upper = levels[k], lower = levels[k + 1];
  if (top >= 1.0) return upper;
  if (lower > 1e-30 && upper > 1e-30) return lower * std::pow(upper / lower, top);
  return lower + top * (upper - lower);
}

/// Notes the sums for the shares up to one that have none yet.
void store(PathSums& sums, const std::vector<double>& light, int share, std::size_t& stored) {
  for (; share >= 0 && stored <= static_cast<std::size_t>(share); ++stored) {
    sums.depth[stored] = sums.depth_so_far;
    sums.scaled_depth[stored] = sums.scaled_so_far;
    std::copy(light.begin(), light.end(),
              sums.light.begin() + static_cast<std::ptrdiff_t>(stored * sums.sums));
  }
}

}  // namespace

/// What a path's steps share.
struct PathLight::Work {
  std::vector<double> source_in, source_out;
  std::vector<double> phase;  // [beam][azimuth][kind]
  double* light = nullptr;    // running sums
};

double scattering_cosine(double zenith_rad, double azimuth_rad, const BodyPlace& body) noexcept {
  return std::clamp(
      std::sin(zenith_rad) * body.sine() * std::cos(azimuth_rad) + std::cos(zenith_rad) * body.mu0,
      -1.0, 1.0);
}

PathLight::PathLight(const LaneFields& fields, std::vector<double> azimuths_rad)
    : fields_{fields},
      azimuths_rad_{std::move(azimuths_rad)},
      kinds_{fields.scattering.size()},
      sums_{fields.components + fields.beams.size() * kinds_} {
  for (const LaneFields::Beam& beam : fields.beams) {
    local_.push_back(sums_);
    if (!beam.local.empty()) sums_ += azimuths_rad_.size();
  }
}

double PathLight::local_at(std::size_t beam, int layer, const StepEnd& end,
                           double azimuth_rad) const {
  const LaneFields::Beam& b = fields_.beams[beam];
  const double mu0 = end.away * b.place.sine() * std::cos(azimuth_rad) + end.up * b.place.mu0;
  return b.local.transmittance(layer, end.top, mu0);
}

void PathLight::add_first(const PathStep& step, double reach, Work& work) const {
  const auto layer = static_cast<std::size_t>(step.layer);
  const double x = fields_.scaled_depth[layer] * step.slant;
  for (std::size_t b = 0; b < fields_.beams.size(); ++b) {
    const double in = beam_at(fields_.beams[b].transmittance, step.layer, step.in.top);
    const double out = beam_at(fields_.beams[b].transmittance, step.layer, step.out.top);
    const double lit = reach * step.slant * fields_.beams[b].irradiance * faded(in, out, x);
    if (lit <= 0.0) continue;
    for (std::size_t k = 0; k < kinds_; ++k) {
      work.light[first(b, k)] += lit * fields_.scattering[k][layer];
    }
  }
}

void PathLight::add_local(const PathStep& step, double reach, Work& work) const {
  const auto layer = static_cast<std::size_t>(step.layer);
  const double x = fields_.scaled_depth[layer] * step.slant;
  const std::size_t azimuths = azimuths_rad_.size();
  for (std::size_t b = 0; b < fields_.beams.size(); ++b) {
    if (fields_.beams[b].local.empty()) continue;
    for (std::size_t a = 0; a < azimuths; ++a) {
      const double in = local_at(b, step.layer, step.in, azimuths_rad_[a]);
      const double out = local_at(b, step.layer, step.out, azimuths_rad_[a]);
      const double lit = reach * step.slant * fields_.beams[b].irradiance * faded(in, out, x);
      const double* phase = work.phase.data() + (b * azimuths + a) * kinds_;
      double scattered = 0.0;
      for (std::size_t k = 0; k < kinds_; ++k) {
        scattered += fields_.scattering[k][layer] * phase[k];
      }
      work.light[local(b, a)] += lit * scattered;
    }
  }
}

void PathLight::start_rates(const ViewPath& path, PathSums& sums, Work& work) const {
  const auto layer = static_cast<std::size_t>(path.start_layer);
  sums.first_depth = fields_.depth[layer];
  sums.first_scaled = fields_.scaled_depth[layer];
  sums.rate.assign(sums_, 0.0);
  std::vector<double> source(fields_.components, 0.0);
  fields_.add_source(path.start_layer, path.start, source);
  for (std::size_t c = 0; c < source.size(); ++c) sums.rate[c] = sums.first_scaled * source[c];
  // Per slant: a step so short that nothing fades along it.
  PathStep step{path.start_layer, 1e-12, path.start, path.start, -1};
  work.light = sums.rate.data();
  add_first(step, 1e12, work);
  add_local(step, 1e12, work);
}

PathSums PathLight::along(const ViewPath& path, std::size_t shares) const {
  PathSums sums;
  sums.sums = sums_;
  sums.depth.assign(shares, 0.0);
  sums.scaled_depth.assign(shares, 0.0);
  sums.light.assign(shares * sums_, 0.0);
  Work work;
  for (const LaneFields::Beam& beam : fields_.beams) {
    for (const double azimuth : azimuths_rad_) {
      const double cosine = scattering_cosine(path.scene_zenith_rad(), azimuth, beam.place);
      for (const auto& phase : fields_.phases) {
        work.phase.push_back(beam.local.empty() ? 0.0 : phase->at(cosine));
      }
    }
  }
  start_rates(path, sums, work);
  std::vector<double> light(sums_, 0.0);
  work.light = light.data();
  double &depth = sums.depth_so_far, &scaled = sums.scaled_so_far;
  std::size_t stored = path.empty_shares;
  for (const PathStep& step : path.steps) {
    const auto layer = static_cast<std::size_t>(step.layer);
    const double x = fields_.scaled_depth[layer] * step.slant;
    const double reach = std::exp(-scaled);
    work.source_in.assign(fields_.components, 0.0);
    work.source_out.assign(fields_.components, 0.0);
    fields_.add_source(step.layer, step.in, work.source_in);
    fields_.add_source(step.layer, step.out, work.source_out);
    const double far = reach * x * mean_far(x), near = reach * x * mean_fade(x) - far;
    for (std::size_t c = 0; c < fields_.components; ++c) {
      light[c] += near * work.source_in[c] + far * work.source_out[c];
    }
    add_first(step, reach, work);
    add_local(step, reach, work);
    scaled += x;
    depth += fields_.depth[layer] * step.slant;
    store(sums, light, step.share, stored);
  }
  return sums;
}

ShareLight::ShareLight(const PathSums& sums, const std::vector<double>& background)
    : sums_{sums}, background_{background} {
  for (std::size_t s = 0; s < sums.depth.size(); ++s) {
    const double peak = sums.depth[s] - sums.scaled_depth[s];
    factors_.push_back({-std::expm1(-peak), std::exp(-peak), -std::expm1(-sums.depth[s])});
  }
}

double ShareLight::all(std::size_t sum) const noexcept {
  return sums_.light[sums_.light.size() - sums_.sums + sum] + background_[sum];
}

double ShareLight::whole(std::size_t sum, std::size_t share) const noexcept {
  const Factors& f = factors_[share];
  return f.peak_lost * all(sum) + f.peak_left * sums_.light[share * sums_.sums + sum];
}

double ShareLight::source(std::size_t sum, std::size_t share) const noexcept {
  // Below this the path adds nothing that a float could tell from its limit.
  if (sums_.depth[share] > 1e-12) return whole(sum, share) / factors_[share].lost;
  if (sums_.first_depth > 0.0) {
    return (sums_.rate[sum] + (sums_.first_depth - sums_.first_scaled) * all(sum)) /
           sums_.first_depth;
  }
  return share + 1 < sums_.depth.size() ? source(sum, share + 1) : 0.0;
}

}  // namespace nadir::atmosphere
