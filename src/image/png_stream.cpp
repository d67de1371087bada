#include "png_stream.h"

#include "vector_state.h"

#include <specbake/core/error.h>

#include <algorithm>

namespace specbake {

PngStream::PngStream(std::string path, std::vector<PngChunk> data)
    : path_(std::move(path)),
      data_(std::move(data)),
      in_(path_, std::ios::binary),
      state_(std::make_unique<inflate_state>()),
      packed_(1 << 15) {
    rewind();
}

void PngStream::rewind() {
    isal_inflate_init(state_.get());
    state_->crc_flag = ISAL_ZLIB;
    state_->avail_in = 0;
    chunk_ = 0;
    taken_ = 0;
}

void PngStream::fail(const std::string& reason) const {
    throw FileError(path_, reason);
}

bool PngStream::refill() {
    while (chunk_ < data_.size() && taken_ == data_[chunk_].length) {
        ++chunk_;
        taken_ = 0;
    }
    if (chunk_ == data_.size()) return false;
    const PngChunk& chunk = data_[chunk_];
    const auto count = std::min<std::size_t>(packed_.size(), chunk.length - taken_);
    in_.seekg(std::streamoff(chunk.offset + taken_));
    in_.read(reinterpret_cast<char*>(packed_.data()), std::streamsize(count));
    if (!in_) fail("truncated");
    taken_ += std::uint32_t(count);
    state_->next_in = packed_.data();
    state_->avail_in = std::uint32_t(count);
    return true;
}

void PngStream::read(std::span<std::uint8_t> bytes) {
    state_->next_out = bytes.data();
    state_->avail_out = std::uint32_t(bytes.size());
    while (state_->avail_out > 0) {
        const bool fed = state_->avail_in > 0 || refill();
        const std::uint32_t missing = state_->avail_out;
        const int result = isal_inflate(state_.get());
        restoreVectorState();
        if (state_->avail_out == 0)
            return;  // like libpng: what follows the pixels is not looked at
        if (result != ISAL_DECOMP_OK) fail("damaged: its pixels cannot be unpacked");
        const bool ended = state_->block_state == ISAL_BLOCK_FINISH;
        if (ended || (!fed && state_->avail_out == missing)) fail("truncated: it lacks pixels");
    }
}

}  // namespace specbake
