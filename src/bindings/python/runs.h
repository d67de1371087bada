#pragma once

#include "interruptible.h"

#include <cstddef>
#include <functional>

namespace specbake::python {

/// Colours that a thread takes at a time: a millisecond's work where they are looked up.
inline constexpr std::size_t kRun = 4096;

/// As many threads as are asked for, but not more than there are cores: TBB would print a warning.
/// Throws ArgumentError for a number below 0.
int threadsHere(int threads);

/// Calls body(first, count) for runs of 0 to `count` - 1, on `threads` threads, at least 1.
/// Throws Cancelled when stopped between two runs, and what the body throws.
void forEachRun(std::size_t count, std::size_t run, int threads, const Watch& watch,
                const std::function<void(std::size_t first, std::size_t count)>& body);

/// The same from Python, so that Ctrl-C stops it. A single run does without threads.
void forEachRunInterruptibly(std::size_t count, std::size_t run, int threads,
                             const std::function<void(std::size_t first, std::size_t count)>& body);

}  // namespace specbake::python
