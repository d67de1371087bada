#include "baking.h"

#include "mantissa.h"
#include "pipeline.h"
#include "refusal.h"

#include <specbake/core/error.h>
#include <specbake/image/limits.h>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>

namespace specbake::internal {
namespace {

/// The rows of a band and those ahead of it; of these, what is kept for the next band is in
/// `ahead`.
std::vector<std::byte> rowsOf(Texture& texture, const Band& band, std::vector<std::byte>& ahead) {
    const std::size_t rowBytes = texture.info().bytesPerRow();
    std::vector<std::byte> stored = std::exchange(ahead, {});
    const std::size_t there = stored.size();
    const int first = int(there / rowBytes);
    const int rows = band.rows + band.rowsAhead;
    stored.resize(rowBytes * std::size_t(rows));
    if (first < rows) {
        texture.readRows(band.firstRow + first, rows - first, std::span(stored).subspan(there));
    }
    ahead.assign(stored.end() - std::ptrdiff_t(rowBytes) * band.rowsAhead, stored.end());
    return stored;
}

/// The texels of a run, of an image whose rows from the band's first on are in `stored`.
std::span<const std::byte> texelsOf(const Window& run, const Band& band, const TextureInfo& info,
                                    const std::vector<std::byte>& stored) {
    const std::size_t texelBytes = info.bytesPerRow() / std::size_t(info.data.width);
    const std::size_t offset =
        info.bytesPerRow() * std::size_t(run.y - band.firstRow) + texelBytes * std::size_t(run.x);
    return std::span(stored).subspan(offset, texelBytes * std::size_t(run.width));
}

}  // namespace

Baking::Baking(const TexelSource& source, const Upsampler& upsampler, SpectralSink& sink, int bits)
    : source_(source),
      upsampler_(upsampler),
      sink_(sink),
      bits_(bits),
      channels_(SampleSelection::channels(upsampler.options().bands)),
      pyramid_(std::span(sink.levels()).subspan(1), sink.alpha()),
      levelTiles_(sink, bits) {}

ColorCensus Baking::run(const std::function<void(double)>& progress) {
    const int height = source_.info().data.height;
    std::vector<Band> bands = bandsOf();
    const auto write = [&](int i) {
        Band& band = bands[std::size_t(i)];
        writeBand(band);
        if (progress) progress(double(band.firstRow + band.rows) / height);
        band = {};
    };
    runPipeline(
        int(bands.size()),
        {[&](int i) { readBand(bands[std::size_t(i)]); },
         [&](int i) { processBand(bands[std::size_t(i)]); }, write, bandBytes(bands.front())},
        source_.threads, source_.stop);
    refuseIncomplete(source_.info(), census_);
    return census_;
}

/// Bands of whole chunks, at least 16 rows where they are short, so that a task is worth it. They
/// begin at even rows where there is a level below: so does what a row of that level is made of.
std::vector<Band> Baking::bandsOf() const {
    const ChunkGrid& image = sink_.levels().front();
    constexpr std::size_t worthwhile = 1 << 22;  // bytes
    const std::size_t rowBytes = std::size_t(image.width) * std::size_t(sink_.channelCount()) *
                                 bytesPerSample(sink_.sampleType());
    const int rows = int(std::min<std::size_t>(worthwhile / rowBytes, 16));
    int rowsOfChunks = std::max(1, rows / image.chunkHeight);
    if (hasLevels() && rowsOfChunks * image.chunkHeight % 2 == 1) rowsOfChunks *= 2;
    std::vector<Band> bands;
    for (int row = 0; row < image.down(); row += rowsOfChunks) {
        const int end = std::min(row + rowsOfChunks, image.down());
        Band band;
        band.firstChunk = row * image.across();
        band.firstRow = row * image.chunkHeight;
        band.rows = std::min(end * image.chunkHeight, image.height) - band.firstRow;
        const bool last = band.firstRow + band.rows == image.height;
        band.rowsAhead = hasLevels() && image.height % 2 == 1 && !last ? 1 : 0;
        const int chunks = (end - row) * image.across();
        band.packed.resize(std::size_t(chunks));
        bands.push_back(std::move(band));
    }
    return bands;
}

/// Its texels, its samples, what they are packed from and what into. Throws FileError for more than
/// the limit.
std::size_t Baking::bandBytes(const Band& band) const {
    std::size_t chunks = 0;
    for (std::size_t i = 0; i < band.packed.size(); ++i) {
        chunks += sink_.chunkBytes(band.firstChunk + int(i));
    }
    const std::size_t bytes = source_.info().bytesPerRow() * std::size_t(band.rows) + 3 * chunks;
    if (bytes <= limits().memory) return bytes;
    throw FileError(source_.info().path,
                    "its rows are so long that those of one chunk take " + bytesText(bytes) +
                        ", more than --max-memory: tiles, or --compression zips, take less");
}

void Baking::readBand(Band& band) {
    band.stored = rowsOf(source_.texture, band, readAhead_);
    for (Beside& beside : beside_) {
        band.beside.push_back(rowsOf(beside.image->image(), band, beside.readAhead));
    }
}

/// The nodes that a band needs, all threads together: a small texture has no other bands for them.
/// If some of the rows need none, the others need few, and find them by themselves.
void Baking::solveNodes(const Band& band, Buffers& buffers) {
    if (!upsampler_.options().grid) return;
    constexpr int sparse = 4;
    constexpr std::size_t worthATask = 32;
    for (int row = 0; row < band.rows; row += sparse) noteNodes(band, row, buffers);
    std::size_t noted = upsampler_.noteNodes({});
    if (noted == 0) return;
    for (int row = 0; row < band.rows; ++row) {
        if (row % sparse != 0) noted = noteNodes(band, row, buffers);
    }
    // Isolated: a thread that waits here must not begin another band, which may wait for this one.
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(std::size_t(0), noted / worthATask + 1,
                          [&](std::size_t) { upsampler_.solveNotedNodes(); });
    });
}

std::size_t Baking::noteNodes(const Band& band, int row, Buffers& buffers) {
    const int width = source_.info().data.width;
    decodeRun(band, {0, band.firstRow + row, width, 1}, buffers);
    return upsampler_.noteNodes(buffers.colors);
}

void Baking::processBand(Band& band) {
    const ChunkGrid& image = sink_.levels().front();
    Buffers buffers;
    idle_.try_pop(buffers);
    solveNodes(band, buffers);
    for (std::size_t i = 0; i < band.packed.size(); ++i) {
        const int chunk = band.firstChunk + int(i);
        std::vector<std::byte> samples;
        spare_.try_pop(samples);
        samples.resize(sink_.chunkBytes(chunk));
        const Window texels = image.texels(chunk);
        const std::size_t rowBytes = samples.size() / std::size_t(texels.height);
        for (int row = 0; row < texels.height; ++row) {
            bakeRun(band, {texels.x, texels.y + row, texels.width, 1}, sink_.sampleType(), buffers,
                    std::span(samples).subspan(std::size_t(row) * rowBytes, rowBytes), band.census,
                    band.besideCensus);
        }
        if (band.census.withoutSpectrum() == 0)
            band.packed[i] = sink_.pack(chunk, std::move(samples));
    }
    if (hasLevels() && band.census.withoutSpectrum() == 0) reduceBand(band, buffers);
    idle_.push(std::move(buffers));
    band.stored = {};
    band.beside = {};
}

/// The rows of the level below whose first tap is in the band.
void Baking::reduceBand(Band& band, Buffers& buffers) {
    const ChunkGrid& image = sink_.levels().front();
    const int height = image.height;
    std::vector<std::pair<int, TexelRow>> known;  // rows of the image
    for (int row = band.firstRow / 2; row < halvedSide(height); ++row) {
        const BoxTaps taps = boxTaps(height, row);
        if (taps.first >= band.firstRow + band.rows) break;
        std::erase_if(known, [&](const auto& k) { return k.first < taps.first; });
        for (int y = taps.first + int(known.size()); y < taps.first + taps.count; ++y) {
            known.emplace_back(y, unroundedRow(band, y, buffers));
        }
        std::vector<const TexelRow*> rows;
        for (const auto& [y, texels] : known) rows.push_back(&texels);
        band.smaller.push_back(averageRows(rows, taps, image.width, sink_.alpha()));
    }
}

TexelRow Baking::unroundedRow(const Band& band, int row, Buffers& buffers) {
    const int width = sink_.levels().front().width;
    TexelRow texels(std::size_t(width) * std::size_t(sink_.channelCount()));
    ColorCensus counted;  // once, when the row's samples were made
    BesideCensus besideCounted;
    bakeRun(band, {0, row, width, 1}, SampleType::float32, buffers,
            std::as_writable_bytes(std::span(texels)), counted, besideCounted);
    return texels;
}

void Baking::decodeRun(const Band& band, const Window& run, Buffers& buffers) const {
    const TextureInfo& info = source_.info();
    const auto count = std::size_t(run.width);
    buffers.colors.resize(count);
    buffers.alpha.resize(info.alpha ? count : 0);
    source_.decoder.decode(texelsOf(run, band, info, band.stored), count, buffers.colors.data(),
                           buffers.alpha.data());
}

void Baking::bakeRun(const Band& band, const Window& run, SampleType type, Buffers& buffers,
                     std::span<std::byte> samples, ColorCensus& census, BesideCensus& beside) {
    const TextureInfo& info = source_.info();
    const auto count = std::size_t(run.width);
    decodeRun(band, run, buffers);
    const std::size_t plane = samples.size() / std::size_t(sink_.channelCount());
    if (info.alpha) storeSamples(buffers.alpha, type, samples.data());
    const auto colorPlanes = samples.subspan(info.alpha ? plane : 0);
    const auto first = std::size_t(run.y) * std::size_t(info.data.width) + std::size_t(run.x);
    const bool later = !beside_.empty() || isShort(type);  // stored from floats
    buffers.unrounded.resize(later ? channels_.count() * count : 0);
    const auto target =
        later ? SampleTarget::planar(SampleType::float32,
                                     std::as_writable_bytes(std::span(buffers.unrounded)).data(),
                                     count * sizeof(float))
              : SampleTarget::planar(type, colorPlanes.data(), plane);
    census.add(upsampler_.sample(buffers.colors, channels_, target, buffers.upsampling), first);
    for (std::size_t i = 0; i < beside_.size(); ++i) {
        const ImageBeside& image = *beside_[i].image;
        image.change(buffers.colors, texelsOf(run, band, image.image().info(), band.beside[i]),
                     buffers.unrounded, beside);
    }
    if (later) store(buffers.unrounded, type, colorPlanes.data());
}

void Baking::store(std::span<const float> samples, SampleType type, std::byte* to) const {
    if (isShort(type)) {
        storeRounded(samples, bits_, to);
    } else {
        storeSamples(samples, type, to);
    }
}

void Baking::writeBand(Band& band) {
    census_.add(band.census);
    besideCensus_.add(band.besideCensus);
    if (census_.withoutSpectrum() > 0) return;
    for (std::size_t i = 0; i < band.packed.size(); ++i) {
        sink_.write(band.firstChunk + int(i), band.packed[i]);
        spare_.push(std::move(band.packed[i]));
    }
    for (TexelRow& row : band.smaller) {
        pyramid_.add(std::move(row));
        for (const TileRow& tiles : pyramid_.takeComplete()) levelTiles_.write(tiles);
    }
}

}  // namespace specbake::internal
