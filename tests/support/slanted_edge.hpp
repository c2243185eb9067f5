#pragma once

#include <vector>

namespace nadir::support {

/// An image with a straight edge that crosses every line, some degrees from upright: dark (0) on
/// one side and bright (1) on the other.
struct EdgeImage {
  int samples = 0, lines = 0;
  std::vector<double> values;  ///< row-major
};

struct EdgeResponse {
  double sample_at_top = 0.0;      ///< where the edge crosses line 0; sample 0 has its centre at 0
  double samples_per_line = 0.0;   ///< how far it moves from line to line
  std::vector<double> modulation;  ///< at the frequencies that were asked for
};

/// Modulation transfer along the lines by the method of ISO 12233:2017, annex D: the centroid of
/// each line's derivative; a straight line through them; all pixels by their distance from it in
/// bins of a part of a pixel; the difference of neighbouring bins; its discrete Fourier transform.
/// Unlike there no window is laid over the line spread, which would cut its wings; each bin is
/// moved from its pixels' mean place to its middle; and the transfer of the bins' means is divided
/// out as well as that of the difference.
///
/// Frequencies are cycles per pixel along the line, not across the edge: an edge that leans by
/// `samples_per_line` also asks for f * samples_per_line along the other axis.
[[nodiscard]] EdgeResponse edge_response(const EdgeImage& image,
                                         const std::vector<double>& cycles_per_pixel,
                                         int bins_a_pixel = 4);

}  // namespace nadir::support
