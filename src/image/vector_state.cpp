#include "vector_state.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace specbake {

#ifdef __x86_64__
namespace {

__attribute__((target("avx"))) void clearUpperHalves() {
    _mm256_zeroupper();
}

}  // namespace

void restoreVectorState() {
    if (__builtin_cpu_supports("avx")) clearUpperHalves();
}
#else
void restoreVectorState() {}
#endif

}  // namespace specbake
