#include "sensor/camera/projection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sensor/camera/find_zero.hpp"
#include "sensor/camera/focal_plane.hpp"

namespace nadir::sensor {
namespace {

// How far beyond its image an array's coordinates go on, of its size.
constexpr double image_margin = 0.1;
// Places of time at which a search looks that must not overlook: of one pass over the image.
constexpr int search_looks = 64;
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

// A place of the image, and how far in pixels it lies outside the piece that was asked for.
struct Found {
  ImagePoint image;
  double outside = std::numeric_limits<double>::infinity();
};

void keep_nearer(Found& best, const Found& other) {
  if (other.outside < best.outside) best = other;
}

double outside_of(double coordinate, Interval piece) {
  return std::max({0.0, piece.low - coordinate, coordinate - piece.high});
}

struct OnPlane {
  Vec2 focal_m{nowhere, nowhere};
  bool seen = false;  // false: only a substitute beyond where the lens folds, or nothing at all
};

OnPlane through_lens(const Perspective& lens, Vec3 camera) {
  if (!(camera.z > 0.0)) return {};
  const Vec2 ideal{camera.x / camera.z, camera.y / camera.z};
  const double f = lens.focal_length_m;
  if (lens.distortion.is_none()) return {{f * ideal.x, f * ideal.y}, true};
  const Vec2 bent = distorted(lens.distortion, ideal);
  const Vec2 back = undistorted(lens.distortion, bent);
  const double miss = std::hypot(back.x - ideal.x, back.y - ideal.y);
  // Far outside, the polynomial folds back into the image; the ideal place goes on outwards, so
  // that searches find their way.
  if (!(miss <= 1e-9)) return {{f * ideal.x, f * ideal.y}, false};
  return {{f * bent.x, f * bent.y}, true};
}

OnPlane on_plane(const DetectorArray& array, const Pose& pose, Vec3 place) {
  const Vec3 camera = pose.axes.transposed() * (place - pose.position);
  if (const auto* lens = std::get_if<Perspective>(&array.projection)) {
    return through_lens(*lens, camera);
  }
  if (std::holds_alternative<Orthographic>(array.projection)) {
    if (!(camera.z > 0.0)) return {};
    return {{camera.x, camera.y}, true};
  }
  const ViewTable& table = **std::get_if<Tabulated>(&array.projection);
  const auto found = place_of(table, normalised(camera));
  if (!found) return {};
  return {focal_of_table(array, table, *found), true};
}

// The search for one place in one array's image.
class Search {
 public:
  Search(const DetectorArray& array, const Platform& platform, Vec3 place)
      : array_{&array}, platform_{&platform}, place_{place} {}

  [[nodiscard]] Found run() const {
    return std::visit([this](const auto& scan) { return find(scan); }, array_->timing.scan);
  }

 private:
  struct Seen {
    DetectorPlace place{nowhere, nowhere};
    bool seen = false;
  };
  [[nodiscard]] Seen seen(const Module* module, double time_s) const {
    const OnPlane plane = on_plane(*array_, platform_->steady(time_s), place_);
    return {detector_place(*array_, module, plane.focal_m), plane.seen};
  }

  // The modules, or one that is the array.
  template <class PerModule>
  [[nodiscard]] Found nearest_module(const PerModule& find_in) const {
    Found best;
    if (array_->modules.empty()) {
      keep_nearer(best, find_in(nullptr));
      return best;
    }
    for (const Module& module : array_->modules) {
      keep_nearer(best, find_in(&module));
      if (best.outside == 0.0) break;
    }
    return best;
  }

  [[nodiscard]] Interval columns(const Module* module) const {
    if (module == nullptr) return {0.0, static_cast<double>(array_->samples)};
    return {static_cast<double>(module->first_sample),
            static_cast<double>(module->first_sample + module->samples)};
  }
  [[nodiscard]] Interval lines() const { return {0.0, static_cast<double>(array_->lines)}; }

  [[nodiscard]] Found found(const Module* module, const Seen& at, double line) const {
    if (!at.seen) return {};
    return {{at.place.column, line},
            outside_of(at.place.column, columns(module)) + outside_of(line, lines())};
  }

  // Lines within the image and its margin of which the platform knows the time.
  [[nodiscard]] Interval lines_in_time(double first_line_s, double period_s) const {
    Interval range{-image_margin * array_->lines, (1.0 + image_margin) * array_->lines};
    if (platform_->is_fixed()) return range;
    const auto line_at = [&](double time_s) { return (time_s - first_line_s) / period_s + 0.5; };
    return {std::max(range.low, line_at(platform_->first_s())),
            std::min(range.high, line_at(platform_->last_s()))};
  }

  // A line whose miss is 0, looked for from a guess, and where that fails everywhere.
  template <class MissOf>
  [[nodiscard]] Found find_line(const Module* module, const MissOf& miss_of, Interval range,
                                double& guess) const {
    const auto found_at = [&](double line) {
      return found(module, seen(module, image_time_s(*array_, {0.0, line})), line);
    };
    if (!(range.low < range.high)) return {};
    Found best;
    if (const auto line =
            secant_zero(miss_of, range, guess, std::min(1.0, range.high - range.low))) {
      guess = *line;
      best = found_at(*line);
      if (best.outside == 0.0) return best;
    }
    every_zero(miss_of, range, search_looks, [&](double line) {
      if (std::abs(miss_of(line)) < 1e-6) keep_nearer(best, found_at(line));
      return best.outside == 0.0;
    });
    return best;
  }

  [[nodiscard]] double row(const Seen& at) const { return at.place.row_m / array_->height_m(); }

  [[nodiscard]] Found find(const GlobalShutter& shutter) const {
    return nearest_module([&](const Module* module) {
      const Seen at = seen(module, shutter.centre_s);
      return found(module, at, row(at) + 0.5 * array_->lines);
    });
  }

  [[nodiscard]] Found find(const RollingShutter& shutter) const {
    if (platform_->is_fixed() || shutter.line_period_s == 0.0) {
      return find(GlobalShutter{shutter.first_line_s});
    }
    const Interval range = lines_in_time(shutter.first_line_s, shutter.line_period_s);
    double guess = 0.5 * array_->lines;
    return nearest_module([&](const Module* module) {
      const auto miss = [&](double line) {
        return row(seen(module, image_time_s(*array_, {0.0, line}))) + 0.5 * array_->lines - line;
      };
      return find_line(module, miss, range, guess);
    });
  }

  [[nodiscard]] Found find(const Pushbroom& broom) const {
    if (platform_->is_fixed()) return find_unmoved();
    const Interval range = lines_in_time(broom.first_line_s, broom.line_period_s);
    double guess = 0.5 * array_->lines;
    return nearest_module([&](const Module* module) {
      const auto miss = [&](double line) {
        return row(seen(module, image_time_s(*array_, {0.0, line})));
      };
      return find_line(module, miss, range, guess);
    });
  }

  // A row that does not move sees the same all the time: the first line has it.
  [[nodiscard]] Found find_unmoved() const {
    return nearest_module([&](const Module* module) {
      const Seen at = seen(module, 0.0);
      return std::abs(row(at)) <= 0.5 ? found(module, at, 0.5) : Found{};
    });
  }

  // Where the column passes over the place in one sweep of a whiskbroom; `outside`: of its lines.
  [[nodiscard]] Found find_in_sweep(const Whiskbroom& broom, int scan, double& guess) const {
    const int rows = broom.lines_per_scan;
    const auto at = [&](double sample) {
      const double line = (scan + 0.5) * rows;
      return seen(nullptr, image_time_s(*array_, {sample, line}));
    };
    const auto miss = [&](double sample) {
      return at(sample).place.column - 0.5 * array_->samples;
    };
    // The sweep's own samples and no image_margin: before and after them the mirror turns back.
    const Interval range = columns(nullptr);
    std::optional<double> sample = secant_zero(miss, range, guess, 1.0);
    if (!sample) {
      every_zero(miss, range, search_looks, [&](double zero) {
        if (std::abs(miss(zero)) < 1e-6) sample = zero;
        return sample.has_value();
      });
    }
    if (!sample) return {};
    guess = *sample;
    const Seen there = at(*sample);
    if (!there.seen) return {};
    const double below = row(there) + 0.5 * rows;
    return {{*sample, scan * rows + below}, outside_of(below, {0.0, static_cast<double>(rows)})};
  }

  // Sweeps of the image and of its margin of which the platform knows the time.
  [[nodiscard]] bool known(const Whiskbroom& broom, int scan) const {
    if (platform_->is_fixed()) return true;
    const double line = (scan + 0.5) * broom.lines_per_scan;
    const double samples = array_->samples;
    return image_time_s(*array_, {0.0, line}) >= platform_->first_s() - 1e-9 &&
           image_time_s(*array_, {samples, line}) <= platform_->last_s() + 1e-9;
  }

  [[nodiscard]] Found find(const Whiskbroom& broom) const {
    const int scans = array_->lines / broom.lines_per_scan;
    int first = -static_cast<int>(image_margin * scans), last = scans - 1 - first;
    while (first < last && !known(broom, first)) ++first;
    while (first < last && !known(broom, last)) --last;
    double guess = 0.5 * array_->samples;
    // From sweep to sweep by the rows that it misses by.
    int scan = std::clamp(scans / 2, first, last);
    for (int i = 0; i < 24; ++i) {
      const Found here = find_in_sweep(broom, scan, guess);
      if (here.outside == 0.0) return earliest(broom, scan, first, here);
      if (!std::isfinite(here.outside)) break;
      const double rows = here.image.line / broom.lines_per_scan - scan;
      const double next = std::clamp(scan + std::floor(rows), first * 1.0, last * 1.0);
      if (static_cast<int>(next) == scan) return here;
      scan = static_cast<int>(next);
    }
    Found best;
    for (scan = first; scan <= last && best.outside > 0.0; ++scan) {
      keep_nearer(best, find_in_sweep(broom, scan, guess));
    }
    return best;
  }

  // Sweeps overlap where they are wider than the way from one to the next.
  [[nodiscard]] Found earliest(const Whiskbroom& broom, int scan, int first, Found here) const {
    double guess = here.image.sample;
    while (scan-- > first) {
      const Found before = find_in_sweep(broom, scan, guess);
      if (before.outside > 0.0) break;
      here = before;
    }
    return here;
  }

  const DetectorArray* array_;
  const Platform* platform_;
  Vec3 place_;
};

bool lies_within(double coordinate, double size, double beyond) {
  return coordinate >= -beyond * size && coordinate <= (1.0 + beyond) * size;
}

}  // namespace

std::optional<ImagePoint> image_of(const DetectorArray& array, const Platform& platform,
                                   Vec3 place) {
  const Found found = Search{array, platform, place}.run();
  if (!std::isfinite(found.outside) ||
      !lies_within(found.image.sample, array.samples, image_margin) ||
      !lies_within(found.image.line, array.lines, image_margin)) {
    return std::nullopt;
  }
  return found.image;
}

bool in_view(const DetectorArray& array, const Platform& platform, Vec3 place) {
  const auto image = image_of(array, platform, place);
  return image && lies_within(image->sample, array.samples, 0.0) &&
         lies_within(image->line, array.lines, 0.0);
}

}  // namespace nadir::sensor
