#include "sim/cli/materials_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "materials/bound_material.hpp"
#include "sim/files/atomic_file.hpp"
#include "sim/files/data_directory.hpp"
#include "sim/files/therm_values.hpp"
#include "sim/run/load_materials.hpp"
#include "sim/scenario/material_library.hpp"

namespace nadir::sim {
namespace {

struct MaterialsOptions {
  std::string name;
  std::filesystem::path library;
  std::string format = "text";
};

// Wavelengths that tell a surface's character: blue, green, red, near and short-wave infrared,
// and the atmospheric windows of the thermal infrared.
const spectral::Lanes shown{
    {0.45_um, 0.55_um, 0.65_um, 0.86_um, 1.61_um, 2.2_um, 3.8_um, 8.6_um, 10.9_um, 12.0_um}};

struct Row {
  std::string name, description;
  spectral::Spectrum reflectance, emissivity;
};

/// Seen from straight above.
Row row_of(const LibraryMaterial& entry) {
  InputFiles files;
  Diagnostics diagnostics;
  const auto bound = materials::bind(load_material(entry, files), shown, diagnostics);
  const Vec3 above{0.0, 0.0, 1.0};
  return {entry.name, entry.description, materials::albedo(bound.scattering, above).reflectance,
          bound.emissivity(above)};
}

void keep_named(std::vector<LibraryMaterial>& entries, const std::string& name) {
  std::vector<std::string> names;
  for (const LibraryMaterial& entry : entries) names.push_back(entry.name);
  entries.erase(std::remove_if(entries.begin(), entries.end(),
                               [&](const LibraryMaterial& entry) { return entry.name != name; }),
                entries.end());
  if (!entries.empty()) return;
  const std::string nearest = nearest_name(name, names);
  throw InputError{InputIssue{{},
                              "there is no material \"" + name + "\" in the library",
                              nearest.empty() ? "" : "did you mean \"" + nearest + "\"?",
                              {}}};
}

void print_json(const std::vector<Row>& rows) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    nlohmann::ordered_json entry{{"name", row.name}, {"description", row.description}};
    for (int lane = 0; lane < shown.count(); ++lane) {
      entry["wavelength_um"].push_back(shown[lane].value);
      entry["reflectance"].push_back(row.reflectance[lane]);
      entry["emissivity"].push_back(row.emissivity[lane]);
    }
    all.push_back(std::move(entry));
  }
  fmt::print("{}\n", all.dump(2));
}

void print_table(const std::vector<Row>& rows) {
  std::size_t width = 8;
  for (const Row& row : rows) width = std::max(width, row.name.size());
  fmt::print("reflectance (directional-hemispherical) at wavelength in um\n{:<{}}", "", width);
  for (const Micrometres wavelength : shown) fmt::print(" {:>6}", wavelength.value);
  fmt::print("   description\n");
  for (const Row& row : rows) {
    fmt::print("{:<{}}", row.name, width);
    for (int lane = 0; lane < shown.count(); ++lane) {
      fmt::print(" {:6.3f}", row.reflectance[lane]);
    }
    fmt::print("   {}\n", row.description);
  }
}

void list_materials(MaterialsOptions options) {
  if (options.library.empty()) options.library = data_directory() / "library" / "materials.xml";
  std::vector<LibraryMaterial> entries = read_material_library(options.library);
  if (!options.name.empty()) keep_named(entries, options.name);
  std::vector<Row> rows;
  for (const LibraryMaterial& entry : entries) rows.push_back(row_of(entry));
  options.format == "json" ? print_json(rows) : print_table(rows);
}

struct ThermOptions {
  std::filesystem::path file, output;
};

void convert_therm(const ThermOptions& options) {
  const ThermValues values = read_therm(options.file);
  fmt::print("{}\n", therm_report(values));
  if (options.output.empty()) {
    fmt::print("{}", therm_csv(values));
    return;
  }
  write_file(options.output, therm_csv(values));
  fmt::print("{}\n", options.output.string());
}

void add_therm_command(CLI::App& materials) {
  auto options = std::make_shared<ThermOptions>();
  CLI::App* command = materials.add_subcommand(
      "therm", "Convert thermal values in calories, as material files for THERM have them");
  command->add_option("file", options->file, "Material file")->required();
  command->add_option("-o,--output", options->output,
                      "Table of substances to write (CSV) [printed]");
  command->callback([options] { convert_therm(*options); });
}

}  // namespace

void add_materials_command(CLI::App& app) {
  auto options = std::make_shared<MaterialsOptions>();
  CLI::App* command = app.add_subcommand("materials", "List a material library's surfaces");
  command->add_option("name", options->name, "Only this material");
  command->add_option("--library", options->library, "Library file [the one that ships]");
  command->add_option("--format", options->format, "text or json [text]")
      ->check(CLI::IsMember({"text", "json"}));
  add_therm_command(*command);
  command->callback([options, command] {
    // Called after the sub-command's own.
    if (command->get_subcommands().empty()) list_materials(*options);
  });
}

}  // namespace nadir::sim
