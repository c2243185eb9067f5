#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sim/products/array_files.hpp"
#include "sim/products/product_checks.hpp"

namespace nadir::sim {
namespace {

using TimeEntry = std::pair<std::string, std::string>;

std::string seconds_text(double seconds) { return fmt::format("{}", seconds); }

std::vector<TimeEntry> scan_times(const sensor::GlobalShutter& shutter) {
  if (shutter.centre_s == 0.0) return {};
  return {{"exposure centre s", seconds_text(shutter.centre_s)}};
}
std::vector<TimeEntry> line_by_line(double first_line_s, double period_s) {
  return {{"first line time s", seconds_text(first_line_s)},
          {"line period s", seconds_text(period_s)}};
}
std::vector<TimeEntry> scan_times(const sensor::RollingShutter& shutter) {
  return line_by_line(shutter.first_line_s, shutter.line_period_s);
}
std::vector<TimeEntry> scan_times(const sensor::Pushbroom& scan) {
  return line_by_line(scan.first_line_s, scan.line_period_s);
}
std::vector<TimeEntry> scan_times(const sensor::Whiskbroom& scan) {
  return {{"first sample time s", seconds_text(scan.first_sample_s)},
          {"sample period s", seconds_text(scan.sample_period_s)},
          {"scan period s", seconds_text(scan.scan_period_s)},
          {"lines per scan", std::to_string(scan.lines_per_scan)}};
}

}  // namespace

ArrayTask array_task(const ProductContext& context, const std::filesystem::path& output_dir,
                     const std::string& name, std::size_t arrival) {
  ArrayTask task{&context, output_dir / product_file_name(name), arrival, nullptr};
  if (context.geometry == nullptr || context.geometry->camera == nullptr) return task;
  const auto& arrays = context.geometry->camera->arrays;
  const auto found = std::find_if(arrays.begin(), arrays.end(),
                                  [&](const auto& array) { return array.name == name; });
  if (found == arrays.end()) return task;
  task.number = static_cast<std::size_t>(found - arrays.begin());
  task.array = &*found;
  return task;
}

std::vector<std::string> names_with_sky(const std::vector<std::string>& names) {
  std::vector<std::string> all{"sky"};
  all.insert(all.end(), names.begin(), names.end());
  return all;
}

const std::vector<float>& light_share(const BandImage& band, LightShare part,
                                      std::vector<float>& room) {
  const std::vector<float>& path = band.shares.path;
  const std::vector<float>& emission = band.shares.emission;
  room.resize(band.radiance.size());
  for (std::size_t i = 0; i < room.size(); ++i) {
    const float all = band.radiance[i];
    const float value = part == LightShare::path       ? path[i]
                        : part == LightShare::emission ? emission[i]
                                                       : all - path[i] - emission[i];
    room[i] = all != 0.0F ? value / all : std::numeric_limits<float>::quiet_NaN();
  }
  return room;
}

std::vector<TimeEntry> line_times(const sensor::DetectorArray& array) {
  auto entries = std::visit([](const auto& scan) { return scan_times(scan); }, array.timing.scan);
  if (array.timing.exposure_s > 0.0) {
    entries.emplace_back("exposure s", seconds_text(array.timing.exposure_s));
  }
  return entries;
}

const sensor::Calibration* calibration_of(const ArrayTask& task, std::size_t band) {
  const auto& all = task.context->calibrations;
  if (task.number >= all.size() || band >= all[task.number].size()) return nullptr;
  return &all[task.number][band];
}

bool wants_geo_products(const ProductContext& context) {
  const ProductsInput& wanted = context.wanted;
  return context.geometry != nullptr && (wanted.geotiff || wanted.netcdf || wanted.sidecars);
}

}  // namespace nadir::sim
