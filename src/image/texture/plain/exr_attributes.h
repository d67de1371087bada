#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace specbake::internal {

/// What a part's header claims.
struct ExrClaims {
    long long width = 1, height = 1;  ///< of the data window
    std::uint64_t channels = 0;
    double tileTexels = 0;  ///< of one tile; 0: scan lines

    /// What a chunk takes at most when it is unpacked.
    std::uint64_t chunkBytes() const;
};

/// Of each part. Throws FileError where an attribute of an EXR's headers cannot take what it claims
/// to take, by the file or by its type: OpenEXR's C++ reader (3.1.5) allocates by the claims, and
/// where a type says otherwise it reads on in the midst of a value. What else is wrong, the readers
/// say.
std::vector<ExrClaims> checkExrAttributes(const std::string& path);

}  // namespace specbake::internal
