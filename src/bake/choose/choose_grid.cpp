#include "choose/color_survey.h"
#include "choose/tolerances.h"
#include "pipeline.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

namespace specbake::internal {
namespace {

constexpr std::array kResolutions = {3, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129};
constexpr std::size_t kRun = 64;  ///< colours looked up at a time

/// The bands of some colours, one after the other.
using Bands = std::vector<float>;

Bands bandsOf(const Upsampler& upsampler, std::span<const TexelColor> colors) {
    const SampleSelection bands = SampleSelection::bands();
    Bands samples(colors.size() * bands.count());
    const auto target = SampleTarget::interleaved(
        SampleType::float32, reinterpret_cast<std::byte*>(samples.data()), bands);
    Upsampler::Workspace workspace;
    // What has no spectrum has that of black in both, and deviates by nothing.
    static_cast<void>(upsampler.sample(colors, bands, target, workspace));
    return samples;
}

double squaredDifference(const Bands& a, const Bands& b) {
    return std::transform_reduce(a.begin(), a.end(), b.begin(), 0.0, std::plus<>(),
                                 [](float x, float y) {
                                     const double difference = double(x) - double(y);
                                     return difference * difference;
                                 });
}

/// The RMS deviation between two models, over the colours and the bands.
double rmsDeviation(const TexelSource& source, std::span<const TexelColor> colors,
                    const Upsampler& coarse, const Upsampler& direct) {
    const int runs = int((colors.size() + kRun - 1) / kRun);
    std::vector<double> sums(std::size_t(runs), 0.0);
    const auto compare = [&](int run) {
        const std::size_t first = std::size_t(run) * kRun;
        const auto some = colors.subspan(first, std::min(kRun, colors.size() - first));
        sums[std::size_t(run)] = squaredDifference(bandsOf(coarse, some), bandsOf(direct, some));
    };
    runPipeline(runs, {[](int) {}, compare, [](int) {}}, source.threads, source.stop);
    const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
    return colors.empty() ? 0 : std::sqrt(sum / (double(colors.size()) * kBandCount));
}

}  // namespace

GridChoice chooseGrid(const TexelSource& source, const ColorSpace& space,
                      const UpsamplerOptions& model, double limit) {
    const std::vector<TexelColor> colors = sampleColors(source, kSampledColors);
    UpsamplerOptions options = model;
    options.grid = std::nullopt;
    const Upsampler direct(space, options);
    GridChoice choice;
    for (const int nodes : kResolutions) {
        options.grid = nodes;
        choice = {nodes, rmsDeviation(source, colors, Upsampler(space, options), direct)};
        if (choice.deviation <= limit) return choice;
    }
    throw FileError(source.info().path, "the finest grid deviates by " +
                                            std::to_string(choice.deviation) +
                                            "; solve every texel by itself instead");
}

}  // namespace specbake::internal
