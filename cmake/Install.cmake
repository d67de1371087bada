# The libraries as an installed package: find_package(specbake COMPONENTS core) and so on, and the
# modules of pkg-config, specbake-core and so on.
include(CMakePackageConfigHelpers)

set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/specbake)

# install_library(NAME TARGET...): the targets of a component.
function(install_library name)
  install(TARGETS specbake_${name} ${ARGN}
          EXPORT specbake-${name}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT specbake-${name} FILE specbake-${name}.cmake NAMESPACE specbake::
          DESTINATION ${destination})
endfunction()

# install_pkg_config(NAME DESCRIPTION REQUIRES PRIVATE [LIBRARY...]): the last are what a static
# library leaves to the program that links it, whether it asks for --static or not: packages, and
# libraries that need each other.
function(install_pkg_config name description requires private)
  set(libs -lspecbake_${name})
  if(NOT BUILD_SHARED_LIBS)
    string(APPEND requires " ${private}")
    if(ARGN)
      list(JOIN ARGN " " others)
      set(libs "-Wl,--start-group ${libs} ${others} -Wl,--end-group")
    endif()
  endif()
  # From the file's own folder, so that the package may be moved.
  file(RELATIVE_PATH prefix /root/${CMAKE_INSTALL_LIBDIR}/pkgconfig /root)
  string(REGEX REPLACE "/$" "" prefix "${prefix}")
  configure_file(cmake/specbake.pc.in specbake-${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/specbake-${name}.pc
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

install_library(core)
install_pkg_config(core "Colours to reflectance spectra" "Imath" "libhwy")
set(components core)
# Linked where it was found (src/image/CMakeLists.txt).
set(color_config_module "")
if(OpenColorIO_FOUND)
  set(color_config_module OpenColorIO)
endif()
if(NOT SPECBAKE_CORE_ONLY)
  list(APPEND components image bake)
  set(seam specbake_openimageio)
  if(BUILD_SHARED_LIBS)
    set(seam "")
  endif()
  install_library(image ${seam})
  install_library(bake)
  install_pkg_config(image "Textures and spectral images" "specbake-core"
    "OpenImageIO OpenEXR libhwy libjpeg libpng libtiff-4 libexif lcms2 libdeflate \
${color_config_module}"
    -lspecbake_openimageio)
  install_pkg_config(bake "Textures to spectral images" "specbake-image" "tbb")
endif()
if(TARGET specbake)
  install(TARGETS specbake RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(TARGETS specbake_openimageio_module
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/specbake)
endif()
# Licences that go with every copy.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/data/NOTICE.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/specbakeConfig.cmake.in specbakeConfig.cmake
                              INSTALL_DESTINATION ${destination})
write_basic_package_version_file(specbakeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/specbakeConfig.cmake
              ${PROJECT_BINARY_DIR}/specbakeConfigVersion.cmake
        DESTINATION ${destination})
