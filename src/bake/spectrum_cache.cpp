#include "spectrum_cache.h"

#include <bit>
#include <cstdint>

namespace specbake {
namespace {

/// The finaliser of splitmix64 (S. Vigna), over the colour's bits.
std::size_t slotOf(const SpectrumCache::Color& color) {
    std::uint64_t h = 0;
    for (const float component : color) {
        h = (h ^ std::bit_cast<std::uint32_t>(component)) + 0x9e3779b97f4a7c15;
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9;
        h = (h ^ (h >> 27)) * 0x94d049bb133111eb;
        h ^= h >> 31;
    }
    return h % SpectrumCache::kSlots;
}

}  // namespace

std::optional<SolvedTexel> SpectrumCache::find(const Color& color) const {
    const std::size_t slot = slotOf(color);
    const std::lock_guard lock(lockOf(slot));
    const Entry* entry = slots_[slot].get();
    if (entry == nullptr || entry->color != color) return {};
    return entry->solved;
}

void SpectrumCache::store(const Color& color, const SolvedTexel& solved) {
    const std::size_t slot = slotOf(color);
    const std::lock_guard lock(lockOf(slot));
    if (slots_[slot]) {
        *slots_[slot] = {color, solved};
    } else {
        slots_[slot] = std::make_unique<Entry>(Entry{color, solved});
    }
}

}  // namespace specbake
