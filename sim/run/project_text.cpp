#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/run/project.hpp"

namespace nadir::sim {
namespace {

using Json = nlohmann::ordered_json;

std::string moment_of(const Projection& one, const ephemeris::Instant& scenario_time) {
  return (scenario_time + Seconds{one.time_s}).to_string();
}

/// For people: a line for each thing that is known.
std::string plain(const Projection& one, const ephemeris::Instant& scenario_time) {
  std::string text;
  if (one.image) {
    text += fmt::format("sample {:.6f}  line {:.6f}{}\n", one.image->sample, one.image->line,
                        one.inside ? "" : "  (outside the image)");
    text += fmt::format("time {:.9f} s  {}\n", one.time_s, moment_of(one, scenario_time));
  } else {
    text += "not in view\n";
  }
  if (one.geodetic) {
    text += fmt::format("latitude {:.9f} deg  longitude {:.9f} deg  height {:.4f} m\n",
                        one.geodetic->latitude_deg, one.geodetic->longitude_deg,
                        one.geodetic->height_m);
    text += fmt::format("east {:.4f} m  north {:.4f} m  up {:.4f} m{}\n", one.place->x,
                        one.place->y, one.place->z, one.hidden ? "  (hidden)" : "");
  } else {
    text += "the line of sight meets nothing\n";
  }
  if (one.ray) {
    const geometry::Ray& ray = *one.ray;
    text += fmt::format("seen from {:.4f} {:.4f} {:.4f} m  towards {:.12f} {:.12f} {:.12f}\n",
                        ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y,
                        ray.direction.z);
  }
  return text;
}

Json json_of(const Projection& one, const ephemeris::Instant& scenario_time) {
  Json json;
  json["in_view"] = one.image.has_value();
  if (one.image) {
    json["sample"] = one.image->sample;
    json["line"] = one.image->line;
    json["inside"] = one.inside;
    json["time_s"] = one.time_s;
    json["time_utc"] = moment_of(one, scenario_time);
  }
  if (one.geodetic) {
    json["latitude_deg"] = one.geodetic->latitude_deg;
    json["longitude_deg"] = one.geodetic->longitude_deg;
    json["height_m"] = one.geodetic->height_m;
    json["east_m"] = one.place->x;
    json["north_m"] = one.place->y;
    json["up_m"] = one.place->z;
    json["hidden"] = one.hidden;
  }
  if (one.ray) {
    const geometry::Ray& ray = *one.ray;
    json["ray_origin_m"] = {ray.origin.x, ray.origin.y, ray.origin.z};
    json["ray_direction"] = {ray.direction.x, ray.direction.y, ray.direction.z};
  }
  return json;
}

/// What is not known is an empty cell.
std::string csv_row(const Projection& one) {
  std::string row;
  const auto cell = [&](bool known, double value, int decimals) {
    if (known) row += fmt::format("{:.{}f}", value, decimals);
    row += ",";
  };
  const bool image = one.image.has_value(), place = one.geodetic.has_value();
  const auto at = one.image.value_or(sensor::ImagePoint{});
  const auto geodetic = one.geodetic.value_or(geometry::Geodetic{});
  const Vec3 local = one.place.value_or(Vec3{});
  cell(image, at.sample, 9);
  cell(image, at.line, 9);
  cell(image, one.time_s, 9);
  cell(place, geodetic.latitude_deg, 12);
  cell(place, geodetic.longitude_deg, 12);
  cell(place, geodetic.height_m, 6);
  cell(place, local.x, 6);
  cell(place, local.y, 6);
  cell(place, local.z, 6);
  return row + fmt::format("{},{}\n", one.inside ? 1 : 0, one.hidden ? 1 : 0);
}

}  // namespace

std::string to_text(const std::vector<Projection>& found, ProjectionFormat format,
                    const ephemeris::Instant& scenario_time) {
  std::string text;
  if (format == ProjectionFormat::json) {
    Json all = Json::array();
    for (const Projection& one : found) all.push_back(json_of(one, scenario_time));
    return all.dump(2) + "\n";
  }
  if (format == ProjectionFormat::csv) {
    text =
        "sample,line,time_s,latitude_deg,longitude_deg,height_m,east_m,north_m,up_m,inside,"
        "hidden\n";
    for (const Projection& one : found) text += csv_row(one);
    return text;
  }
  for (const Projection& one : found) {
    text += (text.empty() ? "" : "\n") + plain(one, scenario_time);
  }
  return text;
}

}  // namespace nadir::sim
