#pragma once

#include <string>

#include "sim/scenario/checked_element.hpp"
#include "sim/scenario/input_paths.hpp"
#include "sim/scenario/issues.hpp"

namespace nadir::sim {

/// Checks a document against the table, starting at the type `root`: names, numbers of children,
/// attributes, values, and that files exist. Adds every mistake to `issues`; what is misspelt is
/// read as its nearest valid name, so that one slip is one mistake.
/// @throws InputError for a root element of another name: nothing in it would make sense
[[nodiscard]] CheckedElement check_document(const XmlElement& document, const std::string& root,
                                            const SourceText& source, const InputPaths& paths,
                                            Issues& issues);

}  // namespace nadir::sim
