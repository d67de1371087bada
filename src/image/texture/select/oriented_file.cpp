#include "texture/select/oriented_file.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace specbake::internal {
namespace {

/// An orientation as what is done to the stored image: mirrored along either axis, then, if it
/// swaps, transposed.
struct Turn {
    bool mirrorsX, mirrorsY, swaps;
};

/// TIFF 6.0, tag 274: where the 0th row and the 0th column of the stored image are to be shown.
constexpr Turn turnOf(int orientation) {
    constexpr Turn turns[] = {{false, false, false},  // 1: top, left
                              {true, false, false},   // 2: top, right
                              {true, true, false},    // 3: bottom, right
                              {false, true, false},   // 4: bottom, left
                              {false, false, true},   // 5: left, top
                              {false, true, true},    // 6: right, top
                              {true, true, true},     // 7: right, bottom
                              {true, false, true}};   // 8: left, bottom
    return turns[orientation - 1];
}

/// The window mirrored and transposed within the display window, whose corner stays.
Window turned(Window w, const Window& display, const Turn& turn) {
    if (turn.mirrorsX) w.x = 2 * display.x + display.width - w.x - w.width;
    if (turn.mirrorsY) w.y = 2 * display.y + display.height - w.y - w.height;
    if (!turn.swaps) return w;
    return {display.x + w.y - display.y, display.y + w.x - display.x, w.height, w.width};
}

ImageDescription described(ImageDescription d) {
    const Turn turn = turnOf(d.orientation);
    const Window display = d.display;
    d.data = turned(d.data, display, turn);
    d.display = turned(display, display, turn);
    d.orientation = 1;
    if (!turn.swaps) return d;
    if (d.pixelAspectRatio > 0) d.pixelAspectRatio = 1 / d.pixelAspectRatio;
    const auto x = d.attributes.find("XResolution");
    const auto y = d.attributes.find("YResolution");
    if (x != d.attributes.end() && y != d.attributes.end()) std::swap(x->second, y->second);
    return d;
}

}  // namespace

OrientedFile::OrientedFile(std::unique_ptr<ImageFile> file, std::size_t mostBytes)
    : ImageFile(described(file->description())), file_(std::move(file)), mostBytes_(mostBytes) {}

void OrientedFile::unpackRows(int first, int count, TexelType type, std::span<std::byte> samples) {
    const std::size_t bytes = rowBytes(type);
    const int height = description().data.height;
    for (int row = first; row < first + count; ++row) {
        if (type != keptType_ || row < keptFirst_ || row >= keptEnd_) {
            const std::size_t fitting = std::max(mostBytes_ / bytes, std::size_t(1));
            fill(row, int(std::min(fitting, std::size_t(height - row))), type);
        }
        std::memcpy(samples.data() + bytes * std::size_t(row - first),
                    kept_.data() + bytes * std::size_t(row - keptFirst_), bytes);
    }
}

/// One pass over the rows of the file that turned rows [first, first + count) come from.
void OrientedFile::fill(int first, int count, TexelType type) {
    keptEnd_ = keptFirst_;  // none, should this throw
    kept_.resize(rowBytes(type) * std::size_t(count));
    const Turn turn = turnOf(file_->description().orientation);
    const int height = file_->description().data.height;
    const int begin = turn.swaps ? 0 : turn.mirrorsY ? height - first - count : first;
    const int end = turn.swaps ? height : begin + count;
    source_.resize(std::size_t(file_->description().data.width) * description().channels.size() *
                   bytesPerSample(type));
    for (int row = begin; row < end; ++row) {
        file_->readRows(row, 1, type, source_);
        fillFromRow(row, first, count, type);
    }
    keptFirst_ = first;
    keptEnd_ = first + count;
    keptType_ = type;
}

/// The texels of source_ to their places in kept_, which holds turned rows [first, first + count).
void OrientedFile::fillFromRow(int sourceRow, int first, int count, TexelType type) {
    const Turn turn = turnOf(file_->description().orientation);
    const Window& window = file_->description().data;
    const std::size_t texel = description().channels.size() * bytesPerSample(type);
    const int v = turn.mirrorsY ? window.height - 1 - sourceRow : sourceRow;
    for (int column = 0; column < window.width; ++column) {
        const int u = turn.mirrorsX ? window.width - 1 - column : column;
        const int x = turn.swaps ? v : u;
        const int y = turn.swaps ? u : v;
        if (y < first || y >= first + count) continue;
        std::memcpy(kept_.data() + rowBytes(type) * std::size_t(y - first) + texel * std::size_t(x),
                    source_.data() + texel * std::size_t(column), texel);
    }
}

}  // namespace specbake::internal
