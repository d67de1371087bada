#include "texture/plain/plain_exr.h"

#include "texture/plain/exr_description.h"
#include "texture/plain/exr_input.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>

namespace specbake::internal {
namespace {

/// The unpacking of one chunk (openexr_decode.h).
class Decoder {
  public:
    Decoder(const ExrInput& input, const exr_chunk_info_t& chunk) : input_(input) {
        input_.check(exr_decoding_initialize(input_.get(), 0, &chunk, &pipeline_));
    }
    ~Decoder() { exr_decoding_destroy(input_.get(), &pipeline_); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    std::span<exr_coding_channel_info_t> channels() {
        return {pipeline_.channels, std::size_t(pipeline_.channel_count)};
    }
    void run() {
        input_.check(exr_decoding_choose_default_routines(input_.get(), 0, &pipeline_));
        input_.check(exr_decoding_run(input_.get(), 0, &pipeline_));
    }

  private:
    const ExrInput& input_;
    exr_decode_pipeline_t pipeline_ = EXR_DECODE_PIPELINE_INITIALIZER;
};

/// One of those that plain files have, by the name that OpenImageIO gives it.
std::string nameOf(exr_compression_t compression) {
    switch (compression) {
        case EXR_COMPRESSION_ZIP:
            return "zip";
        case EXR_COMPRESSION_ZIPS:
            return "zips";
        case EXR_COMPRESSION_PIZ:
            return "piz";
        default:
            return "none";
    }
}

class PlainExr : public ImageFile {
  public:
    PlainExr(std::string path, ExrInput input, ExrDescription description)
        : ImageFile(std::move(description.image)),
          path_(std::move(path)),
          input_(std::move(input)),
          texts_(std::move(description.texts)) {}

    std::optional<std::string> text(const std::string& attribute) const override {
        const auto found = texts_.find(attribute);
        if (found == texts_.end()) return {};
        return found->second;
    }

    std::optional<StorageFacts> facts() const override {
        const ImageDescription& d = description();
        if (d.signs.chromaticities || d.pixelAspectRatio != 1) return {};  // of which there is more
        StorageFacts facts;
        facts.channels = int(d.channels.size());
        facts.sampleType = d.sampleType == TexelType::half ? "half" : "float";
        facts.compression = nameOf(input_.compression());
        facts.attributes.assign(texts_.begin(), texts_.end());
        return facts;
    }

  private:
    void unpackRows(int first, int count, TexelType type, std::span<std::byte> samples) override {
        const ImageDescription& d = description();
        if (type != d.sampleType && type != TexelType::float32) {
            throw ArgumentError("an EXR has floating-point samples");
        }
        const std::size_t bytes = rowBytes(type);
        const int end = d.data.y + first + count;
        for (int y = d.data.y + first; y < end;) {
            std::byte* row = samples.data() + bytes * std::size_t(y - d.data.y - first);
            if (type == type_ && y >= chunkFirst_ && y < chunkEnd_) {
                std::memcpy(row, chunk_.data() + bytes * std::size_t(y - chunkFirst_), bytes);
                ++y;
                continue;
            }
            const exr_chunk_info_t chunk = chunkOf(y);
            if (chunk.start_y == y && y + chunk.height <= end) {
                unpack(chunk, type, row);
                y += chunk.height;
            } else {
                keep(chunk, type);
            }
        }
    }

    exr_chunk_info_t chunkOf(int y) const {
        exr_chunk_info_t info{};
        input_.check(exr_read_scanline_chunk_info(input_.get(), 0, y, &info));
        if (info.width != description().data.width || y < info.start_y ||
            y >= info.start_y + info.height) {
            throw FileError(path_, "damaged: a chunk of another place");
        }
        return info;
    }

    /// A chunk of which not all rows are wanted now, into chunk_.
    void keep(const exr_chunk_info_t& chunk, TexelType type) {
        chunkEnd_ = chunkFirst_;  // none, should this throw
        chunk_.resize(rowBytes(type) * std::size_t(chunk.height));
        unpack(chunk, type, chunk_.data());
        chunkFirst_ = chunk.start_y;
        chunkEnd_ = chunk.start_y + chunk.height;
        type_ = type;
    }

    /// As interleaved samples of that type.
    void unpack(const exr_chunk_info_t& chunk, TexelType type, std::byte* samples) const {
        Decoder decoder(input_, chunk);
        const std::vector<std::string>& names = description().channels;
        for (exr_coding_channel_info_t& channel : decoder.channels()) {
            const auto place = std::find(names.begin(), names.end(), channel.channel_name);
            const auto index = std::size_t(place - names.begin());
            channel.decode_to_ptr =
                reinterpret_cast<std::uint8_t*>(samples + index * bytesPerSample(type));
            channel.user_bytes_per_element = std::int16_t(bytesPerSample(type));
            channel.user_data_type =
                std::uint16_t(type == TexelType::half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT);
            channel.user_pixel_stride = std::int32_t(names.size() * bytesPerSample(type));
            channel.user_line_stride = std::int32_t(rowBytes(type));
        }
        decoder.run();
    }

    std::string path_;
    ExrInput input_;
    std::map<std::string, std::string> texts_;
    std::vector<std::byte> chunk_;  ///< rows [chunkFirst_, chunkEnd_), as samples of type_
    int chunkFirst_ = 0;
    int chunkEnd_ = 0;
    TexelType type_ = TexelType::half;
};

}  // namespace

std::unique_ptr<ImageFile> openPlainExr(const std::string& path) {
    ExrInput input(path);
    if (!input.isOpen()) return {};
    std::optional<ExrDescription> description = describePlain(input);
    if (!description) return {};
    checkSides(path, description->image.data.width, description->image.data.height);
    return std::make_unique<PlainExr>(path, std::move(input), std::move(*description));
}

}  // namespace specbake::internal
