#include "sim/files/raster_write.hpp"

#include <deque>
#include <stdexcept>

#include "sim/files/modules.hpp"
#include "sim/modules/rasters/raster_module.hpp"

namespace nadir::sim {
namespace {

namespace fs = std::filesystem;

const NadirRasterModule& writing_module() {
  const auto& table = load_module<NadirRasterModule>("nadir_rasters", "nadir_raster_module");
  if (table.version != nadir_raster_module_version) {
    throw std::runtime_error("the module nadir_rasters belongs to another version of nadir");
  }
  return table;
}

/// A call of the module with room for its complaint.
template <class Call>
void checked_call(const fs::path& file, const Call& call) {
  std::array<char, 1024> message{};
  if (call(message.data(), message.size()) == 0) return;
  const std::string name = file.empty() ? "" : file.string() + ": ";
  throw std::runtime_error(name + message.data());
}

/// The module writes to a name beside the target's, which then takes its place.
template <class Write>
void write_whole(const fs::path& target, const Write& write) {
  fs::path temporary = target;
  temporary += ".part" + target.extension().string();
  std::error_code ignored;
  fs::remove(temporary, ignored);
  try {
    write(temporary);
  } catch (...) {
    fs::remove(temporary, ignored);
    throw;
  }
  fs::rename(temporary, target);
}

/// Plain views of what the job holds; the job outlives them.
class PlainTexts {
 public:
  NadirTexts of(const TextItems& items) {
    std::vector<NadirText>& plain = kept_.emplace_back();
    for (const auto& [key, value] : items) plain.push_back({key.c_str(), value.c_str()});
    return {plain.data(), static_cast<int>(plain.size())};
  }

 private:
  std::deque<std::vector<NadirText>> kept_;
};

std::vector<NadirGroundControl> plain_control(const std::vector<ControlPoint>& control) {
  std::vector<NadirGroundControl> plain;
  for (const ControlPoint& point : control) {
    plain.push_back({point.image.x, point.image.y, point.place.longitude_deg,
                     point.place.latitude_deg, point.place.height_m});
  }
  return plain;
}

std::vector<NadirGeoTiffBand> plain_bands(const std::vector<GeoTiffBand>& bands,
                                          PlainTexts& texts) {
  std::vector<NadirGeoTiffBand> plain;
  for (const GeoTiffBand& band : bands) {
    plain.push_back({band.description.c_str(), band.unit.c_str(), band.scale, band.offset,
                     texts.of(band.items)});
  }
  return plain;
}

/// A NetCDF job in the module's words.
class PlainNetCdf {
 public:
  PlainNetCdf(const fs::path& target, const NetCdf& job) : target_{target.string()} {
    for (const auto& [name, size] : job.dimensions) dimensions_.push_back({name.c_str(), size});
    for (const NetCdfVariable& variable : job.variables) add(variable);
    const auto& attributes = plain(job.attributes);
    job_ = {target_.c_str(),
            dimensions_.data(),
            static_cast<int>(dimensions_.size()),
            variables_.data(),
            static_cast<int>(variables_.size()),
            attributes.data(),
            static_cast<int>(attributes.size())};
  }
  [[nodiscard]] const NadirNetCdf& job() const { return job_; }

 private:
  static int plain(NetCdfVariable::Type type) {
    if (type == NetCdfVariable::Type::float32) return nadir_float32;
    return type == NetCdfVariable::Type::float64 ? nadir_float64 : nadir_int32;
  }

  const std::vector<NadirAttribute>& plain(const NetCdfAttributes& attributes) {
    std::vector<NadirAttribute>& kept = attributes_.emplace_back();
    for (const auto& [key, value] : attributes) {
      NadirAttribute one{key.c_str(), nullptr, 0.0, 0};
      if (const auto* text = std::get_if<std::string>(&value)) one.text = text->c_str();
      if (const auto* number = std::get_if<double>(&value)) one.number = *number;
      if (const auto* whole = std::get_if<int>(&value)) {
        one.number = *whole;
        one.is_integer = 1;
      }
      kept.push_back(one);
    }
    return kept;
  }

  void add(const NetCdfVariable& from) {
    NadirVariable to{};
    to.name = from.name.c_str();
    to.dimension_count = static_cast<int>(from.dimensions.size());
    if (to.dimension_count > 3) throw std::invalid_argument("a variable of four dimensions");
    for (std::size_t i = 0; i < from.dimensions.size(); ++i) to.dimensions[i] = from.dimensions[i];
    to.type = plain(from.type);
    if (const auto* values = std::get_if<std::vector<double>>(&from.values)) {
      to.values = values->data();
    } else if (const auto* texts = std::get_if<std::vector<std::string>>(&from.values)) {
      to.type = nadir_text;
      std::vector<const char*>& kept = texts_.emplace_back();
      for (const std::string& text : *texts) kept.push_back(text.c_str());
      to.texts = kept.data();
    } else {
      const auto& planes = std::get<RasterPlanes>(from.values);
      to.source = paths_.emplace_back(planes.file.string()).c_str();
      to.first_plane = planes.first_plane;
    }
    const auto& attributes = plain(from.attributes);
    to.attributes = attributes.data();
    to.attribute_count = static_cast<int>(attributes.size());
    to.nan_is_fill = from.nan_is_fill ? 1 : 0;
    variables_.push_back(to);
  }

  std::string target_;
  std::vector<NadirDimension> dimensions_;
  std::vector<NadirVariable> variables_;
  std::deque<std::vector<NadirAttribute>> attributes_;
  std::deque<std::vector<const char*>> texts_;
  std::deque<std::string> paths_;
  NadirNetCdf job_{};
};

}  // namespace

void write_geotiff(const fs::path& target, const GeoTiff& wanted) {
  PlainTexts texts;
  const auto control = plain_control(wanted.control);
  const auto bands = plain_bands(wanted.bands, texts);
  NadirGeoTiff job{};
  job.source = wanted.source.c_str();
  if (wanted.map) {
    job.coordinates = wanted.map->coordinates.c_str();
    for (std::size_t i = 0; i < 6; ++i) job.geotransform[i] = wanted.map->transform[i];
  } else {
    job.control = control.data();
    job.controls = static_cast<int>(control.size());
  }
  job.rpc = texts.of(wanted.rpc);
  job.items = texts.of(wanted.items);
  job.bands = bands.data();
  job.band_count = static_cast<int>(bands.size());
  job.nan_is_no_data = wanted.nan_is_no_data ? 1 : 0;
  write_whole(target, [&](const fs::path& temporary) {
    job.target = temporary.c_str();
    checked_call(target, [&](char* message, std::size_t size) {
      return writing_module().write_geotiff(&job, message, size);
    });
  });
}

void write_netcdf(const fs::path& target, const NetCdf& wanted) {
  write_whole(target, [&](const fs::path& temporary) {
    const PlainNetCdf plain{temporary, wanted};
    checked_call(target, [&](char* message, std::size_t size) {
      return writing_module().write_netcdf(&plain.job(), message, size);
    });
  });
}

std::vector<Vec2> projected(const std::string& coordinates,
                            const std::vector<geometry::Geodetic>& places) {
  std::vector<double> x, y;
  for (const geometry::Geodetic& place : places) {
    x.push_back(place.longitude_deg);
    y.push_back(place.latitude_deg);
  }
  checked_call({}, [&](char* message, std::size_t size) {
    return writing_module().project(coordinates.c_str(), static_cast<int>(places.size()), x.data(),
                                    y.data(), message, size);
  });
  std::vector<Vec2> found;
  for (std::size_t i = 0; i < x.size(); ++i) found.push_back({x[i], y[i]});
  return found;
}

}  // namespace nadir::sim
