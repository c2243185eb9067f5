#include "atmosphere/make/table_filler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "atmosphere/make/sky_flux.hpp"
#include "atmosphere/make/twilight.hpp"
#include "atmosphere/night/night_sky.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "core/error.hpp"

namespace nadir::atmosphere {
namespace {

using std::numbers::pi;

constexpr double degree = pi / 180.0;
/// A body further below the horizon lights the scene as little as the stars do.
constexpr double night_elevation = -18.0 * degree;
/// Down to here twilight is computed; below, the sky of this elevation fades as measured.
constexpr double twilight_elevation = -6.0 * degree;
/// Even steps in sqrt(sin(Theta / 2)): 1e-4 of Rayleigh's phase function between nodes.
constexpr std::size_t phase_nodes = 257;

void check_settings(const TableJob& job) {
  const AirSettings& s = job.settings;
  const auto expect = [](bool good, const std::string& message) {
    if (!good) throw InputError("air settings: " + message);
  };
  expect(s.streams >= 2 && s.streams <= 128 && s.streams % 2 == 0,
         "streams are " + std::to_string(s.streams) + ", expected an even number from 2 to 128");
  expect(s.zenith_nodes >= 3 && s.zenith_nodes <= 400, "zenith nodes must be 3 to 400");
  expect(s.azimuth_nodes >= 2 && s.azimuth_nodes <= 400, "azimuth nodes must be 2 to 400");
  expect(s.share_nodes >= 2 && s.share_nodes <= 400, "share nodes must be 2 to 400");
  expect(s.dark_below >= 0.0 && s.dark_below < 1.0, "dark_below must lie in [0, 1)");
  if (s.paths && s.observer_height_m < job.level_m.back() - 1e-6) {
    throw InputError("the observer, " + std::to_string(s.observer_height_m) +
                     " m above sea level, lies inside the ground at " +
                     std::to_string(job.level_m.back()) + " m");
  }
}

double elevation_of(const TableJob::Body& body) {
  return std::asin(std::clamp(body.direction_enu.z, -1.0, 1.0));
}

/// Cosine of the zenith angle of the middle of what is seen of a disc: one that has half set still
/// shines over the horizon.
double seen_mu0(double elevation, double radius) {
  if (elevation > radius || elevation < -radius) return std::sin(elevation);
  return std::sin(0.5 * (std::max(0.0, elevation - radius) + elevation + radius));
}

/// Irradiance of level ground by a town's glow of radiance 1 in the zenith, by the midpoint rule.
double urban_glow_flux() {
  constexpr int count = 32;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double mu = (i + 0.5) / count;
    sum += 2.0 * pi * mu * urban_glow_shape(mu) / count;
  }
  return sum;
}

AirTable::View table_view(const ViewShape& shape) {
  AirTable::View view;
  view.height_m = shape.height_m;
  view.zenith_rad = shape.zenith_rad;
  view.azimuth_rad = shape.azimuth_rad;
  view.share = shape.share;
  return view;
}

void size_view(AirTable::View& view, std::size_t bodies, std::size_t kinds, std::size_t lanes) {
  const std::size_t all = view.places() * lanes;
  view.extinction.assign(all, 0.0F);
  view.even.assign(all, 0.0F);
  view.night.assign(all, 0.0F);
  view.ground.assign(all, 0.0F);
  view.first.assign(bodies * kinds * all, 0.0F);
  view.smooth.assign(bodies * view.azimuth_rad.size() * all, 0.0F);
}

void spread(std::vector<float>& rows, const std::vector<float>& column, std::size_t lane,
            std::size_t lanes) {
  for (std::size_t i = 0; i < column.size(); ++i) rows[i * lanes + lane] = column[i];
}

void put_view(AirTable::View& view, const LaneView& column, std::size_t lane, std::size_t lanes) {
  spread(view.extinction, column.extinction, lane, lanes);
  spread(view.even, column.even, lane, lanes);
  spread(view.night, column.night, lane, lanes);
  spread(view.ground, column.ground, lane, lanes);
  spread(view.first, column.first, lane, lanes);
  spread(view.smooth, column.smooth, lane, lanes);
}

bool any_night(const TableJob& job) {
  const auto positive = [](double v) { return v > 0.0; };
  return std::any_of(job.airglow.begin(), job.airglow.end(), positive) ||
         std::any_of(job.starlight.begin(), job.starlight.end(), positive);
}

}  // namespace

TableFiller::TableFiller(const TableJob& job)
    : job_{job}, shells_{job.level_m, DirectionGrid{job.settings.streams}} {
  check_settings(job);
  table_.lanes = job.lanes;
  table_.top_m = shells_.top_m();
  table_.ground_m = shells_.ground_m();
  choose_bodies();
  AirSettings settings = job.settings;
  const AirParts wanted = job.wanted_anywhere();
  if (kept_.empty() || !wanted.scattering()) settings.azimuth_nodes = 1;
  sky_ = sky_shape(shells_, settings);
  if (settings.paths && wanted.path()) {
    const double height = std::clamp(settings.observer_height_m, table_.ground_m, table_.top_m);
    views_.push_back(view_shape(shells_, settings, height, any_night(job)));
  }
  size_arrays(job.column(0).kinds.size());
}

double TableFiller::irradiance(std::size_t body, std::size_t lane) const {
  return job_.bodies[kept_[body]].irradiance[lane];
}

void TableFiller::choose_bodies() {
  const std::size_t lanes = table_.lanes.size();
  std::vector<double> strongest(lanes, 0.0);
  const auto strength = [&](const TableJob::Body& body, std::size_t lane) {
    return elevation_of(body) < night_elevation
               ? 0.0
               : body.irradiance[lane] * light_share(body.direction_enu.z);
  };
  for (const TableJob::Body& body : job_.bodies) {
    for (std::size_t i = 0; i < lanes; ++i) {
      strongest[i] = std::max(strongest[i], strength(body, i));
    }
  }
  for (std::size_t b = 0; b < job_.bodies.size(); ++b) {
    bool matters = false;
    for (std::size_t i = 0; i < lanes; ++i) {
      const double s = strength(job_.bodies[b], i);
      matters = matters || (s > 0.0 && s >= job_.settings.dark_below * strongest[i]);
    }
    if (matters) keep_body(b);
  }
}

void TableFiller::keep_body(std::size_t index) {
  const TableJob::Body& body = job_.bodies[index];
  const double elevation = elevation_of(body), shown = std::max(elevation, twilight_elevation);
  kept_.push_back(index);
  places_.push_back({std::sin(shown), body.angular_radius.value});
  const double growth = twilight_growth(elevation / degree);
  decline_.push_back(growth * light_share(std::sin(elevation)) / light_share(std::sin(shown)));
  if (growth > 1.0) {
    table_.notes.push_back("the " + body.name +
                           " has set: its sky is made up to the measured twilight (Janiczek & "
                           "DeYoung 1987), by a factor of " +
                           std::to_string(growth));
  }
  if (elevation < twilight_elevation) {
    table_.notes.push_back(
        "the " + body.name +
        " stands more than 6 degrees below the horizon: its sky is that of 6 degrees, faded as "
        "measured (Janiczek & DeYoung 1987)");
  }
  AirTable::Body out;
  out.name = body.name;
  out.zenith_rad = 0.5 * pi - elevation;
  out.azimuth_rad = std::atan2(body.direction_enu.x, body.direction_enu.y);
  if (out.azimuth_rad < 0.0) out.azimuth_rad += 2.0 * pi;
  table_.bodies.push_back(std::move(out));
}

void TableFiller::size_arrays(std::size_t kinds) {
  const std::size_t lanes = table_.lanes.size(), bodies = kept_.size();
  table_.kinds = static_cast<int>(kinds);
  for (AirTable::Body& body : table_.bodies) {
    for (auto* row : {&body.irradiance, &body.transmittance, &body.ground_irradiance}) {
      row->assign(lanes, 0.0F);
    }
  }
  for (std::size_t i = 0; i < phase_nodes; ++i) {
    table_.phase_grid.push_back(static_cast<double>(i) / static_cast<double>(phase_nodes - 1));
  }
  table_.phase.assign(kinds * phase_nodes * lanes, 0.0F);
  table_.sky = table_view(sky_);
  size_view(table_.sky, bodies, kinds, lanes);
  for (const ViewShape& shape : views_) {
    table_.views.push_back(table_view(shape));
    size_view(table_.views.back(), bodies, kinds, lanes);
  }
  table_.spherical_albedo.assign(lanes, 0.0F);
  table_.even_ground_irradiance.assign(lanes, 0.0F);
  table_.night_ground_irradiance.assign(lanes, 0.0F);
  table_.night_top.assign(lanes, 0.0F);
}

LaneFields TableFiller::solved(std::size_t lane, SolveCounts& counts) const {
  LaneInput input;
  input.column = job_.column(lane);
  input.wavelength = Micrometres{table_.lanes[lane].wavelength_um};
  input.airglow = job_.airglow[lane];
  input.starlight = job_.starlight[lane];
  input.urban_glow = job_.urban_glow[lane];
  const AirParts wanted = job_.wanted_at(lane);
  input.emission = wanted.emission();
  input.scattering = wanted.scattering();
  if (!input.scattering) input.airglow = input.starlight = input.urban_glow = 0.0;
  double strongest = 0.0;
  for (std::size_t b = 0; b < kept_.size(); ++b) {
    input.irradiance.push_back(irradiance(b, lane) * decline_[b]);
    const double strength = input.irradiance[b] * light_share(places_[b].mu0);
    strongest = std::max(strongest, strength);
  }
  for (std::size_t b = 0; b < kept_.size(); ++b) {
    const double strength = input.irradiance[b] * light_share(places_[b].mu0);
    if (strength < job_.settings.dark_below * strongest) input.irradiance[b] = 0.0;
  }
  return lane_fields(input, shells_, places_, job_.settings, counts);
}

void TableFiller::put(std::size_t lane, const LaneFields& fields) {
  const std::size_t lanes = table_.lanes.size();
  const LaneView sky = lane_view(fields, sky_, kept_.size());
  put_view(table_.sky, sky, lane, lanes);
  for (std::size_t v = 0; v < views_.size() && job_.wanted_at(lane).path(); ++v) {
    put_view(table_.views[v], lane_view(fields, views_[v], kept_.size()), lane, lanes);
  }
  put_phases(lane, fields);
  put_fluxes(lane, fields);
  for (std::size_t b = 0; b < kept_.size(); ++b) {
    table_.bodies[b].irradiance[lane] = static_cast<float>(irradiance(b, lane));
    const double elevation = 0.5 * pi - table_.bodies[b].zenith_rad;
    const double mu0 = seen_mu0(elevation, places_[b].angular_radius_rad);
    const double depth = slant_depths(shells_.level_m, fields.depth, mu0).back();
    table_.bodies[b].transmittance[lane] = static_cast<float>(std::exp(-depth));
  }
  for (const LaneFields::Beam& beam : fields.beams) put_body(lane, fields, beam, sky);
}

void TableFiller::put_body(std::size_t lane, const LaneFields& fields, const LaneFields::Beam& beam,
                           const LaneView& sky) {
  const double mu0 = std::max(0.0, beam.place.mu0);
  double down = beam.irradiance * (beam.transmittance.back() * mu0 + beam.fluxes.down_at_ground);
  // The column's flux takes all places of one height for alike; a set body's sky is far brighter on
  // its side: the flux of the sky as tabulated then. Not above the horizon, where the peak about
  // the body is too narrow for the sky's nodes.
  if (beam.place.mu0 <= 0.0) down = body_sky_flux(fields, sky_, sky, beam);
  // Behind opaque air the solver's rounding, 1e-16 of what goes in, may be all there is.
  table_.bodies[beam.body].ground_irradiance[lane] = static_cast<float>(std::max(0.0, down));
}

void TableFiller::put_fluxes(std::size_t lane, const LaneFields& fields) {
  const double albedo = fields.from_ground.down_at_ground / pi;
  table_.spherical_albedo[lane] = static_cast<float>(std::clamp(albedo, 0.0, 1.0));
  table_.night_top[lane] = static_cast<float>(fields.airglow + fields.starlight);
  const double night =
      fields.night_scattered * fields.sky.down_at_ground + fields.urban_glow * urban_glow_flux();
  const double even = std::max(0.0, fields.thermal.down_at_ground + night);
  table_.even_ground_irradiance[lane] = static_cast<float>(even);
  table_.night_ground_irradiance[lane] = static_cast<float>(std::clamp(night, 0.0, even));
}

AirTable TableFiller::take() {
  drop_empty_night();
  return std::move(table_);
}

/// A table without a night needs no room for it.
void TableFiller::drop_empty_night() {
  const auto dark = [](const std::vector<float>& values) {
    return std::all_of(values.begin(), values.end(), [](float v) { return v == 0.0F; });
  };
  std::vector<std::vector<float>*> all{&table_.night_ground_irradiance, &table_.sky.night};
  for (AirTable::View& view : table_.views) all.push_back(&view.night);
  for (std::vector<float>* values : all) {
    if (dark(*values)) values->clear();
  }
}

void TableFiller::put_phases(std::size_t lane, const LaneFields& fields) {
  const std::size_t lanes = table_.lanes.size();
  for (std::size_t k = 0; k < fields.phases.size(); ++k) {
    for (std::size_t i = 0; i < phase_nodes; ++i) {
      const double x = table_.phase_grid[i], half_sine = x * x;
      const double cosine = 1.0 - 2.0 * half_sine * half_sine;
      table_.phase[(k * phase_nodes + i) * lanes + lane] =
          static_cast<float>(fields.phases[k]->at(cosine));
    }
  }
}

}  // namespace nadir::atmosphere
