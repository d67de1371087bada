# Installs the build and uses it as a stranger would: configure, build and run tests/consumer; bake
# the IMAGE, which needs OpenImageIO, with that and with the installed program.
#   cmake -D BUILD= -D SOURCE= -D WORK= -D COMPILER= -D FLAGS= -D TYPE= -D IMAGE= -P consumer.cmake
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
# The package must not need the tree that it came from.
file(RENAME ${WORK}/prefix ${WORK}/moved)
foreach(consumer bake core)
  run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/${consumer} -B ${WORK}/${consumer}
      -D CMAKE_BUILD_TYPE=${TYPE} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
      -D CMAKE_PREFIX_PATH=${WORK}/moved)
  run(${CMAKE_COMMAND} --build ${WORK}/${consumer})
endforeach()
run(${WORK}/core/core_consumer)
run(${WORK}/bake/consumer ${IMAGE} ${WORK}/library.exr)
run(${WORK}/moved/bin/specbake bake -q ${IMAGE} -o ${WORK}/program.exr)
run(${CMAKE_COMMAND} -E compare_files ${WORK}/library.exr ${WORK}/program.exr)

# Without its module the program says so in one line, for the files that need it; others it bakes.
file(GLOB_RECURSE modules ${WORK}/moved/specbake_openimageio*)
file(REMOVE ${modules})
execute_process(COMMAND ${WORK}/moved/bin/specbake bake -q ${IMAGE} -o ${WORK}/none.exr
                RESULT_VARIABLE code ERROR_VARIABLE error)
if(NOT code EQUAL 1 OR NOT error MATCHES "^specbake: [^\n]*: needs OpenImageIO[^\n]*\n$")
  message(FATAL_ERROR "without its module the program ends with ${code} and says: ${error}")
endif()
cmake_path(GET IMAGE PARENT_PATH images)
run(${WORK}/moved/bin/specbake bake -q ${images}/rgb8.png -o ${WORK}/plain.exr)
