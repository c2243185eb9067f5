#include "study_scenes.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/error.hpp"
#include "core/frame.hpp"
#include "study_maker.hpp"

namespace nadir::bench {
namespace {

using geometry::Ray;
using geometry::TriangleMesh;
using materials::Material;
using spectral::Curve;

constexpr double pi = std::numbers::pi;

spectral::Lanes solar_lanes() { return spectral::Lanes{steps(0.45, 1.65, 16)}; }
spectral::Lanes thermal_lanes() { return spectral::Lanes{steps(8.0, 12.0, 16)}; }

Material leaf() {
  Material material =
      lambertian(curve({0.45, 0.55, 0.67, 0.76, 1.3, 1.65}, {0.05, 0.12, 0.06, 0.45, 0.44, 0.30}));
  material.transmittance =
      curve({0.45, 0.55, 0.67, 0.76, 1.3, 1.65}, {0.01, 0.08, 0.02, 0.42, 0.42, 0.28});
  material.scattering = materials::Leaf{};
  return material;
}

// ---- the scenes -------------------------------------------------------------------------------

StudyScene open_ground() {
  Maker make;
  make.add(rolling_ground(),
           make.material(lambertian(curve({0.45, 0.7, 1.3, 1.65}, {0.10, 0.22, 0.36, 0.40}))));
  make.sun(140.0, 40.0);
  make.sky(0.04, 0.006);
  return make.finish(
      "ground",
      "Open ground: soil of reflectance 0.10 to 0.40, waves of 1 m, sun at 40 deg, even blue sky",
      solar_lanes(), from_above(60.0, 50.0));
}

StudyScene street_canyon() {
  constexpr double half_width_m = 8.0, height_m = 20.0, half_length_m = 100.0;
  Maker make;
  make.add(geometry::Plane{{}, 400.0, 400.0}, make.material(grey(0.2)));
  const auto wall = make.material(lambertian(curve({0.45, 0.7, 1.65}, {0.42, 0.52, 0.55})));
  make.add(walls({-30.0, -half_length_m, 0.0}, {-half_width_m, half_length_m, height_m}, true),
           wall);
  make.add(walls({half_width_m, -half_length_m, 0.0}, {30.0, half_length_m, height_m}, true), wall);
  make.sun(130.0, 55.0);
  make.sky(0.04, 0.006);
  Rng rng{12};
  std::vector<Ray> views;
  for (int i = 0; i < view_count; ++i) {
    const double y = 40.0 * (2.0 * rng.next() - 1.0), across = 2.0 * rng.next() - 1.0;
    const double side = across < 0.0 ? -half_width_m : half_width_m;
    const Vec3 to = i % 2 == 0 ? Vec3{0.9 * half_width_m * across, y, 0.0}
                               : Vec3{side, y, height_m * (0.05 + 0.9 * rng.next())};
    views.push_back(between({0.0, y - 25.0, 45.0}, to));
  }
  return make.finish("canyon",
                     "Street canyon: walls of reflectance 0.42 to 0.55, 20 m high, 16 m apart, "
                     "street 0.2, sun at 55 deg, even blue sky",
                     solar_lanes(), std::move(views));
}

StudyScene forest() {
  Maker make;
  make.add(geometry::Plane{{}, 120.0, 120.0},
           make.material(lambertian(curve({0.45, 0.7, 1.65}, {0.06, 0.14, 0.30}))));
  const std::vector<geometry::Surface> tree{
      {crown({0.0, 0.0, 6.0}, 2.5), {make.material(leaf())}},
      {geometry::Cylinder{{}, {0.0, 0.0, 6.0}, 0.15, false},
       {make.material(lambertian(curve({0.45, 0.7, 1.65}, {0.10, 0.20, 0.35})))}}};
  Rng rng{13};
  std::vector<Affine> places;
  for (int row = -8; row < 8; ++row) {
    for (int column = -8; column < 8; ++column) {
      Affine place{rotation({0.0, 0.0, 1.0}, 2.0 * pi * rng.next()), {}};
      const double x = rng.next(), y = rng.next();
      place.origin = {4.5 * (column + x), 4.5 * (row + y), 0.0};
      places.push_back(place);
    }
  }
  make.add_trees(tree, places);
  make.sun(160.0, 50.0);
  make.sky(0.04, 0.006);
  return make.finish("forest",
                     "Forest: 256 trees of 1200 bi-Lambertian leaves (rho + tau 0.06 at 0.45 um to "
                     "0.87 at 0.77 um), sun at 50 deg, even blue sky",
                     solar_lanes(), from_above(15.0, 40.0));
}

StudyScene glossy_roof() {
  Maker make;
  make.add(geometry::Plane{{}, 200.0, 200.0},
           make.material(lambertian(curve({0.45, 0.7, 1.65}, {0.08, 0.15, 0.30}))));
  const auto wall = make.material(grey(0.5));
  Material tiles = lambertian(curve({0.45, 0.6, 1.65}, {0.06, 0.25, 0.35}));
  tiles.scattering = materials::Ward{Curve::constant(0.06), 0.15, 0.15, 0.0};
  const Vec3 lo{-5.0, -8.0, 0.0}, hi{5.0, 8.0, 5.0};
  make.add(walls(lo, hi, false), wall);
  make.add(gable(lo, hi, 8.0), make.material(tiles));
  make.add(walls({9.0, -10.0, 0.0}, {17.0, 10.0, 14.0}, true), wall);  // mirrored in the roof
  make.sun(250.0, 45.0);
  make.sky(0.02, 0.06, atmosphere::SkyShape::overcast);
  Rng rng{14};
  std::vector<Ray> views;
  for (int i = 0; i < view_count; ++i) {
    const double side = i % 2 == 0 ? -1.0 : 1.0, x = 0.5 + 4.0 * rng.next();
    const Vec3 to{side * x, 7.0 * (2.0 * rng.next() - 1.0), 8.0 - 0.6 * x};
    const double elevation = degrees(side < 0.0 ? 15.0 + 70.0 * rng.next() : 70.0).value;
    const double azimuth = degrees(side < 0.0 ? 200.0 + 160.0 * rng.next() : 290.0).value;
    views.push_back(between(to + 60.0 * direction_enu(azimuth, elevation), to));
  }
  return make.finish("roof",
                     "Glossy roof: Ward lobe (rho_s 0.06, alpha 0.15) on tiles of reflectance 0.06 "
                     "to 0.35, beside a white wall; sun at 45 deg, overcast sky",
                     solar_lanes(), std::move(views));
}

/// Walls whose reflectance grows from 0.2 at 8 um to 0.8 at 12 um, 300 K.
StudyScene closed_furnace() {
  Maker make;
  make.add(geometry::Sphere{{}, 5.0},
           make.material(lambertian(curve({8.0, 12.0}, {0.2, 0.8})), Kelvin{300.0}));
  Rng rng{15};
  std::vector<Ray> views;
  for (int i = 0; i < view_count; ++i) {
    const Vec3 from = 3.0 * random_direction(rng);
    views.push_back({from, random_direction(rng)});
  }
  return make.finish(
      "furnace",
      "Closed furnace: reflectance 0.2 at 8 um to 0.8 at 12 um, 300 K; the truth is the black body",
      thermal_lanes(), std::move(views));
}

StudyScene open_furnace() {
  Maker make;
  const auto wall = make.material(lambertian(curve({8.0, 12.0}, {0.2, 0.8})), Kelvin{300.0});
  make.add(walls({-1.0, -1.0, 0.0}, {1.0, 1.0, 2.0}, false), wall);
  make.add(geometry::Plane{{}, 2.0, 2.0}, wall);
  constexpr double hole = 0.4;
  TriangleMesh lid;
  const double strips[][4] = {{-1.0, -1.0, 1.0, -hole},
                              {-1.0, hole, 1.0, 1.0},
                              {-1.0, -hole, -hole, hole},
                              {hole, -hole, 1.0, hole}};
  for (const auto& s : strips) {
    add_quad(lid, {{{s[0], s[1], 2.0}, {s[2], s[1], 2.0}, {s[2], s[3], 2.0}, {s[0], s[3], 2.0}}});
  }
  make.add(lid, wall);
  make.thermal_sky(Kelvin{220.0});
  Rng rng{16};
  std::vector<Ray> views;
  for (int i = 0; i < view_count; ++i) {
    const double x = rng.next(), y = rng.next();
    const Vec3 through{hole * (1.8 * x - 0.9), hole * (1.8 * y - 0.9), 2.0};
    const double azimuth = 2.0 * pi * rng.next(), elevation = 0.4 + 1.1 * rng.next();
    views.push_back(between(through + 3.0 * direction_enu(azimuth, elevation), through));
  }
  return make.finish("opening",
                     "Furnace with an opening: the same walls as a box with 16 % of its lid open "
                     "to a sky of 220 K, seen through it",
                     thermal_lanes(), std::move(views));
}

void add_village(Maker& make) {
  const auto wall = make.material(
      lambertian(curve({0.4, 0.8, 8.0, 12.0}, {0.45, 0.55, 0.08, 0.05})), Kelvin{284.0});
  const auto roof = make.material(
      lambertian(curve({0.4, 0.8, 8.0, 12.0}, {0.15, 0.25, 0.10, 0.07})), Kelvin{274.0});
  const auto cover = make.material(grey(0.1), Kelvin{285.0});
  const Curve white = curve({0.4, 0.55, 0.75, 0.8, 14.0}, {20.0, 45.0, 30.0, 0.0, 0.0});
  const Curve warm = curve({0.4, 0.55, 0.75, 0.8, 14.0}, {1.0, 5.0, 9.0, 0.0, 0.0});
  for (int row = -2; row < 2; ++row) {
    for (int column = -2; column < 2; ++column) {
      const Vec3 lo{18.0 * column + 4.0, 18.0 * row + 4.0, 0.0};
      const Vec3 hi = lo + Vec3{8.0, 10.0, 4.0 + 0.5 * ((row + column) & 1)};
      make.add(walls(lo, hi, false), wall);
      make.add(gable(lo, hi, hi.z + 2.5), roof);
      make.add_lamp(geometry::Disc{{lo.x + 4.0, lo.y - 0.3, 2.6}, {0.0, 0.0, -1.0}, 0.2}, warm,
                    cover);
      make.add_lamp(radiometry::PointLamp{.position = {lo.x - 4.0, lo.y + 5.0, 5.0},
                                          .shape = radiometry::CosinePower{1.0, 1.4}},
                    white);
    }
  }
}

StudyScene night_village() {
  Maker make;
  make.add(geometry::Plane{{}, 300.0, 300.0},
           make.material(lambertian(curve({0.4, 0.8, 8.0, 12.0}, {0.10, 0.20, 0.06, 0.04})),
                         Kelvin{279.0}));
  add_village(make);
  make.thermal_sky(Kelvin{245.0});
  std::vector<Micrometres> both = steps(0.45, 0.70, 8);
  for (const Micrometres lambda : steps(8.0, 12.0, 8)) both.push_back(lambda);
  StudyScene scene = make.finish("night",
                                 "Night village: 16 houses, 16 street lamps (points), 16 porch "
                                 "lamps (discs), walls 0.5 and 284 K, roofs 274 K, sky 245 K",
                                 spectral::Lanes{both}, from_above(30.0, 60.0));
  scene.groups = {{"0.45 to 0.70 um, lamps", 0, 8}, {"8 to 12 um, thermal", 8, 8}};
  return scene;
}

struct Entry {
  const char* name;
  StudyScene (*build)();
};
constexpr Entry entries[] = {{"ground", open_ground},     {"canyon", street_canyon},
                             {"forest", forest},          {"roof", glossy_roof},
                             {"furnace", closed_furnace}, {"opening", open_furnace},
                             {"night", night_village}};

}  // namespace

const std::vector<std::string>& study_scene_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Entry& entry : entries) all.emplace_back(entry.name);
    return all;
  }();
  return names;
}

StudyScene study_scene(const std::string& name) {
  for (const Entry& entry : entries) {
    if (name == entry.name) return entry.build();
  }
  throw InputError{"no scene \"" + name +
                   "\"; there are ground, canyon, forest, roof, furnace, opening, night"};
}

}  // namespace nadir::bench
