# specbake_add_library(NAME SOURCES ... HEADERS ...): the library specbake::NAME of this folder.
#
# Headers are named below include/specbake. What is not declared SPECBAKE_API in one of them stays
# within the library.
function(specbake_add_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;HEADERS")
  set(library specbake_${name})
  add_library(${library} ${arg_SOURCES})
  add_library(specbake::${name} ALIAS ${library})
  list(TRANSFORM arg_HEADERS PREPEND include/specbake/)
  target_sources(${library} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${arg_HEADERS})
  set_target_properties(${library} PROPERTIES
    EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    INSTALL_RPATH $ORIGIN
    VERIFY_INTERFACE_HEADER_SETS ${PROJECT_IS_TOP_LEVEL})
  target_compile_features(${library} PUBLIC cxx_std_20)
  target_include_directories(${library} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${library} PRIVATE $<BUILD_INTERFACE:specbake_compilation>)
  specbake_precompile(${library})
endfunction()
