#include "atmosphere/transfer/scaled_column.hpp"

#include <algorithm>
#include <string>

#include "core/error.hpp"

namespace nadir::atmosphere {

ScaledColumn delta_scaled(const OpticalColumn& column, int streams) {
  if (streams < 2 || streams % 2 != 0 || streams >= PhaseFunction::moment_count) {
    throw InputError{"streams are " + std::to_string(streams) +
                     ", expected an even number from 2 to 128"};
  }
  ScaledColumn scaled{column, {}};
  for (OpticalColumn::Kind& kind : scaled.column.kinds) {
    // A backward peak cannot be taken for light that goes straight on.
    const double f = std::max(0.0, kind.phase->moments()[static_cast<std::size_t>(streams)]);
    scaled.peak.push_back(f);
    for (double& depth : kind.scattering) depth *= 1.0 - f;
  }
  return scaled;
}

}  // namespace nadir::atmosphere
