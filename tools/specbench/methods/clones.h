#pragma once

/// SPECBENCH_CLONES: compile the function for three instruction sets and choose at run time, so
/// that no method is held back by the baseline of the build.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define SPECBENCH_CLONES \
    __attribute__((target_clones("arch=skylake-avx512", "arch=haswell", "default")))
#else
#define SPECBENCH_CLONES
#endif
