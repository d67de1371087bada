#pragma once

#include <specbake/core/node_values.h>

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace specbake {

/// Values of colours that were solved one by one, since textures repeat colours. The key is the
/// colour as it stands in the texture, to the last bit: what is found is what would be solved, so
/// that neither a hit nor a miss, nor what was forgotten meanwhile, shows in the result.
///
/// Bounded: kSlots entries of about 400 bytes, each colour at one slot, where the newest stays.
/// Any number of threads may share it.
class SpectrumCache {
  public:
    using Color = std::array<float, 3>;
    static constexpr std::size_t kSlots = std::size_t(1) << 16;

    /// Copies the values of a colour to `values`; false if it is not there.
    bool find(const Color& color, NodeValues& values) const;
    void store(const Color& color, const NodeValues& values);

  private:
    static constexpr std::size_t kLocks = 64;
    struct Entry {
        Color color;
        NodeValues values;
    };
    std::mutex& lockOf(std::size_t slot) const { return locks_[slot % kLocks]; }

    mutable std::array<std::mutex, kLocks> locks_;
    std::vector<std::unique_ptr<Entry>> slots_ = std::vector<std::unique_ptr<Entry>>(kSlots);
};

}  // namespace specbake
