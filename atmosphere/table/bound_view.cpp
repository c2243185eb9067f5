#include "atmosphere/table/bound_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "atmosphere/paths/path_measure.hpp"

namespace nadir::atmosphere {

void append_rows(const AirFrame& frame, const AirTable& table, const std::vector<float>& values,
                 std::size_t first, std::size_t count, std::vector<float>& out) {
  const std::size_t lanes = table.lanes.size(), rest = frame.padded() - frame.matches.size();
  for (std::size_t row = first; row < first + count; ++row) {
    for (const LaneMatch& match : frame.matches) out.push_back(match.of(&values[row * lanes]));
    out.insert(out.end(), rest, 0.0F);
  }
}

WholeWay whole_way(double top_m, double ground_m, PathPoint eye) noexcept {
  const double horizon = horizon_mu(ground_m, eye.height_m), horizon_rad = std::acos(horizon);
  const double zenith_rad = std::acos(eye.mu);
  WholeWay way;
  way.below = eye.mu < 0.0 && eye.mu <= horizon;
  if (way.below) {
    way.zenith = (zenith_rad - horizon_rad) / (std::numbers::pi - horizon_rad);
    way.length_m = way_down_to_m(eye, ground_m);
    // On the horizon itself rounding may lift the line off the ground: to its lowest point then.
    if (way.length_m < 0.0) way.length_m = -(earth_radius_m + eye.height_m) * eye.mu;
    if (eye.height_m <= ground_m) way.length_m = 0.0;
  } else {
    way.zenith = zenith_rad / horizon_rad;
    way.length_m = std::max(0.0, way_up_to_m(eye, top_m));
  }
  way.measure_m = air_measure_m(eye.height_m, way.below ? ground_m : top_m, way.length_m);
  return way;
}

template <std::size_t N>
struct BoundView::Cell {
  std::array<std::size_t, N> offset{};  // of the rows within an array over places
  std::array<float, N> weight{};

  [[nodiscard]] Corners<N> in(const float* array, float scale = 1.0F) const noexcept {
    Corners<N> corners;
    for (std::size_t k = 0; k < N; ++k) {
      corners.row[k] = array + offset[k];
      corners.weight[k] = weight[k] * scale;
    }
    return corners;
  }
};

BoundView::BoundView(const AirTable& table, const AirTable::View& view, const AirFrame& frame,
                     const std::vector<float>& ground, Want want)
    : height_m_{view.height_m},
      places_{view.places()},
      shares_{view.share.size()},
      azimuths_{view.azimuth_rad.size()} {
  set_axes(view, std::acos(horizon_mu(table.ground_m, view.height_m)));
  append_rows(frame, table, view.extinction, 0, places_, extinction_);
  if (want.light.any()) take_even(table, view, frame, ground, want.light);
  if (want.light.scattered) take_bodies(table, view, frame);
  if (want.whole) divide_by_loss(table, view, frame);
}

/// E + G H, as far as it is wanted.
void BoundView::take_even(const AirTable& table, const AirTable::View& view, const AirFrame& frame,
                          const std::vector<float>& ground, AirLight light) {
  const std::size_t n = frame.padded();
  if (light.emitted) {
    append_rows(frame, table, view.even, 0, places_, even_);
  } else {
    even_.assign(places_ * n, 0.0F);
  }
  std::vector<float> night;
  if (light.scattered != light.emitted && !view.night.empty()) {
    append_rows(frame, table, view.night, 0, places_, night);
  }
  for (std::size_t i = 0; i < night.size(); ++i) {
    even_[i] = light.scattered ? night[i] : std::max(0.0F, even_[i] - night[i]);
  }
  std::vector<float> from_ground;
  append_rows(frame, table, view.ground, 0, places_, from_ground);
  for (std::size_t i = 0; i < even_.size(); ++i) even_[i] += ground[i % n] * from_ground[i];
}

void BoundView::take_bodies(const AirTable& table, const AirTable::View& view,
                            const AirFrame& frame) {
  const std::size_t kinds = static_cast<std::size_t>(table.kinds);
  bodies_ = frame.bodies.size();
  for (const AirFrame::Body& body : frame.bodies) {
    for (const std::size_t kind : frame.kinds) {
      append_rows(frame, table, view.first, (body.index * kinds + kind) * places_, places_, first_);
    }
    append_rows(frame, table, view.smooth, body.index * azimuths_ * places_, azimuths_ * places_,
                smooth_);
  }
}

void BoundView::set_axes(const AirTable::View& view, double horizon_rad) {
  const auto& zenith = view.zenith_rad;
  std::size_t split = 0;  // nodes above the horizon
  while (split < zenith.size() && zenith[split] <= horizon_rad + 1e-6) {
    ++split;
    if (split < zenith.size() && zenith[split] == zenith[split - 1]) break;
  }
  std::vector<double> above, below;
  for (std::size_t i = 0; i < zenith.size(); ++i) {
    const double place = i < split ? zenith[i] / horizon_rad
                                   : (zenith[i] - horizon_rad) / (std::numbers::pi - horizon_rad);
    (i < split ? above : below).push_back(std::clamp(place, 0.0, 1.0));
  }
  above_ = Axis{std::move(above), 0};
  below_ = Axis{std::move(below), split};
  share_ = Axis{view.share, 0};
  std::vector<double> azimuth = view.azimuth_rad;
  for (double& a : azimuth) a = std::clamp(a / std::numbers::pi, 0.0, 1.0);
  azimuth_ = Axis{std::move(azimuth), 0};
}

void BoundView::divide_by_loss(const AirTable& table, const AirTable::View& view,
                               const AirFrame& frame) {
  const std::size_t n = frame.padded();
  std::vector<float> factor(extinction_.size());
  for (std::size_t place = 0; place < places_; ++place) {
    const double mu = std::cos(view.zenith_rad[place / shares_]);
    const WholeWay way = whole_way(table.top_m, table.ground_m, {view.height_m, mu});
    for (std::size_t i = place * n; i < (place + 1) * n; ++i) {
      factor[i] =
          1.0F / (decay(extinction_[i] * static_cast<float>(way.measure_m)).lost + sky_floor);
    }
  }
  for (std::vector<float>* values : {&even_, &first_, &smooth_}) {
    for (std::size_t i = 0; i < values->size(); ++i) (*values)[i] *= factor[i % factor.size()];
  }
}

template <std::size_t N>
BoundView::Cell<N> BoundView::cell(const Look& look, float weight,
                                   std::size_t lanes) const noexcept {
  const Axis& side = look.below ? below_ : above_;
  // A table that knows one side of the horizon only: the horizon's node stands for the other.
  const Between zenith = !side.empty() ? side.find(look.zenith)
                         : look.below  ? above_.find(1.0)
                                       : below_.find(0.0);
  const std::array<std::size_t, 2> rows{zenith.lower * shares_, zenith.upper * shares_};
  const std::array<float, 2> across{weight * (1.0F - zenith.weight), weight * zenith.weight};
  if constexpr (N == 2) {
    const std::size_t last = shares_ - 1;
    return {{(rows[0] + last) * lanes, (rows[1] + last) * lanes}, across};
  } else {
    const Between share = share_.find(look.share);
    const float near = 1.0F - share.weight, far = share.weight;
    return {{(rows[0] + share.lower) * lanes, (rows[0] + share.upper) * lanes,
             (rows[1] + share.lower) * lanes, (rows[1] + share.upper) * lanes},
            {across[0] * near, across[0] * far, across[1] * near, across[1] * far}};
  }
}

template <std::size_t N>
void BoundView::add_bodies(const AirFrame& frame, Vec3 direction, const Cell<N>& cell,
                           LaneBuffer& source) const noexcept {
  const std::size_t n = frame.padded(), block = places_ * n, kinds = frame.kinds.size();
  const double azimuth_rad = azimuths_ > 1 ? std::atan2(direction.x, direction.y) : 0.0;
  for (std::size_t b = 0; b < bodies_; ++b) {
    const AirFrame::Body& body = frame.bodies[b];
    const double apart = std::abs(azimuth_rad - body.azimuth_rad) / std::numbers::pi;
    const Between azimuth = azimuth_.find(apart > 1.0 ? 2.0 - apart : apart);
    const float* smooth = &smooth_[b * azimuths_ * block];
    mix<true>(source.value.data(),
              both(cell.in(smooth + azimuth.lower * block, 1.0F - azimuth.weight),
                   cell.in(smooth + azimuth.upper * block, azimuth.weight)),
              n);
    if (kinds == 0) continue;
    // |direction - towards| = 2 sin(Theta / 2)
    const double last = static_cast<double>(frame.phase_nodes - 1);
    const double at = last * std::sqrt(std::min(1.0, 0.5 * length(direction - body.towards)));
    const double node = std::min(std::floor(at), last - 1.0);
    const float upper = static_cast<float>(at - node);
    for (std::size_t k = 0; k < kinds; ++k) {
      const float* row = &frame.phase[(k * frame.phase_nodes + static_cast<std::size_t>(node)) * n];
      mix_product(source.value.data(), cell.in(&first_[(b * kinds + k) * block]),
                  Corners<2>{{row, row + n}, {1.0F - upper, upper}}, n);
    }
  }
}

template <std::size_t N>
void BoundView::add_cell(const AirFrame& frame, const Look& look, const Cell<N>& cell,
                         LaneBuffer& extinction, LaneBuffer& source) const noexcept {
  const std::size_t n = frame.padded();
  mix<true>(extinction.value.data(), cell.in(extinction_.data()), n);
  if (even_.empty()) return;  // no light is wanted
  mix<true>(source.value.data(), cell.in(even_.data()), n);
  add_bodies(frame, look.direction, cell, source);
}

void BoundView::add(const AirFrame& frame, const Look& look, float weight, LaneBuffer& extinction,
                    LaneBuffer& source) const noexcept {
  const std::size_t n = frame.padded();
  if (look.share >= 1.0) {
    add_cell(frame, look, cell<2>(look, weight, n), extinction, source);
  } else {
    add_cell(frame, look, cell<4>(look, weight, n), extinction, source);
  }
}

void BoundView::add_extinction(const AirFrame& frame, const Look& look,
                               LaneBuffer& out) const noexcept {
  const std::size_t n = frame.padded();
  mix<true>(out.value.data(), cell<2>(look, 1.0F, n).in(extinction_.data()), n);
}

}  // namespace nadir::atmosphere
