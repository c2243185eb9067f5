#include "materials/scattering/measured.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "core/error.hpp"

namespace nadir::materials {
namespace {

using spectral::Lanes;
using spectral::Spectrum;

constexpr double albedo_limit = 1.02;  // measurements err
constexpr double same_angle = 1e-9;

/// Two columns of the table and their weights, for the wavelength of a lane.
struct WavelengthTaps {
  std::size_t first, second;
  float share;  ///< of the second
};

std::vector<WavelengthTaps> taps_at(const std::vector<double>& axis, const Lanes& lanes) {
  std::vector<WavelengthTaps> taps;
  for (const Micrometres lane : lanes) {
    const double um = lane.value;
    if (um < axis.front() || um > axis.back()) {
      char text[160];
      std::snprintf(text, sizeof text,
                    "the measured reflectance is tabulated from %.4g to %.4g um, but the bands "
                    "need it at %.4g um",
                    axis.front(), axis.back(), um);
      throw InputError{text};
    }
    const auto after = std::upper_bound(axis.begin(), axis.end(), um) - axis.begin();
    const auto first = static_cast<std::size_t>(after - 1);
    const std::size_t second = std::min(first + 1, axis.size() - 1);
    const double step = axis[second] - axis[first];
    taps.push_back(
        {first, second, step > 0.0 ? static_cast<float>((um - axis[first]) / step) : 0.0F});
  }
  return taps;
}

/// All zenith angles at which the table has been measured on either side.
std::vector<double> all_zeniths(const BrdfTable& table) {
  std::vector<double> all = table.incidence_rad;
  all.insert(all.end(), table.view_rad.begin(), table.view_rad.end());
  std::sort(all.begin(), all.end());
  const auto same = [](double a, double b) { return b - a < same_angle; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

/// The table's values at the lanes and at any pair of zenith angles, azimuths as tabulated.
class Source {
 public:
  Source(const BrdfTable& table, const Lanes& lanes)
      : table_{table},
        incidence_{table.incidence_rad, AngleAxis::Ends::chord},
        view_{table.view_rad, AngleAxis::Ends::chord},
        wavelengths_{taps_at(table.wavelength_um, lanes)} {}

  /// Adds `scale` times the reciprocal mean at one pair, for all lanes.
  void add(std::pair<double, double> zeniths, std::size_t azimuth, float scale, float* out) const {
    const auto [a, b] = zeniths;
    const bool forth = tabulated(a, b), back = tabulated(b, a);
    const float half = forth == back ? 0.5F * scale : scale;
    if (forth || !back) add_one({a, b}, azimuth, half, out);
    if (back || !forth) add_one({b, a}, azimuth, half, out);
  }

 private:
  [[nodiscard]] bool tabulated(double incidence, double view) const {
    return incidence <= incidence_.back() + same_angle && view <= view_.back() + same_angle;
  }

  void add_one(std::pair<double, double> zeniths, std::size_t azimuth, float scale,
               float* out) const {
    const AxisTaps i = incidence_.at(zeniths.first), v = view_.at(zeniths.second);
    for (std::size_t m = 0; m < 4; ++m) {
      for (std::size_t n = 0; n < 4; ++n) {
        const float weight = i.weight[m] * v.weight[n] * scale;
        if (weight != 0.0F) add_node({i.node[m], v.node[n]}, azimuth, weight, out);
      }
    }
  }

  void add_node(std::pair<std::size_t, std::size_t> node, std::size_t azimuth, float weight,
                float* out) const {
    const std::size_t row = (node.first * view_.size() + node.second) * table_.azimuth_rad.size();
    const float* const value = &table_.value[(row + azimuth) * table_.wavelength_um.size()];
    for (std::size_t lane = 0; lane < wavelengths_.size(); ++lane) {
      const WavelengthTaps& w = wavelengths_[lane];
      out[lane] += weight * (value[w.first] + w.share * (value[w.second] - value[w.first]));
    }
  }

  const BrdfTable& table_;
  AngleAxis incidence_, view_;
  std::vector<WavelengthTaps> wavelengths_;
};

const BrdfTable& checked(const Measured& model) {
  check(*model.table);
  return *model.table;
}

/// Weights of the trapezoid rule over half a turn, sum 1.
std::vector<float> azimuth_weights(const std::vector<double>& axis) {
  std::vector<float> weights(axis.size(), 0.0F);
  for (std::size_t i = 1; i < axis.size(); ++i) {
    const auto half = static_cast<float>(0.5 * (axis[i] - axis[i - 1]) / (axis.back() - axis[0]));
    weights[i - 1] += half;
    weights[i] += half;
  }
  return weights;
}

/// [zenith][zenith][azimuth][lane].
std::vector<float> symmetric_values(const BrdfTable& table, const AngleAxis& zenith,
                                    const Lanes& lanes) {
  const Source source{table, lanes};
  const std::vector<float> weights = azimuth_weights(table.azimuth_rad);
  const std::size_t azimuths = weights.size(), width = static_cast<std::size_t>(lanes.count());
  std::vector<float> values(zenith.size() * zenith.size() * azimuths * width, 0.0F);
  float* out = values.data();
  for (std::size_t a = 0; a < zenith.size(); ++a) {
    for (std::size_t b = 0; b < zenith.size(); ++b) {
      const bool vertical = a == 0 || b == 0;
      for (std::size_t c = 0; c < azimuths; ++c, out += width) {
        if (!vertical) {
          source.add({zenith[a], zenith[b]}, c, 1.0F, out);
          continue;
        }
        for (std::size_t k = 0; k < azimuths; ++k) {
          source.add({zenith[a], zenith[b]}, k, weights[k], out);
        }
      }
    }
  }
  return values;
}

struct Angles {
  double incidence, view, azimuth;
};

Angles angles_of(Vec3 wi, Vec3 wo) noexcept {
  const double across_i = std::sqrt(wi.x * wi.x + wi.y * wi.y);
  const double across_o = std::sqrt(wo.x * wo.x + wo.y * wo.y);
  const double along = wi.x * wo.x + wi.y * wo.y, aside = wi.x * wo.y - wi.y * wo.x;
  return {std::atan2(across_i, std::abs(wi.z)), std::atan2(across_o, std::abs(wo.z)),
          std::atan2(std::abs(aside), along)};
}

/// Mean over the lanes of each node.
std::vector<float> lane_means(const std::vector<float>& values, int lanes) {
  const auto width = static_cast<std::size_t>(lanes);
  std::vector<float> means(values.size() / width, 0.0F);
  for (std::size_t i = 0; i < values.size(); ++i) {
    means[i / width] += values[i] / static_cast<float>(lanes);
  }
  return means;
}

/// A table of `width` lanes and its two axes.
struct Grid {
  const AngleAxis& zenith;
  const AngleAxis& azimuth;
  const float* values;
  std::size_t width;
};

/// Nodes of a grid that take part in one value: pairs of zenith angles times azimuths.
struct GridTaps {
  AxisTaps incidence, view, azimuth;
};

GridTaps taps_of(const Grid& grid, Vec3 wi, Vec3 wo) noexcept {
  const Angles angles = angles_of(wi, wo);
  return {grid.zenith.at(angles.incidence), grid.zenith.at(angles.view),
          grid.azimuth.at(angles.azimuth)};
}

/// Calls visit(first value of the node, weight) for at most 64 nodes.
template <class Visit>
void for_each_node(const Grid& grid, const GridTaps& taps, const Visit& visit) noexcept {
  for (std::size_t m = 0; m < 4; ++m) {
    for (std::size_t n = 0; n < 4; ++n) {
      const float both = taps.incidence.weight[m] * taps.view.weight[n];
      if (both == 0.0F) continue;
      const std::size_t row =
          (taps.incidence.node[m] * grid.zenith.size() + taps.view.node[n]) * grid.azimuth.size();
      for (std::size_t k = 0; k < 4; ++k) {
        visit(grid.values + (row + taps.azimuth.node[k]) * grid.width,
              both * taps.azimuth.weight[k]);
      }
    }
  }
}

DirectionTable directions_for(const AngleAxis& zenith, const AngleAxis& azimuth,
                              const std::vector<float>& means) {
  const Grid grid{zenith, azimuth, means.data(), 1};
  return DirectionTable{[&](Vec3 wi, Vec3 wo) {
    float mean = 0.0F;
    for_each_node(grid, taps_of(grid, wi, wo),
                  [&](const float* value, float weight) { mean += weight * *value; });
    return static_cast<double>(mean);
  }};
}

}  // namespace

BoundMeasured::BoundMeasured(const Measured& model, const BindContext& context)
    : zenith_{all_zeniths(checked(model)), AngleAxis::Ends::chord},
      azimuth_{model.table->azimuth_rad, AngleAxis::Ends::flat},
      lanes_{context.lanes.count()},
      values_{symmetric_values(*model.table, zenith_, context.lanes)},
      directions_{directions_for(zenith_, azimuth_, lane_means(values_, lanes_))},
      albedo_{lanes_, [this](Vec3 wi, Vec3 wo) { return eval(wi, wo); }} {
  albedo_.refuse_above(albedo_limit, context.lanes, "measured");
  // What the instrument added to a white sample must not grow from bounce to bounce.
  Spectrum factor = albedo_.largest();
  for (int lane = 0; lane < lanes_; ++lane) factor[lane] = 1.0F / std::max(factor[lane], 1.0F);
  albedo_.scale(factor);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    values_[i] *= factor[static_cast<int>(i % static_cast<std::size_t>(lanes_))];
  }
}

Spectrum BoundMeasured::eval(Vec3 wi, Vec3 wo) const noexcept {
  Spectrum f{lanes_};
  if (!(wi.z * wo.z > 0.0)) return f;
  const Grid grid{zenith_, azimuth_, values_.data(), static_cast<std::size_t>(lanes_)};
  for_each_node(grid, taps_of(grid, wi, wo), [&](const float* value, float weight) {
    for (int lane = 0; lane < lanes_; ++lane) f[lane] += weight * value[lane];
  });
  for (int lane = 0; lane < lanes_; ++lane) f[lane] = std::max(f[lane], 0.0F);
  return f;
}

double BoundMeasured::pdf(Vec3 wi, Vec3 wo) const noexcept {
  if (!(wi.z * wo.z > 0.0)) return 0.0;
  return directions_.pdf({wi.x, wi.y, std::abs(wi.z)}, {wo.x, wo.y, std::abs(wo.z)});
}

std::optional<ScatteringSample> BoundMeasured::sample(Vec3 wo,
                                                      const ScatteringDraw& u) const noexcept {
  const Vec3 upper{wo.x, wo.y, std::abs(wo.z)};
  if (!(upper.z > 0.0)) return std::nullopt;
  Vec3 wi = directions_.draw(upper, u.point);
  if (!(wi.z > 0.0)) return std::nullopt;
  ScatteringSample s;
  s.pdf = directions_.pdf(wi, upper);
  if (!(s.pdf > 0.0)) return std::nullopt;  // a rounding beyond a cell of no chance
  const auto cos_over_pdf = static_cast<float>(wi.z / s.pdf);
  wi.z = std::copysign(wi.z, wo.z);
  s.wi = wi;
  s.weight = eval(wi, wo) * cos_over_pdf;
  return s;
}

Albedo BoundMeasured::albedo(Vec3 wo) const noexcept { return albedo_.at(wo.z); }

}  // namespace nadir::materials
