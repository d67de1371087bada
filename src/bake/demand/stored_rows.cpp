#include "demand/stored_rows.h"

#include <algorithm>

namespace specbake::internal {
namespace {

/// Bands of a megabyte: a thread that waits for one waits some milliseconds.
int rowsOfBand(const TextureInfo& info) {
    constexpr std::size_t megabyte = 1 << 20;
    return int(std::clamp(megabyte / info.bytesPerRow(), std::size_t(1), std::size_t(64)));
}

std::size_t bandsToKeep(const TextureInfo& info, int rows, std::size_t bytes) {
    return std::max<std::size_t>(bytes / (info.bytesPerRow() * std::size_t(rows)), 4);
}

}  // namespace

StoredRows::StoredRows(Texture& texture, std::size_t bytes)
    : texture_(texture),
      rows_(rowsOfBand(texture.info())),
      most_(bandsToKeep(texture.info(), rows_, bytes)) {}

std::shared_ptr<const StoredRows::Band> StoredRows::bandOf(int row) {
    const int number = bandNumber(row);
    const std::scoped_lock lock(mutex_);  // a texture is read by one thread at a time
    if (const auto known = kept_.find(number); known != kept_.end()) {
        uses_.splice(uses_.begin(), uses_, known->second.use);
        return known->second.band;
    }
    const auto band = read(number);
    if (kept_.size() == most_) {
        kept_.erase(uses_.back());
        uses_.pop_back();
    }
    uses_.push_front(number);
    kept_[number] = {band, uses_.begin()};
    return band;
}

std::shared_ptr<const StoredRows::Band> StoredRows::read(int number) {
    const TextureInfo& info = texture_.info();
    const int first = number * rows_;
    const int count = std::min(rows_, info.data.height - first);
    auto band = std::make_shared<Band>(info.bytesPerRow() * std::size_t(count));
    texture_.readRows(first, count, *band);
    return band;
}

std::span<const std::byte> StoredRows::rowIn(const Band& band, int row) const {
    const std::size_t bytes = texture_.info().bytesPerRow();
    return std::span(band).subspan(bytes * std::size_t(row % rows_), bytes);
}

}  // namespace specbake::internal
