#include <atomic>
#include <cstdlib>
#include <new>

#include "radiometry/small_scene.hpp"
#include "support/catch.hpp"

// Counts what the heap is asked for while rays are traced: nothing.

namespace {

std::atomic<bool> counting{false};
std::atomic<int> allocations{0};

void* counted(std::size_t size) {
  if (counting) ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc{};
}
void* counted(std::size_t size, std::align_val_t alignment) {
  if (counting) ++allocations;
  const auto step = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc{};
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, std::align_val_t a) { return counted(size, a); }
void* operator new[](std::size_t size, std::align_val_t a) { return counted(size, a); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  if (counting) ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  if (counting) ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes lanes_no_allocation{{0.45_um, 0.55_um, 1.65_um, 10.9_um}};

materials::Material with(const materials::Scattering& model) {
  materials::Material material = grey(0.3);
  material.scattering = model;
  return material;
}

/// A little of everything that a ray can meet.
SceneDescription everything() {
  SmallScene scene;
  scene.add(geometry::Plane{{}, 100.0, 100.0}, scene.material(grey(0.4), 290.0_K));
  materials::Material leaf = with(materials::Leaf{});
  leaf.transmittance = spectral::Curve::constant(0.3);
  scene.add(geometry::Disc{{0.0, 3.0, 2.0}, {0.0, 0.6, 0.8}, 2.0}, scene.material(leaf, 290.0_K));
  scene.add(geometry::Sphere{{3.0, 0.0, 1.0}, 1.0},
            scene.material(with(materials::Ward{}), 300.0_K));
  scene.add(geometry::Sphere{{-3.0, 0.0, 1.0}, 1.0},
            scene.material(with(materials::Mirror{}), 300.0_K));
  materials::Material metal = with(materials::Microfacet{});
  metal.reflectance.reset();
  scene.add(geometry::Sphere{{0.0, -3.0, 1.0}, 1.0}, scene.material(metal, 300.0_K));
  scene.add_body(200.0, 40.0, 0.266, 1000.0);
  scene.overcast(50.0);
  Lamp lamp;
  lamp.name = "street";
  lamp.form = PointLamp{{0.0, 0.0, 6.0}};
  lamp.flux = spectral::Curve::constant(100.0);
  scene.lamps.push_back(lamp);
  scene.volumes.push_back(
      {"fog",
       geometry::Region{geometry::Box{{-5.0, -5.0, 0.0}, {5.0, 5.0, 3.0}}, Affine{}},
       {spectral::Curve::constant(0.02), spectral::Curve::constant(0.1),
        materials::HenyeyGreenstein{spectral::Curve::constant(0.7)}},
       nullptr,
       280.0_K,
       {}});
  return scene.build();
}

template <class Solver>
int allocations_of(Solver solver, const LitScene& lit) {
  const auto trace = [&](int rays) {
    for (int i = 0; i < rays; ++i) {
      const double x = -5.0 + 10.0 * (i % 20) / 20.0, y = -5.0 + 10.0 * (i / 20 % 20) / 20.0;
      const geometry::Ray ray{{x, y, 20.0}, {0.0, 0.0, -1.0}};
      const Sampler numbers{mix(3, static_cast<std::uint64_t>(i)), 0};
      const auto seen = solver.aperture_radiance(ray, lit.intersect(ray, numbers), numbers);
      REQUIRE(std::isfinite(seen[0]));
    }
  };
  trace(20);  // whatever the libraries set up at their first ray
  allocations = 0;
  const auto pixel = [&](int i) {
    const geometry::Ray ray{{-5.0 + 0.5 * (i % 20), -5.0 + 0.5 * (i / 20 % 20), 20.0},
                            {0.0, 0.0, -1.0}};
    const Sampler numbers{mix(4, static_cast<std::uint64_t>(i)), 0};
    return solver.aperture_radiance(ray, lit.intersect(ray, numbers), numbers)[0];
  };
  float sum = 0.0F;
  counting = true;
  for (int i = 0; i < 400; ++i) sum += pixel(i);
  counting = false;
  REQUIRE(sum > 0.0F);
  return allocations;
}

TEST_CASE("tracing rays asks the heap for nothing", "[radiometry]") {
  SceneDescription scene = everything();
  Diagnostics diagnostics;
  const LitScene lit{scene, lanes_no_allocation, diagnostics};
  CHECK(allocations_of(GenericSolver{lit}, lit) == 0);
  CHECK(allocations_of(PathSolver{lit}, lit) == 0);
}

TEST_CASE("the allocation counter counts", "[radiometry]") {
  allocations = 0;
  counting = true;
  ::operator delete(::operator new(4));  // a new-expression the compiler may leave out
  counting = false;
  CHECK(allocations == 1);
}

}  // namespace
}  // namespace nadir::radiometry::test
