#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "geometry/scene_builder.hpp"
#include "study_scenes.hpp"

// What the scenes of the study are put together from: spectra, shapes, and a scene in the making.

namespace nadir::bench {

inline constexpr int view_count = 64;

/// `count` wavelengths at equal steps, both ends included.
[[nodiscard]] std::vector<Micrometres> steps(double first_um, double last_um, int count);
/// Linear between the points, held outside.
[[nodiscard]] spectral::Curve curve(std::vector<double> at_um, std::vector<double> value);
[[nodiscard]] materials::Material lambertian(const spectral::Curve& reflectance);
[[nodiscard]] materials::Material grey(double reflectance);

/// Adds a rectangle; its normal is that of its corners going round anticlockwise.
void add_quad(geometry::TriangleMesh& mesh, const std::array<Vec3, 4>& corners);
/// The sides of a box and, if wanted, its top; normals point out.
[[nodiscard]] geometry::TriangleMesh walls(Vec3 lo, Vec3 hi, bool top);
/// Two slopes above a box whose top is at hi.z, the ridge along y.
[[nodiscard]] geometry::TriangleMesh gable(Vec3 lo, Vec3 hi, double ridge_z);
/// Waves of 25 to 40 m length that are a metre high, 200 m x 200 m.
[[nodiscard]] geometry::TriangleMesh rolling_ground();
/// 1200 round leaves (of eight corners) at random in a ball, turned at random.
[[nodiscard]] geometry::TriangleMesh crown(Vec3 centre, double radius);

[[nodiscard]] Vec3 random_direction(Rng& rng);
[[nodiscard]] geometry::Ray between(Vec3 from, Vec3 to);
/// Onto places of a level square about the origin, from all azimuths and up to `zenith_deg`.
[[nodiscard]] std::vector<geometry::Ray> from_above(double half_width_m, double zenith_deg);

/// A scene in the making.
class Maker {
 public:
  std::uint32_t material(const materials::Material& material, Kelvin temperature = Kelvin{295.0}) {
    materials_.push_back(material);
    temperatures_.emplace_back(thermal::ConstantTemperature{temperature});
    return static_cast<std::uint32_t>(materials_.size() - 1);
  }
  void add(const geometry::TriangleMesh& mesh, std::uint32_t material) {
    builder_.add({mesh, {material}}, Affine{}, object_++);
  }
  void add(const geometry::Shape& shape, std::uint32_t material) {
    builder_.add({shape, {material}}, Affine{}, object_++);
  }
  void add_trees(const std::vector<geometry::Surface>& tree, const std::vector<Affine>& places) {
    builder_.add_instances(tree, places, object_++);
  }
  void add_lamp(const geometry::Disc& disc, const spectral::Curve& flux, std::uint32_t material) {
    radiometry::AreaLamp lamp;
    lamp.surface = disc;
    lamp.object = object_;
    lamps_.push_back({"disc", lamp, flux});
    add(disc, material);
  }
  void add_lamp(const radiometry::PointLamp& lamp, const spectral::Curve& flux) {
    lamps_.push_back({"point", lamp, flux});
  }
  void sun(double azimuth_deg, double elevation_deg);
  /// Blue by `blue`, white by `white`: radiance as a share of the sun's irradiance.
  void sky(double blue, double white, atmosphere::SkyShape shape = atmosphere::SkyShape::even);
  void thermal_sky(Kelvin temperature) { air(spectral::Curve::constant(0.0), temperature); }

  [[nodiscard]] StudyScene finish(std::string name, std::string title, const spectral::Lanes& lanes,
                                  std::vector<geometry::Ray> views);

 private:
  void air(const spectral::Curve& sky_radiance, Kelvin sky_temperature);

  geometry::SceneBuilder builder_;
  std::vector<materials::Material> materials_;
  std::vector<thermal::TemperatureSource> temperatures_;
  ephemeris::Illumination illumination_;
  atmosphere::Atmosphere air_ = atmosphere::None{};
  std::vector<radiometry::Lamp> lamps_;
  std::uint32_t object_ = 0;
};

}  // namespace nadir::bench
