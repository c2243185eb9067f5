#include "sim/files/texture_seams.hpp"

#include <map>
#include <tuple>

namespace nadir::sim {
namespace {

class Splitter {
 public:
  explicit Splitter(geometry::TriangleMesh& mesh)
      : mesh_{mesh}, has_texture_(mesh.positions.size(), false) {
    mesh_.texture.assign(mesh_.positions.size(), {});
  }

  /// The position to use for a corner at `vertex` with this texture coordinate.
  std::uint32_t with_texture(std::uint32_t vertex, Vec2 at) {
    if (!has_texture_[vertex]) {
      has_texture_[vertex] = true;
      mesh_.texture[vertex] = at;
    }
    if (mesh_.texture[vertex] == at) return vertex;
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [copy, is_new] = copies_.try_emplace({vertex, at.x, at.y}, next);
    if (is_new) {
      mesh_.positions.push_back(Vec3{mesh_.positions[vertex]});
      mesh_.texture.push_back(at);
      if (!mesh_.vertex_values.empty()) {
        mesh_.vertex_values.push_back(float{mesh_.vertex_values[vertex]});
      }
    }
    return copy->second;
  }

 private:
  geometry::TriangleMesh& mesh_;
  std::vector<bool> has_texture_;
  std::map<std::tuple<std::uint32_t, double, double>, std::uint32_t> copies_;
};

}  // namespace

void set_texture(geometry::TriangleMesh& mesh, const std::vector<Vec2>& texture,
                 const std::vector<CornerTexture>& corners) {
  Splitter splitter{mesh};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t number = corners[i][k];
      std::uint32_t& vertex = mesh.triangles[i][k];
      vertex = splitter.with_texture(vertex, number > 0 ? texture[number - 1] : Vec2{});
    }
  }
}

}  // namespace nadir::sim
