#include "radiometry/lamps/emitting_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/frame.hpp"
#include "core/transform.hpp"
#include "radiometry/lamps/spherical_rectangle.hpp"

namespace nadir::radiometry {
namespace {

constexpr double pi = std::numbers::pi;
/// Below this solid angle a rectangle is nearly flat as seen, and sampling its area is as good; the
/// sum of angles would lose digits.
constexpr double least_solid_angle_sr = 0.01;
constexpr double touching_m = 1e-9;

void require(bool good, const char* message) {
  if (!good) throw InputError{message};
}
bool is_size(double value_m) { return std::isfinite(value_m) && value_m > 0.0; }
bool is_unit(Vec3 v) { return std::abs(length(v) - 1.0) < 1e-6; }

/// A point of the unit disc, uniform in area. Source: Shirley & Chiu, J. Graphics Tools 2(3), 45
/// (1997).
Vec2 in_disc(Vec2 u) {
  const double a = 2.0 * u.x - 1.0, b = 2.0 * u.y - 1.0;
  if (a == 0.0 && b == 0.0) return {};
  const bool flat = std::abs(a) > std::abs(b);
  const double r = flat ? a : b;
  const double phi = flat ? pi / 4.0 * (b / a) : pi / 2.0 - pi / 4.0 * (a / b);
  return {r * std::cos(phi), r * std::sin(phi)};
}

/// 1 - cos of half the cone that a sphere fills.
double cap(double radius, double distance) {
  const double s = radius / distance;
  return s * s / (1.0 + std::sqrt(std::max(0.0, 1.0 - s * s)));
}

}  // namespace

EmittingSurface::EmittingSurface(const AreaLamp& lamp) {
  require(is_finite(lamp.centre), "an area lamp's place must be finite");
  require(is_unit(lamp.axis_x) && is_unit(lamp.axis_y) &&
              std::abs(dot(lamp.axis_x, lamp.axis_y)) < 1e-6,
          "an area lamp's axes must be unit vectors at right angles");
  x_ = lamp.axis_x;
  y_ = lamp.axis_y;
  normal_ = cross(x_, y_);
  std::visit([this](const auto& shape) { place(shape); }, lamp.surface);
  centre_ = lamp.centre + centre_;
}

void EmittingSurface::place(const geometry::Disc& disc) {
  require(is_size(disc.radius), "a disc lamp's radius must be a positive number of metres");
  require(is_finite(disc.normal) && length(disc.normal) > 0.0,
          "a disc lamp's normal has no length");
  kind_ = Kind::disc;
  const Mat3 to_scene{x_, y_, normal_};
  centre_ = to_scene * disc.centre;
  normal_ = normalised(to_scene * disc.normal);
  const Frame frame = frame_about(normal_);
  x_ = frame.x;
  y_ = frame.y;
  radius_ = disc.radius;
  area_ = pi * radius_ * radius_;
}

void EmittingSurface::place(const geometry::Plane& plane) {
  require(is_size(plane.size_x) && is_size(plane.size_y),
          "a plane lamp's sizes must be positive numbers of metres");
  kind_ = Kind::plane;
  centre_ = Mat3{x_, y_, normal_} * plane.centre;
  half_x_ = 0.5 * plane.size_x;
  half_y_ = 0.5 * plane.size_y;
  area_ = plane.size_x * plane.size_y;
}

void EmittingSurface::place(const geometry::Sphere& sphere) {
  require(is_size(sphere.radius), "a sphere lamp's radius must be a positive number of metres");
  kind_ = Kind::sphere;
  centre_ = Mat3{x_, y_, normal_} * sphere.centre;
  radius_ = sphere.radius;
  area_ = 4.0 * pi * radius_ * radius_;
}

std::optional<EmittingSurface::Place> EmittingSurface::sample(Vec3 position,
                                                              Vec2 u) const noexcept {
  return kind_ == Kind::sphere ? sample_sphere(position, u) : sample_area(position, u);
}

std::optional<EmittingSurface::Place> EmittingSurface::sample_sphere(Vec3 position,
                                                                     Vec2 u) const noexcept {
  const Vec3 to_centre = centre_ - position;
  const double distance = length(to_centre);
  if (!(distance > radius_)) return std::nullopt;
  const double height = cap(radius_, distance) * u.x;  // 1 - cos
  const double sine = std::sqrt(height * (2.0 - height)), phi = 2.0 * pi * u.y;
  const Frame frame = frame_about(to_centre / distance);
  const Vec3 direction =
      normalised(frame.to_world({sine * std::cos(phi), sine * std::sin(phi), 1.0 - height}));
  const double across = distance * sine;
  const double depth = std::sqrt(std::max(0.0, (radius_ - across) * (radius_ + across)));
  return Place{direction, std::max(distance * (1.0 - height) - depth, distance - radius_),
               cone_pdf(position)};
}

double EmittingSurface::cone_pdf(Vec3 position) const noexcept {
  const double distance = length(centre_ - position);
  if (!(distance > radius_)) return 0.0;
  return 1.0 / (2.0 * pi * cap(radius_, distance));
}

/// Density of a place that is uniform over the area, as solid angle: d^2 / (A cos).
double EmittingSurface::area_pdf(Vec3 towards, double distance2) const noexcept {
  return distance2 / (area_ * -dot(towards, normal_));
}

namespace {

/// Null where the rectangle is too small to be treated as spherical.
std::optional<SphericalRectangle> as_seen(const SeenRectangle& seen, double area) {
  const double x = std::clamp(0.0, seen.x0, seen.x1), y = std::clamp(0.0, seen.y0, seen.y1);
  const double nearest2 = x * x + y * y + seen.z * seen.z;
  // A / d^2 of the nearest point is more than the solid angle: spares the angles of far lamps.
  if (seen.z < touching_m || area < least_solid_angle_sr * nearest2) return std::nullopt;
  const SphericalRectangle rectangle{seen};
  if (!(rectangle.solid_angle() >= least_solid_angle_sr)) return std::nullopt;
  return rectangle;
}

}  // namespace

std::optional<EmittingSurface::Place> EmittingSurface::sample_area(Vec3 position,
                                                                   Vec2 u) const noexcept {
  const Vec3 to_centre = centre_ - position;
  const double height = -dot(to_centre, normal_);  // of the position above the front
  if (!(height > 0.0)) return std::nullopt;
  const Vec2 middle{dot(to_centre, x_), dot(to_centre, y_)};
  std::optional<SphericalRectangle> spherical;
  Vec2 place;
  if (kind_ == Kind::plane) {
    spherical = as_seen(
        {middle.x - half_x_, middle.x + half_x_, middle.y - half_y_, middle.y + half_y_, height},
        area_);
    place = spherical ? spherical->point(u)
                      : Vec2{middle.x + (2.0 * u.x - 1.0) * half_x_,
                             middle.y + (2.0 * u.y - 1.0) * half_y_};
  } else {
    const Vec2 on_disc = in_disc(u);
    place = {middle.x + radius_ * on_disc.x, middle.y + radius_ * on_disc.y};
  }
  const Vec3 towards = place.x * x_ + place.y * y_ - height * normal_;
  const double distance = length(towards);
  if (!(distance > touching_m)) return std::nullopt;
  const Vec3 direction = towards / distance;
  const double pdf =
      spherical ? 1.0 / spherical->solid_angle() : area_pdf(direction, distance * distance);
  return Place{direction, distance, pdf};
}

double EmittingSurface::pdf(Vec3 position, Vec3 direction, Vec3 on_lamp) const noexcept {
  if (kind_ == Kind::sphere) return cone_pdf(position);
  const Vec3 to_centre = centre_ - position;
  const double height = -dot(to_centre, normal_);
  if (!(height > 0.0) || !(dot(direction, normal_) < 0.0)) return 0.0;
  if (kind_ == Kind::plane) {
    const double x = dot(to_centre, x_), y = dot(to_centre, y_);
    const auto spherical =
        as_seen({x - half_x_, x + half_x_, y - half_y_, y + half_y_, height}, area_);
    if (spherical) return 1.0 / spherical->solid_angle();
  }
  const Vec3 way = on_lamp - position;
  return area_pdf(direction, dot(way, way));
}

bool EmittingSurface::seen_from_front(Vec3 direction, Vec3 on_lamp) const noexcept {
  return dot(direction, kind_ == Kind::sphere ? on_lamp - centre_ : normal_) < 0.0;
}

LightTreeItem EmittingSurface::bound() const noexcept {
  if (kind_ == Kind::sphere) {
    const Vec3 reach{radius_, radius_, radius_};
    return {{centre_ - reach, centre_ + reach}, normal_, pi, 0.0, 0.0};
  }
  const double rx = kind_ == Kind::disc ? radius_ : half_x_;
  const double ry = kind_ == Kind::disc ? radius_ : half_y_;
  const auto reach = [&](double x, double y) {
    return kind_ == Kind::disc ? std::hypot(rx * x, ry * y) : std::abs(rx * x) + std::abs(ry * y);
  };
  const Vec3 half{reach(x_.x, y_.x), reach(x_.y, y_.y), reach(x_.z, y_.z)};
  return {{centre_ - half, centre_ + half}, normal_, 0.0, pi / 2, 0.0};
}

}  // namespace nadir::radiometry
