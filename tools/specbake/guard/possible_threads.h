#pragma once

namespace specbake::tool {

/// So many of `wanted` threads as the limits of this process leave room for, at least 1: TBB ends a
/// program that cannot have a thread which it counts on.
int possibleThreads(int wanted);

}  // namespace specbake::tool
