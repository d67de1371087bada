#pragma once

#include "demand/block.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <tuple>
#include <utility>

namespace specbake::internal {

/// Blocks of mip levels, up to a number of bytes. Those of small levels, each of which is made of
/// many texels of the image, stay longer. Any number of threads may share it.
class BlockCache {
  public:
    explicit BlockCache(std::size_t bytes) : most_(bytes) {}

    struct Key {
        int level = 0;
        int x = 0, y = 0;                  ///< of the block's corner
        std::vector<std::size_t> samples;  ///< BlockChannels::samples
        bool operator<(const Key& other) const {
            return std::tie(level, x, y, samples) <
                   std::tie(other.level, other.x, other.y, other.samples);
        }
    };

    /// Nothing if it is not there.
    std::shared_ptr<const Block> find(const Key& key);
    void store(const Key& key, std::shared_ptr<const Block> block);

  private:
    struct Kept {
        std::shared_ptr<const Block> block;
        std::uint64_t worth = 0;
    };

    std::uint64_t worthNow(const Key& key);
    void drop();

    std::size_t most_;
    std::mutex mutex_;
    std::size_t bytes_ = 0;
    std::uint64_t uses_ = 0;
    std::map<Key, Kept> kept_;
    std::set<std::pair<std::uint64_t, Key>> order_;  ///< by worth
};

}  // namespace specbake::internal
