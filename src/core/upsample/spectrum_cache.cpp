#include "upsample/spectrum_cache.h"

#include <specbake/core/color_hash.h>

namespace specbake::internal {
namespace {

std::size_t slotOf(const SpectrumCache::Color& color) {
    return hashOf(color) % SpectrumCache::kSlots;
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

}  // namespace specbake::internal
