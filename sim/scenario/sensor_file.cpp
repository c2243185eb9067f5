#include "sim/scenario/sensor_file.hpp"

#include "sim/scenario/build_camera.hpp"
#include "sim/scenario/read_root.hpp"

namespace nadir::sim {
namespace {

SensorInput build_sensor(const BuildContext& context, const CheckedElement& root) {
  SensorInput sensor;
  sensor.name = root.value<std::string>("name");
  sensor.title = root.value<std::string>("title");
  sensor.source = root.value<std::string>("source");
  sensor.nominal_height_m = root.number("nominal_height_m");
  sensor.ground_speed_m_s = root.number("ground_speed_m_s");
  if (!root.children.empty()) sensor.camera = build_projection(context, root.children.front());
  sensor.camera.name = sensor.name;
  sensor.camera.platform_name = root.value<std::string>("platform");
  return sensor;
}

}  // namespace

std::optional<SensorInput> read_sensor(const std::filesystem::path& file, Issues& issues) {
  auto sensor = read_root(file, sensor_root, issues, build_sensor);
  if (sensor) sensor->camera.sensor_file = file;
  return sensor;
}

SensorInput read_sensor_file(const std::filesystem::path& file) {
  Issues issues;
  auto sensor = read_sensor(file, issues);
  issues.throw_if_any();
  return std::move(*sensor);
}

bool is_sensor_file(const std::filesystem::path& file) {
  return parse_xml(read_source_text(file)).name == schema().type(sensor_root).name;
}

}  // namespace nadir::sim
