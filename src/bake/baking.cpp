#include "baking.h"

#include "mantissa.h"
#include "pipeline.h"

#include <specbake/core/error.h>

#include <algorithm>

namespace specbake {
namespace {

/// "FILE: pixel (x, y) is …; N in all", with the window's coordinates.
[[noreturn]] void refuse(const TextureInfo& info, const TexelCensus::Kind& kind, const char* what) {
    const auto width = std::size_t(info.data.width);
    const std::string x = std::to_string(info.data.x + int(*kind.first % width));
    const std::string y = std::to_string(info.data.y + int(*kind.first / width));
    throw FileError(info.path, "pixel (" + x + ", " + y + ") " + what + "; " +
                                   std::to_string(kind.count) + " such in all");
}

void refuseIncomplete(const TextureInfo& info, const TexelCensus& census) {
    const std::pair<Fate, const char*> reasons[] = {
        {Fate::notFinite, "is not a finite number"},
        {Fate::refused, "has a colour that no reflectance has"},
        {Fate::failed, "was not solved"}};
    for (const auto& [fate, what] : reasons) {
        if (census.of(fate).count > 0) refuse(info, census.of(fate), what);
    }
}

}  // namespace

Baking::Baking(Job& job, SpectrumLookup& lookup, SpectralWriter& writer,
               const StorageOptions& storage, int bits)
    : job_(job), lookup_(lookup), writer_(writer), storage_(storage), bits_(bits) {}

TexelCensus Baking::run(const std::function<void(double)>& progress) {
    const int height = job_.reader.info().data.height;
    std::vector<Band> bands = bandsOf();
    const auto write = [&](int i) {
        Band& band = bands[std::size_t(i)];
        writeBand(band);
        if (progress) progress(double(band.firstRow + band.rows) / height);
        band = {};
    };
    runPipeline(int(bands.size()),
                {[&](int i) { readBand(bands[std::size_t(i)]); },
                 [&](int i) { processBand(bands[std::size_t(i)]); }, write},
                job_.threads, job_.stop);
    refuseIncomplete(job_.reader.info(), census_);
    return census_;
}

/// Bands of whole chunks, at least 16 rows where they are short, so that a task is worth it.
std::vector<Band> Baking::bandsOf() const {
    const ChunkGrid& image = writer_.levels().front();
    constexpr std::size_t worthwhile = 1 << 22;  // bytes
    const std::size_t rowBytes = std::size_t(image.width) * std::size_t(writer_.channelCount()) *
                                 bytesPerSample(storage_.sampleType);
    const int rows = int(std::min<std::size_t>(worthwhile / rowBytes, 16));
    const int rowsOfChunks = std::max(1, rows / image.chunkHeight);
    std::vector<Band> bands;
    for (int row = 0; row < image.down(); row += rowsOfChunks) {
        const int end = std::min(row + rowsOfChunks, image.down());
        Band band;
        band.firstChunk = row * image.across();
        band.firstRow = row * image.chunkHeight;
        band.rows = std::min(end * image.chunkHeight, image.height) - band.firstRow;
        band.packed.resize(std::size_t((end - row) * image.across()));
        bands.push_back(std::move(band));
    }
    return bands;
}

void Baking::readBand(Band& band) {
    band.stored.resize(job_.reader.info().bytesPerRow() * std::size_t(band.rows));
    job_.reader.readRows(band.firstRow, band.rows, band.stored);
}

void Baking::processBand(Band& band) {
    const ChunkGrid& image = writer_.levels().front();
    Buffers& buffers = buffers_.local();
    std::vector<std::byte>& samples = buffers.samples;
    for (std::size_t i = 0; i < band.packed.size(); ++i) {
        const int chunk = band.firstChunk + int(i);
        samples.resize(writer_.chunkBytes(chunk));
        const Window texels = image.texels(chunk);
        const std::size_t rowBytes = samples.size() / std::size_t(texels.height);
        for (int row = 0; row < texels.height; ++row) {
            blendRun(band, {texels.x, texels.y + row, texels.width, 1}, buffers,
                     std::span(samples).subspan(std::size_t(row) * rowBytes, rowBytes));
        }
        if (band.census.complete()) band.packed[i] = writer_.pack(chunk, samples);
    }
    band.stored = {};
}

void Baking::blendRun(Band& band, const Window& run, Buffers& buffers,
                      std::span<std::byte> samples) {
    const TextureInfo& info = job_.reader.info();
    const auto count = std::size_t(run.width);
    buffers.colors.resize(count);
    buffers.alpha.resize(info.alpha ? count : 0);
    buffers.mixes.resize(count);
    const std::size_t texelBytes = info.bytesPerRow() / std::size_t(info.data.width);
    const std::size_t offset =
        info.bytesPerRow() * std::size_t(run.y - band.firstRow) + texelBytes * std::size_t(run.x);
    job_.decoder.decode(std::span(band.stored).subspan(offset, texelBytes * count), count,
                        buffers.colors.data(), buffers.alpha.data());
    SpectrumLookup::Scratch scratch;
    const std::size_t first =
        std::size_t(run.y) * std::size_t(info.data.width) + std::size_t(run.x);
    lookup_.locate(buffers.colors, first, buffers.mixes, scratch, band.census);
    const std::size_t plane = count * bytesPerSample(storage_.sampleType);
    const bool half = storage_.sampleType == SampleType::half;
    const BlendType type = half ? BlendType::half : BlendType::float32;
    if (info.alpha) storeSamples(buffers.alpha, type, samples.data());
    const auto colorPlanes = samples.subspan(info.alpha ? plane : 0);
    blend(buffers.mixes, type, colorPlanes.data(), plane);
    if (half) roundMantissa(colorPlanes, bits_);
}

void Baking::writeBand(Band& band) {
    census_.add(band.census);
    if (!census_.complete()) return;
    for (std::size_t i = 0; i < band.packed.size(); ++i) {
        writer_.write(band.firstChunk + int(i), band.packed[i]);
    }
}

}  // namespace specbake
