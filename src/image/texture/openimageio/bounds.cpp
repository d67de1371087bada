#include "texture/openimageio/bounds.h"

#include "file/input_stream.h"
#include "texture/image_file.h"
#include "texture/plain/exr_attributes.h"
#include "texture/plain/exr_input.h"

#include <specbake/core/error.h>
#include <specbake/image/limits.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace specbake::internal {
namespace {

/// Whatever a file's size, so much may be asked for.
constexpr std::uint64_t kFree = std::uint64_t(1) << 26;

/// No lossless packing of rows makes more of a byte: Deflate comes to 1032, LZW to 3640.
constexpr std::uint64_t kMostUnpacked = 4096;

/// Formats in which flat pictures take next to nothing.
constexpr std::array<std::string_view, 6> kUnbounded = {"jpeg", "jpeg2000", "webp",
                                                        "heif", "raw",      "jpegxl"};

void checkPlausible(const std::string& path, std::uint64_t bytes, std::uint64_t mostUnpacked) {
    if (bytes <= kFree) return;
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path, error);
    if (error || size > bytes / mostUnpacked) return;
    throw FileError(path, "its header claims " + bytesText(bytes) + ", which a file of " +
                              bytesText(size) + " cannot hold");
}

/// Of the largest chunk of a part, or of a whole row of its tiles.
std::uint64_t unpackedSize(const ExrInput& exr, int part) {
    std::uint64_t size = 0;
    if (exr_get_chunk_unpacked_size(exr.get(), part, &size) != EXR_ERR_SUCCESS) return 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    exr_tile_level_mode_t levels{};
    exr_tile_round_mode_t rounding{};
    exr_attr_box2i_t window{};
    const bool tiled = exr_get_tile_descriptor(exr.get(), part, &width, &height, &levels,
                                               &rounding) == EXR_ERR_SUCCESS;
    if (!tiled || exr_get_data_window(exr.get(), part, &window) != EXR_ERR_SUCCESS) return size;
    const auto across = std::uint64_t(1LL + window.max.x - window.min.x);
    return size * ((across + width - 1) / std::max(width, 1U));
}

}  // namespace

void checkBounds(const std::string& path, const std::string& format, const OIIO::ImageSpec& spec) {
    if (format == "openexr") return;
    const std::uint64_t bytes = std::uint64_t(spec.width) * std::uint64_t(spec.height) *
                                std::uint64_t(spec.nchannels) * spec.format.size();
    checkMemory(path, bytes);
    const bool bounded =
        std::find(kUnbounded.begin(), kUnbounded.end(), format) == kUnbounded.end();
    if (bounded) checkPlausible(path, bytes, kMostUnpacked);
}

void checkExrBounds(const std::string& path) {
    // What a chunk of one value comes to: a few dozen bytes for the 32 rows of PIZ.
    constexpr std::uint64_t mostUnpacked = std::uint64_t(1) << 16;
    if (!beginsWith(path, kExrSignature)) return;
    const auto checkChunk = [&](std::uint64_t size) {
        checkMemory(path, size);
        checkPlausible(path, size, mostUnpacked);
    };
    const std::vector<ExrClaims> claims = checkExrAttributes(path);
    const ExrInput exr(path);
    int parts = 0;
    if (!exr.isOpen() || exr_get_count(exr.get(), &parts) != EXR_ERR_SUCCESS) {
        for (const ExrClaims& part : claims) {  // OpenEXR's C++ reader may take it all the same
            checkSides(path, part.width, part.height);
            checkChunk(part.chunkBytes());
        }
        return;
    }
    for (int part = 0; part < parts; ++part) checkChunk(unpackedSize(exr, part));
}

}  // namespace specbake::internal
