# Writes the commit that is checked out, counted from the last tag if there is one, into a header,
# where it has changed:
#   cmake -D SOURCE= -D HEADER= -P revision.cmake
# Outside of a repository there is none, and the text is empty.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git -C ${SOURCE} describe --tags --always --abbrev=12
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
                RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  set(revision "")
endif()
set(text "#pragma once

/// The commit that the program was built of; empty where none is known.
#define SPECBAKE_REVISION \"${revision}\"
")
set(written "")
if(EXISTS ${HEADER})
  file(READ ${HEADER} written)
endif()
if(NOT text STREQUAL written)
  file(WRITE ${HEADER} "${text}")
endif()
