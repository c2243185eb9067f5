#pragma once

#include <optional>
#include <variant>

#include "core/vec.hpp"
#include "geometry/scene.hpp"
#include "radiometry/lamps/lamp.hpp"
#include "radiometry/lamps/light_tree.hpp"

namespace nadir::radiometry {

/// The shape of an area lamp in scene axes: where it is, and directions towards it.
///
/// A sphere is sampled uniformly over the cone that it fills; a plane uniformly over its solid
/// angle where that is large, else, like a disc, uniformly over its area.
/// Sources: sphere: Pharr, Jakob & Humphreys, Physically Based Rendering, 3rd ed. (2016), 14.2.2;
/// plane: Urena, Fajardo & King, "An Area-Preserving Parametrization for Spherical Rectangles",
/// Comput. Graph. Forum 32(4), 59 (2013), doi:10.1111/cgf.12151.
class EmittingSurface {
 public:
  /// @throws InputError for degenerate shapes and axes that are not unit and at right angles
  explicit EmittingSurface(const AreaLamp& lamp);

  struct Place {
    Vec3 direction;         ///< unit, from the point to the place
    double distance = 0.0;  ///< m
    double pdf = 0.0;       ///< sr^-1, > 0 and finite
  };
  /// A place whose front faces `position`; none where there is none, or where it would touch.
  [[nodiscard]] std::optional<Place> sample(Vec3 position, Vec2 u) const noexcept;
  /// Density of `sample` for a unit direction that meets the front at `on_lamp`; 0 from behind.
  [[nodiscard]] double pdf(Vec3 position, Vec3 direction, Vec3 on_lamp) const noexcept;
  /// Whether a ray that meets the surface at `on_lamp` comes from its front.
  [[nodiscard]] bool seen_from_front(Vec3 direction, Vec3 on_lamp) const noexcept;

  [[nodiscard]] double area() const noexcept { return area_; }
  /// Bounds for the hierarchy; the weight is left at 0.
  [[nodiscard]] LightTreeItem bound() const noexcept;

 private:
  enum class Kind { disc, plane, sphere };

  void place(const geometry::Disc& disc);
  void place(const geometry::Plane& plane);
  void place(const geometry::Sphere& sphere);
  [[nodiscard]] std::optional<Place> sample_sphere(Vec3 position, Vec2 u) const noexcept;
  [[nodiscard]] std::optional<Place> sample_area(Vec3 position, Vec2 u) const noexcept;
  [[nodiscard]] double cone_pdf(Vec3 position) const noexcept;
  [[nodiscard]] double area_pdf(Vec3 towards, double distance2) const noexcept;

  Kind kind_ = Kind::disc;
  Vec3 centre_;  // of the shape itself
  Vec3 x_, y_, normal_;
  double half_x_ = 0.0, half_y_ = 0.0;  // of a plane
  double radius_ = 0.0;                 // of a disc or sphere
  double area_ = 0.0;
};

}  // namespace nadir::radiometry
