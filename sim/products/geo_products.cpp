#include "sim/products/geo_products.hpp"

#include "sim/products/csm_isd.hpp"
#include "sim/products/geotiff.hpp"
#include "sim/products/netcdf_swath.hpp"
#include "sim/products/stac_item.hpp"

namespace nadir::sim {

std::vector<ProductFile> write_geo_products(const ProductContext& context, std::size_t array,
                                            const std::filesystem::path& stem,
                                            const std::vector<ProductFile>& written) {
  const ProductGeometry* geometry = context.geometry;
  if (geometry == nullptr || geometry->camera == nullptr) return {};
  const GeoTask task{&context, geometry, &geometry->camera->arrays.at(array), array, stem};
  std::vector<ProductFile> files;
  const auto add = [&](const std::vector<ProductFile>& more) {
    files.insert(files.end(), more.begin(), more.end());
  };
  const Georeference place = context.wanted.geotiff ? georeference(task) : map_of(task);
  if (context.wanted.geotiff) add(write_geotiffs(task, place));
  if (context.wanted.netcdf) add(write_netcdf_swath(task));
  if (!context.wanted.sidecars) return files;
  add(write_csm_isds(task));
  std::vector<ProductFile> assets = written;
  assets.insert(assets.end(), files.begin(), files.end());
  add(write_stac_item(task, place, assets));
  return files;
}

}  // namespace nadir::sim
