#pragma once

#include <specbake/core/api.h>

#include <cstdint>
#include <string>

namespace specbake {

/// What a process refuses before it costs memory or time. The defaults are above any honest
/// texture.
struct Limits {
    std::uint64_t pixels = std::uint64_t(1) << 32;  ///< of an image that is read
    /// Bytes that reading one image, or the rows under way in one bake, may take.
    std::uint64_t memory = std::uint64_t(16) << 30;
};

/// Those of this process. They are its own: no library that reads files is told of them for good.
SPECBAKE_API Limits limits();

/// For the program, before it reads anything; a library that is a guest in a process leaves them.
SPECBAKE_API void setLimits(const Limits& limits);

/// "1.5 GB", for messages.
SPECBAKE_API std::string bytesText(std::uint64_t bytes);

}  // namespace specbake
