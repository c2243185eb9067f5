#include "sim/products/netcdf_swath.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/files/envi.hpp"
#include "sim/files/raster_write.hpp"
#include "sim/products/ground_points.hpp"

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;

// The file's dimensions, by number.
enum Dimension { band_dimension = 0, line_dimension = 1, sample_dimension = 2 };

// One more than the cube has dimensions: GDAL would take as many for the axes themselves.
constexpr const char* auxiliary = "time latitude longitude height wavelength band_name";
using VariableType = NetCdfVariable::Type;

/// The places of pixels: those of the truth, or computed for the time of the writing.
class PlaceFile {
 public:
  explicit PlaceFile(const GeoTask& task) : file_{task.with("_place.img")} {
    if (fs::exists(file_)) return;
    file_ = task.with("_swath-places.img");
    own_ = true;
    write_places(file_, *task.geometry, *task.array);
  }
  ~PlaceFile() {
    if (!own_) return;
    std::error_code ignored;
    fs::remove(file_, ignored);
    fs::remove(envi_header_of(file_), ignored);
  }
  PlaceFile(const PlaceFile&) = delete;
  PlaceFile& operator=(const PlaceFile&) = delete;
  [[nodiscard]] const fs::path& file() const { return file_; }

 private:
  fs::path file_;
  bool own_ = false;
};

std::vector<double> line_times_of(const sensor::DetectorArray& array) {
  std::vector<double> times;
  for (int line = 0; line < array.lines; ++line) {
    times.push_back(sensor::image_time_s(array, {0.5 * array.samples, line + 0.5}));
  }
  return times;
}

/// CF's form of a moment: as ISO 8601 but for the blank.
std::string since(const ephemeris::Instant& time) {
  std::string text = time.to_string();
  std::replace(text.begin(), text.end(), 'T', ' ');
  std::replace(text.begin(), text.end(), 'Z', ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  return "seconds since " + text + " UTC";
}

NetCdfVariable cube(const char* name, const fs::path& file, NetCdfAttributes attributes) {
  attributes.emplace_back("units", radiance_unit);
  attributes.emplace_back("coordinates", auxiliary);
  attributes.emplace_back("grid_mapping", "crs");
  return {name,
          {band_dimension, line_dimension, sample_dimension},
          VariableType::float32,
          RasterPlanes{file, 1},
          std::move(attributes),
          true};
}

/// How many paths each pixel had, and what is stated of the error that they do not show: where the
/// image was sampled to a goal.
void add_sampling(const GeoTask& task, std::vector<NetCdfVariable>& variables) {
  const auto bias = task.with("_bias.img"), paths = task.with("_paths.img");
  if (fs::exists(bias)) {
    variables.push_back(cube("radiance_bias", bias,
                             {{"long_name", "bound of the systematic error of the radiance"}}));
  }
  if (!fs::exists(paths)) return;
  variables.push_back({"paths",
                       {line_dimension, sample_dimension},
                       VariableType::int32,
                       RasterPlanes{paths, 1},
                       {{"long_name", "paths that the pixel was sampled with"},
                        {"units", "1"},
                        {"coordinates", auxiliary},
                        {"grid_mapping", "crs"}}});
}

void add_cubes(const GeoTask& task, std::vector<NetCdfVariable>& variables) {
  const auto error = task.with("_error.img");
  const bool has_error = fs::exists(error);
  NetCdfAttributes attributes{
      {"standard_name", "toa_outgoing_radiance_per_unit_wavelength"},
      {"long_name", "spectral radiance at the sensor's aperture, mean over the band"}};
  if (has_error) attributes.emplace_back("ancillary_variables", "radiance_error");
  variables.push_back(cube("radiance", task.with("_radiance.img"), std::move(attributes)));
  if (!has_error) return;
  variables.push_back(
      cube("radiance_error", error,
           {{"standard_name", "toa_outgoing_radiance_per_unit_wavelength standard_error"},
            {"long_name", "standard error of the radiance"}}));
}

void add_bands(const GeoTask& task, std::vector<NetCdfVariable>& variables) {
  std::vector<std::string> names;
  std::vector<double> centres, widths;
  for (const BandFigures& band : band_figures(*task.array)) {
    names.push_back(band.name);
    centres.push_back(band.centre_um);
    widths.push_back(band.fwhm_um);
  }
  variables.push_back({"wavelength",
                       {band_dimension},
                       VariableType::float64,
                       centres,
                       {{"standard_name", "sensor_band_central_radiation_wavelength"},
                        {"long_name", "centroid of the band's response"},
                        {"units", "um"}}});
  variables.push_back(
      {"wavelength_width",
       {band_dimension},
       VariableType::float64,
       widths,
       {{"long_name", "full width of the band's response at half its maximum"}, {"units", "um"}}});
  variables.push_back({"band_name",
                       {band_dimension},
                       VariableType::float64,
                       names,
                       {{"standard_name", "sensor_band_identifier"}, {"long_name", "band"}}});
}

void add_places(const fs::path& places, std::vector<NetCdfVariable>& variables) {
  struct Plane {
    const char* name;
    const char* units;
    const char* standard_name;
  };
  const Plane planes[] = {{"latitude", "degrees_north", "latitude"},
                          {"longitude", "degrees_east", "longitude"},
                          {"height", "m", "height_above_reference_ellipsoid"}};
  int number = 0;
  for (const Plane& plane : planes) {
    NetCdfAttributes attributes{{"standard_name", plane.standard_name}, {"units", plane.units}};
    if (number == 2) attributes.emplace_back("positive", "up");
    variables.push_back({plane.name,
                         {line_dimension, sample_dimension},
                         VariableType::float64,
                         RasterPlanes{places, ++number},
                         std::move(attributes),
                         true});
  }
}

void add_times(const GeoTask& task, std::vector<NetCdfVariable>& variables) {
  NetCdfAttributes attributes{{"standard_name", "time"},
                              {"long_name", "centre of the exposure of the line's middle sample"},
                              {"units", since(task.geometry->time)},
                              {"calendar", "standard"}};
  variables.push_back(
      {"time", {line_dimension}, VariableType::float64, line_times_of(*task.array), attributes});
}

void add_reference(std::vector<NetCdfVariable>& variables) {
  variables.push_back({"crs",
                       {},
                       VariableType::int32,
                       std::vector<double>{0.0},
                       {{"grid_mapping_name", "latitude_longitude"},
                        {"long_name", "WGS 84"},
                        {"semi_major_axis", 6378137.0},
                        {"inverse_flattening", 298.257223563},
                        {"longitude_of_prime_meridian", 0.0}}});
}

}  // namespace

std::vector<ProductFile> write_netcdf_swath(const GeoTask& task) {
  const PlaceFile places{task};
  const sensor::DetectorArray& array = *task.array;
  const Camera& camera = *task.geometry->camera;
  NetCdf file;
  file.dimensions = {{"band", static_cast<int>(array.bands.size())},
                     {"line", array.lines},
                     {"sample", array.samples}};
  file.attributes = {{"Conventions", "CF-1.10"},
                     {"title", fmt::format("Simulated radiance of {}, array {}",
                                           task.context->scenario_name, array.name)},
                     {"institution", "simulation"},
                     {"source", fmt::format("nadir {}", task.context->version)},
                     {"history", fmt::format("rendered by nadir {}", task.context->version)},
                     {"references", "docs/geometry-products.md of nadir"}};
  if (!camera.platform_name.empty()) {
    file.attributes.emplace_back("platform", camera.platform_name);
  }
  if (!camera.instrument_name.empty()) {
    file.attributes.emplace_back("instrument", camera.instrument_name);
  }
  add_cubes(task, file.variables);
  add_sampling(task, file.variables);
  add_bands(task, file.variables);
  add_places(places.file(), file.variables);
  add_times(task, file.variables);
  add_reference(file.variables);
  const auto target = task.with(".nc");
  write_netcdf(target, file);
  return {task.record("NetCDF swath", target)};
}

}  // namespace nadir::sim
