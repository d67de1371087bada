#include "spectral/exr_context.h"

#include <specbake/core/error.h>

namespace specbake::internal {
namespace {

void ignoreMessage(exr_const_context_t /*context*/, exr_result_t /*code*/, const char* /*text*/) {}

/// -1 if it failed; the stream knows why.
std::int64_t writeBytes(exr_const_context_t /*context*/, void* stream, const void* bytes,
                        std::uint64_t count, std::uint64_t offset,
                        exr_stream_error_func_ptr_t /*error*/) {
    const bool written = static_cast<WriteStream*>(stream)->write(bytes, count, offset);
    return written ? std::int64_t(count) : -1;
}

exr_attr_box2i_t boxOf(const Window& w) {
    return {{w.x, w.y}, {w.x + w.width - 1, w.y + w.height - 1}};
}

exr_compression_t compressionOf(Compression compression) {
    switch (compression) {
        case Compression::zip:
            return EXR_COMPRESSION_ZIP;
        case Compression::zips:
            return EXR_COMPRESSION_ZIPS;
        case Compression::piz:
            return EXR_COMPRESSION_PIZ;
        case Compression::none:
            break;
    }
    return EXR_COMPRESSION_NONE;
}

/// Levels are written side by side, as their rows become known.
exr_lineorder_t lineOrderOf(const StorageOptions& storage) {
    return storage.mipmap ? EXR_LINEORDER_RANDOM_Y : EXR_LINEORDER_INCREASING_Y;
}

/// Sets one attribute of whatever type its value has.
struct AttributeSetter {
    exr_context_t context;
    const char* name;

    exr_result_t operator()(const std::string& value) const {
        return exr_attr_set_string(context, 0, name, value.c_str());
    }
    exr_result_t operator()(int value) const { return exr_attr_set_int(context, 0, name, value); }
    exr_result_t operator()(float value) const {
        return exr_attr_set_float(context, 0, name, value);
    }
    exr_result_t operator()(const std::vector<float>& v) const {
        switch (v.size()) {
            case 2: {
                const exr_attr_v2f_t value = {v[0], v[1]};
                return exr_attr_set_v2f(context, 0, name, &value);
            }
            case 3: {
                const exr_attr_v3f_t value = {v[0], v[1], v[2]};
                return exr_attr_set_v3f(context, 0, name, &value);
            }
            case 9:
                return exr_attr_set_m33f(context, 0, name, matrix<exr_attr_m33f_t>(v).get());
            case 16:
                return exr_attr_set_m44f(context, 0, name, matrix<exr_attr_m44f_t>(v).get());
            default:
                return EXR_ERR_INVALID_ARGUMENT;
        }
    }

  private:
    template <class Matrix>
    static std::unique_ptr<Matrix> matrix(const std::vector<float>& v) {
        auto result = std::make_unique<Matrix>();
        std::copy(v.begin(), v.end(), result->m);
        return result;
    }
};

}  // namespace

ExrContext::ExrContext(const std::filesystem::path& file, std::string shownAs,
                       const SpectralHeader& header, const StorageOptions& storage)
    : shownAs_(std::move(shownAs)), stream_(file), top_(header.data.y), tiled_(storage.isTiled()) {
    exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
    options.error_handler_fn = ignoreMessage;
    options.user_data = &stream_;
    options.write_fn = writeBytes;
    check(exr_start_write(&context_, file.c_str(), EXR_WRITE_FILE_DIRECTLY, &options));
    int part = 0;
    check(exr_add_part(context_, "", tiled_ ? EXR_STORAGE_TILED : EXR_STORAGE_SCANLINE, &part));
    const exr_attr_box2i_t data = boxOf(header.data);
    const exr_attr_box2i_t display = boxOf(header.display);
    const exr_attr_v2f_t center = {0, 0};
    check(exr_initialize_required_attr(context_, part, &display, &data, header.pixelAspectRatio,
                                       &center, 1.0F, lineOrderOf(storage),
                                       compressionOf(storage.compression)));
    if (tiled_) {
        const TileSize tile = storage.tile.value_or(TileSize());
        check(exr_set_tile_descriptor(
            context_, part, std::uint32_t(tile.width), std::uint32_t(tile.height),
            storage.mipmap ? EXR_TILE_MIPMAP_LEVELS : EXR_TILE_ONE_LEVEL, EXR_TILE_ROUND_DOWN));
    }
    const bool half = storage.sampleType == SampleType::half;
    for (const std::string& name : channelNames(header.alpha, header.bands)) {
        check(exr_add_channel(context_, part, name.c_str(), half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT,
                              EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1));
    }
    for (const auto& [name, value] : header.attributes) {
        check(std::visit(AttributeSetter{context_, name.c_str()}, value));
    }
    check(exr_write_header(context_));
}

ExrContext::~ExrContext() {
    if (context_ != nullptr) exr_finish(&context_);
}

void ExrContext::reserve(std::uint64_t bytes) {
    if (!stream_.reserve(bytes)) check(EXR_ERR_WRITE_IO);
}

int ExrContext::firstRow(const ChunkGrid& level, int chunk) const {
    return top_ + level.texels(chunk).y;
}

exr_chunk_info_t ExrContext::chunkInfo(const ChunkGrid& level, int chunk) const {
    exr_chunk_info_t info{};
    check(tiled_ ? exr_write_tile_chunk_info(context_, 0, level.column(chunk), level.row(chunk),
                                             level.level, level.level, &info)
                 : exr_write_scanline_chunk_info(context_, 0, firstRow(level, chunk), &info));
    // OpenEXR 3.1 takes the last tiles of the levels below the first for whole ones.
    const Window texels = level.texels(chunk);
    info.width = texels.width;
    info.height = texels.height;
    return info;
}

void ExrContext::writeChunk(const ChunkGrid& level, int chunk,
                            std::span<const std::byte> packed) const {
    check(tiled_ ? exr_write_tile_chunk(context_, 0, level.column(chunk), level.row(chunk),
                                        level.level, level.level, packed.data(), packed.size())
                 : exr_write_scanline_chunk(context_, 0, firstRow(level, chunk), packed.data(),
                                            packed.size()));
}

void ExrContext::check(exr_result_t result) const {
    if (result == EXR_ERR_SUCCESS) return;
    const std::string reason = stream_.error();
    throw FileError(shownAs_, reason.empty() ? exr_get_default_error_message(result) : reason);
}

void ExrContext::finish() {
    const exr_result_t result = exr_finish(&context_);
    context_ = nullptr;
    check(result);
    if (!stream_.close()) check(EXR_ERR_WRITE_IO);
}

}  // namespace specbake::internal
