# OpenImageIO by its own package, mended: Debian 12's lists /usr/include/opencv4, a folder that only
# libopencv-dev holds and that no header of OpenImageIO needs. CMake refuses absent folders.
find_package(OpenImageIO CONFIG QUIET)
if(OpenImageIO_FOUND)
  foreach(property INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
    get_target_property(folders OpenImageIO::OpenImageIO ${property})
    if(folders)
      list(REMOVE_ITEM folders /usr/include/opencv4)
      set_target_properties(OpenImageIO::OpenImageIO PROPERTIES ${property} "${folders}")
    endif()
  endforeach()
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenImageIO CONFIG_MODE)
