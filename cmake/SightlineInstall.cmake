# cmake --install: headers, libraries, the command, and the package that find_package(sightline) finds.
include(CMakePackageConfigHelpers)

set(header_dir "${CMAKE_INSTALL_INCLUDEDIR}/sightline-${PROJECT_VERSION}")
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/sightline")

install(DIRECTORY geometry sweep reconstruct reflect coverage formats sightline DESTINATION "${header_dir}" FILES_MATCHING PATTERN "*.h")
install(TARGETS sightline_geometry sightline_sweep sightline_reconstruct sightline_reflect sightline_coverage
  sightline_sightline sightline_formats sightline_library EXPORT sightline)
install(EXPORT sightline NAMESPACE sightline:: FILE sightlineTargets.cmake DESTINATION "${package_dir}")

configure_package_config_file(cmake/sightlineConfig.cmake.in sightlineConfig.cmake INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(sightlineConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/sightlineConfig.cmake" "${PROJECT_BINARY_DIR}/sightlineConfigVersion.cmake"
  DESTINATION "${package_dir}")

if(TARGET sightline)
  install(TARGETS sightline)
endif()
