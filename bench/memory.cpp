// What does a scene cost in memory? Resident bytes per instanced tree and per terrain triangle,
// Embree's own included, after the scene is built and what it was built from is gone.

#include <malloc.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "geometry/scene_builder.hpp"
#include "geometry/terrain.hpp"

namespace nadir::bench {
namespace {

double resident_bytes() {
  malloc_trim(0);  // what was freed is the system's again
  long pages = 0, resident = 0;
  if (FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
    std::fclose(file);
  }
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void report(const char* what, double count, const std::function<geometry::Scene()>& build) {
  const double before = resident_bytes();
  const geometry::Scene scene = build();
  const double after = resident_bytes();
  std::printf("| %s | %.0f | %.1f |\n", what, count, (after - before) / count);
  if (!scene.intersect({{1.0, 1.0, 1e4}, {0.0, 0.0, -1.0}})) std::printf("(nothing hit)\n");
}

/// A hilly square of 2 n^2 triangles, 10 m a cell.
geometry::Scene terrain(int n) {
  geometry::TriangleMesh mesh;
  for (int row = 0; row <= n; ++row) {
    for (int column = 0; column <= n; ++column) {
      const double x = 10.0 * (column - n / 2), y = 10.0 * (row - n / 2);
      mesh.positions.push_back({x, y, 50.0 * std::sin(0.01 * x) * std::cos(0.013 * y)});
    }
  }
  const auto side = static_cast<std::uint32_t>(n + 1);
  for (std::uint32_t row = 0; row + 1 < side; ++row) {
    for (std::uint32_t column = 0; column + 1 < side; ++column) {
      const std::uint32_t a = row * side + column, b = a + 1, c = a + side, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  mesh.parts.assign(mesh.triangles.size(), 0);
  mesh.part_names = {"ground"};
  geometry::SceneBuilder builder;
  builder.add({std::move(mesh), {0}}, Affine{}, 0);
  return builder.build();
}

/// n^2 trees of a few hundred leaves on a grid, each turned its own way.
geometry::Scene forest(int n) {
  geometry::TriangleMesh tree;
  for (std::uint32_t leaf = 0; leaf < 400; ++leaf) {
    const double a = 2.4 * leaf, z = 2.0 + 6.0 * leaf / 400.0, r = 2.0 * std::fabs(std::sin(a * z));
    const Vec3 at{r * std::cos(a), r * std::sin(a), z};
    tree.positions.insert(tree.positions.end(),
                          {at, at + Vec3{0.1, 0.0, 0.05}, at + Vec3{0.0, 0.1, 0.0}});
    tree.triangles.push_back({3 * leaf, 3 * leaf + 1, 3 * leaf + 2});
  }
  tree.parts.assign(tree.triangles.size(), 0);
  tree.part_names = {"leaves"};
  std::vector<Affine> placements;
  for (int i = 0; i < n * n; ++i) {
    const double turn = 0.7 * i, c = std::cos(turn), s = std::sin(turn);
    placements.push_back({{{c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}},
                          {5.0 * (i % n - n / 2), 5.0 * (i / n - n / 2), 0.0}});
  }
  geometry::SceneBuilder builder;
  builder.add_instances({{std::move(tree), {0}}}, placements, 0);
  // A ground, so that a ray through the crowns has something to hit.
  builder.add({geometry::Plane{{}, 1e5, 1e5}, {0}}, Affine{}, 1);
  return builder.build();
}

}  // namespace
}  // namespace nadir::bench

int main() {
  using nadir::bench::report;
  report("(warm-up)", 2.0 * 100 * 100, [] { return nadir::bench::terrain(100); });
  std::printf("| what | number | bytes each |\n|---|---|---|\n");
  report("terrain triangle", 2.0 * 700 * 700, [] { return nadir::bench::terrain(700); });
  report("instanced tree", 300.0 * 300, [] { return nadir::bench::forest(300); });
}
