#pragma once

#include <filesystem>

namespace nadir::sim {

/// Removes the temporaries of AtomicFile that processes which are no more have left in a folder: a
/// killed run cannot do so itself. What cannot be removed stays.
void remove_stale_temporaries(const std::filesystem::path& folder);

}  // namespace nadir::sim
