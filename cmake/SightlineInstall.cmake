# cmake --install: headers, the library, the command, and what find_package(sightline) and pkg-config find it by.
include(CMakePackageConfigHelpers)
include(cmake/SightlineHeaders.cmake)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/sightline")

foreach(header IN LISTS sightline_headers)
  get_filename_component(folder "${header}" DIRECTORY)
  install(FILES "${header}" DESTINATION "${SIGHTLINE_HEADER_DIR}/${folder}")
endforeach()
install(TARGETS sightline_library EXPORT sightline)
install(EXPORT sightline NAMESPACE sightline:: FILE sightlineTargets.cmake DESTINATION "${package_dir}")

configure_package_config_file(cmake/sightlineConfig.cmake.in sightlineConfig.cmake INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(sightlineConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/sightlineConfig.cmake" "${PROJECT_BINARY_DIR}/sightlineConfigVersion.cmake"
  DESTINATION "${package_dir}")

# A static library needs oneTBB where it is linked; a shared one has said so itself.
set(SIGHTLINE_PKGCONFIG_REQUIRES "eigen3")
if(NOT BUILD_SHARED_LIBS)
  set(SIGHTLINE_PKGCONFIG_REQUIRES "eigen3 tbb")
endif()
file(RELATIVE_PATH SIGHTLINE_PKGCONFIG_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" SIGHTLINE_PKGCONFIG_PREFIX "${SIGHTLINE_PKGCONFIG_PREFIX}")
configure_file(cmake/sightline.pc.in sightline.pc @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/sightline.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

if(TARGET sightline)
  install(TARGETS sightline)
endif()
