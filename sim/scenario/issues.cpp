#include "sim/scenario/issues.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

namespace nadir::sim {

void Issues::throw_if_any() const {
  if (issues_.empty()) return;
  std::vector<std::string> files;  // in the order in which they first have a mistake
  const auto file_rank = [&](const InputIssue& issue) {
    return std::find(files.begin(), files.end(), issue.where.file) - files.begin();
  };
  for (const InputIssue& issue : issues_) {
    if (file_rank(issue) == static_cast<std::ptrdiff_t>(files.size())) {
      files.push_back(issue.where.file);
    }
  }
  std::vector<InputIssue> sorted = issues_;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const InputIssue& a, const InputIssue& b) {
    return std::tuple{file_rank(a), a.where.line, a.where.column} <
           std::tuple{file_rank(b), b.where.line, b.where.column};
  });
  throw InputError{std::move(sorted)};
}

std::string suggestion(const std::string& name, const std::vector<std::string>& known) {
  if (known.empty()) return {};
  const std::string nearest = nearest_name(name, known);
  if (!nearest.empty()) return fmt::format("did you mean \"{}\"?", nearest);
  constexpr std::size_t most = 20;  // a library has a hundred names: nobody reads them here
  const std::size_t shown = std::min(most, known.size());
  const std::vector<std::string> first(known.begin(),
                                       known.begin() + static_cast<std::ptrdiff_t>(shown));
  std::string list = fmt::format("known: {}", fmt::join(first, ", "));
  if (known.size() > most) list += fmt::format(" and {} more", known.size() - most);
  return list;
}

}  // namespace nadir::sim
