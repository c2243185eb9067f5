#include "sim/cli/atmosphere_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <variant>

#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "core/quantity.hpp"
#include "sim/files/air_import.hpp"
#include "sim/files/air_table_file.hpp"
#include "sim/run/air_cache.hpp"
#include "sim/run/air_stage.hpp"
#include "sim/run/world.hpp"
#include "sim/scenario/read_scenario.hpp"

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;
using atmosphere::AirTable;

std::string range_of(const std::vector<double>& nodes, double unit) {
  return fmt::format("{} from {:.6g} to {:.6g}", nodes.size(), nodes.front() / unit,
                     nodes.back() / unit);
}

std::string describe_view(const std::string& name, const AirTable::View& view) {
  return fmt::format(
      "{:<22}{:.1f} m: zenith angles {} deg, azimuths {} deg, {} shares of the way\n", name,
      view.height_m, range_of(view.zenith_rad, radians_per_degree),
      range_of(view.azimuth_rad, radians_per_degree), view.share.size());
}

std::string summary(const AirTable& table) {
  std::string text = fmt::format("{:<22}{}\n", "made by", table.made_by);
  for (const std::string& note : table.notes) text += fmt::format("{:<22}{}\n", "note", note);
  text += fmt::format("{:<22}{} from {:.6g} to {:.6g} um\n", "lanes", table.lanes.size(),
                      table.lanes.front().wavelength_um, table.lanes.back().wavelength_um);
  text += fmt::format("{:<22}{:.1f} m to {:.1f} m\n", "air", table.ground_m, table.top_m);
  for (const AirTable::Body& body : table.bodies) {
    text +=
        fmt::format("{:<22}zenith angle {:.6g} deg, azimuth {:.6g} deg\n", body.name,
                    body.zenith_rad / radians_per_degree, body.azimuth_rad / radians_per_degree);
  }
  text += fmt::format("{:<22}{}\n", "kinds of scatterers", table.kinds);
  text += describe_view("sky", table.sky);
  for (const AirTable::View& view : table.views) text += describe_view("view", view);
  return text + fmt::format("{:<22}{:.3g}\n", "interpolation error", table.interpolation_error);
}

void add_show(CLI::App& parent) {
  struct Options {
    fs::path file;
    bool csv = false, head = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = parent.add_subcommand("show", "What a table of the air holds");
  command->add_option("file", options->file, "Table (*.air)")->required();
  command->add_flag("--csv", options->csv, "All values, one a line: array, indices, value");
  command->add_flag("--head", options->head, "All axes and lanes, as in the file's head");
  command->callback([options] {
    const AirTableFile file = read_air_table(options->file);
    if (options->csv) {
      fmt::print("{}", air_table_csv(file.table));
    } else {
      fmt::print("{}", options->head ? air_table_head(file.table) : summary(file.table));
    }
  });
}

void add_import(CLI::App& parent) {
  struct Options {
    AirImport wanted;
    double sun_zenith_deg = -1.0, sun_azimuth_deg = -1.0;
    fs::path out;
  };
  const std::map<std::string, AirSource> sources{{"tape7", AirSource::tape7},
                                                 {"modtran-csv", AirSource::modtran_csv},
                                                 {"uvspec", AirSource::uvspec}};
  auto options = std::make_shared<Options>();
  AirImport& wanted = options->wanted;
  CLI::App* command = parent.add_subcommand("import", "Make a table of another program's runs");
  command->add_option("files", wanted.files, "Outputs; for uvspec with the input (.inp) beside")
      ->required();
  command->add_option("--from", wanted.from, "tape7, modtran-csv or uvspec")
      ->required()
      ->transform(CLI::CheckedTransformer(sources, CLI::ignore_case));
  command->add_option("--out", options->out, "Table to write (*.air)")->required();
  command->add_option("--geometry", wanted.geometry,
                      "CSV table of where runs look: height_m, zenith_deg, azimuth_deg, length_m");
  command->add_option("--azimuth", wanted.azimuth_deg,
                      "Azimuths that runs look at, from the sun [deg]: one for all, or one each");
  command->add_option("--sun-zenith", options->sun_zenith_deg, "Of the sun [deg; as the runs say]")
      ->check(CLI::Range(0.0, 180.0));
  command->add_option("--sun-azimuth", options->sun_azimuth_deg, "Of the sun, from north [deg]")
      ->check(CLI::Range(0.0, 360.0));
  command->add_option("--ground-m", wanted.settings.ground_m, "Height of the ground [0]");
  command->add_option("--top-m", wanted.settings.top_m, "Height of the air's top [100000]");
  command->add_flag("--watts", wanted.uvspec.watts,
                    "uvspec: the solar spectrum is in W, not mW, m^-2 nm^-1");
  command->callback([options] {
    AirRunSettings& settings = options->wanted.settings;
    if (options->sun_zenith_deg >= 0.0)
      settings.sun_zenith_rad = options->sun_zenith_deg * radians_per_degree;
    if (options->sun_azimuth_deg >= 0.0) {
      settings.sun_azimuth_rad = options->sun_azimuth_deg * radians_per_degree;
    }
    const AirTable table = import_air(options->wanted);
    write_air_table(options->out, {table, {}});
    fmt::print("{}{}\n", summary(table), options->out.string());
  });
}

void add_cache(CLI::App& parent) {
  auto clear = std::make_shared<bool>(false);
  CLI::App* command = parent.add_subcommand("cache", "Tables that are kept between runs");
  command->add_flag("--clear", *clear, "Remove them");
  command->callback([clear] {
    const fs::path folder = air_cache_folder();
    if (folder.empty()) throw InputError{"the environment names no folder for a cache"};
    const AirCacheSize size = *clear ? clear_air_cache(folder) : air_cache_size(folder);
    fmt::print("{}: {} {} of {:.1f} MB{}\n", folder.string(), size.tables,
               size.tables == 1 ? "table" : "tables", static_cast<double>(size.bytes) * 1e-6,
               *clear ? " removed" : "");
  });
}

void write_scenario_table(const fs::path& scenario_file, const fs::path& out, bool use_cache) {
  Diagnostics diagnostics;
  InputFiles files;
  const Scenario scenario = read_scenario(scenario_file, diagnostics);
  World world = load_world(scenario, files, diagnostics);
  finish_air(world, scenario.sampling, diagnostics, {use_cache, {}});
  for (const std::string& warning : diagnostics.messages()) {
    fmt::print(stderr, "warning: {}\n", warning);
  }
  const auto* air = std::get_if<atmosphere::Tabulated>(&world.scene.atmosphere);
  if (air == nullptr) {
    throw InputError{InputIssue{{scenario_file.string(), 0, 0},
                                "the scenario's air needs no table",
                                "<layered> air does",
                                {}}};
  }
  write_air_table(out, {*air->table, {}});
  fmt::print("{}{}\n", summary(*air->table), out.string());
}

void add_table(CLI::App& parent) {
  struct Options {
    fs::path scenario, out;
    bool no_cache = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = parent.add_subcommand("table", "Compute the table of a scenario's air");
  command->add_option("scenario", options->scenario, "Scenario file (XML)")->required();
  command->add_option("--out", options->out, "Table to write (*.air)")->required();
  command->add_flag("--no-air-cache", options->no_cache, "Compute it even where it is kept");
  command->callback(
      [options] { write_scenario_table(options->scenario, options->out, !options->no_cache); });
}

}  // namespace

void add_atmosphere_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("atmosphere", "Tables of the air");
  command->require_subcommand(1);
  add_table(*command);
  add_show(*command);
  add_import(*command);
  add_cache(*command);
}

}  // namespace nadir::sim
