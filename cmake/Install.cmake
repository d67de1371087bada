# The three libraries as an installed package: find_package(specbake), specbake::core, ::image, ::bake.
include(CMakePackageConfigHelpers)

install(TARGETS specbake_core specbake_image specbake_bake
        EXPORT specbakeTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS specbake RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT specbakeTargets NAMESPACE specbake::
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/specbake)
configure_package_config_file(cmake/specbakeConfig.cmake.in specbakeConfig.cmake
        INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/specbake)
write_basic_package_version_file(specbakeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/specbakeConfig.cmake
              ${PROJECT_BINARY_DIR}/specbakeConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/specbake)
