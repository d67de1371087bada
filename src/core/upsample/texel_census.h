#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

namespace specbake {

/// What became of a texel.
enum class Fate {
    solved,     ///< its spectrum has its colour
    moved,      ///< outside the solid: its spectrum has another colour, by the rule for these
    refused,    ///< outside the solid, and the rule is to refuse
    notFinite,  ///< NaN or infinity
    failed      ///< inside the solid, and yet the method did not solve it
};

/// What some texels met. Censuses of parts, in any order, add up to that of the whole.
class TexelCensus {
  public:
    /// Texels of one fate: how many, and the first one's number in row order.
    struct Kind {
        std::size_t count = 0;
        std::optional<std::size_t> first;
    };

    /// A texel that is no blend of the grid's nodes; `difference`: CIEDE2000 from asked to given.
    void meet(std::size_t texel, Fate fate, double difference) {
        Kind& kind = kinds_[std::size_t(fate)];
        kind.first = std::min(texel, kind.first.value_or(texel));
        ++kind.count;
        largestMove_ = std::max(largestMove_, difference);
    }

    void add(const TexelCensus& other) {
        for (std::size_t i = 0; i < kFates; ++i) {
            const Kind& kind = other.kinds_[i];
            if (kind.first)
                kinds_[i].first = std::min(*kind.first, kinds_[i].first.value_or(*kind.first));
            kinds_[i].count += kind.count;
        }
        largestMove_ = std::max(largestMove_, other.largestMove_);
    }

    const Kind& of(Fate fate) const { return kinds_[std::size_t(fate)]; }
    double largestMove() const { return largestMove_; }

    /// Every texel has a spectrum.
    bool complete() const {
        return of(Fate::refused).count + of(Fate::notFinite).count + of(Fate::failed).count == 0;
    }

  private:
    static constexpr std::size_t kFates = 5;
    Kind kinds_[kFates];
    double largestMove_ = 0;
};

}  // namespace specbake
