#pragma once

#include <string>

namespace nadir::sim {

/// The table as a page for people, in Markdown: what docs/scenario-reference.md holds.
[[nodiscard]] std::string write_reference();

}  // namespace nadir::sim
