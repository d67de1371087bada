#pragma once

namespace specbake {

/// To be called after functions of ISA-L: they may return with the upper halves of the vector
/// registers in use. On many processors that makes all SSE code of the thread several times slower
/// from then on, the C library's included.
void restoreVectorState();

}  // namespace specbake
