# A Debian package of all that is installed: cpack -G DEB in the build folder.
set(CPACK_PACKAGE_NAME specbake)
set(CPACK_PACKAGE_VENDOR "specbake")
set(CPACK_PACKAGE_CONTACT "specbake maintainers <maintainers@specbake.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"spectral textures for spectral renderers
 specbake turns XYZ and RGB textures into OpenEXR images of 81 reflectance bands
 whose colours are exactly those of the texture under the light that is named.
 This package has the program, its manual, the C++ libraries and headers, and
 whatever bindings were built.")
# What the programs load, by the names and versions of the packages that are installed here.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
# What the headers and the static libraries need of a program that is linked with them.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libopenimageio-dev, libopenexr-dev, libimath-dev, libtbb-dev, \
libjpeg-dev, libpng-dev, libtiff-dev, libexif-dev, libdeflate-dev, liblcms2-dev, \
libopencolorio-dev, libhwy-dev, python3-numpy")
include(CPack)
