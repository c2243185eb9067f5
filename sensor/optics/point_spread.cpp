#include "sensor/optics/point_spread.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/error.hpp"
#include "core/normal_pair.hpp"
#include "sensor/optics/diffraction_mix.hpp"
#include "sensor/optics/spread_picture.hpp"
#include "sensor/optics/stray_light.hpp"

namespace nadir::sensor {
namespace {

/// Of any length on the focal plane: that of an orthographic camera is as large as its ground.
constexpr double largest_m = 1e4;
constexpr double two_pi = 2.0 * std::numbers::pi;

void require(bool good, const std::string& message) {
  if (!good) throw InputError{message};
}

/// A distance and a share of the whole turn, as a place.
Vec2 turned(double distance, double share) {
  const double angle = two_pi * share;
  return {distance * std::cos(angle), distance * std::sin(angle)};
}

/// False for NaN as well.
bool within(double value, double lo, double hi) { return value >= lo && value <= hi; }

void check_table(const TabulatedSpread& table) {
  require(table.columns > 0 && table.rows > 0 && table.pitch_m > 0.0 &&
              within(table.pitch_m, 0.0, largest_m) && !table.slices.empty(),
          "a table of a point-spread function needs cells, their pitch and a wavelength");
  const auto cells = static_cast<std::size_t>(table.columns) * static_cast<std::size_t>(table.rows);
  double former_um = 0.0;
  for (const TabulatedSpread::Slice& slice : table.slices) {
    require(slice.wavelength_um > former_um,
            "the wavelengths of a point-spread function must be positive and ascend");
    former_um = slice.wavelength_um;
    require(slice.weights.size() == cells,
            fmt::format("the point-spread function at {} um has {} weights for {} cells",
                        slice.wavelength_um, slice.weights.size(), cells));
    double sum = 0.0;
    for (const double weight : slice.weights) {
      require(weight >= 0.0 && std::isfinite(weight),
              fmt::format("the point-spread function at {} um has a weight of {}; light cannot be "
                          "less than none",
                          slice.wavelength_um, weight));
      sum += weight;
    }
    constexpr double rounding = 1e-3;  // of tables with three or four digits
    require(within(sum, 1.0 - rounding, 1.0 + rounding),
            fmt::format("the point-spread function at {} um sums to {:.6g}, not to one",
                        slice.wavelength_um, sum));
  }
}

void check_spread(const SpreadDescription& d) {
  require(!(d.diffraction && d.table),
          "a table of the point-spread function holds the diffraction already: give one of them");
  if (d.diffraction) {
    require(within(d.diffraction->f_number, 0.1, 1e4), "the focal ratio must lie in 0.1 .. 10000");
    require(within(d.diffraction->obscuration, 0.0, 0.95), "the obscuration must lie in 0 .. 0.95");
  }
  for (const GaussianSpread& g : d.gaussians) {
    require(within(g.sigma_x_m, 0.0, largest_m) && within(g.sigma_y_m, 0.0, largest_m),
            "the blur's standard deviation must lie in 0 .. 10000 m");
  }
  if (d.table) check_table(*d.table);
  if (d.stray) {
    require(within(d.stray->share, 0.0, 0.999), "the stray light's share must lie in 0 .. 0.999");
    require(d.stray->core_m > 0.0 && within(d.stray->reach_m, 0.0, largest_m) &&
                d.stray->reach_m > d.stray->core_m && within(d.stray->slope, 0.0, 20.0),
            "stray light needs 0 < core < reach <= 10000 m and a slope in 0 .. 20");
  }
}

}  // namespace

/// What drawing needs, the same for all threads.
struct PointSpread::Tables {
  std::optional<DiffractionMix> diffraction;
  std::optional<SpreadPicture> picture;
  double sigma_x_m = 0.0, sigma_y_m = 0.0;  // of all Gaussians
};

PointSpread::PointSpread(const SpreadDescription& description,
                         const std::vector<spectral::Response>& bands)
    : description_{description} {
  check_spread(description);
  require(!bands.empty(), "a point-spread function needs the bands that it serves");
  auto tables = std::make_shared<Tables>();
  std::vector<WavelengthQuantiles> quantiles;
  for (const spectral::Response& band : bands) quantiles.emplace_back(band);
  for (const GaussianSpread& g : description.gaussians) {
    tables->sigma_x_m = std::hypot(tables->sigma_x_m, g.sigma_x_m);
    tables->sigma_y_m = std::hypot(tables->sigma_y_m, g.sigma_y_m);
  }
  const bool several = bands.size() > 1;
  if (description.diffraction) {
    depends_on_band_ = several;
    tables->diffraction.emplace(*description.diffraction, std::move(quantiles));
  } else if (description.table) {
    depends_on_band_ = several && description.table->slices.size() > 1;
    tables->picture.emplace(*description.table, quantiles);
  }
  tables_ = std::move(tables);
}

PointSpread::Draw PointSpread::draw(const Sampler& numbers, std::uint32_t first) const noexcept {
  Draw drawn;
  const Tables& t = *tables_;
  if (description_.stray && numbers.point(first).y < description_.stray->share) {
    const Vec2 place = numbers.point(first + 1);
    drawn.displacement_m = turned(stray_distance(*description_.stray, place.x), place.y);
    drawn.stray = true;
    return drawn;
  }
  Vec2 core{0.0, 0.0};
  if (t.diffraction || t.picture) {
    const double which = numbers.number(first);  // the x of the point that decides on stray light
    const Vec2 place = numbers.point(first + 1);
    core = t.diffraction ? turned(t.diffraction->distance(which, place.x), place.y)
                         : t.picture->draw(which, place);
  }
  drawn.core_x_m = static_cast<float>(core.x);
  drawn.core_y_m = static_cast<float>(core.y);
  // Light that the optics throw from its ideal place by `core` is met by going back.
  drawn.displacement_m = {-core.x, -core.y};
  if (t.sigma_x_m > 0.0 || t.sigma_y_m > 0.0) {
    const Vec2 normal = normal_pair(numbers.point(first + 2));
    drawn.displacement_m.x += t.sigma_x_m * normal.x;
    drawn.displacement_m.y += t.sigma_y_m * normal.y;
  }
  return drawn;
}

void PointSpread::weights(const Draw& draw, std::span<double> by_band) const noexcept {
  if (!depends_on_band_ || draw.stray) {
    std::fill(by_band.begin(), by_band.end(), 1.0);
    return;
  }
  const Vec2 core{static_cast<double>(draw.core_x_m), static_cast<double>(draw.core_y_m)};
  if (tables_->diffraction) {
    tables_->diffraction->weights(std::hypot(core.x, core.y), by_band);
    return;
  }
  for (std::size_t band = 0; band < by_band.size(); ++band) {
    by_band[band] = tables_->picture->ratio(band, core);
  }
}

double PointSpread::mtf(std::size_t band, Vec2 frequency_per_m) const {
  const Tables& t = *tables_;
  std::complex<double> core = 1.0;
  const double frequency = std::hypot(frequency_per_m.x, frequency_per_m.y);
  if (t.diffraction) core *= t.diffraction->mtf(band, frequency);
  if (t.picture) core *= t.picture->otf(band, frequency_per_m);
  const double a = t.sigma_x_m * frequency_per_m.x, b = t.sigma_y_m * frequency_per_m.y;
  core *= std::exp(-0.5 * two_pi * two_pi * (a * a + b * b));
  if (!description_.stray) return std::abs(core);
  const double share = description_.stray->share;
  return std::abs((1.0 - share) * core + share * stray_mtf(*description_.stray, frequency));
}

}  // namespace nadir::sensor
