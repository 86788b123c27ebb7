# How every target of the project is compiled, and what a room is.

# Inline functions of our headers must round as the library does, wherever they are compiled: contraction is off for
# users too. Warnings are for our own builds only, and without those that g++ 12 reports at -O3 for correct code inlined
# from std::string (GCC bug 105651; more of them where headers are precompiled) and from Boost's small_vector.
function(sightline_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PUBLIC -ffp-contract=off)
  # Eigen sums in another order where it uses the processor's vector instructions: so it does not.
  target_compile_definitions(${target} PRIVATE EIGEN_DONT_VECTORIZE)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  if(PROJECT_IS_TOP_LEVEL)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion
      $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread>
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
      $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>)
  endif()
  if(SIGHTLINE_UNITY_BUILD)
    sightline_unity_build(${target})
  endif()
  if(SIGHTLINE_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# The sources of one folder are compiled as one unit, at most so many of them: they share what reading the headers costs.
# No two sources of a folder may use one name for two things; the tests have a namespace per source.
function(sightline_unity_build target)
  set(most_together 12)
  get_target_property(sources ${target} SOURCES)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(last_folder "")
  foreach(source IN LISTS sources)
    get_filename_component(source "${source}" ABSOLUTE)
    get_filename_component(folder "${source}" DIRECTORY)
    if(NOT folder STREQUAL last_folder)
      set(count 0)
    endif()
    set(last_folder "${folder}")
    math(EXPR unit "${count} / ${most_together}")
    math(EXPR count "${count} + 1")
    file(RELATIVE_PATH group "${PROJECT_SOURCE_DIR}" "${folder}")
    string(MAKE_C_IDENTIFIER "${group}_${unit}" group)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# A room is a folder of the source tree and the static library sightline_<room> made of all its sources; what it may
# include is what it is linked with.
function(sightline_add_room room)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${room}/*.cpp")
  list(FILTER sources EXCLUDE REGEX "/formats/pictures/")  # they need libpng: a part of the command
  set(target sightline_${room})
  add_library(${target} STATIC ${sources})
  if(NOT room STREQUAL "sightline")  # sightline::sightline is all rooms
    add_library(sightline::${room} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${room})
  endif()
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/sightline-${PROJECT_VERSION}>")
  target_link_libraries(${target} PUBLIC ${ARGN})
  sightline_compile_options(${target})
endfunction()
