# Builds one of the outside projects and runs it; for find_package installs sightline first.
#   cmake -D PROJECT=find_package|add_subdirectory -D SIGHTLINE_BUILD=DIR -D WORK=DIR -D COMPILER=CXX -D FLAGS=FLAGS -P run.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
if(PROJECT STREQUAL "find_package")
  run(${CMAKE_COMMAND} --install "${SIGHTLINE_BUILD}" --prefix "${WORK}/prefix")
endif()
run(${CMAKE_COMMAND} -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}/${PROJECT}" -B "${WORK}/build"
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}"
  -DSIGHTLINE_UNITY_BUILD=ON)
run(${CMAKE_COMMAND} --build "${WORK}/build" --target consumer)

execute_process(COMMAND "${WORK}/build/consumer" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
message("${output}")
if(NOT output MATCHES "^face 0 shows [0-9.]+\n(face 1 shows [0-9.]+\n)+$")
  message(FATAL_ERROR "the outside program does not see what it should")
endif()
