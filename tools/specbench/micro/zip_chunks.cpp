#include "zip_chunks.h"

#include <OpenEXR/openexr.h>
#include <libdeflate.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace specbake::bench {

namespace {

class ExrFile {
  public:
    explicit ExrFile(const std::string& name) : name_(name) {
        exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
        settings.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
        check(exr_start_read(&context_, name.c_str(), &settings));
        check(exr_get_data_window(context_, 0, &window_));
        check(exr_get_scanlines_per_chunk(context_, 0, &chunkRows_));
        const exr_attr_chlist_t* channels = nullptr;
        check(exr_get_channels(context_, 0, &channels));
        channelCount_ = std::size_t(channels->num_channels);
    }
    ~ExrFile() { exr_finish(&context_); }
    ExrFile(const ExrFile&) = delete;
    ExrFile& operator=(const ExrFile&) = delete;

    std::size_t chunkCount() const {
        const int rows = window_.max.y - window_.min.y + 1;
        return (std::size_t(rows) + std::size_t(chunkRows_) - 1) / std::size_t(chunkRows_);
    }

    ZipChunk inflated(std::size_t chunk) const {
        exr_chunk_info_t info;
        check(exr_read_scanline_chunk_info(context_, 0, window_.min.y + int(chunk) * chunkRows_,
                                           &info));
        if (info.compression != EXR_COMPRESSION_ZIP || info.packed_size >= info.unpacked_size) {
            throw std::runtime_error(name_ +
                                     ": has a chunk that is not ZIP, or that ZIP did not shrink");
        }
        std::vector<std::uint8_t> packed(info.packed_size);
        check(exr_read_chunk(context_, 0, &info, packed.data()));
        const std::size_t rows = channelCount_ * std::size_t(info.height);
        ZipChunk result{std::vector<std::uint8_t>(info.unpacked_size),
                        info.unpacked_size / rows / 2};
        const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
            decompressor(libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
        if (libdeflate_zlib_decompress(decompressor.get(), packed.data(), packed.size(),
                                       result.bytes.data(), result.bytes.size(),
                                       nullptr) != LIBDEFLATE_SUCCESS) {
            throw std::runtime_error(name_ + ": a chunk cannot be inflated");
        }
        return result;
    }

  private:
    void check(exr_result_t result) const {
        if (result == EXR_ERR_SUCCESS) return;
        throw std::runtime_error(name_ + ": " + exr_get_default_error_message(result));
    }

    std::string name_;
    exr_context_t context_ = nullptr;
    exr_attr_box2i_t window_{};
    std::int32_t chunkRows_ = 0;
    std::size_t channelCount_ = 0;
};

}  // namespace

std::vector<ZipChunk> readZipChunks(const std::string& file, std::size_t most) {
    const ExrFile exr(file);
    const std::size_t count = exr.chunkCount();
    const std::size_t taken = std::min(count, most);
    std::vector<ZipChunk> chunks;
    for (std::size_t i = 0; i < taken; ++i) chunks.push_back(exr.inflated(i * count / taken));
    return chunks;
}

}  // namespace specbake::bench
