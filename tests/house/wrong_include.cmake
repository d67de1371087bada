# An include against the flow must not build, and for no other reason than its folder:
#   cmake -D COMPILER= -D INCLUDE= -D HEADER= -D LOWER= -D UPPER= -D WORK= -P wrong_include.cmake
# INCLUDE is what the probe includes, HEADER the file that it means. The probe must not compile
# with the folders LOWER, must say that it misses INCLUDE, and must compile with UPPER besides.
if(NOT EXISTS ${HEADER})
  message(FATAL_ERROR "${HEADER} does not exist: this test would pass on nothing")
endif()

file(WRITE ${WORK}/probe.cpp "#include <${INCLUDE}>\n")

function(compile result message)
  set(folders ${ARGN})
  list(TRANSFORM folders PREPEND -I)
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only ${folders} ${WORK}/probe.cpp
                  RESULT_VARIABLE code ERROR_VARIABLE error)
  set(${result} ${code} PARENT_SCOPE)
  set(${message} "${error}" PARENT_SCOPE)
endfunction()

compile(code error ${LOWER} ${UPPER})
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the control does not compile:\n${error}")
endif()
compile(code error ${LOWER})
if(code EQUAL 0)
  message(FATAL_ERROR "<${INCLUDE}> compiles with ${LOWER}")
endif()
if(NOT error MATCHES "fatal error: ${INCLUDE}: No such file")
  message(FATAL_ERROR "fails for another reason than the include:\n${error}")
endif()
