# How every target of the project is compiled, what a room is, and what users get of the rooms.

# Inline functions of our headers must round as the library does, wherever they are compiled: contraction is off for
# users too.
function(sightline_usage_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PUBLIC -ffp-contract=off)
  # One order of summation whatever the processor; and the linker may take a function of Eigen's from any object.
  target_compile_definitions(${target} PUBLIC EIGEN_DONT_VECTORIZE)
endfunction()

# Warnings are for our own builds only, and without those that g++ 12 reports at -O3 for correct code inlined
# from std::string (GCC bug 105651; more of them where headers are precompiled) and from Boost's small_vector.
function(sightline_compile_options target)
  sightline_usage_options(${target})
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

# A room is a folder of the source tree and the static library sightline_<room> made of all its sources, for our own
# programs: they use what users do not see. What a room may include is what it is linked with.
function(sightline_add_room room)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${room}/*.cpp")
  string(MAKE_C_IDENTIFIER "sightline_${room}" target)
  add_library(${target} STATIC ${sources})
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target} PUBLIC ${ARGN})
  sightline_compile_options(${target})
endfunction()

# The library that users link: the objects of these rooms. Of a shared one only what is marked SIGHTLINE_EXPORT is seen
# from outside. As long as the major version is 0, a minor one may break what is compiled against it.
function(sightline_add_library)
  add_library(sightline_library)
  add_library(sightline::sightline ALIAS sightline_library)
  foreach(room IN LISTS ARGN)
    set_target_properties(${room} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    if(BUILD_SHARED_LIBS)
      set_target_properties(${room} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
    target_sources(sightline_library PRIVATE $<TARGET_OBJECTS:${room}>)
  endforeach()
  set_target_properties(sightline_library PROPERTIES OUTPUT_NAME sightline EXPORT_NAME sightline LINKER_LANGUAGE CXX
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_include_directories(sightline_library INTERFACE
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>" "$<INSTALL_INTERFACE:${SIGHTLINE_HEADER_DIR}>")
  sightline_usage_options(sightline_library)
endfunction()
