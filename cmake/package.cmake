# Debian packages: `cpack -G DEB` in the build folder, or scripts/package.sh.
set(CPACK_PACKAGE_NAME fluidymation)
set(CPACK_PACKAGE_VENDOR "The fluidymation developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_CONTACT "The fluidymation developers")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL tool development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)

set(CPACK_DEBIAN_TOOL_PACKAGE_NAME fluidymation)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOL_DESCRIPTION "${PROJECT_DESCRIPTION}
 An animation of plain shapes, one mask a frame, and a film of watercolour, ink,
 dye or rust spreading over a surface become frames that look as if that medium
 itself flowed in the shape, direction and speed of the animation.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libfluidymation-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libpng-dev, libxxhash-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "library behind fluidymation, for C++ programs
 A static library, its headers, and a package for CMake:
 find_package(fluidymation) gives the target fluidymation::engine.")

include(CPack)
