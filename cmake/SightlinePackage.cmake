# cpack -G DEB: one Debian package with the command, the library, its headers and its manual.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The sightline authors")
set(CPACK_PACKAGE_CONTACT "The sightline authors <sightline@localhost>")
set(CPACK_PACKAGE_DESCRIPTION "Where a renderer answers in pixels, sightline answers with the visible
polygons themselves, and gives the surface back, refined and labelled: each
triangle is wholly visible, hidden, back-facing or out of view, and reflects
a light panel wholly or not at all. A command, and a C++20 library.")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# For those who compile against it.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libboost-dev, libtbb-dev, pkg-config")

install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME copyright)
install(DIRECTORY examples DESTINATION "${CMAKE_INSTALL_DOCDIR}")

include(CPack)
