# What `cmake --install` puts where. Two components: `tool`, for those who paint, and `development`, for those who
# link the engine.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS fluidymation RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tool)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT tool)
install(FILES ${PROJECT_SOURCE_DIR}/docs/copyright
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT tool)
if(TARGET fluidymation_reference)
  install(FILES ${PROJECT_BINARY_DIR}/reference/fluidymation.1
    DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tool)
  install(FILES ${PROJECT_BINARY_DIR}/reference/fluidymation.bash RENAME fluidymation
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tool)
  install(FILES ${PROJECT_BINARY_DIR}/reference/_fluidymation
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT tool)
endif()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/fluidymation)
install(TARGETS fluidymation_engine EXPORT fluidymationTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/fluidymation
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN "*.h")
install(EXPORT fluidymationTargets NAMESPACE fluidymation::
  DESTINATION ${package_folder} COMPONENT development)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/fluidymationConfig.cmake.in
  ${PROJECT_BINARY_DIR}/fluidymationConfig.cmake INSTALL_DESTINATION ${package_folder})
# Before 1.0 a minor version may change anything.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fluidymationConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/fluidymationConfig.cmake
    ${PROJECT_BINARY_DIR}/fluidymationConfigVersion.cmake
    ${PROJECT_SOURCE_DIR}/cmake/FindxxHash.cmake
  DESTINATION ${package_folder} COMPONENT development)
install(FILES ${PROJECT_SOURCE_DIR}/docs/copyright
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libfluidymation-dev COMPONENT development)
