# What `cmake --install` puts where:
#   bin/nadir                      the command
#   lib/nadir/                     its modules, loaded on first use
#   share/nadir/                   its data: what scenes/ holds
#   share/doc/nadir/               licence and pages
#   lib/, include/nadir/<folder>/  the libraries and their public headers
#   lib/cmake/Nadir/               find_package(Nadir); targets nadir::<folder>
# The command finds modules and data from its own place, so that the tree may be moved as a whole.
include(CMakePackageConfigHelpers)

install(TARGETS nadir_command RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(TARGETS nadir_rasters nadir_images
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/nadir")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/scenes/" DESTINATION "${CMAKE_INSTALL_DATADIR}/nadir")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs/" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
foreach(page IN ITEMS LICENSE README.md CHANGELOG.md)
  install(FILES "${PROJECT_SOURCE_DIR}/${page}" DESTINATION "${CMAKE_INSTALL_DOCDIR}" OPTIONAL)
endforeach()

get_property(modules GLOBAL PROPERTY NADIR_MODULES)
list(TRANSFORM modules PREPEND nadir_ OUTPUT_VARIABLE libraries)
# The static libraries link nadir_compiler, of which a user gets no more than its link options.
set_target_properties(nadir_compiler PROPERTIES EXPORT_NAME compiler)
install(TARGETS ${libraries} nadir_sim nadir_compiler EXPORT NadirTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
# Public headers: all but those that say that they are private to their folder, and the insides of
# the command and of the modules.
foreach(folder IN LISTS modules ITEMS sim)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}"
    "${PROJECT_SOURCE_DIR}/${folder}/*.hpp")
  list(FILTER headers EXCLUDE REGEX "^sim/(cli|modules)/")
  foreach(header IN LISTS headers)
    file(STRINGS "${PROJECT_SOURCE_DIR}/${header}" private REGEX "^// Private to this folder")
    if(NOT private)
      cmake_path(GET header PARENT_PATH place)
      install(FILES "${PROJECT_SOURCE_DIR}/${header}"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/nadir/${place}")
    endif()
  endforeach()
endforeach()

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Nadir")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/NadirConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/NadirConfig.cmake" INSTALL_DESTINATION "${package_dir}")
# Before 1.0 a minor version may break its users.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/NadirConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/NadirConfig.cmake"
              "${PROJECT_BINARY_DIR}/NadirConfigVersion.cmake" DESTINATION "${package_dir}")
install(EXPORT NadirTargets NAMESPACE nadir:: DESTINATION "${package_dir}")
