#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "sim/scenario/build_context.hpp"
#include "sim/scenario/check_document.hpp"

namespace nadir::sim {

/// Reads a file whose root is no scenario (a material library, a sensor file), checks its form and
/// hands the root on. Mistakes, which name the file, go to `issues`.
/// @param root   id of the root's type
/// @param build  makes the file's data of (BuildContext, CheckedElement)
/// @return what it makes; nothing where the file cannot be taken apart at all
template <class Build>
auto read_root(const std::filesystem::path& file, const std::string& root, Issues& issues,
               Build&& build)
    -> std::optional<decltype(build(std::declval<const BuildContext&>(),
                                    std::declval<const CheckedElement&>()))> {
  try {
    const SourceText source = read_source_text(file);
    const XmlElement xml = parse_xml(source);
    const CheckedElement element = check_document(xml, root, source, InputPaths{file}, issues);
    Diagnostics unused;  // binding tells again of what matters in what is used
    return build(BuildContext{source, issues, unused}, element);
  } catch (const InputError& error) {
    issues.add(error);
    return std::nullopt;
  }
}

}  // namespace nadir::sim
