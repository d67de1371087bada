#include "texture/openimageio/tiff_chromaticities.h"

#include <tiffio.h>

#include <cstdarg>
#include <memory>
#include <span>

namespace specbake::internal {
namespace {

struct Closed {
    void operator()(TIFF* file) const { TIFFClose(file); }
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

using File = std::unique_ptr<TIFF, Closed>;

/// A file is refused, or not, by the reader of its texels, with its own words.
int passOver(TIFF*, void*, const char*, const char*, std::va_list) {
    return 1;
}

/// Its handlers are the file's own: the host's stay as they are.
File opened(const std::string& path) {
    constexpr tmsize_t mostBytes = tmsize_t(1) << 26U;  // of one tag or table
    const std::unique_ptr<TIFFOpenOptions, Closed> options(TIFFOpenOptionsAlloc());
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), mostBytes);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), passOver, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), passOver, nullptr);
    return File(TIFFOpenExt(path.c_str(), "rm", options.get()));  // m: not mapped into memory
}

/// x and y, `points` times; empty if the tag is not there.
std::span<const float> pointsOf(TIFF* file, std::uint32_t tag, std::size_t points) {
    const float* xy = nullptr;
    if (TIFFGetField(file, tag, &xy) != 1 || xy == nullptr) return {};
    return {xy, 2 * points};
}

}  // namespace

std::optional<Primaries> tiffChromaticities(const std::string& path, int directory) {
    const File file = opened(path);
    if (!file || TIFFSetDirectory(file.get(), tdir_t(directory)) != 1) return {};
    const auto rgb = pointsOf(file.get(), TIFFTAG_PRIMARYCHROMATICITIES, 3);
    const auto white = pointsOf(file.get(), TIFFTAG_WHITEPOINT, 1);
    if (rgb.empty() || white.empty()) return {};
    const auto at = [](std::span<const float> xy, std::size_t point) {
        return Chromaticity{double(xy[2 * point]), double(xy[2 * point + 1])};
    };
    return Primaries{at(rgb, 0), at(rgb, 1), at(rgb, 2), at(white, 0)};
}

}  // namespace specbake::internal
