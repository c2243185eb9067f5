#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "radiometry/small_scene.hpp"
#include "support/catch.hpp"

// Plates, grooves, street canyons and spheres against published figures and closed forms. Both
// solvers each time; four standard errors, and for the generic solver what its bounces leave out.

namespace nadir::radiometry::test {
namespace {

constexpr double published_pi = std::numbers::pi;
constexpr Method both_published[] = {Method::generic, Method::path};
const spectral::Lanes one_lane_published{{10.0_um}};

const char* name_of(Method method) { return method == Method::path ? "path" : "generic"; }

/// One full sample a hit, followed for long: noise for bias.
materials::SolverSettings long_walks(int mu = 4, int phi = 8) {
  return {.initial_sample_count = 1,
          .sample_decay_rate = 1.0,
          .max_bounces = 60,
          .mu_samples = mu,
          .phi_samples = phi};
}

void check_mean(const Estimate& seen, double expected, double systematic = 1e-5) {
  CAPTURE(seen.mean, seen.standard_error, expected);
  CHECK(seen.standard_error < 0.015 * expected);  // or agreement would be no news
  CHECK(std::abs(seen.mean - expected) < 4.0 * seen.standard_error + systematic * expected);
}

double planck_here(Kelvin temperature) {
  return spectral::planck(one_lane_published[0], temperature).value;
}

/// A rectangle from `corner` along two sides; the front is where a, b and its normal are
/// right-handed.
geometry::TriangleMesh rectangle(Vec3 corner, Vec3 a, Vec3 b) {
  return {{corner, corner + a, corner + a + b, corner + b}, {{0, 1, 2}, {0, 2, 3}}, {}, {}, {}};
}

// A white cold plate opposite a black warm one shows F B, averaged over the plate: what leaves the
// first and meets the second. All else is black and cold.
// Figures: J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors (C-11, C-14,
// C-41), after D. C. Hamilton and W. R. Morgan, NACA TN 2836 (1952), to eight digits.
struct Plates {
  const char* name;
  double figure;
  SmallScene scene;
  Vec3 corner, a, b;  // of the first, seen from just above (it is level)
  bool disc = false;
};

Plates parallel_rectangles(double a, double b, double gap, double figure) {
  Plates plates{"parallel rectangles", figure, {}, {}, {a, 0.0, 0.0}, {0.0, b, 0.0}};
  plates.scene.add(rectangle({}, plates.a, plates.b),
                   plates.scene.material(grey(1.0), Kelvin{0.0}));
  plates.scene.add(rectangle({0.0, 0.0, gap}, plates.b, plates.a),
                   plates.scene.material(grey(0.0), 300.0_K));
  return plates;
}
Plates perpendicular_rectangles(double w, double h, double l, double figure) {
  Plates plates{"perpendicular rectangles", figure, {}, {}, {w, 0.0, 0.0}, {0.0, l, 0.0}};
  plates.scene.add(rectangle({}, plates.a, plates.b),
                   plates.scene.material(grey(1.0), Kelvin{0.0}));
  plates.scene.add(rectangle({}, plates.b, {0.0, 0.0, h}),
                   plates.scene.material(grey(0.0), 300.0_K));
  return plates;
}
Plates parallel_discs(double r1, double r2, double gap, double figure) {
  Plates plates{"discs", figure, {}, {}, {r1, 0.0, 0.0}, {0.0, r1, 0.0}, true};
  plates.scene.add(geometry::Disc{{}, {0.0, 0.0, 1.0}, r1},
                   plates.scene.material(grey(1.0), Kelvin{0.0}));
  plates.scene.add(geometry::Disc{{0.0, 0.0, gap}, {0.0, 0.0, -1.0}, r2},
                   plates.scene.material(grey(0.0), 300.0_K));
  return plates;
}

TEST_CASE("published: plates see each other by the view factors of Hamilton and Morgan",
          "[radiometry][published]") {
  std::vector<Plates> all;
  all.push_back(parallel_rectangles(1.0, 1.0, 1.0, 0.19982490));
  all.push_back(parallel_rectangles(1.0, 1.5, 0.5, 0.47557644));
  all.push_back(parallel_rectangles(2.0, 2.0, 1.0, 0.41525328));
  all.push_back(parallel_rectangles(10.0, 10.0, 1.0, 0.82699452));
  all.push_back(perpendicular_rectangles(1.0, 1.0, 1.0, 0.20004378));
  all.push_back(perpendicular_rectangles(1.0, 2.0, 1.0, 0.23285260));
  all.push_back(perpendicular_rectangles(2.0, 1.0, 1.0, 0.11642630));
  all.push_back(perpendicular_rectangles(0.5, 3.0, 1.0, 0.31960896));
  all.push_back(parallel_discs(1.0, 1.0, 1.0, 0.38196601));
  all.push_back(parallel_discs(1.0, 2.0, 1.0, 0.76393202));
  all.push_back(parallel_discs(0.5, 0.5, 2.0, 0.05572809));
  for (Plates& plates : all) {
    const auto ray_of = [&](Vec2 u) -> geometry::Ray {
      Vec3 place = plates.corner + u.x * plates.a + u.y * plates.b;
      if (plates.disc) {
        const double r = std::sqrt(u.x), phi = 2.0 * published_pi * u.y;
        place = r * std::cos(phi) * plates.a + r * std::sin(phi) * plates.b;
      }
      return {place + Vec3{0.0, 0.0, 1e-4}, {0.0, 0.0, -1.0}};
    };
    SceneDescription description = plates.scene.build();
    for (const Method method : both_published) {
      description.method = method;
      const int samples = method == Method::generic ? 1024 : 4096;
      const Measured seen = measure_area(description, one_lane_published, ray_of, 16, samples);
      CAPTURE(plates.name, plates.figure, name_of(method));
      check_mean(seen.lanes[0], plates.figure * planck_here(300.0_K));
    }
  }
}

// Two endless grey plates: J1 = (eps1 B1 + rho1 eps2 B2) / (1 - rho1 rho2), here as the broadband
// radiosities that the textbooks' formula gives with sigma T^4 (e.g. Siegel & Howell, Thermal
// Radiation Heat Transfer, 4th ed. (2002), sec. 7-2); W m^-2 to eight digits.
TEST_CASE("published: two endless grey plates have their radiosities", "[radiometry][published]") {
  struct Case {
    double eps1, eps2;
    Kelvin t1, t2;
    double radiosity;
  };
  const Case cases[] = {{0.9, 0.8, 310.0_K, 290.0_K, 513.6615},
                        {0.5, 0.5, 320.0_K, 280.0_K, 512.56556},
                        {0.1, 0.9, 300.0_K, 300.0_K, 459.30033},
                        {0.05, 0.05, 400.0_K, 300.0_K, 968.18008}};
  constexpr double stefan_boltzmann = 5.670374419e-8;
  for (const Case& c : cases) {
    for (const Method method : both_published) {
      // Plates that both reflect 0.95 need hundreds of bounces, more than weights of 1e-5 allow.
      if (method == Method::generic && c.eps1 + c.eps2 < 0.2) continue;
      double radiosity = 0.0, error = 0.0;
      for (const bool first : {true, false}) {  // one plate warm at a time: the sum is linear
        SmallScene scene;
        scene.method = method;
        scene.solver = long_walks();
        const Kelvin cold{0.0}, warm = 300.0_K;
        scene.add(geometry::Plane{{}, 4000.0, 4000.0},
                  scene.material(grey(1.0 - c.eps1), first ? warm : cold));
        scene.add(geometry::Plane{{0.0, 0.0, 1.0}, 4000.0, 4000.0},
                  scene.material(grey(1.0 - c.eps2), first ? cold : warm));
        const Estimate seen =
            measure(scene.build(), one_lane_published, downward(0.5), 16, 256).lanes[0];
        const double t = first ? c.t1.value : c.t2.value;
        const double scale = stefan_boltzmann * t * t * t * t / planck_here(warm);
        radiosity += scale * seen.mean;
        error = std::hypot(error, scale * seen.standard_error);
      }
      CAPTURE(c.eps1, c.eps2, name_of(method));
      // 2e-4: the plates end 2000 gaps away, and weights of the generic solver at 1e-5.
      check_mean({radiosity, error}, c.radiosity, 2e-4);
    }
  }
}

// Phase function of a Lambertian sphere, disc-integrated I / F at albedo 1:
// 2/3 (sin a + (pi - a) cos a) / pi. H. N. Russell, Astrophys. J. 43, 173 (1916).
TEST_CASE("published: a Lambertian sphere has the phases of Lambert's moon",
          "[radiometry][published]") {
  struct Phase {
    double degrees, figure;
  };
  const Phase phases[] = {{0.0, 0.66666667},  {30.0, 0.58722852},  {60.0, 0.40599852},
                          {90.0, 0.21220659}, {120.0, 0.07266519}, {150.0, 0.00987825}};
  for (const Phase& phase : phases) {
    SmallScene scene;
    scene.add(geometry::Sphere{{}, 1.0}, scene.material(grey(1.0), Kelvin{0.0}));
    scene.add_body(0.0, 85.0, 1e-3, published_pi);  // F = E / pi = 1
    scene.solver = {.initial_sample_count = 0, .min_quad_samples = 0};
    SceneDescription description = scene.build();
    // From that angle beside the sun; the disc of the sphere fills the square's circle.
    const double elevation = degrees(85.0 - phase.degrees).value;
    const Frame view = frame_about(direction_enu(0.0, elevation));
    const auto ray_of = [&](Vec2 u) -> geometry::Ray {
      const double r = std::sqrt(u.x), phi = 2.0 * published_pi * u.y;
      return {5.0 * view.z + r * std::cos(phi) * view.x + r * std::sin(phi) * view.y, -view.z};
    };
    for (const Method method : both_published) {
      description.method = method;
      const Measured seen = measure_area(description, one_lane_published, ray_of, 16, 2048);
      CAPTURE(phase.degrees, name_of(method));
      check_mean(seen.lanes[0], phase.figure, 2e-5);  // the sun's disc of 1e-3 degrees
    }
  }
}

/// A street 4 km long: floor from x = 0 to width, walls of that height on both sides.
SmallScene street(double width, double height, double floor_rho, double wall_rho) {
  SmallScene scene;
  const auto floor = scene.material(grey(floor_rho), Kelvin{0.0});
  const auto wall = scene.material(grey(wall_rho), Kelvin{0.0});
  const Vec3 along{0.0, 4000.0, 0.0};
  scene.add(rectangle({0.0, -2000.0, 0.0}, {width, 0.0, 0.0}, along), floor);
  scene.add(rectangle({0.0, -2000.0, 0.0}, along, {0.0, 0.0, height}), wall);
  scene.add(rectangle({width, 2000.0, 0.0}, -along, {0.0, 0.0, height}), wall);
  scene.sky(1.0);
  scene.solver = long_walks(8, 8);
  return scene;
}

// Sky view factor of the whole floor of an endless canyon, sqrt(1 + (h/w)^2) - h/w: V. Masson,
// Boundary-Layer Meteorol. 94, 357 (2000), eq. 9; of its middle, cos(atan(2 h / w)): T. R. Oke,
// J. Climatol. 1, 237 (1981).
TEST_CASE("published: the floor of a black street canyon sees the sky of Masson and Oke",
          "[radiometry][published]") {
  for (const double ratio : {0.5, 1.0, 3.0}) {
    const double width = 10.0;
    SceneDescription description = street(width, ratio * width, 1.0, 0.0).build();
    const auto across = [&](Vec2 u) -> geometry::Ray {
      return {{u.x * width, 0.0, 0.5}, {0.0, 0.0, -1.0}};
    };
    const geometry::Ray middle{{0.5 * width, 0.0, 0.5}, {0.0, 0.0, -1.0}};
    for (const Method method : both_published) {
      description.method = method;
      CAPTURE(ratio, name_of(method));
      const Measured mean = measure_area(description, one_lane_published, across, 16, 1024);
      check_mean(mean.lanes[0], std::sqrt(1.0 + ratio * ratio) - ratio, 1e-4);  // of 4 km
      const Measured there = measure(description, one_lane_published, middle, 16, 1024);
      check_mean(there.lanes[0], std::cos(std::atan(2.0 * ratio)), 1e-4);
    }
  }
}

/// Radiosities of an endless canyon under an even sky of 1 by Hottel's crossed strings over strips
/// (H. C. Hottel & A. F. Sarofim, Radiative Transfer (1967), ch. 2): J_i = rho_i (F_i,sky +
/// sum F_ij J_j). Strips of floor, left and right wall.
struct CanyonStrips {
  struct Strip {
    Vec2 a, b;
    double rho;
  };
  std::vector<Strip> strips;
  std::vector<double> radiosity;

  static double distance(Vec2 p, Vec2 q) { return std::hypot(p.x - q.x, p.y - q.y); }
  /// From i to j: both turn the same way about the street, so that a_i b_j and b_i a_j do not
  /// cross.
  static double factor(const Strip& i, const Strip& j) {
    const double crossed = distance(i.a, j.a) + distance(i.b, j.b);
    const double uncrossed = distance(i.a, j.b) + distance(i.b, j.a);
    return std::max(0.0, (crossed - uncrossed) / (2.0 * distance(i.a, i.b)));
  }

  CanyonStrips(double width, double height, double floor_rho, double wall_rho, int n) {
    const auto side = [&](Vec2 from, Vec2 to, double rho) {
      const auto at = [&](int k) -> Vec2 {
        const double t = static_cast<double>(k) / n;
        return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
      };
      for (int k = 0; k < n; ++k) strips.push_back({at(k), at(k + 1), rho});
    };
    side({0.0, height}, {0.0, 0.0}, wall_rho);
    side({0.0, 0.0}, {width, 0.0}, floor_rho);
    side({width, 0.0}, {width, height}, wall_rho);
    const Strip sky{{width, height}, {0.0, height}, 0.0};
    radiosity.assign(strips.size(), 0.0);
    for (int sweep = 0; sweep < 60; ++sweep) {  // Gauss-Seidel: rho^60 is nothing
      for (std::size_t i = 0; i < strips.size(); ++i) {
        double arriving = factor(strips[i], sky);
        for (std::size_t j = 0; j < strips.size(); ++j) {
          if (j != i) arriving += factor(strips[i], strips[j]) * radiosity[j];
        }
        radiosity[i] = strips[i].rho * arriving;
      }
    }
  }
};

TEST_CASE("published: a grey street canyon has the radiosities of Hottel's crossed strings",
          "[radiometry][published]") {
  const double width = 10.0, height = 15.0;
  // 99 strips a side: the middle one is 0.1 m wide; twice as many change it by 2e-5.
  const int n = 99;
  const CanyonStrips exact{width, height, 0.3, 0.7, n};
  SceneDescription description = street(width, height, 0.3, 0.7).build();
  for (const Method method : both_published) {
    description.method = method;
    CAPTURE(name_of(method));
    const Measured floor = measure(description, one_lane_published,
                                   {{0.5 * width, 0.0, 0.5}, {0.0, 0.0, -1.0}}, 16, 1024);
    check_mean(floor.lanes[0], exact.radiosity[n + n / 2], 3e-4);
    const Measured wall = measure(description, one_lane_published,
                                  {{5.0, 0.0, 0.5 * height}, {1.0, 0.0, 0.0}}, 16, 1024);
    check_mean(wall.lanes[0], exact.radiosity[2 * n + n / 2], 3e-4);
  }
}

// A V groove with mirror walls of emissivity eps sends along a ray that is reflected n times
// 1 - (1 - eps)^n of a black body. Unfolded about its apex the groove is a fan of its mirror
// images, which a straight ray crosses. E. M. Sparrow & S. H. Lin, Int. J. Heat Mass Transfer 5,
// 1111 (1962); R. B. Zipin, J. Res. NBS 70C, 275 (1966).
TEST_CASE("published: a mirrored V groove emits by the number of its images",
          "[radiometry][published]") {
  const double opening_deg = 50.0, rho = 0.7;
  const double half = degrees(0.5 * opening_deg).value;
  SmallScene scene;
  materials::Material mirror = grey(rho);
  mirror.scattering = materials::Mirror{};
  const auto wall = scene.material(mirror, 300.0_K);
  const Vec3 along{0.0, 200.0, 0.0}, start{0.0, -100.0, 0.0};
  scene.add(rectangle(start, along, {std::sin(half), 0.0, std::cos(half)}), wall);
  scene.add(rectangle(start, along, {-std::sin(half), 0.0, std::cos(half)}), wall);
  scene.solver = long_walks();
  SceneDescription description = scene.build();
  const auto planes_met = [&](double x) {
    // Down at x, from the mouth's circle of radius 1 about the apex: in the unfolded fan the ray is
    // a straight chord that leaves the circle at the angle pi - asin(x) from the upright; walls
    // stand at half, 3 half, 5 half ...
    const double exit = published_pi - std::asin(x);
    return static_cast<int>(std::floor((exit - half) / (2.0 * half))) + 1;
  };
  for (const double x : {0.02, 0.1, 0.2, 0.3}) {
    const geometry::Ray ray{{x, 0.0, 3.0}, {0.0, 0.0, -1.0}};
    for (const Method method : both_published) {
      description.method = method;
      const Measured seen = measure(description, one_lane_published, ray, 16, 64);
      CAPTURE(x, planes_met(x), name_of(method));
      check_mean(seen.lanes[0], planck_here(300.0_K) * (1.0 - std::pow(rho, planes_met(x))));
    }
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
