#include "sim/run/load_camera_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/files/point_spread_file.hpp"
#include "sim/files/view_table_file.hpp"
#include "sim/run/read_curves.hpp"

namespace nadir::sim {
namespace {

constexpr double metres_per_um = 1e-6;
constexpr double metres_per_mm = 1e-3;
constexpr double seconds_per_ms = 1e-3;
constexpr double seconds_per_us = 1e-6;

/// Runs a part; mistakes of it that do not say where they are lie at `where` and get its name.
template <class F>
auto at_part(const SourceLocation& where, const std::string& name, F&& part) {
  try {
    return part();
  } catch (const InputError& error) {
    std::vector<InputIssue> issues = error.issues();
    for (InputIssue& issue : issues) {
      if (!issue.where.file.empty()) continue;
      issue.where = where;
      issue.message = name + ": " + issue.message;
    }
    throw InputError{std::move(issues)};
  }
}

// ---- responses ----------------------------------------------------------------------------------

/// Electrons a photon as a weight of radiance: times the wavelength. Between the table's rows the
/// product of two straight lines bends, by their slopes times (step / 2)^2: it gets rows of its
/// own, so close that this is below 1e-5 of a response that doubles over a tenth of a micrometre.
spectral::Curve weighting_radiance(const spectral::Curve& quantum) {
  constexpr double most_step = 0.002;  // of the wavelength
  const std::vector<double>& from = quantum.wavelengths_um();
  std::vector<double> wavelengths, values;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double next = i + 1 < from.size() ? from[i + 1] : from[i];
    const int parts =
        std::max(1, static_cast<int>(std::ceil((next - from[i]) / from[i] / most_step)));
    const int rows = i + 1 < from.size() ? parts : 1;
    for (int k = 0; k < rows; ++k) {
      const double w = from[i] + (next - from[i]) * k / parts;
      wavelengths.push_back(w);
      values.push_back(w * quantum.at(Micrometres{w}));
    }
  }
  return {std::move(wavelengths), std::move(values), spectral::Outside::zero};
}

spectral::Response response_of(const BoxBand& box, CurveReader& /*curves*/) {
  return spectral::BoxResponse{Micrometres{box.lo_um}, Micrometres{box.hi_um}};
}
spectral::Response response_of(const GaussianBand& gaussian, CurveReader& /*curves*/) {
  return spectral::GaussianResponse{Micrometres{gaussian.centre_um}, Micrometres{gaussian.fwhm_um}};
}
spectral::Response response_of(const TabulatedBand& table, CurveReader& curves) {
  spectral::Curve curve =
      curves.read({table.file, table.column}, SpectrumQuantity::response, spectral::Outside::zero);
  if (table.quantum) curve = weighting_radiance(curve);
  return spectral::TabulatedResponse{std::move(curve)};
}

// ---- timing -------------------------------------------------------------------------------------

sensor::Timing load_timing(const ArrayInput& input) {
  const double first_s = first_exposure_s(input.timing, input.samples, input.lines);
  sensor::Timing timing;
  if (const auto* global = std::get_if<GlobalShutterInput>(&input.timing)) {
    timing.scan = sensor::GlobalShutter{first_s};
    timing.exposure_s = global->exposure_ms * seconds_per_ms;
  } else if (const auto* rolling = std::get_if<RollingShutterInput>(&input.timing)) {
    timing.scan = sensor::RollingShutter{first_s, rolling->line_period_ms * seconds_per_ms};
    timing.exposure_s = rolling->exposure_ms * seconds_per_ms;
  } else if (const auto* push = std::get_if<PushbroomInput>(&input.timing)) {
    timing.scan = sensor::Pushbroom{first_s, push->line_period_ms * seconds_per_ms};
    timing.exposure_s = push->exposure_ms * seconds_per_ms;
    timing.tdi_stages = push->tdi_stages;
    timing.tdi_reversed = push->tdi_behind;
  } else if (const auto* whisk = std::get_if<WhiskbroomInput>(&input.timing)) {
    timing.scan = sensor::Whiskbroom{first_s, whisk->sample_period_us * seconds_per_us,
                                     whisk->scan_period_ms * seconds_per_ms, whisk->lines_per_scan};
    timing.exposure_s = whisk->exposure_us * seconds_per_us;
  } else if (const auto* lag = std::get_if<BolometerInput>(&input.timing)) {
    timing.lag_s = lag->time_constant_ms * seconds_per_ms;
    if (lag->line_period_us > 0.0) {
      timing.scan = sensor::RollingShutter{first_s, lag->line_period_us * seconds_per_us};
    } else {
      timing.scan = sensor::GlobalShutter{lag->start_s.value_or(0.0)};
    }
  }
  return timing;
}

// ---- where pixels look --------------------------------------------------------------------------

/// Lines of sight of the part of a table that an array's image is cut from, pixel by pixel: the
/// table's own bilinear values.
/// @throws InputError where the table ends before the part does
sensor::ViewTable cut_views(const sensor::ViewTable& table, const ArrayInput& input) {
  const auto pixels = [](int nodes, double step) { return (nodes - 1) * step + 1.0; };
  constexpr double slack = 1e-3;  // steps are printed with few digits
  sensor::ViewTable part;
  part.samples = input.samples;
  part.lines = table.lines == 1 ? 1 : input.lines;
  if (pixels(table.samples, table.sample_step) + slack < input.first_sample + part.samples ||
      (table.lines > 1 &&
       pixels(table.lines, table.line_step) + slack < input.first_line + part.lines)) {
    throw InputError{"it ends before the part of the image that is wanted"};
  }
  for (int line = 0; line < part.lines; ++line) {
    for (int sample = 0; sample < part.samples; ++sample) {
      part.directions.push_back(sensor::direction(
          table, {input.first_sample + sample + 0.5, input.first_line + line + 0.5}));
    }
  }
  return part;
}

sensor::Tabulated load_views(const ArrayInput& input, InputFiles& files) {
  const std::filesystem::path& file = files.note(*input.view_table);
  return at_part({file.string(), 0, 0}, "view table", [&] {
    sensor::ViewTable table = read_view_table(file);
    return sensor::checked(input.is_cut ? cut_views(table, input) : std::move(table));
  });
}

void place(const LensInput& lens, const ArrayInput& input, sensor::DetectorArray& array) {
  array.projection = sensor::Perspective{lens.focal_length_mm * metres_per_mm,
                                         {lens.k1, lens.k2, lens.p1, lens.p2, lens.k3}};
  array.offset_x_m = (input.offset_x_um - lens.principal_x_um) * metres_per_um;
  array.offset_y_m = (input.offset_y_um - lens.principal_y_um) * metres_per_um;
}

/// The array's own facts, without what comes from files.
sensor::DetectorArray frame_of(const ArrayInput& input, const CameraInput& camera) {
  sensor::DetectorArray array;
  array.name = input.name;
  array.samples = input.samples;
  array.lines = input.lines;
  if (camera.orthographic) {
    array.projection = sensor::Orthographic{};
    array.pitch_m = input.ground_pitch_m;
    array.pitch_y_m = input.ground_pitch_y_m;
    array.offset_x_m = input.offset_x_m;
    array.offset_y_m = input.offset_y_m;
  } else {
    array.pitch_m = input.pitch_um * metres_per_um;
    array.pitch_y_m = input.pitch_y_um * metres_per_um;
    if (!input.view_table) place(input.lens.value_or(camera.lens), input, array);
  }
  array.fill_x = input.fill_x;
  array.fill_y = input.fill_y;
  array.timing = load_timing(input);
  for (const ModuleInput& module : input.modules) {
    array.modules.push_back({module.first_sample, module.samples,
                             module.offset_x_um * metres_per_um, module.offset_y_um * metres_per_um,
                             module.rotation_deg * std::numbers::pi / 180.0});
  }
  return array;
}

// ---- blur ---------------------------------------------------------------------------------------

sensor::SpreadDescription describe_spread(const BlurInput& blur, InputFiles& files) {
  sensor::SpreadDescription description;
  if (blur.diffraction) {
    description.diffraction =
        sensor::DiffractionSpread{blur.diffraction->f_number, blur.diffraction->obscuration};
  }
  for (const GaussianBlurInput& gaussian : blur.gaussians) {
    description.gaussians.push_back(
        {gaussian.sigma_x_um * metres_per_um, gaussian.sigma_y_um * metres_per_um});
  }
  if (blur.table) description.table = read_point_spread(files.note(*blur.table));
  if (blur.stray) {
    description.stray =
        sensor::StraySpread{blur.stray->share, blur.stray->core_um * metres_per_um,
                            blur.stray->slope, blur.stray->reach_um * metres_per_um};
  }
  return description;
}

std::shared_ptr<const sensor::PointSpread> load_spread(const BlurInput& blur,
                                                       const std::vector<sensor::Band>& bands,
                                                       InputFiles& files) {
  if (blur.is_none()) return nullptr;
  std::vector<spectral::Response> responses;
  for (const sensor::Band& band : bands) responses.push_back(band.response);
  return std::make_shared<const sensor::PointSpread>(describe_spread(blur, files), responses);
}

/// @return whether all its bands are there
bool load_bands(const ArrayInput& input, sensor::DetectorArray& array,
                std::vector<BandElectronics>& electronics, CurveReader& curves, ErrorList& errors) {
  for (const BandInput& band : input.bands) {
    errors.attempt([&] {
      at_part(band.where, "band " + band.name + " of array " + input.name, [&] {
        const auto response =
            std::visit([&](const auto& r) { return response_of(r, curves); }, band.response);
        spectral::check(response);
        array.bands.push_back({band.name, response});
        electronics.push_back(load_electronics(input, band, array, response));
      });
    });
  }
  return electronics.size() == input.bands.size();
}

}  // namespace

CameraArrays load_arrays(const CameraInput& camera, InputFiles& files, ErrorList& errors) {
  CameraArrays loaded;
  CurveReader curves{files};
  for (const ArrayInput& input : camera.arrays) {
    sensor::DetectorArray array = frame_of(input, camera);
    std::vector<BandElectronics> electronics;
    const bool bands = load_bands(input, array, electronics, curves, errors);
    errors.attempt([&] {
      at_part(input.where, "array " + input.name, [&] {
        if (input.view_table) array.projection = load_views(input, files);
        sensor::check(array);
        if (!bands) return;
        array.spread = load_spread(input.blur, array.bands, files);
        check_electronics(input, array, electronics);
      });
    });
    loaded.arrays.push_back(std::move(array));
    loaded.electronics.push_back(std::move(electronics));
  }
  return loaded;
}

sensor::TimeSpan span_of(const std::vector<sensor::DetectorArray>& arrays) {
  sensor::TimeSpan all =
      sensor::span(arrays.front().timing, arrays.front().samples, arrays.front().lines);
  for (const sensor::DetectorArray& array : arrays) {
    const sensor::TimeSpan own = sensor::span(array.timing, array.samples, array.lines);
    all = {std::min(all.first_s, own.first_s), std::max(all.last_s, own.last_s)};
  }
  return all;
}

}  // namespace nadir::sim
