#include "geometry/shapes.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "geometry/shape_hit.hpp"

namespace nadir::geometry {
namespace {

void require(bool good, const std::string& message) {
  if (!good) throw InputError{message};
}
bool is_size(double value_m) { return std::isfinite(value_m) && value_m > 0.0; }

void check(const Sphere& s) {
  require(is_finite(s.centre), "sphere: the centre must be finite");
  require(is_size(s.radius), "sphere: the radius must be a positive number of metres");
}
void check(const Disc& d) {
  require(is_finite(d.centre), "disc: the centre must be finite");
  require(is_finite(d.normal) && length(d.normal) > 0.0, "disc: the normal must not be zero");
  require(is_size(d.radius), "disc: the radius must be a positive number of metres");
}
void check(const Box& b) {
  require(is_finite(b.lo) && is_finite(b.hi), "box: the corners must be finite");
  require(b.lo.x < b.hi.x && b.lo.y < b.hi.y && b.lo.z < b.hi.z,
          "box: every coordinate of the low corner must be below that of the high corner");
}
void check(const Plane& p) {
  require(is_finite(p.centre), "plane: the centre must be finite");
  require(is_size(p.size_x) && is_size(p.size_y),
          "plane: both sizes must be positive numbers of metres");
}
void check(const Cylinder& c) {
  require(is_finite(c.base) && is_finite(c.top), "cylinder: base and top must be finite");
  require(length(c.top - c.base) > 0.0, "cylinder: base and top must differ");
  require(is_size(c.radius), "cylinder: the radius must be a positive number of metres");
}

}  // namespace

void validate(const Shape& shape) {
  std::visit([](const auto& s) { check(s); }, shape);
}

}  // namespace nadir::geometry
