#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "atmosphere/atmosphere.hpp"
#include "atmosphere/layered.hpp"
#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "ephemeris/illumination.hpp"
#include "ephemeris/refraction.hpp"
#include "sim/run/ground_light.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// Air in layers, with all that its light is computed from.
struct LayeredTask {
  atmosphere::Layered air;
  atmosphere::AirSettings settings;
  bool refraction = false;
  std::vector<std::filesystem::path> figures;  ///< files of gases and particles it was read from
};
/// Air that needs the finished scene before light can go through it: air in layers, whose table is
/// still to be computed, or a table from elsewhere, which needs the ground about.
struct AirTask {
  SourceLocation where;  ///< of its element, for mistakes
  GroundAbout ground;
  std::optional<LayeredTask> layered;
};

/// The scenario's air as far as it is known before the scene: its curves or its table read. Nothing
/// (None) for air in layers, whose light is computed later.
[[nodiscard]] atmosphere::Atmosphere load_atmosphere(const Scenario& scenario, InputFiles& files);

/// What remains to be done for the air; nothing for none and uniform air, for which no file of
/// figures is opened.
/// @throws InputError for a file, a sounding or amounts that cannot be, located at the element
[[nodiscard]] std::optional<AirTask> load_air_task(const Scenario& scenario, InputFiles& files,
                                                   Diagnostics& diagnostics);

/// Pressure and temperature at the scene, for refraction.
[[nodiscard]] ephemeris::AirAtSite air_at_site(const atmosphere::Layered& air);

/// Runs a part; mistakes of it that do not say where they are lie at `where`.
template <class F>
auto at_element(const SourceLocation& where, F&& part) {
  try {
    return part();
  } catch (const InputError& error) {
    throw error.located(where, {});
  }
}

/// @throws InputError at a place of the user's files
[[noreturn]] void refuse_at(const SourceLocation& where, std::string message,
                            std::string hint = {});

/// Tells of what may be wrong at a place of the user's files, as a compiler would.
void warn_at(const SourceLocation& where, const std::string& message, Diagnostics& diagnostics);

/// Figures of air are given for one sun and do not darken when it sets: tells of a night whose sky
/// still shines in the visible.
void warn_of_bright_night(const Scenario& scenario, const ephemeris::Illumination& bodies,
                          const atmosphere::Atmosphere& air, Diagnostics& diagnostics);

}  // namespace nadir::sim
