#include "ray_tape.hpp"

namespace nadir::bench {
namespace {

thread_local RayTape* current_tape = nullptr;

void note(RTCScene scene, const RTCRay& ray, bool any_hit) {
  if (current_tape != nullptr) current_tape->add(scene, ray, any_hit);
}

}  // namespace

void RayTape::add(RTCScene scene, const RTCRay& ray, bool any_hit) {
  scene_ = scene;
  ++calls_;
  if (!entries_.empty()) {
    const RTCRay& last = entries_.back().ray;
    const bool again =
        last.dir_x == ray.dir_x && last.dir_y == ray.dir_y && last.dir_z == ray.dir_z;
    if (again && entries_.back().any_hit == any_hit) return;
  }
  entries_.push_back({ray, any_hit});
}

std::uint64_t RayTape::replay() const {
  geometry::embree::Context context;
  geometry::embree::initialise(context);
  std::uint64_t hits = 0;
  for (const Entry& entry : entries_) {
    if (entry.any_hit) {
      RTCRay ray = entry.ray;
      geometry::embree::occluded(scene_, context, ray, nullptr);
      hits += ray.tfar < 0.0F ? 1 : 0;
    } else {
      RTCRayHit ray;
      ray.ray = entry.ray;
      ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      geometry::embree::intersect(scene_, context, ray, nullptr);
      hits += ray.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
    }
  }
  return hits;
}

Recording::Recording(RayTape& tape) noexcept { current_tape = &tape; }
Recording::~Recording() { current_tape = nullptr; }

}  // namespace nadir::bench

// The linker sends every call of Embree through these (--wrap). Not recording costs a load and a
// branch, about a nanosecond of some hundreds.
// NOLINTBEGIN(bugprone-reserved-identifier): the linker prescribes the names
extern "C" {
#if NADIR_EMBREE == 4

void __real_rtcIntersect1(RTCScene, RTCRayHit*, RTCIntersectArguments*);
void __real_rtcOccluded1(RTCScene, RTCRay*, RTCOccludedArguments*);
void __wrap_rtcIntersect1(RTCScene, RTCRayHit*, RTCIntersectArguments*);
void __wrap_rtcOccluded1(RTCScene, RTCRay*, RTCOccludedArguments*);

void __wrap_rtcIntersect1(RTCScene scene, RTCRayHit* ray, RTCIntersectArguments* arguments) {
  nadir::bench::note(scene, ray->ray, false);
  __real_rtcIntersect1(scene, ray, arguments);
}
void __wrap_rtcOccluded1(RTCScene scene, RTCRay* ray, RTCOccludedArguments* arguments) {
  nadir::bench::note(scene, *ray, true);
  __real_rtcOccluded1(scene, ray, arguments);
}

#else

void __real_rtcIntersect1(RTCScene, RTCIntersectContext*, RTCRayHit*);
void __real_rtcOccluded1(RTCScene, RTCIntersectContext*, RTCRay*);
void __wrap_rtcIntersect1(RTCScene, RTCIntersectContext*, RTCRayHit*);
void __wrap_rtcOccluded1(RTCScene, RTCIntersectContext*, RTCRay*);

void __wrap_rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray) {
  nadir::bench::note(scene, ray->ray, false);
  __real_rtcIntersect1(scene, context, ray);
}
void __wrap_rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
  nadir::bench::note(scene, *ray, true);
  __real_rtcOccluded1(scene, context, ray);
}

#endif
}
// NOLINTEND(bugprone-reserved-identifier)
