#include "spectral_input.h"

#include "level_specs.h"
#include "recipe.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <mutex>
#include <numeric>
#include <span>

namespace specbake::openimageio {
namespace {

constexpr const char* kHints = "spectral:";

void applyHints(Recipe& recipe, const OIIO::ImageSpec& config) {
    forEachOption([&](std::string_view name) {
        const auto* hint = config.find_attribute(kHints + std::string(name));
        if (hint != nullptr && name != "source") setOption(recipe, name, hint->get_string());
    });
}

/// What is solved for one image serves the others of the same options, as long as any is open.
std::shared_ptr<ModelCache> sharedModels() {
    static std::mutex mutex;
    static std::weak_ptr<ModelCache> models;
    const std::lock_guard lock(mutex);
    auto shared = models.lock();
    if (!shared) models = shared = std::make_shared<ModelCache>();
    return shared;
}

/// A tile's rows to where they belong in a region, as far as they lie in it.
void copyRows(std::span<const std::byte> from, const Window& tile, const Window& region,
              std::size_t pixelBytes, std::byte* to) {
    const std::size_t rowBytes = std::size_t(tile.width) * pixelBytes;
    const int columns = std::min(tile.width, region.x + region.width - tile.x);
    const int rows = std::min(tile.height, region.y + region.height - tile.y);
    for (int y = 0; y < rows; ++y) {
        const std::size_t pixel = std::size_t(tile.y + y - region.y) * std::size_t(region.width) +
                                  std::size_t(tile.x - region.x);
        std::memcpy(to + pixel * pixelBytes, from.data() + std::size_t(y) * rowBytes,
                    std::size_t(columns) * pixelBytes);
    }
}

}  // namespace

int SpectralInput::supports(OIIO::string_view feature) const {
    return feature == "arbitrary_metadata" || feature == "mipmap" ? 1 : 0;
}

bool SpectralInput::valid_file(const std::string& name) const {
    try {
        return !recipeOf(name).source.empty();
    } catch (const std::exception&) {
        return false;
    }
}

bool SpectralInput::open(const std::string& name, OIIO::ImageSpec& spec) {
    return open(name, spec, OIIO::ImageSpec());
}

bool SpectralInput::open(const std::string& name, OIIO::ImageSpec& spec,
                         const OIIO::ImageSpec& config) {
    close();
    try {
        Recipe recipe = recipeOf(name);
        applyHints(recipe, config);
        image_ = imageOf(recipe, sharedModels());
        specs_ = levelSpecs(*image_);
        channels_ = readersOrder(image_->header().alpha, image_->header().bands.count);
    } catch (const std::exception& error) {
        close();
        errorfmt("{}", error.what());
        return false;
    }
    m_spec = specs_.front();
    spec = m_spec;
    return true;
}

bool SpectralInput::close() {
    image_.reset();
    specs_.clear();
    channels_.clear();
    level_ = 0;
    m_spec = OIIO::ImageSpec();
    return true;
}

bool SpectralInput::exists(int subimage, int miplevel) const {
    return subimage == 0 && miplevel >= 0 && miplevel < int(specs_.size());
}

bool SpectralInput::seek_subimage(int subimage, int miplevel) {
    if (!exists(subimage, miplevel)) return false;
    if (miplevel == level_) return true;
    level_ = miplevel;
    m_spec = specs_[std::size_t(miplevel)];
    return true;
}

OIIO::ImageSpec SpectralInput::spec(int subimage, int miplevel) {
    return exists(subimage, miplevel) ? specs_[std::size_t(miplevel)] : OIIO::ImageSpec();
}

OIIO::ImageSpec SpectralInput::spec_dimensions(int subimage, int miplevel) {
    OIIO::ImageSpec dimensions;
    if (exists(subimage, miplevel)) dimensions.copy_dimensions(specs_[std::size_t(miplevel)]);
    return dimensions;
}

bool SpectralInput::read_tiles(int subimage, int miplevel, int xbegin, int xend, int ybegin,
                               int yend, int zbegin, int zend, int chbegin, int chend,
                               OIIO::TypeDesc format, void* data, OIIO::stride_t xstride,
                               OIIO::stride_t ystride, OIIO::stride_t zstride) {
    if (!exists(subimage, miplevel)) return false;
    const OIIO::ImageSpec& level = specs_[std::size_t(miplevel)];
    const int width = xend - xbegin;
    const int height = yend - ybegin;
    if (width % level.tile_width == 0 && height % level.tile_height == 0) {
        return ImageInput::read_tiles(subimage, miplevel, xbegin, xend, ybegin, yend, zbegin, zend,
                                      chbegin, chend, format, data, xstride, ystride, zstride);
    }
    const int channels = std::clamp(chend, 0, level.nchannels) - chbegin;
    if (width <= 0 || height <= 0 || channels <= 0) return false;
    if (format == OIIO::TypeUnknown) format = level.format;
    std::vector<std::byte> samples(std::size_t(width) * std::size_t(height) *
                                   std::size_t(channels) * level.format.size());
    OIIO::ImageSpec::auto_stride(xstride, ystride, zstride, format, channels, width, height);
    return read_native_tiles(subimage, miplevel, xbegin, xend, ybegin, yend, zbegin, zend, chbegin,
                             chbegin + channels, samples.data()) &&
           OIIO::convert_image(channels, width, height, 1, samples.data(), level.format,
                               OIIO::AutoStride, OIIO::AutoStride, OIIO::AutoStride, data, format,
                               xstride, ystride, zstride);
}

bool SpectralInput::read_native_scanline(int /*subimage*/, int /*miplevel*/, int /*y*/, int /*z*/,
                                         void* /*data*/) {
    errorfmt("a spectral image is read by tiles");
    return false;
}

bool SpectralInput::read_native_tile(int subimage, int miplevel, int x, int y, int z, void* data) {
    if (!exists(subimage, miplevel)) return false;
    const OIIO::ImageSpec& level = specs_[std::size_t(miplevel)];
    return read_native_tiles(subimage, miplevel, x, x + level.tile_width, y, y + level.tile_height,
                             z, z + 1, 0, level.nchannels, data);
}

bool SpectralInput::read_native_tiles(int subimage, int miplevel, int xbegin, int xend, int ybegin,
                                      int yend, int zbegin, int zend, void* data) {
    return read_native_tiles(subimage, miplevel, xbegin, xend, ybegin, yend, zbegin, zend, 0,
                             int(channels_.size()), data);
}

bool SpectralInput::read_native_tiles(int subimage, int miplevel, int xbegin, int xend, int ybegin,
                                      int yend, int /*zbegin*/, int /*zend*/, int chbegin,
                                      int chend, void* data) {
    if (!exists(subimage, miplevel)) return false;
    const OIIO::ImageSpec& level = specs_[std::size_t(miplevel)];
    chend = std::clamp(chend, 0, level.nchannels);
    const bool atTile = xbegin >= level.x && (xbegin - level.x) % level.tile_width == 0 &&
                        ybegin >= level.y && (ybegin - level.y) % level.tile_height == 0;
    if (chbegin < 0 || chbegin >= chend || xend <= xbegin || yend <= ybegin || !atTile) {
        errorfmt("no such tiles or channels");
        return false;
    }
    try {
        readRegion(
            miplevel,
            {{xbegin - level.x, ybegin - level.y, xend - xbegin, yend - ybegin}, chbegin, chend},
            static_cast<std::byte*>(data));
    } catch (const std::exception& error) {
        errorfmt("{}", error.what());
        return false;
    }
    return true;
}

/// Tile by tile; what lies beyond the image's edges becomes 0.
void SpectralInput::readRegion(int miplevel, const Region& region, std::byte* data) const {
    const ChunkGrid& level = image_->levels()[std::size_t(miplevel)];
    const auto channels = std::span(channels_).subspan(
        std::size_t(region.firstChannel), std::size_t(region.endChannel - region.firstChannel));
    const std::size_t pixelBytes = channels.size() * bytesPerSample(image_->sampleType());
    const Window& at = region.at;
    std::memset(data, 0, pixelBytes * std::size_t(at.width) * std::size_t(at.height));
    const int right = std::min(at.x + at.width, level.width);
    const int lower = std::min(at.y + at.height, level.height);
    std::vector<std::byte> samples;
    for (int y = at.y; y < lower; y += level.chunkHeight) {
        for (int x = at.x; x < right; x += level.chunkWidth) {
            const int chunk =
                level.firstChunk + y / level.chunkHeight * level.across() + x / level.chunkWidth;
            const Window tile = level.texels(chunk);
            samples.resize(pixelBytes * std::size_t(tile.width) * std::size_t(tile.height));
            image_->readChunk(chunk, channels, samples);
            copyRows(samples, tile, at, pixelBytes, data);
        }
    }
}

}  // namespace specbake::openimageio
