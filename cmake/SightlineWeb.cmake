# The pages that the command writes, bundled from web/ where node and npm are there. Everything happens in
# ${SIGHTLINE_WEB_DIR}; where npm does not reach its registry the build says so and goes on without pages, and the next
# build tries again.
set(SIGHTLINE_WEB_DIR "${PROJECT_BINARY_DIR}/web")
find_program(SIGHTLINE_NODE node NAMES node nodejs)
find_program(SIGHTLINE_NPM npm)

# The source that has the pages in it, or none of them.
function(sightline_page_source variable)
  if(NOT SIGHTLINE_NODE OR NOT SIGHTLINE_NPM)
    message(WARNING "node and npm are not there: sightline is built without its pages (analyze --report, trace)")
    set(${variable} "${PROJECT_SOURCE_DIR}/web/no_pages.cpp" PARENT_SCOPE)
    return()
  endif()
  file(GLOB_RECURSE parts CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/web/*")
  list(FILTER parts EXCLUDE REGEX "/node_modules/")
  # pages.stamp is made where all went well only: without it the next build runs the command again.
  add_custom_command(
    OUTPUT "${SIGHTLINE_WEB_DIR}/pages.cpp" "${SIGHTLINE_WEB_DIR}/pages.stamp"
    COMMAND "${CMAKE_COMMAND}" -D "WEB=${PROJECT_SOURCE_DIR}/web" -D "OUT=${SIGHTLINE_WEB_DIR}"
      -D "NODE=${SIGHTLINE_NODE}" -D "NPM=${SIGHTLINE_NPM}" -P "${PROJECT_SOURCE_DIR}/cmake/build_pages.cmake"
    DEPENDS ${parts} "${PROJECT_SOURCE_DIR}/cmake/build_pages.cmake"
    COMMENT "Bundling the pages"
    VERBATIM)
  set(${variable} "${SIGHTLINE_WEB_DIR}/pages.cpp" PARENT_SCOPE)
endfunction()
