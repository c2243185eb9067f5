#include "sim/scenario/read_scenario.hpp"

#include "sim/scenario/build_context.hpp"
#include "sim/scenario/check_document.hpp"

namespace nadir::sim {
namespace {

/// Builds in the order of dependence: settings before materials before what is made of them.
void build_parts(const BuildContext& context, const CheckedElement& root, Scenario& scenario) {
  build_time(context, root, scenario);
  if (const auto* site = root.child("site")) scenario.origin = build_geodetic(*site);
  if (const auto* light = root.child("illumination")) {
    scenario.illumination = build_illumination(context, *light);
  }
  if (const auto* air = root.child("atmosphere")) scenario.air = build_air(context, *air);
  scenario.heat = build_heat(context, root);
  if (const auto* solver = root.child("solver")) {
    scenario.solver = build_solver(*solver, scenario.solver);
    const bool path = solver->value<std::string>("method") == "path";
    scenario.method = path ? radiometry::Method::path : radiometry::Method::generic;
    scenario.path_max_bounces = solver->value<int>("path_max_bounces");
  }
  const CheckedElement* materials = root.child("materials");
  const CheckedElement* geometry = root.child("geometry");
  if (materials != nullptr && geometry != nullptr) {
    MaterialNames names = build_materials(context, root, scenario);
    build_geometry(context, *geometry, names, scenario);
    build_lamps(context, root, names, scenario);
    names.warn_of_unused(context);
  }
  if (const auto* volumes = root.child("volumes")) {
    const bool has_terrain = geometry != nullptr && geometry->child("terrain") != nullptr;
    build_volumes(context, *volumes, has_terrain, scenario);
  }
  if (const auto* platform = root.child("platform")) build_platform(context, *platform, scenario);
  if (const auto* camera = root.child("camera")) build_camera(context, *camera, scenario);
  build_effects(context, root, scenario);
  build_results(context, root, scenario);
}

Scenario read(const SourceText& source, const std::filesystem::path& file,
              Diagnostics& diagnostics) {
  const XmlElement xml = parse_xml(source);
  Issues issues;
  const CheckedElement root = check_document(xml, scenario_root, source, InputPaths{file}, issues);
  Scenario scenario;
  scenario.file = std::filesystem::absolute(file).lexically_normal();
  scenario.name = root.value<std::string>("name");
  scenario.title = root.value<std::string>("title");
  build_parts(BuildContext{source, issues, diagnostics}, root, scenario);
  issues.throw_if_any();
  return scenario;
}

}  // namespace

Scenario read_scenario(const std::filesystem::path& file, Diagnostics& diagnostics) {
  return read(read_source_text(file), file, diagnostics);
}

Scenario parse_scenario(std::string text, const std::filesystem::path& file,
                        Diagnostics& diagnostics) {
  return read(SourceText{file.string(), std::move(text)}, file, diagnostics);
}

bool is_material_library(const std::filesystem::path& file) {
  return parse_xml(read_source_text(file)).name == schema().type(library_root).name;
}

}  // namespace nadir::sim
