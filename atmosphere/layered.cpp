#include "atmosphere/layered.hpp"

#include <cmath>
#include <string>

#include "atmosphere/make/columns.hpp"
#include "atmosphere/make/table_job.hpp"
#include "core/error.hpp"
#include "spectral/coverage.hpp"

namespace nadir::atmosphere {
namespace {

using spectral::AbsorptionLane;
using spectral::Curve;

/// The mean of a curve over what a lane stands for.
double at_lane(const Curve& curve, const AbsorptionLane& lane, Micrometres wavelength,
               const std::string& what) {
  const double value = spectral::lane_mean(curve, wavelength, lane);
  if (!std::isfinite(value)) {
    throw InputError(what + " is not known at " + std::to_string(wavelength.value) + " um");
  }
  return value;
}

std::vector<double> at_lanes(const Curve& curve, const std::vector<AirTable::Lane>& lanes,
                             const std::string& what) {
  std::vector<double> values;
  values.reserve(lanes.size());
  for (const AirTable::Lane& lane : lanes) {
    values.push_back(at_lane(curve, lane.absorption, Micrometres{lane.wavelength_um}, what));
  }
  return values;
}

/// The absorption of every lane, from the terms of its wavelength.
std::vector<std::vector<double>> gas_depths(const ColumnMaker& maker, const AirSettings& settings,
                                            const std::vector<AirTable::Lane>& lanes) {
  std::vector<std::vector<double>> depths;
  depths.reserve(lanes.size());
  std::vector<AbsorptionTerm> terms;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const AirTable::Lane& lane = lanes[i];
    const AirTable::Lane& before = lanes[i > 0 ? i - 1 : 0];
    const bool same = i > 0 && before.wavelength_um == lane.wavelength_um &&
                      before.absorption.lo_um == lane.absorption.lo_um &&
                      before.absorption.hi_um == lane.absorption.hi_um;
    if (!same) {
      terms =
          maker.terms(lane.absorption, Micrometres{lane.wavelength_um}, settings.term_tolerance);
    }
    const auto term = static_cast<std::size_t>(lane.absorption.term);
    if (lane.absorption.term < 0 || term >= terms.size()) {
      throw InputError("the air has no absorption term " + std::to_string(lane.absorption.term) +
                       " at " + std::to_string(lane.wavelength_um) + " um");
    }
    depths.push_back(terms[term].depth);
  }
  return depths;
}

std::vector<TableJob::Body> job_bodies(const ephemeris::Illumination& bodies,
                                       const std::vector<AirTable::Lane>& lanes) {
  std::vector<TableJob::Body> made;
  for (const ephemeris::LightSource& body : bodies) {
    made.push_back({body.name, body.direction_enu, body.angular_radius,
                    at_lanes(body.irradiance, lanes, "the irradiance of the " + body.name)});
  }
  return made;
}

}  // namespace

std::vector<SplitLane> split_lanes(const Layered& air, const AirSettings& settings,
                                   const std::vector<Micrometres>& wavelengths,
                                   const std::vector<AbsorptionLane>& of) {
  const ColumnMaker maker{air, wavelengths};
  std::vector<SplitLane> lanes;
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    AbsorptionLane absorption = i < of.size() ? of[i] : AbsorptionLane{};
    const auto terms = maker.terms(absorption, wavelengths[i], settings.term_tolerance);
    for (std::size_t t = 0; t < terms.size(); ++t) {
      absorption.term = static_cast<int>(t);
      lanes.push_back({static_cast<int>(i), absorption, terms[t].weight});
    }
  }
  return lanes;
}

AirTable make_air_table(const Layered& air, const AirSettings& settings,
                        const std::vector<SplitLane>& lanes,
                        const std::vector<Micrometres>& wavelengths,
                        const ephemeris::Illumination& bodies, SolveCounts* counts) {
  const ColumnMaker maker{air, wavelengths};
  TableJob job;
  job.settings = settings;
  job.level_m = maker.levels_m();
  for (const SplitLane& lane : lanes) {
    const auto source = static_cast<std::size_t>(lane.source);
    job.lanes.push_back({wavelengths.at(source).value, lane.absorption, lane.weight});
  }
  const auto depths = gas_depths(maker, settings, job.lanes);
  job.column = [&](std::size_t lane) {
    return maker.column(Micrometres{job.lanes[lane].wavelength_um}, depths[lane]);
  };
  job.bodies = job_bodies(bodies, job.lanes);
  job.airglow = at_lanes(air.night.airglow, job.lanes, "the airglow");
  job.starlight = at_lanes(air.night.starlight, job.lanes, "the starlight");
  job.urban_glow = at_lanes(air.night.urban_glow, job.lanes, "the urban glow");
  return filled_table(job, counts);
}

}  // namespace nadir::atmosphere
