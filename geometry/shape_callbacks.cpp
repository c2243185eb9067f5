#include <cmath>
#include <limits>

#include "geometry/ray_query.hpp"
#include "geometry/shape_hit.hpp"

namespace nadir::geometry {
namespace {

/// Float bounds that hold the double ones: conversion may round either way.
float below(double v) {
  return std::nextafter(static_cast<float>(v), -std::numeric_limits<float>::infinity());
}
float above(double v) {
  return std::nextafter(static_cast<float>(v), std::numeric_limits<float>::infinity());
}

void bounds_callback(const RTCBoundsFunctionArguments* arguments) {
  const Bounds& b = static_cast<const Item*>(arguments->geometryUserPtr)->shape->padded;
  RTCBounds& out = *arguments->bounds_o;
  out.lower_x = below(b.lo.x);
  out.lower_y = below(b.lo.y);
  out.lower_z = below(b.lo.z);
  out.upper_x = above(b.hi.x);
  out.upper_y = above(b.hi.y);
  out.upper_z = above(b.hi.z);
}

/// Where the double ray meets the shape, as Embree counts distance; negative for not at all.
template <class Arguments>
float distance_to_shape(const Arguments& arguments) {
  const auto& query = *static_cast<const RayQuery*>(arguments.context);
  const Found found{arguments.geomID, query.instID[0], arguments.primID};
  const auto hit = exact_hit(query, found);
  return hit ? static_cast<float>(hit->t + query.set_back) : -1.0F;
}

void intersect_callback(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  auto& rayhit = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);  // one ray a call: N is 1
  const float t = distance_to_shape(*arguments);
  if (t < rayhit.ray.tnear || !(t < rayhit.ray.tfar)) return;
  rayhit.ray.tfar = t;
  rayhit.hit.u = rayhit.hit.v = 0.0F;
  rayhit.hit.Ng_x = rayhit.hit.Ng_y = rayhit.hit.Ng_z = 0.0F;
  rayhit.hit.primID = arguments->primID;
  rayhit.hit.geomID = arguments->geomID;
  rayhit.hit.instID[0] = arguments->context->instID[0];
}

void occluded_callback(const RTCOccludedFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  auto& ray = *reinterpret_cast<RTCRay*>(arguments->ray);
  const float t = distance_to_shape(*arguments);
  if (t < ray.tnear || !(t < ray.tfar)) return;
  ray.tfar = -std::numeric_limits<float>::infinity();
}

}  // namespace

void attach_shape_callbacks(RTCGeometry geometry, const Item* item) {
  rtcSetGeometryUserPrimitiveCount(geometry, 1);
  rtcSetGeometryUserData(geometry, const_cast<Item*>(item));  // handed back, never written to
  rtcSetGeometryBoundsFunction(geometry, bounds_callback, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_callback);
  rtcSetGeometryOccludedFunction(geometry, occluded_callback);
}

}  // namespace nadir::geometry
