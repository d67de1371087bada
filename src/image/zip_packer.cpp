#include "zip_packer.h"

#include "vector_state.h"

#include <specbake/core/error.h>
#include <specbake/image/spectral_layout.h>

#include <isa-l/igzip_lib.h>
#include <libdeflate.h>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>

namespace specbake {
namespace {

/// "reordering and predictor" of the OpenEXR file layout document.
std::vector<std::uint8_t> splitAndPredict(std::span<const std::byte> samples) {
    const std::size_t size = samples.size();
    const std::size_t half = (size + 1) / 2;
    std::vector<std::uint8_t> split(size);
    for (std::size_t i = 0; i < size / 2; ++i) {
        split[i] = std::uint8_t(samples[2 * i]);
        split[half + i] = std::uint8_t(samples[2 * i + 1]);
    }
    if (size % 2 == 1) split[half - 1] = std::uint8_t(samples[size - 1]);
    std::vector<std::uint8_t> predicted(size);
    if (size > 0) predicted[0] = split[0];
    for (std::size_t i = 1; i < size; ++i) {
        predicted[i] = std::uint8_t(split[i] - split[i - 1] + 128);
    }
    return predicted;
}

/// Compresses into `packed`; false if it does not fit.
bool deflateFast(std::span<const std::uint8_t> bytes, int level, std::vector<std::byte>& packed) {
    constexpr std::array<std::size_t, 4> bufferSizes = {
        ISAL_DEF_LVL0_DEFAULT, ISAL_DEF_LVL1_DEFAULT, ISAL_DEF_LVL2_DEFAULT, ISAL_DEF_LVL3_DEFAULT};
    std::vector<std::uint8_t> buffer(bufferSizes.at(std::size_t(level)));
    const auto stream = std::make_unique<isal_zstream>();
    isal_deflate_stateless_init(stream.get());
    stream->level = std::uint32_t(level);
    stream->level_buf = buffer.data();
    stream->level_buf_size = std::uint32_t(buffer.size());
    stream->gzip_flag = IGZIP_ZLIB;
    stream->end_of_stream = 1;
    stream->next_in = const_cast<std::uint8_t*>(bytes.data());  // a C interface; it only reads
    stream->avail_in = std::uint32_t(bytes.size());
    stream->next_out = reinterpret_cast<std::uint8_t*>(packed.data());
    stream->avail_out = std::uint32_t(packed.size());
    const int result = isal_deflate_stateless(stream.get());
    restoreVectorState();
    if (result != COMP_OK) return false;
    packed.resize(stream->total_out);
    return true;
}

bool deflateSmall(std::span<const std::uint8_t> bytes, int level, std::vector<std::byte>& packed) {
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    const std::size_t size = libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(),
                                                      packed.data(), packed.size());
    packed.resize(size);
    return size > 0;
}

}  // namespace

std::vector<std::byte> packZip(std::span<const std::byte> samples, int level) {
    if (samples.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw ArgumentError("a chunk of more than 4 GiB");
    }
    const std::vector<std::uint8_t> bytes = splitAndPredict(samples);
    std::vector<std::byte> packed(samples.size());
    const bool fast = level <= StorageOptions::kFastestSmall;
    const bool shrunk =
        fast ? deflateFast(bytes, level, packed) : deflateSmall(bytes, level, packed);
    if (!shrunk || packed.size() >= samples.size()) packed.assign(samples.begin(), samples.end());
    return packed;
}

}  // namespace specbake
