#include "piz_packer.h"

#include <cstdint>
#include <cstring>
#include <utility>

namespace specbake {
namespace {

/// What goes into the encoder and comes out of it.
struct Transit {
    std::span<const std::byte> samples;
    std::vector<std::byte> packed;
};

Transit& transitOf(exr_encode_pipeline_t* encoder) {
    return *static_cast<Transit*>(encoder->encoding_user_data);
}

/// The encoder's first step here: the samples lie already as it packs them.
exr_result_t takeSamples(exr_encode_pipeline_t* encoder) {
    const std::span<const std::byte> samples = transitOf(encoder).samples;
    if (encoder->packed_alloc_size < samples.size()) return EXR_ERR_INVALID_ARGUMENT;
    std::memcpy(encoder->packed_buffer, samples.data(), samples.size());
    encoder->packed_bytes = samples.size();
    return EXR_ERR_SUCCESS;
}

/// Its last step here: the bytes are kept instead of written.
exr_result_t keepPacked(exr_encode_pipeline_t* encoder) {
    const auto* first = static_cast<const std::byte*>(encoder->compressed_buffer);
    transitOf(encoder).packed.assign(first, first + encoder->compressed_bytes);
    return EXR_ERR_SUCCESS;
}

/// OpenEXRCore's encoder for one chunk.
class Encoder {
  public:
    Encoder(const ExrContext& context, const exr_chunk_info_t& chunk) : context_(context) {
        context.check(exr_encoding_initialize(context.get(), 0, &chunk, &encoder_));
    }
    ~Encoder() { exr_encoding_destroy(context_.get(), &encoder_); }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    std::vector<std::byte> run(std::span<const std::byte> samples) {
        Transit transit{samples, {}};
        // The routines are chosen for channels that hold their samples; any address will do.
        for (int c = 0; c < encoder_.channel_count; ++c) {
            auto& channel = encoder_.channels[c];
            channel.encode_from_ptr = reinterpret_cast<const std::uint8_t*>(samples.data());
            channel.user_pixel_stride = std::uint8_t(channel.bytes_per_element);
            channel.user_line_stride = channel.width * channel.user_pixel_stride;
        }
        context_.check(exr_encoding_choose_default_routines(context_.get(), 0, &encoder_));
        encoder_.convert_and_pack_fn = takeSamples;
        encoder_.encoding_user_data = &transit;
        encoder_.yield_until_ready_fn = nullptr;
        encoder_.write_fn = keepPacked;
        context_.check(exr_encoding_run(context_.get(), 0, &encoder_));
        return std::move(transit.packed);
    }

  private:
    const ExrContext& context_;
    exr_encode_pipeline_t encoder_ = EXR_ENCODE_PIPELINE_INITIALIZER;
};

}  // namespace

std::vector<std::byte> packPiz(const ExrContext& context, const ChunkGrid& level, int chunk,
                               std::span<const std::byte> samples) {
    return Encoder(context, context.chunkInfo(level, chunk)).run(samples);
}

}  // namespace specbake
