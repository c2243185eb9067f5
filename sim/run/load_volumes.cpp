#include "sim/run/load_volumes.hpp"

#include <map>
#include <memory>

#include "sim/files/grid_file.hpp"
#include "sim/files/phase_table.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/place.hpp"
#include "sim/run/read_curves.hpp"

namespace nadir::sim {
namespace {

using radiometry::ScalarGrid;
using spectral::Outside;

class VolumeLoader {
 public:
  VolumeLoader(const TerrainProbe& terrain, InputFiles& files)
      : terrain_{&terrain}, files_{&files} {}

  radiometry::Volume load(const VolumeInput& input) {
    return {input.name,     region(input),      medium(input),
            density(input), temperature(input), input.where};
  }

 private:
  /// A shape or placement that is refused has no file of its own: the volume's place is told.
  [[nodiscard]] geometry::Region region(const VolumeInput& input) const {
    try {
      return {input.shape, placed(input.placement, *terrain_)};
    } catch (const InputError& error) {
      std::vector<InputIssue> issues = error.issues();
      for (InputIssue& issue : issues) {
        issue.message = "volume \"" + input.name + "\": " + issue.message;
      }
      throw InputError{std::move(issues)}.located(input.where, {});
    }
  }

  materials::Medium medium(const VolumeInput& input) {
    return {
        curve_of(input.absorption_per_m, SpectrumQuantity::attenuation, Outside::reject, *files_),
        curve_of(input.scattering_per_m, SpectrumQuantity::attenuation, Outside::reject, *files_),
        std::visit([&](const auto& phase) { return phase_of(phase); }, input.phase)};
  }

  materials::PhaseFunction phase_of(const HenyeyGreensteinInput& input) {
    return materials::HenyeyGreenstein{
        curve_of(input.g, SpectrumQuantity::parameter, Outside::reject, *files_)};
  }
  static materials::PhaseFunction phase_of(const RayleighInput& /*none*/) {
    return materials::RayleighPhase{};
  }
  materials::PhaseFunction phase_of(const PhaseTableInput& input) {
    return read_phase_table(files_->note(input.file));
  }

  std::shared_ptr<const ScalarGrid> density(const VolumeInput& input) {
    return input.density_grid ? grid(*input.density_grid) : nullptr;
  }

  std::variant<Kelvin, std::shared_ptr<const ScalarGrid>> temperature(const VolumeInput& input) {
    if (const auto* kelvin = std::get_if<double>(&input.temperature)) return Kelvin{*kelvin};
    return grid(std::get<std::filesystem::path>(input.temperature));
  }

  std::shared_ptr<const ScalarGrid> grid(const std::filesystem::path& file) {
    auto& known = grids_[file];
    if (!known) known = std::make_shared<const ScalarGrid>(read_grid(files_->note(file)));
    return known;
  }

  const TerrainProbe* terrain_;
  InputFiles* files_;
  std::map<std::filesystem::path, std::shared_ptr<const ScalarGrid>> grids_;
};

}  // namespace

std::vector<radiometry::Volume> load_volumes(const Scenario& scenario, const TerrainProbe& terrain,
                                             InputFiles& files) {
  VolumeLoader loader{terrain, files};
  std::vector<radiometry::Volume> all;
  ErrorList errors;
  for (const VolumeInput& input : scenario.volumes) {
    errors.attempt([&] { all.push_back(loader.load(input)); });
  }
  errors.throw_if_any();
  return all;
}

}  // namespace nadir::sim
