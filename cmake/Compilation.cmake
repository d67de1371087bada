# How every source of the project is compiled. Our presets make a warning an error; who builds the
# project within another, or with another compiler, is not stopped by one.
add_library(specbake_compilation INTERFACE)
target_compile_options(specbake_compilation INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion -Wformat=2)

# The floating-point contract: products and sums are fused where the code says so (std::fma,
# Highway's MulAdd) and nowhere else, so that a result does not depend on what a compiler likes.
target_compile_options(specbake_compilation INTERFACE -ffp-contract=off)
