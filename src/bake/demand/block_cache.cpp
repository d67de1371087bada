#include "demand/block_cache.h"

namespace specbake::internal {

/// The number of the use, as if a block of the level below had been used 256 times more: making
/// one takes four of the level above.
std::uint64_t BlockCache::worthNow(const Key& key) {
    constexpr std::uint64_t ofLevel = 256;
    return ++uses_ + ofLevel * std::uint64_t(key.level);
}

std::shared_ptr<const Block> BlockCache::find(const Key& key) {
    const std::scoped_lock lock(mutex_);
    const auto known = kept_.find(key);
    if (known == kept_.end()) return nullptr;
    order_.erase({known->second.worth, key});
    known->second.worth = worthNow(key);
    order_.emplace(known->second.worth, key);
    return known->second.block;
}

void BlockCache::store(const Key& key, std::shared_ptr<const Block> block) {
    const std::scoped_lock lock(mutex_);
    const std::size_t bytes = block->bytes();
    if (bytes > most_ || kept_.count(key) > 0) return;
    while (bytes_ + bytes > most_) drop();
    const std::uint64_t worth = worthNow(key);
    kept_[key] = {std::move(block), worth};
    order_.emplace(worth, key);
    bytes_ += bytes;
}

/// The one worth least.
void BlockCache::drop() {
    const auto least = order_.begin();
    const auto known = kept_.find(least->second);
    bytes_ -= known->second.block->bytes();
    kept_.erase(known);
    order_.erase(least);
}

}  // namespace specbake::internal
