#include "spectral/pack/zip_packer.h"

#include "deflate/row_deflate.h"
#include "spectral/pack/zip_predictor.h"

#include <specbake/image/spectral_layout.h>

#include <libdeflate.h>

#include <cstdint>
#include <memory>
#include <new>

namespace specbake::internal {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// The size of the packed bytes; 0 if they do not fit.
std::size_t deflateSmall(Bytes bytes, int level, std::span<std::uint8_t> packed) {
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    return libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(),
                                    bytes.size());
}

std::size_t deflate(Bytes bytes, std::size_t rowLength, int level, std::span<std::uint8_t> packed) {
    if (level > StorageOptions::kFastestSmall) return deflateSmall(bytes, level, packed);
    if (rowLength > kDeflateWindow) return deflateSmall(bytes, 1, packed);
    return rowDeflate(bytes, rowLength, std::size_t(level), packed);
}

}  // namespace

void packZip(std::vector<std::byte>& samples, std::size_t rowBytes, int level) {
    thread_local std::vector<std::uint8_t> predicted;  // fresh pages cost as much as the prediction
    const std::size_t size = samples.size();
    predicted.resize(size);
    splitAndPredict({reinterpret_cast<const std::uint8_t*>(samples.data()), size}, predicted);
    samples.resize(rowDeflateBound(size));
    const std::span bytes(reinterpret_cast<std::uint8_t*>(samples.data()), samples.size());
    const std::size_t packed = deflate(predicted, rowBytes / 2, level, bytes);
    const bool shorter = packed > 0 && packed < size;
    if (!shorter) restore(predicted, bytes.first(size));
    samples.resize(shorter ? packed : size);
}

}  // namespace specbake::internal
