# find_package(OpenImageIO), mended: some packages of it name include folders of libraries that it
# was built with and that are not installed, which CMake refuses.
find_package(OpenImageIO REQUIRED)

get_target_property(_specbake_oiio_folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
set(_specbake_oiio_present "")
foreach(_specbake_folder IN LISTS _specbake_oiio_folders)
  if(EXISTS ${_specbake_folder})
    list(APPEND _specbake_oiio_present ${_specbake_folder})
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${_specbake_oiio_present}")
