# Every library that Nadir uses, found once, under the names that the folders link.
find_package(PkgConfig REQUIRED)
find_package(TBB REQUIRED CONFIG)
find_package(Eigen3 REQUIRED CONFIG)
find_package(tinyxml2 REQUIRED CONFIG)
find_package(OpenEXR REQUIRED CONFIG)
find_package(CLI11 REQUIRED CONFIG)
find_package(fmt REQUIRED CONFIG)
find_package(nlohmann_json REQUIRED CONFIG)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(ZLIB REQUIRED)
find_package(GDAL REQUIRED CONFIG)
find_package(OpenImageIO REQUIRED CONFIG)
find_package(embree ${NADIR_EMBREE} REQUIRED CONFIG)
# GeographicLib's own find module lies outside CMake's search path on Debian; pkg-config works.
pkg_check_modules(GEOGRAPHICLIB REQUIRED IMPORTED_TARGET geographiclib)
pkg_check_modules(ERFA REQUIRED IMPORTED_TARGET erfa)

# Debian's OpenImageIO target names an opencv4 include folder that nothing installs.
get_target_property(_oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(FILTER _oiio_includes EXCLUDE REGEX "opencv4$")
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${_oiio_includes}")
