#pragma once
// Private to this folder: Embree 3 and Embree 4 under one face. Nothing else names a version.

#include <memory>
#include <type_traits>

#if NADIR_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace nadir::geometry::embree {

template <class Handle, void (*release)(Handle)>
struct Releaser {
  using pointer = Handle;
  void operator()(Handle handle) const { release(handle); }
};
using Device =
    std::unique_ptr<std::remove_pointer_t<RTCDevice>, Releaser<RTCDevice, rtcReleaseDevice>>;
using SceneHandle =
    std::unique_ptr<std::remove_pointer_t<RTCScene>, Releaser<RTCScene, rtcReleaseScene>>;
using GeometryHandle =
    std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Releaser<RTCGeometry, rtcReleaseGeometry>>;

#if NADIR_EMBREE == 4

using Context = RTCRayQueryContext;
inline constexpr RTCSceneFlags filter_from_caller = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;
inline constexpr auto call_filter = static_cast<RTCRayQueryFlags>(
    RTC_RAY_QUERY_FLAG_INCOHERENT | RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER);

inline void initialise(Context& context) { rtcInitRayQueryContext(&context); }

inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray, RTCFilterFunctionN filter) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  arguments.filter = filter;
  if (filter) arguments.flags = call_filter;
  rtcIntersect1(scene, &ray, &arguments);
}

inline void occluded(RTCScene scene, Context& context, RTCRay& ray, RTCFilterFunctionN filter) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  arguments.filter = filter;
  if (filter) arguments.flags = call_filter;
  rtcOccluded1(scene, &ray, &arguments);
}

#else

using Context = RTCIntersectContext;
inline constexpr RTCSceneFlags filter_from_caller = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

inline void initialise(Context& context) { rtcInitIntersectContext(&context); }

inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray, RTCFilterFunctionN filter) {
  context.filter = filter;
  rtcIntersect1(scene, &context, &ray);
}

inline void occluded(RTCScene scene, Context& context, RTCRay& ray, RTCFilterFunctionN filter) {
  context.filter = filter;
  rtcOccluded1(scene, &context, &ray);
}

#endif

}  // namespace nadir::geometry::embree
