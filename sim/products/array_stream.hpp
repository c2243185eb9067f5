#pragma once

#include <optional>
#include <vector>

#include "sim/products/array_files.hpp"
#include "sim/products/preview.hpp"
#include "sim/products/product_checks.hpp"
#include "sim/products/running_summary.hpp"

namespace nadir::sim {

/// Everything that is made of one array while its strips come: its files, its quick look, its
/// summary. In memory are, beside the strip, the pixels of the preview.
class ArrayStream {
 public:
  /// Makes the files; takes nothing yet.
  /// @param context  must outlive this
  /// @param arrival  how many arrays came before
  ArrayStream(const ArrayImage& first, const ProductContext& context,
              const std::filesystem::path& output_dir, std::size_t arrival);

  /// @throws std::invalid_argument for a strip that does not follow the former one
  void take(const ArrayImage& strip);
  [[nodiscard]] bool is_complete() const noexcept { return next_line_ == lines_; }
  /// @throws std::invalid_argument while lines are missing
  void check_complete() const;

  /// What the array has come to.
  struct Finished {
    std::vector<ProductFile> files;      ///< those that are wanted
    std::vector<ProductFile> temporary;  ///< to be removed when other products are made from them
    ArraySummary summary;
    bool shown_as_wanted = true;  ///< whether it has the bands wanted for the quick look
    ArrayTask task;
  };
  /// Gives the files their names. Only of a complete array, and only once.
  [[nodiscard]] Finished finish();

  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  void check_next(const ArrayImage& strip) const;
  void write_quick_look(Finished& finished);

  const ProductContext* context_;
  ArrayTask task_;
  std::string name_;
  int samples_, lines_, next_line_ = 0;
  std::vector<std::string> bands_;
  PlaneList planes_;
  RunningSummary summary_;
  std::optional<Preview> preview_;
  std::optional<ArrayEnvi> envi_;
  std::optional<ArrayExr> exr_;
};

}  // namespace nadir::sim
