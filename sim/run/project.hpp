#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/diagnostics.hpp"
#include "ephemeris/instant.hpp"
#include "geometry/earth.hpp"
#include "geometry/scene.hpp"
#include "sensor/camera/path_view.hpp"
#include "sim/run/camera.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// A scenario's camera and the surfaces before it, without materials, light and air.
struct CameraScene {
  Scenario scenario;
  geometry::LocalFrame frame;
  geometry::Scene scene;
  Camera camera;
};

/// @throws InputError with the mistakes of the scenario, its geometry and its camera
[[nodiscard]] CameraScene load_camera_scene(const std::filesystem::path& scenario,
                                            Diagnostics& diagnostics);

/// The array of a name, or that which has a band of a name; a camera's only one without either.
/// @throws InputError naming what there is
[[nodiscard]] const sensor::DetectorArray& find_array(const Camera& camera,
                                                      const std::string& array,
                                                      const std::string& band);

/// A place in scene axes: east, north, up, m.
struct LocalPlace {
  Vec3 enu;
};
/// A place of the image; its line of sight ends at a height above the ellipsoid where one is given,
/// otherwise on the first surface.
struct ImagePlace {
  sensor::ImagePoint image;
  std::optional<double> height_m{};
};
using ProjectionPoint = std::variant<geometry::Geodetic, LocalPlace, ImagePlace>;

/// A place of the image and the place of the earth that belongs to it.
struct Projection {
  std::optional<sensor::ImagePoint> image;  ///< none: not in view, nor near it
  bool inside = false;                      ///< the image
  double time_s = 0.0;                      ///< exposure's centre, after the scenario's time
  std::optional<geometry::Ray> ray;         ///< from the camera
  std::optional<Vec3> place;                ///< scene axes; none: the line of sight meets nothing
  std::optional<geometry::Geodetic> geodetic;
  bool hidden = false;  ///< of a place asked for: a surface lies before it
};

/// Lines of sight are those of the camera at rest in its moment: without blur, jitter or bending by
/// the air.
/// @throws InputError for places that are not of the earth or far from the image
[[nodiscard]] Projection project(const CameraScene& scene, const sensor::DetectorArray& array,
                                 const ProjectionPoint& point);

/// The points of a CSV table with a row of names: latitude_deg, longitude_deg, height_m; or
/// east_m, north_m, up_m; or sample, line and perhaps height_m.
/// @param name  of the file, for messages
/// @throws InputError with the mistakes of the table
[[nodiscard]] std::vector<ProjectionPoint> read_projection_points(std::string_view text,
                                                                  const std::string& name);

enum class ProjectionFormat { text, json, csv };
/// What was found, for people, programs or tables: 1e-9 degree and pixel, 1e-6 m and s.
[[nodiscard]] std::string to_text(const std::vector<Projection>& found, ProjectionFormat format,
                                  const ephemeris::Instant& scenario_time);

}  // namespace nadir::sim
