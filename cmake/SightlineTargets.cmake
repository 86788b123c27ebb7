# How every target of the project is compiled, and what a room is.

# Inline functions of our headers must round as the library does, wherever they are compiled: contraction is off for
# users too. Warnings are for our own builds only, and without those that g++ 12 reports at -O3 for correct code inlined
# from std::string (GCC bug 105651; more of them where headers are precompiled) and from Boost's small_vector. A second
# argument names the target whose precompiled headers this one shares.
function(sightline_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PUBLIC -ffp-contract=off)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  if(PROJECT_IS_TOP_LEVEL)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion
      $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread>
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
      $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>)
  endif()
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources source_count)
  if(SIGHTLINE_PRECOMPILE_HEADERS AND source_count GREATER 2)
    sightline_precompile_headers(${target} "${ARGN}")
  endif()
  if(SIGHTLINE_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# Compiled once per target; or those of another target that is compiled alike.
function(sightline_precompile_headers target headers_of)
  if(headers_of)
    target_precompile_headers(${target} REUSE_FROM ${headers_of})
  else()
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <boost/multiprecision/cpp_int.hpp> <cmath> <map>
      <optional> <span> <string> <vector>)
  endif()
endfunction()

# A room is a folder of the source tree and the static library sightline_<room> made of all its sources; what it may
# include is what it is linked with.
function(sightline_add_room room)
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${room}/*.cpp")
  set(target sightline_${room})
  add_library(${target} STATIC ${sources})
  add_library(sightline::${room} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${room})
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/sightline-${PROJECT_VERSION}>")
  target_link_libraries(${target} PUBLIC ${ARGN})
  if(room STREQUAL "geometry")
    sightline_compile_options(${target})
  else()
    sightline_compile_options(${target} sightline_geometry)
  endif()
endfunction()
