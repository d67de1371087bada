#include "texture/openimageio/row_source.h"

#include "texture/openimageio/bounds.h"
#include "texture/openimageio/one_line.h"
#include "texture/openimageio/quirks.h"
#include "texture/openimageio/subimages.h"
#include "texture/openimageio/webp_chunks.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

namespace specbake::internal {

RowSource::RowSource(std::string path, int subimage, bool raw)
    : path_(std::move(path)),
      subimage_(subimage),
      input_(openSubimage(path_, subimage, raw)),
      spec_(input_->spec()),
      remarks_(correctQuirks(input_->format_name(), spec_)) {
    if (input_->format_name() == std::string_view("webp")) {
        spec_["Orientation"] = webpOrientation(path_);
        const std::string profile = webpProfile(path_);
        if (!profile.empty()) {
            spec_.attribute("ICCProfile",
                            OIIO::TypeDesc(OIIO::TypeDesc::UINT8, int(profile.size())),
                            profile.data());
        }
    }
    checkConsistency(path_, spec_);
    checkBounds(path_, input_->format_name(), spec_);
}

/// A reader that says another size now than when it was opened would write past our buffers.
void RowSource::checkUnchanged() const {
    const OIIO::ImageSpec& now = input_->spec();
    if (now.x != spec_.x || now.y != spec_.y || now.width != spec_.width ||
        now.height != spec_.height || now.nchannels != spec_.nchannels ||
        now.tile_width != spec_.tile_width || now.tile_height != spec_.tile_height) {
        throw FileError(path_, "its reader says another size than before");
    }
}

void RowSource::fail() {
    throw FileError(path_, oneLine(input_->geterror()));
}

void RowSource::read(int first, int count, const OIIO::TypeDesc& type,
                     std::span<std::byte> samples) {
    checkUnchanged();
    if (spec().tile_width == 0) {
        const int y = spec().y + first;
        if (!input_->read_scanlines(subimage_, 0, y, y + count, 0, 0, spec().nchannels, type,
                                    samples.data()) ||
            input_->has_error()) {  // a truncated JPEG reads as grey, and only complains
            fail();
        }
        return;
    }
    const std::size_t rowBytes =
        std::size_t(spec().width) * std::size_t(spec().nchannels) * type.size();
    for (int row = 0; row < count; ++row) {
        readTileRow((first + row) / spec().tile_height, type);
        const std::size_t inside = std::size_t((first + row) % spec().tile_height);
        std::memcpy(samples.data() + rowBytes * std::size_t(row), tiles_.data() + rowBytes * inside,
                    rowBytes);
    }
}

void RowSource::readTileRow(int tileRow, const OIIO::TypeDesc& type) {
    if (tileRow == tileRow_ && type == tileType_) return;
    const auto& s = spec();
    const int first = s.y + tileRow * s.tile_height;
    const int last = std::min(first + s.tile_height, s.y + s.height);
    tiles_.resize(std::size_t(s.width) * std::size_t(s.tile_height) * std::size_t(s.nchannels) *
                  type.size());
    if (!input_->read_tiles(subimage_, 0, s.x, s.x + s.width, first, last, 0, 1, 0, s.nchannels,
                            type, tiles_.data())) {
        fail();
    }
    tileRow_ = tileRow;
    tileType_ = type;
}

}  // namespace specbake::internal
