# How every source of the project is compiled. Our presets make a warning an error; who builds the
# project within another, or with another compiler, is not stopped by one.
add_library(specbake_compilation INTERFACE)
target_compile_options(specbake_compilation INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion -Wformat=2)

# The floating-point contract: products and sums are fused where the code says so (std::fma,
# Highway's MulAdd) and nowhere else, so that a result does not depend on what a compiler likes.
target_compile_options(specbake_compilation INTERFACE -ffp-contract=off)

# On aarch64 vectors are NEON's, which every such processor has: those of SVE have no size that a
# class could hold them by. The other definition says that there is nothing to choose from at run
# time, for which Highway would ask for extensions that containers of vectors are not inlined with.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)")
  target_compile_definitions(specbake_compilation INTERFACE TOOLCHAIN_MISS_SYS_AUXV_H
    "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128)")
endif()

# Headers of others that most sources of a target include, parsed once. Each source includes what it
# uses all the same.
option(SPECBAKE_PRECOMPILE_HEADERS "Parse the headers of libraries once for a target"
       ${PROJECT_IS_TOP_LEVEL})
set(SPECBAKE_STANDARD_HEADERS
  <algorithm> <array> <cmath> <cstddef> <cstdint> <cstring> <filesystem> <functional> <limits> <map>
  <memory> <numeric> <optional> <span> <string> <string_view> <utility> <vector>)

# specbake_precompile(TARGET HEADER...): these, and the standard library's.
function(specbake_precompile target)
  if(SPECBAKE_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} PRIVATE ${SPECBAKE_STANDARD_HEADERS} ${ARGN})
  endif()
endfunction()
