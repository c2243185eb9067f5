#include "sim/run/read_surface.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "sim/files/mesh_obj.hpp"
#include "sim/files/mesh_ply.hpp"

namespace nadir::sim {
namespace {

geometry::TriangleMesh read_mesh(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();  // the scenario's checks admit no others
  return ending.size() == 4 && (ending[1] == 'p' || ending[1] == 'P') ? read_ply(file)
                                                                      : read_obj(file);
}

/// The material of a part: the entry of its name, else the entry for all others.
const PartMaterial* material_of(const std::string& part, const std::vector<PartMaterial>& given) {
  const auto named = [&](const std::string& name) {
    return std::find_if(given.begin(), given.end(),
                        [&](const PartMaterial& entry) { return entry.part == name; });
  };
  auto found = named(part);
  if (found == given.end()) found = named("");
  return found == given.end() ? nullptr : &*found;
}

void check_part_names(const MeshInput& input, const geometry::TriangleMesh& mesh,
                      std::vector<InputIssue>& issues) {
  for (const PartMaterial& entry : input.parts) {
    const auto& names = mesh.part_names;
    if (entry.part.empty() || std::find(names.begin(), names.end(), entry.part) != names.end()) {
      continue;
    }
    const std::string nearest = nearest_name(entry.part, names);
    issues.push_back({{input.file.string(), 0, 0},
                      fmt::format("the scenario gives a material to part \"{}\", which this mesh "
                                  "does not have",
                                  entry.part),
                      nearest.empty() ? fmt::format("its parts are: {}", fmt::join(names, ", "))
                                      : fmt::format("did you mean \"{}\"?", nearest),
                      {}});
  }
}

geometry::Surface surface_of(const MeshInput& input, InputFiles& files) {
  geometry::Surface surface;
  geometry::TriangleMesh mesh = read_mesh(files.note(input.file));
  std::vector<InputIssue> issues;
  check_part_names(input, mesh, issues);
  for (const std::string& part : mesh.part_names) {
    const PartMaterial* entry = material_of(part, input.parts);
    if (entry == nullptr) {
      issues.push_back(
          {{input.file.string(), 0, 0},
           fmt::format("part \"{}\" of this mesh has no material in the scenario", part),
           "give the mesh a material for all parts, or this part one of its own",
           {}});
      continue;
    }
    surface.part_materials.push_back(static_cast<std::uint32_t>(entry->material));
  }
  if (!issues.empty()) throw InputError{std::move(issues)};
  surface.form = std::move(mesh);
  return surface;
}

geometry::Surface surface_of(const ShapeInput& input, InputFiles& /*files*/) {
  return {input.shape, {static_cast<std::uint32_t>(input.material)}};
}

}  // namespace

geometry::Surface read_surface(const FormInput& form, InputFiles& files) {
  return std::visit([&](const auto& input) { return surface_of(input, files); }, form);
}

}  // namespace nadir::sim
