# The libraries in the ways in which strangers use them: shared, core alone, by pkg-config, within
# another project.
#   cmake -D PROJECT= -D WORK= -D COMPILER= -D IMAGE= -P packages.cmake
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Unoptimised, for the oldest processor alone: what is looked at is how it fits together.
set(common -G Ninja -D CMAKE_BUILD_TYPE=Debug
    "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -DHWY_COMPILE_ONLY_STATIC"
    -D CMAKE_CXX_COMPILER=${COMPILER} -D SPECBAKE_PRECOMPILE_HEADERS=ON)
set(hidden OpenImageIO OpenEXR JPEG PNG TIFF TBB PkgConfig)
list(TRANSFORM hidden PREPEND "-DCMAKE_DISABLE_FIND_PACKAGE_")
list(TRANSFORM hidden APPEND "=ON")

function(build source work)
  run(${CMAKE_COMMAND} ${common} -S ${source} -B ${work} ${ARGN})
  run(${CMAKE_COMMAND} --build ${work})
endfunction()

file(REMOVE_RECURSE ${WORK})

# Shared libraries, without the programs; where there are such folders, two deep as Debian's.
execute_process(COMMAND ${COMPILER} -print-multiarch OUTPUT_VARIABLE multiarch ERROR_QUIET
                OUTPUT_STRIP_TRAILING_WHITESPACE)
build(${PROJECT} ${WORK}/shared -D BUILD_SHARED_LIBS=ON -D SPECBAKE_BUILD_TOOLS=OFF
      -D CMAKE_INSTALL_LIBDIR=lib/${multiarch}
      -D SPECBAKE_BUILD_BENCH=OFF -D SPECBAKE_BUILD_TESTS=OFF -D SPECBAKE_BUILD_PYTHON=OFF
      -D SPECBAKE_BUILD_OPENIMAGEIO_PLUGIN=OFF)
run(${CMAKE_COMMAND} --install ${WORK}/shared --prefix ${WORK}/prefix)

# They export what is public, and nothing else.
file(GLOB libraries ${WORK}/prefix/lib/libspecbake_*.so ${WORK}/prefix/lib/*/libspecbake_*.so)
list(LENGTH libraries count)
if(NOT count EQUAL 3)
  message(FATAL_ERROR "core, image and bake are expected, not: ${libraries}")
endif()
foreach(library IN LISTS libraries)
  execute_process(COMMAND nm -D -C --defined-only ${library} OUTPUT_VARIABLE symbols
                  COMMAND_ERROR_IS_FATAL ANY)
  if(NOT symbols MATCHES "specbake::")
    message(FATAL_ERROR "${library} exports nothing")
  endif()
  string(REGEX MATCH "[^\n]*(specbake::internal|anonymous namespace|::N_[A-Z])[^\n]*" private
         "${symbols}")
  if(private)
    message(FATAL_ERROR "${library} exports a private name: ${private}")
  endif()
endforeach()

# With find_package; for core alone where nothing that the others need is to be found.
build(${PROJECT}/tests/consumer/core ${WORK}/core ${hidden} -D CMAKE_PREFIX_PATH=${WORK}/prefix)
run(${WORK}/core/core_consumer)
build(${PROJECT}/tests/consumer/bake ${WORK}/bake -D CMAKE_PREFIX_PATH=${WORK}/prefix)
run(${WORK}/bake/consumer ${IMAGE} ${WORK}/library.exr)

# With pkg-config.
file(GLOB modules ${WORK}/prefix/lib/pkgconfig ${WORK}/prefix/lib/*/pkgconfig)
set(ENV{PKG_CONFIG_PATH} ${modules})
execute_process(COMMAND pkg-config --cflags --libs specbake-core OUTPUT_VARIABLE flags
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags)
run(${COMPILER} -std=c++20 ${PROJECT}/tests/consumer/core/main.cpp -o ${WORK}/by_pkg_config
    ${flags})
cmake_path(GET modules PARENT_PATH folder)
set(ENV{LD_LIBRARY_PATH} ${folder})
run(${WORK}/by_pkg_config)

# The sources within another project.
build(${PROJECT}/tests/consumer/within ${WORK}/within ${hidden} -D SPECBAKE=${PROJECT})
run(${WORK}/within/within)
