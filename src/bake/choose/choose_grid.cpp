#include "choose/color_survey.h"
#include "choose/tolerances.h"
#include "pipeline.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace specbake {
namespace {

constexpr std::array kResolutions = {3, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129};
constexpr std::size_t kRun = 64;  ///< colours looked up at a time

/// The mean over the bands of (a - b)²
double squaredDeviation(const Mix& a, const Mix& b) {
    double sum = 0;
    for (std::size_t p = kPreviewValues; p < kNodeValues; ++p) {
        double difference = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            difference += double(a.weights[k]) * double(a.values[k][p]) -
                          double(b.weights[k]) * double(b.values[k][p]);
        }
        sum += difference * difference;
    }
    return sum / kBandCount;
}

/// The RMS deviation between two lookups, over the colours and the bands.
double rmsDeviation(const Job& job, std::span<const TexelColor> colors, SpectrumLookup& coarse,
                    SpectrumLookup& direct) {
    const int runs = int((colors.size() + kRun - 1) / kRun);
    std::vector<double> sums(std::size_t(runs), 0.0);
    const auto compare = [&](int run) {
        const std::size_t first = std::size_t(run) * kRun;
        const auto some = colors.subspan(first, std::min(kRun, colors.size() - first));
        std::array<Mix, kRun> a;
        std::array<Mix, kRun> b;
        SpectrumLookup::Scratch scratch;
        TexelCensus census;
        coarse.locate(some, 0, std::span(a).first(some.size()), scratch, census);
        direct.locate(some, 0, std::span(b).first(some.size()), scratch, census);
        for (std::size_t i = 0; i < some.size(); ++i) {
            sums[std::size_t(run)] += squaredDeviation(a[i], b[i]);
        }
    };
    runPipeline(runs, {[](int) {}, compare, [](int) {}}, job.threads, job.stop);
    const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
    return colors.empty() ? 0 : std::sqrt(sum / double(colors.size()));
}

}  // namespace

GridChoice chooseGrid(const Job& job, double limit) {
    const std::vector<TexelColor> colors =
        sampleColors(job.path, job.decoder, kSampledColors, job.threads, job.stop);
    SpectrumLookup direct(std::nullopt, job.spaces, job.resolver);
    GridChoice choice;
    for (const int nodes : kResolutions) {
        SpectrumLookup lookup(nodes, job.spaces, job.resolver);
        choice = {nodes, rmsDeviation(job, colors, lookup, direct)};
        if (choice.deviation <= limit) return choice;
    }
    throw FileError(job.path, "the finest grid deviates by " + std::to_string(choice.deviation) +
                                  "; solve every texel by itself instead");
}

}  // namespace specbake
