# Packs what was built, unpacks the package into a folder, and runs the command from there on Fang's example.
#   cmake -D SIGHTLINE_BUILD=DIR -D WORK=DIR -D CPACK=COMMAND -D DPKG_DEB=COMMAND -P run.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
run("${CPACK}" -G DEB --config "${SIGHTLINE_BUILD}/CPackConfig.cmake" -B "${WORK}")
file(GLOB package "${WORK}/*.deb")

execute_process(COMMAND "${DPKG_DEB}" --field "${package}" Depends OUTPUT_VARIABLE needed COMMAND_ERROR_IS_FATAL ANY)
message("It needs ${needed}")
foreach(library libc6 libstdc\\+\\+6 libtbb)
  if(NOT needed MATCHES "${library}")
    message(FATAL_ERROR "the package does not say that it needs ${library}")
  endif()
endforeach()

run("${DPKG_DEB}" --extract "${package}" "${WORK}/root")
foreach(file bin/sightline include/sightline-*/sightline/sightline.h lib*/pkgconfig/sightline.pc
    share/bash-completion/completions/sightline share/doc/sightline/copyright share/man/man1/sightline.1*)
  file(GLOB found "${WORK}/root/usr/${file}")
  if(NOT found)
    message(FATAL_ERROR "the package has no ${file}")
  endif()
endforeach()

run("${WORK}/root/usr/bin/sightline" analyze "${CMAKE_CURRENT_LIST_DIR}/../../fixtures/fang/scene.toml" -o "${WORK}/out")
file(READ "${WORK}/out/page/report.json" report)
string(JSON faces GET "${report}" counts faces visible)
if(NOT faces EQUAL 2)
  message(FATAL_ERROR "the packaged command does not see what it should, but ${faces} faces")
endif()
