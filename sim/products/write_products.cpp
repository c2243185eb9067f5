#include "sim/products/write_products.hpp"

#include <set>
#include <stdexcept>

#include "sim/products/product_checks.hpp"

namespace nadir::sim {

std::vector<ProductFile> write_products(const std::vector<ArrayImage>& images,
                                        const ProductContext& context,
                                        const std::filesystem::path& output_dir) {
  // All is looked at before anything is written.
  std::set<std::string> names;
  for (const ArrayImage& image : images) {
    const std::string name = product_file_name(image.name);
    if (!names.insert(name).second) {
      throw std::invalid_argument("two arrays would write the files of " + name);
    }
    static_cast<void>(check_planes(image, context.wanted.truth));
  }
  ProductWriter writer{context, output_dir};
  for (const ArrayImage& image : images) writer.take(image);
  return writer.finish().files;
}

}  // namespace nadir::sim
