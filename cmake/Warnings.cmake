# One set of warnings for every target of the project; a warning is an error.
add_library(specbake_warnings INTERFACE)
target_compile_options(specbake_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion -Wformat=2
  -Werror)
