#include "spectral/pack/piz_packer.h"

#include <cstdint>
#include <cstring>
#include <utility>

namespace specbake::internal {
namespace {

/// What goes into the encoder and comes out of it.
std::vector<std::byte>& samplesOf(exr_encode_pipeline_t* encoder) {
    return *static_cast<std::vector<std::byte>*>(encoder->encoding_user_data);
}

/// The encoder's first step here: the samples lie already as it packs them.
exr_result_t takeSamples(exr_encode_pipeline_t* encoder) {
    const std::vector<std::byte>& samples = samplesOf(encoder);
    if (encoder->packed_alloc_size < samples.size()) return EXR_ERR_INVALID_ARGUMENT;
    std::memcpy(encoder->packed_buffer, samples.data(), samples.size());
    encoder->packed_bytes = samples.size();
    return EXR_ERR_SUCCESS;
}

/// Its last step here: the bytes are kept instead of written.
exr_result_t keepPacked(exr_encode_pipeline_t* encoder) {
    const auto* first = static_cast<const std::byte*>(encoder->compressed_buffer);
    samplesOf(encoder).assign(first, first + encoder->compressed_bytes);
    return EXR_ERR_SUCCESS;
}

}  // namespace

/// OpenEXRCore's encoder and its memory.
class PizPacker::Encoder {
  public:
    Encoder(const ExrContext& context, const exr_chunk_info_t& chunk) : context_(context) {
        context.check(exr_encoding_initialize(context.get(), 0, &chunk, &encoder_));
    }
    ~Encoder() { exr_encoding_destroy(context_.get(), &encoder_); }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    void goOnWith(const exr_chunk_info_t& chunk) {
        context_.check(exr_encoding_update(context_.get(), 0, &chunk, &encoder_));
    }

    void run(std::vector<std::byte>& samples) {
        // The routines are chosen for channels that hold their samples; any address will do.
        for (int c = 0; c < encoder_.channel_count; ++c) {
            auto& channel = encoder_.channels[c];
            channel.encode_from_ptr = reinterpret_cast<const std::uint8_t*>(samples.data());
            channel.user_pixel_stride = std::uint8_t(channel.bytes_per_element);
            channel.user_line_stride = channel.width * channel.user_pixel_stride;
        }
        context_.check(exr_encoding_choose_default_routines(context_.get(), 0, &encoder_));
        encoder_.convert_and_pack_fn = takeSamples;
        encoder_.encoding_user_data = &samples;
        encoder_.yield_until_ready_fn = nullptr;
        encoder_.write_fn = keepPacked;
        context_.check(exr_encoding_run(context_.get(), 0, &encoder_));
    }

  private:
    const ExrContext& context_;
    exr_encode_pipeline_t encoder_ = EXR_ENCODE_PIPELINE_INITIALIZER;
};

PizPacker::PizPacker(const ExrContext& context) : context_(context) {}
PizPacker::~PizPacker() = default;

void PizPacker::release() {
    idle_.clear();
}

std::unique_ptr<PizPacker::Encoder> PizPacker::takeEncoder(const exr_chunk_info_t& chunk) {
    std::unique_ptr<Encoder> encoder;
    {
        const std::lock_guard lock(mutex_);
        if (idle_.empty()) return std::make_unique<Encoder>(context_, chunk);
        encoder = std::move(idle_.back());
        idle_.pop_back();
    }
    encoder->goOnWith(chunk);
    return encoder;
}

void PizPacker::pack(const ChunkGrid& level, int chunk, std::vector<std::byte>& samples) {
    std::unique_ptr<Encoder> encoder = takeEncoder(context_.chunkInfo(level, chunk));
    encoder->run(samples);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(encoder));
}

}  // namespace specbake::internal
