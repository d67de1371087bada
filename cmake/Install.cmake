# The libraries as an installed package: find_package(specbake), specbake::core and so on.
include(CMakePackageConfigHelpers)

set(libraries core image bake)  # src/*, in the order in which data flows
set(programs specbake)
# What a static library links, even PRIVATE, its user's program links too: CMake packages, and
# modules of pkg-config as pkg_check_modules(NAME REQUIRED IMPORTED_TARGET NAME) finds them.
set(packages hwy Imath JPEG OpenEXR OpenImageIO PNG TBB)
set(modules libdeflate)
set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/specbake)

foreach(library IN LISTS libraries)
  install(TARGETS specbake_${library}
          EXPORT specbakeTargets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endforeach()
foreach(program IN LISTS programs)
  install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endforeach()

install(TARGETS specbake_openimageio LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/specbake)

install(EXPORT specbakeTargets NAMESPACE specbake:: DESTINATION ${destination})
configure_package_config_file(cmake/specbakeConfig.cmake.in specbakeConfig.cmake
                              INSTALL_DESTINATION ${destination})
write_basic_package_version_file(specbakeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/specbakeConfig.cmake
              ${PROJECT_BINARY_DIR}/specbakeConfigVersion.cmake
        DESTINATION ${destination})
