#include "atmosphere/layered.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <string>
#include <utility>

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
  const auto interval = [&](std::size_t i) { return i < of.size() ? of[i] : AbsorptionLane{}; };
  std::vector<std::vector<AbsorptionTerm>> terms(wavelengths.size());
  tbb::parallel_for(std::size_t{0}, wavelengths.size(), [&](std::size_t i) {
    terms[i] = maker.terms(interval(i), wavelengths[i], settings.term_tolerance);
  });
  std::vector<SplitLane> lanes;
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    AbsorptionLane absorption = interval(i);
    for (std::size_t t = 0; t < terms[i].size(); ++t) {
      absorption.term = static_cast<int>(t);
      lanes.push_back(
          {static_cast<int>(i), absorption, terms[i][t].weight, std::move(terms[i][t].depth)});
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
    if (lane.gas_depth.size() + 1 != job.level_m.size()) {
      throw InputError("expected lanes as they were split for this air");
    }
    job.lanes.push_back({wavelengths.at(source).value, lane.absorption, lane.weight});
    job.wanted.push_back(lane.wanted);
  }
  job.column = [&](std::size_t lane) {
    return maker.column(Micrometres{job.lanes[lane].wavelength_um}, lanes[lane].gas_depth);
  };
  job.bodies = job_bodies(bodies, job.lanes);
  job.airglow = at_lanes(air.night.airglow, job.lanes, "the airglow");
  job.starlight = at_lanes(air.night.starlight, job.lanes, "the starlight");
  job.urban_glow = at_lanes(air.night.urban_glow, job.lanes, "the urban glow");
  AirTable table = filled_table(job, counts);
  check(table);
  return table;
}

}  // namespace nadir::atmosphere
