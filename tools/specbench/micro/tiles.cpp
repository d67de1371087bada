/// tiles_bench IMAGE...: tiles of 64 × 64 a second through OpenImageIO's ImageCache, one thread,
/// for all channels and for four bands: of a texture that is computed as it is read (NAME.spectral,
/// $OIIO_LIBRARY_PATH tells where the reader is) and of files that were baked.
///
/// First: a cache that has seen nothing, opening included. Again: the same tiles once more, of
/// which the cache has kept next to nothing. Kept: once more, from a cache that holds them all. The
/// images take turns, so that what else the machine does falls on all alike; medians of the turns.
#include "statistics.h"

#include <OpenImageIO/imagecache.h>
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace specbake::bench {
namespace {

constexpr int kSide = 64;
constexpr int kTurns = 3;

struct Deleter {
    void operator()(OIIO::ImageCache* cache) const { OIIO::ImageCache::destroy(cache, true); }
};
using Cache = std::unique_ptr<OIIO::ImageCache, Deleter>;

Cache newCache(float megabytes) {
    Cache cache(OIIO::ImageCache::create(false));
    cache->attribute("max_memory_MB", megabytes);
    return cache;
}

struct Channels {
    int first, end;
};

/// Tiles a second of all whole tiles, row by row.
double rate(OIIO::ImageCache& cache, const std::string& path, bool fewBands) {
    const auto begin = std::chrono::steady_clock::now();
    const OIIO::ustring name(path);
    OIIO::ImageSpec spec;
    if (!cache.get_imagespec(name, spec)) throw std::runtime_error(cache.geterror());
    const int bands = spec.nchannels - 81;
    const Channels channels =
        fewBands ? Channels{bands + 40, bands + 44} : Channels{0, spec.nchannels};
    std::vector<float> texels(std::size_t(kSide * kSide) *
                              std::size_t(channels.end - channels.first));
    int tiles = 0;
    for (int y = 0; y + kSide <= spec.height; y += kSide) {
        for (int x = 0; x + kSide <= spec.width; x += kSide, ++tiles) {
            if (!cache.get_pixels(name, 0, 0, x, x + kSide, y, y + kSide, 0, 1, channels.first,
                                  channels.end, OIIO::TypeFloat, texels.data(), OIIO::AutoStride,
                                  OIIO::AutoStride, OIIO::AutoStride, channels.first,
                                  channels.end)) {
                throw std::runtime_error(cache.geterror());
            }
        }
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    return tiles / seconds.count();
}

/// What is measured of one image.
struct Rates {
    std::vector<double> first, again, kept;
};

void takeTurn(const std::string& path, bool fewBands, Rates& rates) {
    const Cache small = newCache(1);
    rates.first.push_back(rate(*small, path, fewBands));
    rates.again.push_back(rate(*small, path, fewBands));
    const Cache large = newCache(8192);
    rate(*large, path, fewBands);
    rates.kept.push_back(rate(*large, path, fewBands));
}

void compare(const std::vector<std::string>& paths) {
    fmt::print("| tiles a second | channels | first | again | kept |\n|---|---|---|---|---|\n");
    for (const bool fewBands : {false, true}) {
        std::vector<Rates> rates(paths.size());
        for (int turn = 0; turn < kTurns; ++turn) {
            for (std::size_t i = 0; i < paths.size(); ++i) takeTurn(paths[i], fewBands, rates[i]);
        }
        for (std::size_t i = 0; i < paths.size(); ++i) {
            fmt::print("| {} | {} | {:.0f} | {:.0f} | {:.0f} |\n", paths[i], fewBands ? "4" : "all",
                       median(rates[i].first), median(rates[i].again), median(rates[i].kept));
        }
    }
}

}  // namespace
}  // namespace specbake::bench

int main(int argc, char** argv) {
    try {
        if (argc < 2) throw std::runtime_error("tiles_bench IMAGE...");
        specbake::bench::compare({argv + 1, argv + argc});
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tiles_bench: %s\n", error.what());
        return 1;
    }
}
