#pragma once

#include <string>

namespace nadir::sim {

/// The table as an XML Schema 1.0: what scenes/schema/nadir.xsd holds.
[[nodiscard]] std::string write_xsd();

}  // namespace nadir::sim
