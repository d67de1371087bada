#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace specbake {

/// What a run of texels met. Censuses of consecutive runs add up to that of the whole.
struct TexelCensus {
    /// Texels of one unhappy kind: how many, and the first one's number in row order.
    struct Kind {
        std::size_t count = 0;
        std::optional<std::size_t> first;

        void meet(std::size_t texel) {
            if (count++ == 0) first = texel;
        }
        void append(const Kind& later) {
            if (count == 0) first = later.first;
            count += later.count;
        }
    };

    std::size_t direct = 0;  ///< solved one by one
    Kind notFinite;
    Kind outside;  ///< of the object-colour solid
    Kind failed;   ///< inside, and yet not solved

    void append(const TexelCensus& later) {
        direct += later.direct;
        notFinite.append(later.notFinite);
        outside.append(later.outside);
        failed.append(later.failed);
    }
    bool usable() const { return notFinite.count + outside.count + failed.count == 0; }
};

}  // namespace specbake
