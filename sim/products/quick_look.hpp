#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/files/png.hpp"
#include "sim/run/image.hpp"

namespace nadir::sim {

struct QuickLookOptions {
  std::string title;               ///< of the scenario
  std::string time;                ///< UTC, as it is to be read
  std::string software;            ///< name and version, into the PNG's text
  std::vector<std::string> bands;  ///< red, green, blue, or one; empty: chosen (band_choice.hpp)
};

struct QuickLook {
  PngImage picture;
  std::size_t invalid_pixels = 0;  ///< shown in magenta and named in the caption
  bool bands_as_wanted = true;     ///< false where the array has not the wanted bands
};

class Preview;

/// A picture of the array for the eye: natural colour, false colour or grey for reflected light,
/// a temperature map with a colour bar for thermal bands; below it a caption with what is shown
/// and its extremes. Narrow arrays are magnified by a whole factor. A pure function: the same
/// image gives the same bytes.
[[nodiscard]] QuickLook quick_look(const ArrayImage& image, const QuickLookOptions& options);

/// The same for an image of which a preview was kept, for the same bands. If that has not all
/// pixels, the caption says so; its extremes and counts hold for all of them.
[[nodiscard]] QuickLook quick_look(const Preview& preview, const QuickLookOptions& options);

}  // namespace nadir::sim
