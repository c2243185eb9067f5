// Embree divides by zero on purpose: its reciprocal directions are infinite, and so are the bounds
// of an empty node. The linker leads the suite's calls of Embree (-Wl,--wrap) through here, where
// traps are off; our callbacks, which Embree calls, run with traps again. The product has no part
// in it and pays nothing.
#include <utility>

#include "support/floating_point_traps.hpp"

#if NADIR_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace {

using nadir::support::floating_point_is_trapped;
using nadir::support::ignore_floating_point;
using nadir::support::trap_floating_point;
using nadir::support::WithoutTraps;

/// Whether the call of Embree under way came from code that traps.
thread_local bool ours_traps = false;

/// A call of Embree: not ours.
class Shield {
 public:
  Shield() : before_{std::exchange(ours_traps, floating_point_is_trapped())} {}
  ~Shield() { ours_traps = before_; }
  Shield(const Shield&) = delete;
  Shield& operator=(const Shield&) = delete;

 private:
  bool before_;
  WithoutTraps without_;
};

/// A call of Embree's back: ours.
class Ours {
 public:
  Ours() {
    if (ours_traps) trap_floating_point();
  }
  ~Ours() { ignore_floating_point(); }
  Ours(const Ours&) = delete;
  Ours& operator=(const Ours&) = delete;
};

// One function of ours for each kind of callback, whichever scene it belongs to.
RTCBoundsFunction our_bounds = nullptr;
RTCIntersectFunctionN our_intersect = nullptr;
RTCOccludedFunctionN our_occluded = nullptr;
thread_local RTCFilterFunctionN our_filter = nullptr;

void call_bounds(const RTCBoundsFunctionArguments* arguments) {
  const Ours ours;
  our_bounds(arguments);
}
void call_intersect(const RTCIntersectFunctionNArguments* arguments) {
  const Ours ours;
  our_intersect(arguments);
}
void call_occluded(const RTCOccludedFunctionNArguments* arguments) {
  const Ours ours;
  our_occluded(arguments);
}
void call_filter(const RTCFilterFunctionNArguments* arguments) {
  const Ours ours;
  our_filter(arguments);
}

/// Puts ours behind the shield's, where there is one.
void lead_back(RTCFilterFunctionN& filter) {
  our_filter = filter;
  if (filter != nullptr) filter = call_filter;
}

}  // namespace

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): the linker's names
extern "C" {

RTCDevice __real_rtcNewDevice(const char* config);
RTCDevice __wrap_rtcNewDevice(const char* config) {
  const Shield shield;
  return __real_rtcNewDevice(config);
}

void __real_rtcCommitGeometry(RTCGeometry geometry);
void __wrap_rtcCommitGeometry(RTCGeometry geometry) {
  const Shield shield;
  __real_rtcCommitGeometry(geometry);
}

void __real_rtcCommitScene(RTCScene scene);
void __wrap_rtcCommitScene(RTCScene scene) {
  const Shield shield;
  __real_rtcCommitScene(scene);
}

void __real_rtcSetGeometryTransform(RTCGeometry geometry, unsigned step, RTCFormat format,
                                    const void* transform);
void __wrap_rtcSetGeometryTransform(RTCGeometry geometry, unsigned step, RTCFormat format,
                                    const void* transform) {
  const Shield shield;
  __real_rtcSetGeometryTransform(geometry, step, format, transform);
}

void __real_rtcSetGeometryBoundsFunction(RTCGeometry geometry, RTCBoundsFunction bounds,
                                         void* user);
void __wrap_rtcSetGeometryBoundsFunction(RTCGeometry geometry, RTCBoundsFunction bounds,
                                         void* user) {
  our_bounds = bounds;
  __real_rtcSetGeometryBoundsFunction(geometry, call_bounds, user);
}

void __real_rtcSetGeometryIntersectFunction(RTCGeometry geometry, RTCIntersectFunctionN intersect);
void __wrap_rtcSetGeometryIntersectFunction(RTCGeometry geometry, RTCIntersectFunctionN intersect) {
  our_intersect = intersect;
  __real_rtcSetGeometryIntersectFunction(geometry, call_intersect);
}

void __real_rtcSetGeometryOccludedFunction(RTCGeometry geometry, RTCOccludedFunctionN occluded);
void __wrap_rtcSetGeometryOccludedFunction(RTCGeometry geometry, RTCOccludedFunctionN occluded) {
  our_occluded = occluded;
  __real_rtcSetGeometryOccludedFunction(geometry, call_occluded);
}

#if NADIR_EMBREE == 4

void __real_rtcIntersect1(RTCScene scene, RTCRayHit* ray, RTCIntersectArguments* arguments);
void __wrap_rtcIntersect1(RTCScene scene, RTCRayHit* ray, RTCIntersectArguments* arguments) {
  const Shield shield;
  if (arguments != nullptr) lead_back(arguments->filter);
  __real_rtcIntersect1(scene, ray, arguments);
}

void __real_rtcOccluded1(RTCScene scene, RTCRay* ray, RTCOccludedArguments* arguments);
void __wrap_rtcOccluded1(RTCScene scene, RTCRay* ray, RTCOccludedArguments* arguments) {
  const Shield shield;
  if (arguments != nullptr) lead_back(arguments->filter);
  __real_rtcOccluded1(scene, ray, arguments);
}

#else

void __real_rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray);
void __wrap_rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray) {
  const Shield shield;
  lead_back(context->filter);
  __real_rtcIntersect1(scene, context, ray);
}

void __real_rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray);
void __wrap_rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
  const Shield shield;
  lead_back(context->filter);
  __real_rtcOccluded1(scene, context, ray);
}

#endif

}  // extern "C"
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
