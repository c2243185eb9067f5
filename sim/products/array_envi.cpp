#include "sim/files/envi.hpp"
#include "sim/products/array_files.hpp"
#include "sim/products/envi_products.hpp"

namespace nadir::sim {
namespace {

/// A file while it is written.
struct OpenEnvi {
  const char* kind;
  std::filesystem::path file;
  std::vector<PlaneSource> planes;
  std::unique_ptr<EnviWriter> writer;
};

OpenEnvi open_envi(EnviProduct product, const ArrayTask& task) {
  const auto file = with_ending(task.stem, product.ending);
  auto writer = std::make_unique<EnviWriter>(file, std::move(product.header), product.type,
                                             product.planes.size());
  return {product.kind, file, std::move(product.planes), std::move(writer)};
}

}  // namespace

struct ArrayEnvi::State {
  std::string array;
  std::vector<OpenEnvi> files;
  std::vector<float> room;
};

ArrayEnvi::ArrayEnvi(const ArrayImage& first, const ArrayTask& task)
    : state_{std::make_unique<State>()} {
  state_->array = first.name;
  for (EnviProduct& product : envi_products(first, task)) {
    state_->files.push_back(open_envi(std::move(product), task));
  }
}

ArrayEnvi::~ArrayEnvi() = default;
ArrayEnvi::ArrayEnvi(ArrayEnvi&&) noexcept = default;
ArrayEnvi& ArrayEnvi::operator=(ArrayEnvi&&) noexcept = default;

void ArrayEnvi::take(const ArrayImage& strip) {
  for (const OpenEnvi& file : state_->files) {
    for (std::size_t i = 0; i < file.planes.size(); ++i) {
      const StripPlane plane = file.planes[i](strip, state_->room);
      std::visit([&](auto numbers) { file.writer->write(i, numbers); }, plane);
    }
  }
}

void ArrayEnvi::finish(std::vector<ProductFile>& written) {
  for (const OpenEnvi& file : state_->files) {
    file.writer->commit();
    for (const auto& path : {file.file, envi_header_of(file.file)}) {
      written.push_back({file.kind, state_->array, path, std::filesystem::file_size(path)});
    }
  }
}

}  // namespace nadir::sim
