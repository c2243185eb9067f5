#include "atmosphere/make/lane_views.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "atmosphere/night/night_sky.hpp"
#include "atmosphere/paths/spherical_path.hpp"

namespace nadir::atmosphere {
namespace {

float not_negative(double value) noexcept { return static_cast<float>(std::max(0.0, value)); }

/// Writes one path of one lane.
class Writer {
 public:
  Writer(const LaneFields& fields, const ViewShape& shape, LaneView& view)
      : fields_{fields}, shape_{shape}, view_{view}, light_{fields, shape.azimuth_rad} {
    for (const double azimuth : shape.azimuth_rad) {
      for (std::size_t m = 0; m < cosine_modes; ++m) {
        cosines_.push_back(std::cos(static_cast<double>(m) * azimuth));
      }
    }
  }

  void write(std::size_t zenith) {
    const ViewPath& path = shape_.paths[zenith];
    const PathSums sums = light_.along(path, shape_.share.size());
    std::vector<double> background(sums.sums, 0.0);
    const double left = std::exp(-sums.scaled_depth.back());
    night_ = path.meets_ground ? 0.0 : night_beyond(fields_, path);
    background[LaneFields::ground] = path.meets_ground ? left : 0.0;
    background[fields_.night] = left * night_;
    const ShareLight light{sums, background};
    set_phases(path);
    for (std::size_t s = 0; s < shape_.share.size(); ++s) {
      write_share(path, sums, light, {zenith * shape_.share.size() + s, s});
    }
  }

 private:
  struct Place {
    std::size_t index, share;
  };

  [[nodiscard]] double value(const ShareLight& light, std::size_t sum, std::size_t share) const {
    return shape_.whole ? light.whole(sum, share) : light.source(sum, share);
  }

  /// Optical depth per measure of air up to a share. At share 0, where a path starts, its limit;
  /// from high above that is a ratio of two densities next to nothing and no guide to what follows:
  /// the next node's then.
  [[nodiscard]] double extinction(const ViewPath& path, const PathSums& sums,
                                  std::size_t share) const {
    constexpr double high_m = 20e3;
    const double measure = shape_.share[share] * path.measure_m;
    if (measure > 0.0) return sums.depth[share] / measure;
    const bool more = path.measure_m > 0.0 && share + 1 < shape_.share.size();
    if (more && shape_.height_m > high_m) return extinction(path, sums, share + 1);
    return sums.first_depth / (path.start_thickness_m * path.start_density);
  }

  void write_share(const ViewPath& path, const PathSums& sums, const ShareLight& light, Place at) {
    const double share = shape_.share[at.share];
    const double depth = sums.depth[at.share];
    view_.extinction[at.index] = not_negative(extinction(path, sums, at.share));
    double night = urban(path);
    if (share >= 1.0 && night_ > 0.0) {
      // Seen through the whole way, the night sky itself is part of the light.
      const double straight = std::exp(-depth) * night_;
      if (shape_.whole)
        night += straight;
      else if (depth > 0.0)
        night += straight / -std::expm1(-depth);
    }
    const double emitted = value(light, LaneFields::even, at.share);
    if (fields_.night_alone) night += value(light, fields_.night, at.share);
    const bool apart = fields_.night != LaneFields::even || !fields_.night_alone;
    view_.even[at.index] = not_negative(apart ? emitted + night : night);
    view_.night[at.index] = std::min(not_negative(night), view_.even[at.index]);
    view_.ground[at.index] = not_negative(value(light, LaneFields::ground, at.share));
    for (std::size_t b = 0; b < fields_.beams.size(); ++b) write_beam(light, b, at);
  }

  /// A town's glow as if its source were even along the way: of the right sum from the ground up.
  [[nodiscard]] double urban(const ViewPath& path) const {
    if (fields_.urban_glow <= 0.0) return 0.0;
    const double mu = std::abs(std::cos(path.zenith_rad));
    const double glow = fields_.urban_glow * urban_glow_shape(mu);
    if (shape_.whole) return path.meets_ground ? 0.0 : glow;
    const double depth = vertical_depth() / std::max(mu, 0.025);
    return depth > 1e-6 ? glow / -std::expm1(-depth) : 0.0;
  }
  [[nodiscard]] double vertical_depth() const {
    double sum = 0.0;
    for (const double d : fields_.depth) sum += d;
    return sum;
  }

  void write_beam(const ShareLight& light, std::size_t b, Place at) {
    const LaneFields::Beam& beam = fields_.beams[b];
    const std::size_t places = shape_.places(), kinds = fields_.scattering.size();
    first_.resize(kinds);
    for (std::size_t k = 0; k < kinds; ++k) {
      first_[k] = std::max(0.0, value(light, light_.first(b, k), at.share));
      view_.first[(beam.body * kinds + k) * places + at.index] = static_cast<float>(first_[k]);
    }
    modes_.resize(static_cast<std::size_t>(beam.modes));
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      modes_[m] = value(light, beam.first_component + m, at.share);
    }
    for (std::size_t a = 0; a < shape_.azimuth_rad.size(); ++a) {
      double smooth = 0.0;
      for (std::size_t m = 0; m < modes_.size(); ++m) {
        smooth += modes_[m] * cosines_[a * cosine_modes + m];
      }
      const double* phase = phase_.data() + (b * shape_.azimuth_rad.size() + a) * kinds;
      double once = 0.0;
      for (std::size_t k = 0; k < kinds; ++k) once += first_[k] * phase[k];
      if (!beam.local.empty()) {
        smooth += beam.local_share * (value(light, light_.local(b, a), at.share) - once);
      }
      // Delta scaling may leave ripples below zero; not in the sum that is seen.
      smooth = std::max(smooth, -once);
      view_.smooth[(beam.body * shape_.azimuth_rad.size() + a) * places + at.index] =
          static_cast<float>(smooth);
    }
  }

  /// Phase functions towards every body, by azimuth of the path.
  void set_phases(const ViewPath& path) {
    phase_.clear();
    for (const LaneFields::Beam& beam : fields_.beams) {
      for (const double azimuth : shape_.azimuth_rad) {
        const double cosine = scattering_cosine(path.scene_zenith_rad(), azimuth, beam.place);
        for (const auto& phase : fields_.phases) phase_.push_back(phase->at(cosine));
      }
    }
  }

  static constexpr std::size_t cosine_modes = 128;  // as many as streams can make
  const LaneFields& fields_;
  const ViewShape& shape_;
  LaneView& view_;
  PathLight light_;
  double night_ = 0.0;
  std::vector<double> cosines_;        // [azimuth][mode]
  std::vector<double> phase_;          // [beam][azimuth][kind], of the path being written
  std::vector<double> first_, modes_;  // of the beam and share being written
};

std::vector<double> azimuth_axis(int nodes) {
  std::vector<double> axis;
  for (int i = 0; i < nodes; ++i) axis.push_back(i == 0 ? 0.0 : std::numbers::pi * i / (nodes - 1));
  return axis;
}

}  // namespace

ViewShape view_shape(const Shells& shells, const AirSettings& settings, double height_m,
                     bool night) {
  ViewShape shape;
  shape.height_m = height_m;
  shape.azimuth_rad = azimuth_axis(settings.azimuth_nodes);
  shape.share = share_axis(shells, height_m, settings.share_nodes);
  if (night) shape.share.insert(shape.share.end() - 1, 1.0 - 1e-6);
  const ZenithAxis axis = zenith_axis(shells, height_m, settings.zenith_nodes);
  for (const Side side : {Side::above, Side::below}) {
    for (const double zenith : side == Side::above ? axis.above : axis.below) {
      shape.zenith_rad.push_back(zenith);
      shape.paths.push_back(view_path(shells, height_m, zenith, side, shape.share));
    }
  }
  return shape;
}

ViewShape sky_shape(const Shells& shells, const AirSettings& settings) {
  ViewShape shape;
  shape.height_m = shells.ground_m();
  shape.whole = true;
  shape.azimuth_rad = azimuth_axis(settings.azimuth_nodes);
  shape.share = {1.0};
  shape.zenith_rad = zenith_axis(shells, shape.height_m, settings.zenith_nodes).above;
  for (const double zenith : shape.zenith_rad) {
    shape.paths.push_back(view_path(shells, shape.height_m, zenith, Side::above, shape.share));
  }
  return shape;
}

double night_beyond(const LaneFields& fields, const ViewPath& path) noexcept {
  const double cos_zenith = std::max(0.0, std::cos(path.zenith_rad));
  return fields.starlight + fields.airglow * van_rhijn(cos_zenith);
}

LaneView lane_view(const LaneFields& fields, const ViewShape& shape, std::size_t bodies) {
  const std::size_t places = shape.places(), kinds = fields.scattering.size();
  LaneView view;
  view.extinction.assign(places, 0.0F);
  view.even.assign(places, 0.0F);
  view.night.assign(places, 0.0F);
  view.ground.assign(places, 0.0F);
  view.first.assign(bodies * kinds * places, 0.0F);
  view.smooth.assign(bodies * shape.azimuth_rad.size() * places, 0.0F);
  Writer writer{fields, shape, view};
  for (std::size_t z = 0; z < shape.paths.size(); ++z) writer.write(z);
  return view;
}

}  // namespace nadir::atmosphere
