#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <string>
#include <vector>

#include "atmosphere/make/probe.hpp"
#include "atmosphere/make/table_filler.hpp"
#include "atmosphere/make/table_job.hpp"
#include "core/error.hpp"

namespace nadir::atmosphere {
namespace {

std::string described(const AirSettings& s) {
  const bool fast = s.mode == AirMode::fast;
  return std::string("nadir, ") +
         (fast ? "two streams" : std::to_string(s.streams) + " streams, discrete ordinates") +
         "; nodes: zenith 2 x " + std::to_string(s.zenith_nodes) + ", azimuth " +
         std::to_string(s.azimuth_nodes) + ", share " + std::to_string(s.share_nodes);
}

}  // namespace

AirParts TableJob::wanted_anywhere() const {
  if (wanted.empty()) return {};
  AirParts all = AirParts::none();
  for (const AirParts& parts : wanted) all = all | parts;
  return all;
}

AirTable filled_table(const TableJob& job, SolveCounts* counts) {
  if (job.lanes.empty()) throw InputError("air table: no wavelengths");
  TableFiller filler{job};
  std::vector<SolveCounts> each(job.lanes.size());
  ErrorProbe probe{job, filler};
  namespace tbb = oneapi::tbb;
  tbb::parallel_for(tbb::blocked_range<std::size_t>{0, job.lanes.size(), 1},
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t lane = range.begin(); lane != range.end(); ++lane) {
                        LaneFields fields = filler.solved(lane, each[lane]);
                        filler.put(lane, fields);
                        probe.keep(lane, std::move(fields));
                      }
                    });
  if (counts != nullptr) {
    for (const SolveCounts& c : each) *counts += c;
  }
  AirTable table = filler.take();
  table.made_by = described(job.settings);
  table.interpolation_error = probe.largest_error(table);
  return table;
}

}  // namespace nadir::atmosphere
