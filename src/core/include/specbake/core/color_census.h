#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace specbake {

/// What became of a colour that is no blend of the grid's nodes alone.
enum class Fate {
    solved,     ///< its spectrum has its colour
    moved,      ///< outside the solid: its spectrum has another colour, by the rule for these
    refused,    ///< outside the solid, and the rule is to refuse
    notFinite,  ///< NaN or infinity
    failed      ///< inside the solid, and yet the method did not solve it
};

/// What some colours met. Censuses of parts, in any order, add up to that of the whole.
class ColorCensus {
  public:
    /// Colours of one fate: how many, and the number of the first.
    struct Kind {
        std::size_t count = 0;
        std::optional<std::size_t> first;
    };

    /// `difference`: CIEDE2000 from the colour asked for to that given.
    void meet(std::size_t number, Fate fate, double difference) {
        Kind& kind = kinds_[std::size_t(fate)];
        kind.first = std::min(number, kind.first.value_or(number));
        ++kind.count;
        largestMove_ = std::max(largestMove_, difference);
    }

    /// `offset`: the number, here, of the other's number 0.
    void add(const ColorCensus& other, std::size_t offset = 0) {
        for (std::size_t i = 0; i < kFates; ++i) {
            const Kind& kind = other.kinds_[i];
            if (kind.first) {
                const std::size_t first = *kind.first + offset;
                kinds_[i].first = std::min(first, kinds_[i].first.value_or(first));
            }
            kinds_[i].count += kind.count;
        }
        largestMove_ = std::max(largestMove_, other.largestMove_);
    }

    const Kind& of(Fate fate) const { return kinds_[std::size_t(fate)]; }
    double largestMove() const { return largestMove_; }

    /// How many colours have no spectrum.
    std::size_t withoutSpectrum() const {
        return of(Fate::refused).count + of(Fate::notFinite).count + of(Fate::failed).count;
    }

  private:
    static constexpr std::size_t kFates = 5;
    std::array<Kind, kFates> kinds_;
    double largestMove_ = 0;
};

}  // namespace specbake
