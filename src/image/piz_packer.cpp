#include "piz_packer.h"

namespace specbake {
namespace {

/// The encoder's last step here: keep the bytes instead of writing them.
exr_result_t keepPacked(exr_encode_pipeline_t* encoder) {
    auto& packed = *static_cast<std::vector<std::byte>*>(encoder->encoding_user_data);
    const auto* first = static_cast<const std::byte*>(encoder->compressed_buffer);
    packed.assign(first, first + encoder->compressed_bytes);
    return EXR_ERR_SUCCESS;
}

/// OpenEXRCore's encoder for one chunk; the samples are lent to it.
class Encoder {
  public:
    Encoder(const ExrContext& context, int y) : context_(context) {
        exr_chunk_info_t chunk;
        context.check(exr_write_scanline_chunk_info(context.get(), 0, y, &chunk));
        context.check(exr_encoding_initialize(context.get(), 0, &chunk, &encoder_));
    }
    ~Encoder() {
        encoder_.packed_buffer = nullptr;
        exr_encoding_destroy(context_.get(), &encoder_);
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    std::vector<std::byte> run(std::span<const std::byte> samples) {
        std::vector<std::byte> packed;
        // The routines are chosen for channels that hold their samples; any address will do.
        for (int c = 0; c < encoder_.channel_count; ++c) {
            auto& channel = encoder_.channels[c];
            channel.encode_from_ptr = reinterpret_cast<const std::uint8_t*>(samples.data());
            channel.user_pixel_stride = channel.bytes_per_element;
            channel.user_line_stride = channel.width * channel.bytes_per_element;
        }
        context_.check(exr_encoding_choose_default_routines(context_.get(), 0, &encoder_));
        encoder_.convert_and_pack_fn = nullptr;                           // they are packed already
        encoder_.packed_buffer = const_cast<std::byte*>(samples.data());  // it only reads
        encoder_.packed_bytes = samples.size();
        encoder_.encoding_user_data = &packed;
        encoder_.yield_until_ready_fn = nullptr;
        encoder_.write_fn = keepPacked;
        context_.check(exr_encoding_run(context_.get(), 0, &encoder_));
        return packed;
    }

  private:
    const ExrContext& context_;
    exr_encode_pipeline_t encoder_ = EXR_ENCODE_PIPELINE_INITIALIZER;
};

}  // namespace

std::vector<std::byte> packPiz(const ExrContext& context, int y,
                               std::span<const std::byte> samples) {
    return Encoder(context, y).run(samples);
}

}  // namespace specbake
