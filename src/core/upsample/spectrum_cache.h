#pragma once

#include "upsample/node_values.h"

#include <specbake/core/color_census.h>

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace specbake::internal {

/// A texel solved by itself.
struct SolvedTexel {
    NodeValues values;
    Fate fate = Fate::solved;
    double difference = 0;  ///< CIEDE2000 from the colour asked for to that given
};

/// Colours that were solved one by one, since textures repeat colours. The key is the
/// colour as it stands in the texture, to the last bit: what is found is what would be solved, so
/// that neither a hit nor a miss, nor what was forgotten meanwhile, shows in the result.
///
/// Bounded: kSlots entries of about 400 bytes, each colour at one slot, where the newest stays.
/// Any number of threads may share it.
class SpectrumCache {
  public:
    using Color = std::array<float, 3>;
    static constexpr std::size_t kSlots = std::size_t(1) << 16;

    std::optional<SolvedTexel> find(const Color& color) const;
    void store(const Color& color, const SolvedTexel& solved);

  private:
    static constexpr std::size_t kLocks = 64;
    struct Entry {
        Color color;
        SolvedTexel solved;
    };
    std::mutex& lockOf(std::size_t slot) const { return locks_[slot % kLocks]; }

    mutable std::array<std::mutex, kLocks> locks_;
    std::vector<std::unique_ptr<Entry>> slots_ = std::vector<std::unique_ptr<Entry>>(kSlots);
};

}  // namespace specbake::internal
