#include "radiometry/lamps/intensity_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::radiometry {
namespace {

constexpr double pi = std::numbers::pi;
/// Emission bounds are that much wider than the lamp, so that rounding never puts a lit point
/// outside.
constexpr double slack_rad = 1e-6;

void require(bool good, const std::string& message) {
  if (!good) throw InputError{message};
}

bool ascending(const std::vector<double>& list) {
  return std::adjacent_find(list.begin(), list.end(),
                            [](double a, double b) { return !(a < b); }) == list.end();
}

/// Angles come in degrees of a few decimals, so that a multiple of pi/2 is met closely.
bool is_about(double angle_rad, double expected_rad) {
  return std::abs(angle_rad - expected_rad) < 1e-6;
}

void check(const IntensityTable& table) {
  const auto &v = table.vertical_rad, &h = table.horizontal_rad;
  require(v.size() >= 2 && ascending(v) && v.front() >= 0.0 && v.back() <= pi + 1e-9,
          "an intensity table needs at least two vertical angles, ascending within 0 and 180 deg");
  require(!h.empty() && ascending(h), "an intensity table needs ascending horizontal angles");
  const bool closed =
      is_about(h.back(), pi / 2) || is_about(h.back(), pi) || is_about(h.back(), 2.0 * pi);
  require(h.size() == 1 || (is_about(h.front(), 0.0) && closed),
          "horizontal angles of an intensity table must reach from 0 to 90, 180 or 360 deg");
  require(table.value.size() == v.size() * h.size(),
          "an intensity table needs a value for each pair of angles");
  for (const double value : table.value) {
    require(std::isfinite(value) && value >= 0.0,
            "an intensity must be finite and not negative, found " + number_text(value));
  }
}

/// int_a^b (y_a + (t - a) (y_b - y_a) / (b - a)) sin t dt
double zone(double a, double b, double y_a, double y_b) {
  // By parts: the integral of t sin t is sin t - t cos t.
  const double slope = (y_b - y_a) / (b - a);
  return y_a * std::cos(a) - y_b * std::cos(b) + slope * (std::sin(b) - std::sin(a));
}

/// 2 pi int_{edge}^{1} m^p dm, with 1 - cos^(p + 1) kept exact for narrow beams.
double cosine_integral(double power, double edge_rad) {
  const double s = std::sin(0.5 * edge_rad);
  if (power == 0.0) return 4.0 * pi * s * s;
  const double log_cos = std::log1p(-2.0 * s * s);  // -inf at 90 degrees, whose power is 0
  return -2.0 * pi * std::expm1((power + 1.0) * log_cos) / (power + 1.0);
}

/// The largest value at each vertical angle, all around.
std::vector<double> profile(const IntensityTable& table) {
  const std::size_t n = table.vertical_rad.size();
  std::vector<double> largest(n, 0.0);
  for (std::size_t i = 0; i < table.value.size(); ++i) {
    largest[i % n] = std::max(largest[i % n], table.value[i]);
  }
  return largest;
}

/// The least spread whose cosine covers the profile. The bound is concave up to spread + 90
/// degrees, so straight lines between knots below it stay below.
EmissionBound bound_of(const IntensityTable& table, double total) {
  const std::vector<double> largest = profile(table);
  const std::vector<double>& angle = table.vertical_rad;
  const double peak = *std::max_element(largest.begin(), largest.end());
  double spread = 0.0, end = 0.0;
  for (std::size_t i = 0; i < largest.size(); ++i) {
    if (largest[i] <= 0.0) continue;
    spread = std::max(spread, angle[i] - std::acos(std::min(1.0, largest[i] / peak)));
    end = angle[std::min(i + 1, angle.size() - 1)];
  }
  spread = std::max(spread, end - pi / 2);
  return {std::min(pi, spread + slack_rad), std::clamp(end - spread + slack_rad, 0.0, pi / 2),
          peak / total};
}

}  // namespace

double integral(const IntensityTable& table) {
  check(table);
  const std::size_t rows = table.vertical_rad.size();
  const auto meridian = [&](std::size_t column) {
    double sum = 0.0;
    for (std::size_t i = 1; i < rows; ++i) {
      const double* value = &table.value[column * rows + i];
      sum += zone(table.vertical_rad[i - 1], table.vertical_rad[i], value[-1], value[0]);
    }
    return sum;
  };
  const std::vector<double>& h = table.horizontal_rad;
  if (h.size() == 1) return 2.0 * pi * meridian(0);
  double sum = 0.0;
  for (std::size_t j = 1; j < h.size(); ++j) {
    sum += 0.5 * (h[j] - h[j - 1]) * (meridian(j - 1) + meridian(j));
  }
  return sum * 2.0 * pi / (h.back() - h.front());
}

BoundShape::BoundShape(const IntensityShape& shape) {
  if (const auto* cosine = std::get_if<CosinePower>(&shape)) {
    bind(*cosine);
  } else {
    const auto& table = std::get<std::shared_ptr<const IntensityTable>>(shape);
    require(table != nullptr, "a lamp's intensity table is missing");
    bind(*table);
  }
}

void BoundShape::bind(const CosinePower& shape) {
  require(std::isfinite(shape.power) && shape.power >= 0.0,
          "the power of a lamp's cosine must not be negative, found " + number_text(shape.power));
  require(shape.half_angle_rad > 0.0 && shape.half_angle_rad <= pi + 1e-9,
          "a lamp's half angle must be above 0 and at most 180 deg, found " +
              number_text(shape.half_angle_rad * 180.0 / pi) + " deg");
  const double edge = std::min(shape.half_angle_rad, shape.power > 0.0 ? pi / 2 : pi);
  const double scale = 1.0 / cosine_integral(shape.power, edge);
  cosine_ = Cosine{shape.power, std::cos(edge), scale};
  // cos^p lies below cos from p = 1 on; below that only its edge bounds it.
  bound_ = shape.power >= 1.0 ? EmissionBound{0.0, std::min(edge + slack_rad, pi / 2), scale}
                              : EmissionBound{std::min(edge + slack_rad, pi), 0.0, scale};
}

void BoundShape::bind(const IntensityTable& shape) {
  const double total = integral(shape);
  require(total > 0.0, "a lamp's intensity table holds no light");
  bound_ = bound_of(shape, total);
  std::vector<double> scaled = shape.value;
  for (double& value : scaled) value /= total;
  table_ = Table{Axis{shape.vertical_rad}, Axis{shape.horizontal_rad}, std::move(scaled)};
}

double BoundShape::operator()(Vec3 direction) const noexcept {
  if (table_) return table_->at(direction);
  if (direction.z < cosine_.cos_edge) return 0.0;
  if (cosine_.power == 0.0) return cosine_.scale;
  return cosine_.scale * std::pow(std::max(0.0, direction.z), cosine_.power);
}

BoundShape::Axis::Axis(std::vector<double> ascending) : knots{std::move(ascending)} {
  if (knots.size() < 2) return;
  constexpr double most_steps = 4096.0;
  const double range = knots.back() - knots.front();
  double least = range;
  for (std::size_t i = 1; i < knots.size(); ++i) least = std::min(least, knots[i] - knots[i - 1]);
  const double steps = std::ceil(std::min(range / least, most_steps));
  steps_per_unit = steps / range;
  std::uint32_t interval = 0;
  for (double step = 0.0; step <= steps; ++step) {
    const double begin = knots.front() + step / steps_per_unit;
    while (interval + 2 < knots.size() && knots[interval + 1] <= begin) ++interval;
    first.push_back(interval);
  }
}

std::pair<std::size_t, double> BoundShape::Axis::find(double value) const noexcept {
  if (knots.size() < 2) return {0, 0.0};
  const auto step =
      static_cast<std::size_t>(std::max(0.0, (value - knots.front()) * steps_per_unit));
  std::size_t i = first[std::min(step, first.size() - 1)];
  while (i > 0 && value < knots[i]) --i;  // rounding may have led one step too far
  while (i + 2 < knots.size() && value >= knots[i + 1]) ++i;
  return {i, std::clamp((value - knots[i]) / (knots[i + 1] - knots[i]), 0.0, 1.0)};
}

double BoundShape::Table::at(Vec3 direction) const noexcept {
  const double theta = std::acos(std::clamp(direction.z, -1.0, 1.0));
  if (theta < vertical.knots.front() || theta > vertical.knots.back()) return 0.0;
  double phi = std::atan2(direction.y, direction.x);
  const double last = horizontal.knots.back();
  if (last > 4.0) {
    if (phi < 0.0) phi += 2.0 * pi;  // all around
  } else {
    phi = std::abs(phi);                            // both halves alike
    if (last < 2.0) phi = std::min(phi, pi - phi);  // each quadrant alike
  }
  const auto [i, s] = vertical.find(theta);
  const auto [j, t] = horizontal.find(phi);
  const std::size_t rows = vertical.knots.size();
  const auto along = [&, i = i, s = s](std::size_t column) {
    const double* low = &value[column * rows + i];
    return low[0] + s * (low[1] - low[0]);
  };
  if (horizontal.knots.size() == 1) return along(0);
  return along(j) * (1.0 - t) + along(j + 1) * t;
}

}  // namespace nadir::radiometry
