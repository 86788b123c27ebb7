# Installs sightline for the outside projects: as it was built, or, shared, built anew without the rest.
#   cmake -D LINKAGE=static|shared -D SIGHTLINE_BUILD=DIR -D WORK=DIR -D COMPILER=CXX -D FLAGS=FLAGS -P install.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}/prefix")
set(build "${SIGHTLINE_BUILD}")
if(LINKAGE STREQUAL "shared")
  set(build "${WORK}/build")
  run(${CMAKE_COMMAND} -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}/../.." -B "${build}" -DBUILD_SHARED_LIBS=ON
    -DSIGHTLINE_BUILD_CLI=OFF -DSIGHTLINE_BUILD_TESTS=OFF -DSIGHTLINE_BUILD_BENCH=OFF -DSIGHTLINE_BUILD_EXAMPLES=OFF
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}")
  run(${CMAKE_COMMAND} --build "${build}")
endif()
run(${CMAKE_COMMAND} --install "${build}" --prefix "${WORK}/prefix")
