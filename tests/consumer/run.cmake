# Builds one of the outside projects and runs it.
#   cmake -D PROJECT=find_package|add_subdirectory|headers|examples|pkg_config -D WORK=DIR [-D PREFIX=DIR] -D COMPILER=CXX
#     -D FLAGS=FLAGS [-D PKG_CONFIG=COMMAND] -P run.cmake
# PREFIX: where sightline is installed (install.cmake), for all but add_subdirectory.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(build_with_cmake)
  set(source "${CMAKE_CURRENT_LIST_DIR}/${PROJECT}")
  if(PROJECT STREQUAL "examples")
    set(source "${CMAKE_CURRENT_LIST_DIR}/../../examples")
  endif()
  run(${CMAKE_COMMAND} -G Ninja -S "${source}" -B "${WORK}"
    "-DCMAKE_PREFIX_PATH=${PREFIX}" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}")
  run(${CMAKE_COMMAND} --build "${WORK}")
endfunction()

function(build_with_pkg_config)
  file(GLOB folder "${PREFIX}/*/pkgconfig" "${PREFIX}/lib/*/pkgconfig")
  set(ENV{PKG_CONFIG_PATH} "${folder}")
  execute_process(COMMAND "${PKG_CONFIG}" --cflags --libs sightline OUTPUT_VARIABLE options
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(options UNIX_COMMAND "${options}")
  separate_arguments(flags UNIX_COMMAND "${FLAGS}")
  file(MAKE_DIRECTORY "${WORK}")
  run("${COMPILER}" -std=c++20 ${flags} "${CMAKE_CURRENT_LIST_DIR}/main.cpp" -o "${WORK}/consumer" ${options})
  get_filename_component(library_folder "${folder}" DIRECTORY)
  set(ENV{LD_LIBRARY_PATH} "${library_folder}")  # what is installed where the loader looks needs no such thing
  check_output()
endfunction()

function(check_output)
  execute_process(COMMAND "${WORK}/consumer" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  message("${output}")
  if(NOT output MATCHES "^face 0 shows [0-9.]+\n(face 1 shows [0-9.]+\n)+$")
    message(FATAL_ERROR "the outside program does not see what it should")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
if(PROJECT STREQUAL "pkg_config")
  build_with_pkg_config()
else()
  build_with_cmake()
endif()
if(PROJECT MATCHES "find_package|add_subdirectory")
  check_output()
endif()
