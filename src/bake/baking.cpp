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
    const int chunkRows = rowsPerChunk(storage_.compression);
    constexpr std::size_t worthwhile = 1 << 22;  // bytes
    const std::size_t rowBytes = writer_.chunkBytes(0) / std::size_t(writer_.chunkRows(0));
    const int chunks =
        std::max(1, int(std::min<std::size_t>(worthwhile / rowBytes, 16)) / chunkRows);
    std::vector<Band> bands;
    for (int chunk = 0; chunk < writer_.chunkCount(); chunk += chunks) {
        Band band;
        band.firstChunk = chunk;
        band.firstRow = writer_.chunkFirstRow(chunk);
        const int last = std::min(chunk + chunks, writer_.chunkCount()) - 1;
        band.rows = writer_.chunkFirstRow(last) + writer_.chunkRows(last) - band.firstRow;
        const int packed = last - chunk + 1;
        band.packed.resize(std::size_t(packed));
        bands.push_back(std::move(band));
    }
    return bands;
}

void Baking::readBand(Band& band) {
    band.stored.resize(job_.reader.info().bytesPerRow() * std::size_t(band.rows));
    job_.reader.readRows(band.firstRow, band.rows, band.stored);
}

void Baking::processBand(Band& band) {
    Buffers& buffers = buffers_.local();
    std::vector<std::byte>& samples = buffers.samples;
    for (std::size_t i = 0; i < band.packed.size(); ++i) {
        const int chunk = band.firstChunk + int(i);
        samples.resize(writer_.chunkBytes(chunk));
        for (int row = 0; row < writer_.chunkRows(chunk); ++row) {
            const std::size_t bytes = samples.size() / std::size_t(writer_.chunkRows(chunk));
            const int imageRow = writer_.chunkFirstRow(chunk) + row;
            blendRow(band, imageRow, buffers,
                     std::span(samples).subspan(std::size_t(row) * bytes, bytes));
        }
        if (band.census.complete()) band.packed[i] = writer_.pack(chunk, samples);
    }
    band.stored = {};
}

void Baking::blendRow(Band& band, int imageRow, Buffers& buffers, std::span<std::byte> samples) {
    const TextureInfo& info = job_.reader.info();
    const auto width = std::size_t(info.data.width);
    buffers.colors.resize(width);
    buffers.alpha.resize(info.alpha ? width : 0);
    buffers.mixes.resize(width);
    const std::size_t offset = info.bytesPerRow() * std::size_t(imageRow - band.firstRow);
    job_.decoder.decode(std::span(band.stored).subspan(offset, info.bytesPerRow()), width,
                        buffers.colors.data(), buffers.alpha.data());
    SpectrumLookup::Scratch scratch;
    lookup_.locate(buffers.colors, std::size_t(imageRow) * width, buffers.mixes, scratch,
                   band.census);
    const std::size_t plane = width * bytesPerSample(storage_.sampleType);
    const bool half = storage_.sampleType == SampleType::half;
    const BlendType type = half ? BlendType::half : BlendType::float32;
    if (info.alpha) storeSamples(buffers.alpha, type, samples.data());
    const auto colorPlanes = samples.subspan(info.alpha ? plane : 0);
    blend(buffers.mixes, type, colorPlanes.data(), plane);
    if (half) roundMantissa(colorPlanes, bits_);
}

void Baking::writeBand(Band& band) {
    census_.append(band.census);
    if (!census_.complete()) return;
    for (std::size_t i = 0; i < band.packed.size(); ++i) {
        writer_.write(band.firstChunk + int(i), band.packed[i]);
    }
}

}  // namespace specbake
