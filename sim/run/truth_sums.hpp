#pragma once

#include <cstdint>
#include <vector>

#include "geometry/earth.hpp"
#include "radiometry/lit_scene.hpp"
#include "sim/run/image.hpp"

namespace nadir::sim {

/// Which truth planes are filled, and what their computation needs.
struct TruthOptions {
  bool planes = true;                           ///< all but those that follow
  bool sky_view = false;                        ///< costs a ray a path
  bool fractions = false;                       ///< one plane a material
  bool heat = true;                             ///< solve temperatures that no band asked for
  const geometry::LocalFrame* frame = nullptr;  ///< of the scene; null: no places on the earth
};

/// What the paths of one pixel saw. One for each thread; a pixel allocates nothing.
class TruthSums {
 public:
  TruthSums(const radiometry::SceneDescription& scene, const TruthOptions& options);

  void begin_pixel();
  /// @param hit  its material resolved; null: the path meets no surface
  void add(const geometry::Ray& ray, const geometry::Hit* hit, const Sampler& numbers);
  /// Writes the pixel into the planes of a strip that `prepare` has made.
  void store(std::size_t pixel, TruthImage& planes) const;
  [[nodiscard]] std::uint64_t rays() const noexcept { return rays_; }

 private:
  [[nodiscard]] const ephemeris::LightSource* sun() const;  // or null
  void add_surface(const geometry::Ray& ray, const geometry::Hit& hit, const Sampler& numbers);
  void add_sun(const geometry::Hit& hit);
  void store_ids(std::size_t pixel, TruthImage& planes) const;
  void store_place(std::size_t pixel, TruthImage& planes) const;

  struct Sums {
    std::uint32_t paths = 0, hits = 0;
    std::uint32_t with_temperature = 0;  // fewer where nobody asked for some
    double range_m = 0.0, temperature_k = 0.0, sun_elevation_deg = 0.0, shadow = 0.0, sky = 0.0;
    Vec3 normal, position, towards_sensor;
  };
  const radiometry::SceneDescription* scene_;
  TruthOptions options_;
  Sums sums_;
  std::vector<std::uint32_t> material_votes_;  // the sky first, then one a material
  struct Vote {
    std::uint32_t object, count;
  };
  std::vector<Vote> object_votes_;  // those seen in this pixel
  std::uint64_t rays_ = 0;
};

/// Gives a strip's truth its planes, of the size of its pixels.
/// @param object_names  by object number
void prepare(TruthImage& planes, std::size_t pixels, const radiometry::SceneDescription& scene,
             const std::vector<std::string>& object_names, const TruthOptions& options);

}  // namespace nadir::sim
