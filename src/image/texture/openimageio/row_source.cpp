#include "texture/openimageio/row_source.h"

#include "texture/image_file.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <cstring>

namespace specbake::internal {
namespace {

std::unique_ptr<OIIO::ImageInput> open(const std::string& path) {
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;
    auto input = OIIO::ImageInput::open(path, &wishes);
    if (!input) throw FileError(path, oneLine(OIIO::geterror()));
    input->threads(1);
    return input;
}

void checkSize(const std::string& path, const OIIO::ImageSpec& spec) {
    if (spec.deep) throw FileError(path, "deep images are not textures");
    if (spec.depth > 1) throw FileError(path, "volumes are not textures");
    checkSides(path, spec.width, spec.height);
    if (spec.tile_width > kLargestSide || spec.tile_height > kLargestSide) {
        throw FileError(path, "tiles of more than " + std::to_string(kLargestSide) + " pixels");
    }
}

}  // namespace

std::string oneLine(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.empty() ? "cannot be read" : text;
}

RowSource::RowSource(const std::string& path) : path_(path), input_(open(path)) {
    checkSize(path, spec());
}

void RowSource::fail() {
    throw FileError(path_, oneLine(input_->geterror()));
}

void RowSource::read(int first, int count, const OIIO::TypeDesc& type,
                     std::span<std::byte> samples) {
    if (spec().tile_width == 0) {
        const int y = spec().y + first;
        if (!input_->read_scanlines(0, 0, y, y + count, 0, 0, spec().nchannels, type,
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
    if (!input_->read_tiles(0, 0, s.x, s.x + s.width, first, last, 0, 1, 0, s.nchannels, type,
                            tiles_.data())) {
        fail();
    }
    tileRow_ = tileRow;
    tileType_ = type;
}

}  // namespace specbake::internal
