#include "study_maker.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/frame.hpp"
#include "spectral/planck.hpp"

namespace nadir::bench {

using geometry::Ray;
using geometry::TriangleMesh;
using materials::Material;
using spectral::Curve;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double sun_radius_deg = 0.266;

/// A black body of 5772 K as large as the sun, behind air that lets 80 % through.
double sunlight(double lambda_um) {
  const double sine = std::sin(degrees(sun_radius_deg).value);
  return 0.8 * pi * sine * sine * spectral::planck(Micrometres{lambda_um}, Kelvin{5772.0}).value;
}
template <class F>
Curve solar_curve(const F& value) {
  std::vector<double> at, values;
  for (const Micrometres lambda : steps(0.4, 1.7, 66)) {
    at.push_back(lambda.value);
    values.push_back(value(lambda.value));
  }
  return curve(std::move(at), std::move(values));
}

}  // namespace

// ---- spectra and materials --------------------------------------------------------------------

std::vector<Micrometres> steps(double first_um, double last_um, int count) {
  std::vector<Micrometres> wavelengths;
  for (int i = 0; i < count; ++i) {
    wavelengths.emplace_back(first_um + (last_um - first_um) * i / (count - 1));
  }
  return wavelengths;
}

Curve curve(std::vector<double> at_um, std::vector<double> value) {
  return {std::move(at_um), std::move(value), spectral::Outside::hold};
}

Material lambertian(const Curve& reflectance) {
  Material material;
  material.name = "diffuse";
  material.reflectance = reflectance;
  return material;
}
Material grey(double reflectance) { return lambertian(Curve::constant(reflectance)); }

// ---- shapes -----------------------------------------------------------------------------------

void add_quad(TriangleMesh& mesh, const std::array<Vec3, 4>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

TriangleMesh walls(Vec3 lo, Vec3 hi, bool top) {
  TriangleMesh mesh;
  const Vec2 corner[] = {{lo.x, lo.y}, {hi.x, lo.y}, {hi.x, hi.y}, {lo.x, hi.y}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 a = corner[i], b = corner[(i + 1) % 4];
    add_quad(mesh, {{{a.x, a.y, lo.z}, {b.x, b.y, lo.z}, {b.x, b.y, hi.z}, {a.x, a.y, hi.z}}});
  }
  if (top) {
    add_quad(mesh,
             {{{lo.x, lo.y, hi.z}, {hi.x, lo.y, hi.z}, {hi.x, hi.y, hi.z}, {lo.x, hi.y, hi.z}}});
  }
  return mesh;
}

TriangleMesh gable(Vec3 lo, Vec3 hi, double ridge_z) {
  TriangleMesh mesh;
  const double x = 0.5 * (lo.x + hi.x);
  add_quad(mesh,
           {{{lo.x, hi.y, hi.z}, {lo.x, lo.y, hi.z}, {x, lo.y, ridge_z}, {x, hi.y, ridge_z}}});
  add_quad(mesh,
           {{{hi.x, lo.y, hi.z}, {hi.x, hi.y, hi.z}, {x, hi.y, ridge_z}, {x, lo.y, ridge_z}}});
  for (const double y : {lo.y, hi.y}) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(),
                          {{lo.x, y, hi.z}, {hi.x, y, hi.z}, {x, y, ridge_z}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TriangleMesh rolling_ground() {
  constexpr int cells = 100, half = cells / 2;
  constexpr double cell_m = 2.0;
  TriangleMesh mesh;
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const double x = cell_m * (column - half), y = cell_m * (row - half);
      const double z =
          0.8 * std::sin(x / 6.0) * std::cos(y / 5.0) + 0.3 * std::sin(0.5 * x + y / 2.3);
      mesh.positions.push_back({x, y, z});
    }
  }
  constexpr std::uint32_t side = cells + 1;
  for (std::uint32_t row = 0; row < cells; ++row) {
    for (std::uint32_t column = 0; column < cells; ++column) {
      const std::uint32_t a = row * side + column;
      mesh.triangles.push_back({a, a + 1, a + side + 1});
      mesh.triangles.push_back({a, a + side + 1, a + side});
    }
  }
  return mesh;
}

Vec3 random_direction(Rng& rng) {
  const double mu = 2.0 * rng.next() - 1.0, phi = 2.0 * pi * rng.next();
  const double sine = std::sqrt(1.0 - mu * mu);
  return {sine * std::cos(phi), sine * std::sin(phi), mu};
}

TriangleMesh crown(Vec3 centre, double radius) {
  constexpr int leaves = 1200, corners = 8;
  constexpr double leaf_m = 0.12;
  Rng rng{2024};
  TriangleMesh mesh;
  for (int i = 0; i < leaves; ++i) {
    const Vec3 middle = centre + radius * std::cbrt(rng.next()) * random_direction(rng);
    const Frame frame = frame_about(random_direction(rng));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t k = 0; k < corners; ++k) {
      const double turn = 2.0 * pi * k / corners;
      mesh.positions.push_back(middle +
                               leaf_m * (std::cos(turn) * frame.x + std::sin(turn) * frame.y));
      if (k >= 2) mesh.triangles.push_back({first, first + k - 1, first + k});
    }
  }
  return mesh;
}

Ray between(Vec3 from, Vec3 to) { return {from, normalised(to - from)}; }

std::vector<Ray> from_above(double half_width_m, double zenith_deg) {
  constexpr double height_m = 200.0;
  Rng rng{11};
  std::vector<Ray> views;
  for (int i = 0; i < view_count; ++i) {
    const double x = half_width_m * (2.0 * rng.next() - 1.0);
    const double y = half_width_m * (2.0 * rng.next() - 1.0);
    const double azimuth = 2.0 * pi * rng.next();
    const double zenith = degrees(zenith_deg * rng.next()).value;
    const Vec3 up = direction_enu(azimuth, 0.5 * pi - zenith), to{x, y, 0.0};
    views.push_back(between(to + (height_m / up.z) * up, to));
  }
  return views;
}

// ---- a scene in the making --------------------------------------------------------------------

void Maker::sun(double azimuth_deg, double elevation_deg) {
  illumination_.push_back({"sun",
                           direction_enu(degrees(azimuth_deg).value, degrees(elevation_deg).value),
                           degrees(sun_radius_deg), solar_curve(sunlight)});
}
void Maker::sky(double blue, double white, atmosphere::SkyShape shape) {
  air(solar_curve(
          [&](double um) { return sunlight(um) * (blue * std::pow(0.55 / um, 3.0) + white); }),
      Kelvin{0.0});
  std::get<atmosphere::Uniform>(air_).sky_shape = shape;
}

StudyScene Maker::finish(std::string name, std::string title, const spectral::Lanes& lanes,
                         std::vector<Ray> views) {
  radiometry::SceneDescription description{
      builder_.build(), materials_, thermal::TemperatureField{temperatures_},
      illumination_,    air_,       {}};
  description.lamps = lamps_;
  return {std::move(name), std::move(title),         std::move(description),
          lanes,           {{"", 0, lanes.count()}}, std::move(views)};
}

void Maker::air(const Curve& sky_radiance, Kelvin sky_temperature) {
  const Curve one = Curve::constant(1.0), none = Curve::constant(0.0);
  air_ = atmosphere::Uniform{sky_radiance, sky_temperature, one, one, none, Kelvin{0.0}};
}

}  // namespace nadir::bench
