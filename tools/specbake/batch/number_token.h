#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace specbake::tool {

/// The place in a name where the number of a UDIM tile or of a frame stands:
///
///     <UDIM>  %(UDIM)d  _MAPID_      1001, 1002, … (Mari)
///     <UVTILE>  %(UVTILE)d           u1_v1, u2_v1, … (Mudbox)
///     ####  %04d                     0001 and so on, with at least as many digits
///     %d                             1 and so on, without zeros before it
struct NumberToken {
    std::size_t begin = 0;
    std::size_t length = 0;
    /// Patterns of glob(7) that between them match the number.
    std::vector<std::string> globs;
};

/// The first in a name; nothing if there is none.
std::optional<NumberToken> findNumberToken(const std::string& name);

}  // namespace specbake::tool
