# cmake -D WEB=... -D OUT=... -D NODE=... -D NPM=... -P build_pages.cmake: what web/package-lock.json names goes to
# OUT/node_modules, only when the lock has changed; the pages go to OUT/pages.cpp.
file(MAKE_DIRECTORY "${OUT}")
file(SHA256 "${WEB}/package-lock.json" lock)
set(installed "")
if(EXISTS "${OUT}/installed.sha256")
  file(READ "${OUT}/installed.sha256" installed)
endif()

if(NOT installed STREQUAL lock)
  file(COPY "${WEB}/package.json" "${WEB}/package-lock.json" DESTINATION "${OUT}")
  execute_process(
    COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund --loglevel=error --fetch-retries=1
    WORKING_DIRECTORY "${OUT}" RESULT_VARIABLE failed ERROR_VARIABLE cause OUTPUT_QUIET)
  if(failed)
    message(WARNING "npm ci failed: sightline is built without its pages (analyze --report, trace)\n${cause}")
    execute_process(COMMAND "${CMAKE_COMMAND}" -E copy_if_different "${WEB}/no_pages.cpp" "${OUT}/pages.cpp")
    return()
  endif()
  file(WRITE "${OUT}/installed.sha256" "${lock}")
endif()

execute_process(COMMAND "${NODE}" "${WEB}/build.mjs" "${OUT}" RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the pages cannot be bundled")
endif()
file(TOUCH "${OUT}/pages.stamp")
