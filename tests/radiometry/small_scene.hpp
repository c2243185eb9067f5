#pragma once

#include <numbers>
#include <utility>
#include <vector>

#include "core/frame.hpp"
#include "core/statistics.hpp"
#include "geometry/scene_builder.hpp"
#include "radiometry/generic_solver.hpp"
#include "radiometry/path_solver.hpp"
#include "spectral/planck.hpp"

namespace nadir::radiometry::test {

/// A material with the same reflectance at all wavelengths; emissivity by Kirchhoff's law.
inline materials::Material grey(double reflectance) {
  materials::Material material;
  material.name = "grey";
  material.reflectance = spectral::Curve::constant(reflectance);
  return material;
}

/// Shapes, materials and light for a closed-form test.
class SmallScene {
 public:
  /// Adds a material at a temperature and returns its index.
  std::uint32_t material(const materials::Material& m, Kelvin temperature) {
    return material(m, thermal::TemperatureSource{thermal::ConstantTemperature{temperature}});
  }
  std::uint32_t material(const materials::Material& m, thermal::TemperatureSource temperature) {
    materials_.push_back(m);
    temperatures_.push_back(std::move(temperature));
    return static_cast<std::uint32_t>(materials_.size() - 1);
  }
  void add(const geometry::Shape& shape, std::uint32_t material) {
    builder_.add({shape, {material}}, Affine{}, object_++);
  }
  void add(const geometry::TriangleMesh& mesh, std::uint32_t material) {
    builder_.add({mesh, {material}}, Affine{}, object_++);
  }
  /// Adds the front of a disc as a lamp whose surface has that radiance.
  void add_disc_lamp(const geometry::Disc& disc, double radiance, std::uint32_t material) {
    AreaLamp lamp;
    lamp.surface = disc;
    lamp.object = object_;
    const double factor = std::numbers::pi * std::numbers::pi * disc.radius * disc.radius;
    lamps.push_back({"disc", lamp, spectral::Curve::constant(radiance * factor)});
    add(disc, material);
  }
  void add_body(double azimuth_deg, double elevation_deg, double angular_radius_deg,
                double irradiance) {
    illumination_.push_back(
        {"sun", direction_enu(degrees(azimuth_deg).value, degrees(elevation_deg).value),
         degrees(angular_radius_deg), spectral::Curve::constant(irradiance)});
  }
  void sky(double radiance, Kelvin temperature = Kelvin{0.0}) {
    const auto one = spectral::Curve::constant(1.0), none = spectral::Curve::constant(0.0);
    air_ = atmosphere::Uniform{
        spectral::Curve::constant(radiance), temperature, one, one, none, Kelvin{0.0}};
  }
  void overcast(double radiance) {
    sky(radiance);
    std::get<atmosphere::Uniform>(air_).sky_shape = atmosphere::SkyShape::overcast;
  }
  materials::SolverSettings solver;
  Method method = Method::generic;
  int path_max_bounces = 0;
  std::vector<Volume> volumes;
  std::vector<Lamp> lamps;

  SceneDescription build() {
    SceneDescription scene{builder_.build(), materials_, thermal::TemperatureField{temperatures_},
                           illumination_,    air_,       solver};
    scene.method = method;
    scene.path_max_bounces = path_max_bounces;
    scene.volumes = volumes;
    scene.lamps = lamps;
    return scene;
  }

 private:
  geometry::SceneBuilder builder_;
  std::vector<materials::Material> materials_;
  std::vector<thermal::TemperatureSource> temperatures_;
  ephemeris::Illumination illumination_;
  atmosphere::Atmosphere air_ = atmosphere::None{};
  std::uint32_t object_ = 0;
};

/// Mean radiance per lane seen along a ray, with its standard error from replicates.
struct Measured {
  std::vector<Estimate> lanes;
  Counters counters;
};

template <class Solver>
Measured measure_with(Solver solver, const LitScene& lit, const geometry::Ray& ray, int replicates,
                      int samples, std::uint64_t seed) {
  const auto hit = lit.intersect(ray, Sampler{seed, 0});
  std::vector<Welford> spread(static_cast<std::size_t>(lit.lanes().count()));
  for (int r = 0; r < replicates; ++r) {
    spectral::SpectrumSum sum{lit.lanes().count()};
    for (int i = 0; i < samples; ++i) {
      const Sampler numbers{mix(seed, static_cast<std::uint64_t>(r)),
                            static_cast<std::uint32_t>(i)};
      sum.add(solver.aperture_radiance(ray, hit, numbers));
    }
    for (std::size_t lane = 0; lane < spread.size(); ++lane) {
      spread[lane].add(sum[static_cast<int>(lane)] / samples);
    }
  }
  Measured result;
  for (const Welford& w : spread) result.lanes.push_back(w.estimate());
  result.counters = solver.counters();
  return result;
}

/// By the solver that the scene names.
inline Measured measure(const SceneDescription& scene, const spectral::Lanes& lanes,
                        const geometry::Ray& ray, int replicates, int samples,
                        std::uint64_t seed = 1) {
  Diagnostics diagnostics;
  const LitScene lit{scene, lanes, diagnostics};
  if (scene.method == Method::path) {
    return measure_with(PathSolver{lit}, lit, ray, replicates, samples, seed);
  }
  return measure_with(GenericSolver{lit}, lit, ray, replicates, samples, seed);
}

/// The mean over an area: every sample has a ray of its own, that goes through a random place of
/// the unit square. As a sensor's pixel does it.
template <class Solver, class RayOf>
Measured measure_area_with(Solver solver, const LitScene& lit, const RayOf& ray_of, int replicates,
                           int samples) {
  constexpr std::uint32_t place = 99;  // purpose of the random number
  std::vector<Welford> spread(static_cast<std::size_t>(lit.lanes().count()));
  for (int r = 0; r < replicates; ++r) {
    spectral::SpectrumSum sum{lit.lanes().count()};
    for (int i = 0; i < samples; ++i) {
      const Sampler numbers{mix(7, static_cast<std::uint64_t>(r)), static_cast<std::uint32_t>(i)};
      const geometry::Ray ray = ray_of(numbers.point(place));
      sum.add(solver.aperture_radiance(ray, lit.intersect(ray, numbers), numbers.child(0)));
    }
    for (std::size_t lane = 0; lane < spread.size(); ++lane) {
      spread[lane].add(sum[static_cast<int>(lane)] / samples);
    }
  }
  Measured result;
  for (const Welford& w : spread) result.lanes.push_back(w.estimate());
  result.counters = solver.counters();
  return result;
}

/// By the solver that the scene names.
template <class RayOf>
Measured measure_area(const SceneDescription& scene, const spectral::Lanes& lanes,
                      const RayOf& ray_of, int replicates, int samples) {
  Diagnostics diagnostics;
  const LitScene lit{scene, lanes, diagnostics};
  if (scene.method == Method::path) {
    return measure_area_with(PathSolver{lit}, lit, ray_of, replicates, samples);
  }
  return measure_area_with(GenericSolver{lit}, lit, ray_of, replicates, samples);
}

/// A ray straight down onto the origin.
inline geometry::Ray downward(double height_m = 10.0) {
  return {{0.0, 0.0, height_m}, {0.0, 0.0, -1.0}};
}

}  // namespace nadir::radiometry::test
