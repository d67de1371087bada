#include "attributes.h"
#include "baking.h"
#include "choose/tolerances.h"
#include "mantissa.h"

#include <specbake/bake/bake.h>
#include <specbake/core/error.h>

#include <chrono>

namespace specbake {
namespace {

SpectralHeader headerOf(const TextureInfo& info, Attributes attributes) {
    return {info.data, info.display, info.pixelAspectRatio, info.alpha.has_value(),
            std::move(attributes)};
}

/// The options with what they leave to the texture decided.
struct Decided {
    BakeOptions options;
    std::optional<double> deviation;
    std::optional<double> difference;

    std::optional<int> grid() const {
        return options.perTexel ? std::nullopt : std::optional(options.grid);
    }
};

Decided decidedGrid(const Job& job, const BakeOptions& options) {
    if (options.bits < kFewestMantissaBits || options.bits > kHalfMantissaBits) {
        throw ArgumentError("a half's mantissa is rounded to 4 to 10 bits");
    }
    Decided decided{options, {}, {}};
    if (!options.maxDeviation || options.perTexel) return decided;
    const GridChoice choice = chooseGrid(job, *options.maxDeviation);
    decided.options.grid = choice.nodes;
    decided.deviation = choice.deviation;
    return decided;
}

void decideBits(const Job& job, SpectrumLookup& lookup, Decided& decided) {
    BakeOptions& options = decided.options;
    if (!options.maxDE || options.storage.sampleType != SampleType::half) return;
    const BitsChoice choice = chooseBits(job, lookup, *options.maxDE);
    options.bits = choice.bits;
    decided.difference = choice.difference;
}

BakeStatistics statisticsOf(const Job& job, const Decided& decided, const TexelCensus& census) {
    const TextureInfo& info = job.reader.info();
    BakeStatistics s;
    s.space = job.space.name;
    s.illuminant = job.observer.illuminant();
    s.texels = std::size_t(info.data.width) * std::size_t(info.data.height);
    s.grid = decided.grid().value_or(0);
    s.bits = decided.options.storage.sampleType == SampleType::half ? decided.options.bits : 23;
    s.deviation = decided.deviation;
    s.difference = decided.difference;
    s.directTexels = census.of(Fate::solved).count + census.of(Fate::moved).count;
    s.outsideTexels = census.of(Fate::moved).count;
    s.largestMove = census.largestMove();
    s.notes = info.notes;
    return s;
}

BakeStatistics bakeJob(Job& job, const std::filesystem::path& output, const BakeOptions& options) {
    Decided decided = decidedGrid(job, options);
    SpectrumLookup lookup(decided.grid(), job.spaces, job.resolver);
    decideBits(job, lookup, decided);
    const TextureInfo& info = job.reader.info();
    SpectralWriter writer(output,
                          headerOf(info, bakedAttributes(info.attributes, decided.options,
                                                         job.space, job.observer.illuminant())),
                          options.storage);
    const TexelCensus census =
        Baking(job, lookup, writer, options.storage, decided.options.bits).run(options.progress);
    writer.commit();
    BakeStatistics statistics = statisticsOf(job, decided, census);
    statistics.nodesSolved = lookup.nodesSolved();
    return statistics;
}

}  // namespace

BakeStatistics bake(const std::string& input, const std::filesystem::path& output,
                    const BakeOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    Job job(input, options);
    BakeStatistics statistics = bakeJob(job, output, options);
    statistics.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return statistics;
}

}  // namespace specbake
