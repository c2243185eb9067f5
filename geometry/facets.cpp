// Every triangle and every face of a shape by its number, without a ray.

#include <algorithm>
#include <cassert>
#include <limits>

#include "geometry/ray_query.hpp"
#include "geometry/scene.hpp"
#include "geometry/shape_hit.hpp"

namespace nadir::geometry {
namespace {

/// The last of those whose facets begin at or before `facet`. Two never begin alike: each has some.
template <class Owner>
const Owner& owner_of(const std::vector<Owner>& owners, std::uint64_t facet) {
  const auto after = std::upper_bound(
      owners.begin(), owners.end(), facet,
      [](std::uint64_t number, const Owner& owner) { return number < owner.first_facet; });
  return *std::prev(after);
}

std::uint64_t facets_of_items(const Scene::Data& data) {
  return data.prototypes.empty() ? data.facets : data.prototypes.front().first_facet;
}

FacetPlace find(const Scene::Data& data, std::uint64_t facet) {
  assert(facet < data.facets);
  if (facet < facets_of_items(data)) {
    const Item& item = owner_of(data.items, facet);
    return {&item, nullptr, static_cast<std::uint32_t>(facet - item.first_facet)};
  }
  const Prototype& prototype = owner_of(data.prototypes, facet);
  const std::uint64_t offset = facet - prototype.first_facet;
  const std::uint64_t within = offset % prototype.facets;
  const Item& item = owner_of(prototype.items, within);
  return {&item, &data.instances[prototype.first_instance + offset / prototype.facets],
          static_cast<std::uint32_t>(within - item.first_facet)};
}

}  // namespace

std::uint64_t Scene::facets() const { return data_->facets; }

FacetSize Scene::facet_size(std::uint64_t facet) const {
  const FacetPlace place = find(*data_, facet);
  if (place.item->shape) {
    return face_size(place.item->shape->shape, place.number, shape_to_scene(*data_, place).linear);
  }
  const Triangle t = triangle_of(*data_, place);
  return {true, std::max({length(t.b - t.a), length(t.c - t.b), length(t.a - t.c)}), 0.0};
}

Hit Scene::on_facet(std::uint64_t facet, Vec2 uv, bool back) const {
  const ExactHit exact = exact_place(*data_, find(*data_, facet), uv);
  return finished(*data_, exact, back ? exact.normal : -exact.normal);
}

double Scene::vertex_value(const Hit& hit) const {
  const FacetPlace place = find(*data_, hit.facet);
  const auto& values = place.item->vertex_values;
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const std::uint32_t* corner = place.item->triangles + 3 * std::size_t{place.number};
  const double a = values[corner[0]], b = values[corner[1]], c = values[corner[2]];
  return a + hit.uv.x * (b - a) + hit.uv.y * (c - a);
}

}  // namespace nadir::geometry
