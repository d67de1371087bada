#include "choose/color_survey.h"
#include "choose/tolerances.h"
#include "pipeline.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace specbake::internal {
namespace {

constexpr std::array kResolutions = {3, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129};

constexpr int kFinestShared = 33;  ///< whose nodes, 14 MB at most, are kept for other textures

/// The bands of some colours, one after the other.
using Bands = std::vector<float>;

Bands bandsOf(const Upsampler& upsampler, std::span<const TexelColor> colors) {
    const SampleSelection bands = SampleSelection::bands(upsampler.observer().knots());
    Bands samples(colors.size() * bands.count());
    const auto target = SampleTarget::interleaved(
        SampleType::float32, reinterpret_cast<std::byte*>(samples.data()), bands);
    Upsampler::Workspace workspace;
    // What has no spectrum has that of black in both, and deviates by nothing.
    static_cast<void>(upsampler.sample(colors, bands, target, workspace));
    return samples;
}

double squaredDifference(std::span<const float> a, std::span<const float> b) {
    return std::transform_reduce(a.begin(), a.end(), b.begin(), 0.0, std::plus<>(),
                                 [](float x, float y) {
                                     const double difference = double(x) - double(y);
                                     return difference * difference;
                                 });
}

/// How far spectra deviate: squares summed over bands and texels, and the largest texel's.
struct Deviation {
    double squares = 0;
    double largest = 0;
    std::size_t texels = 0;

    void add(const Deviation& other) {
        squares += other.squares;
        largest = std::max(largest, other.largest);
        texels += other.texels;
    }
    double rms() const { return rootOfMean(squares, texels); }
    double largestRms() const { return rootOfMean(largest, 1); }

  private:
    static double rootOfMean(double sum, std::size_t count) {
        return count == 0 ? 0 : std::sqrt(sum / (double(count) * kBandCount));
    }
};

/// Grids beside the solver, on the colours of a texture.
class GridTrial {
  public:
    GridTrial(const TexelSource& source, const Upsampler& direct)
        : source_(source),
          direct_(direct),
          tally_(tallyColors(source, kMostColors)),
          runs_((tally_.colors.size() + kRun - 1) / kRun),
          solved_(std::min(runs_, kKeptRuns)) {
        for (const ColorCount& c : tally_.colors) texels_ += c.texels;
    }

    const ColorTally& tally() const { return tally_; }

    /// Of the spectra through a grid; where it is beyond `limit`, of as many colours as show that.
    Deviation of(const Upsampler& coarse, double limit) {
        // A little more, lest the order in which runs come decide a draw.
        const double most = limit * limit * double(texels_) * kBandCount * (1 + 1e-6);
        std::vector<Deviation> found(runs_);
        std::atomic<double> squares = 0;
        const auto compare = [&](int run) {
            if (squares > most) return;
            found[std::size_t(run)] = ofRun(coarse, std::size_t(run));
            squares += found[std::size_t(run)].squares;
        };
        runPipeline(int(runs_), {[](int) {}, compare, [](int) {}}, source_.threads, source_.stop);
        Deviation total;
        for (const Deviation& run : found) total.add(run);
        return total;
    }

  private:
    static constexpr std::size_t kRun = 64;         ///< colours looked up at a time
    static constexpr std::size_t kKeptRuns = 4096;  ///< whose solved bands are kept: 85 MB

    Deviation ofRun(const Upsampler& coarse, std::size_t run) {
        const auto counts = std::span(tally_.colors).subspan(run * kRun);
        std::vector<TexelColor> colors;
        for (const ColorCount& c : counts.first(std::min(kRun, counts.size()))) {
            colors.push_back(c.color);
        }
        Bands solved = run < kKeptRuns ? std::move(solved_[run]) : Bands();
        if (solved.empty()) solved = bandsOf(direct_, colors);
        const Bands looked = bandsOf(coarse, colors);
        const auto count = std::size_t(direct_.observer().knots().count);
        Deviation found;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            const auto bands = [&](const Bands& all) {
                return std::span(all).subspan(i * count, count);
            };
            // As of kBandCount bands, however many there are.
            const double squares =
                squaredDifference(bands(looked), bands(solved)) * (kBandCount / double(count));
            found.add({squares * double(counts[i].texels), squares, counts[i].texels});
        }
        if (run < kKeptRuns) solved_[run] = std::move(solved);
        return found;
    }

    const TexelSource& source_;
    const Upsampler& direct_;
    ColorTally tally_;
    std::size_t runs_;
    std::vector<Bands> solved_;  ///< of the first runs, once they were solved
    std::size_t texels_ = 0;
};

}  // namespace

GridChoice chooseGrid(const TexelSource& source, const ColorSpace& space,
                      const UpsamplerOptions& model, double limit, ModelCache& models) {
    UpsamplerOptions options = model;
    options.grid = std::nullopt;
    const auto direct = models.model(space, options);
    GridTrial trial(source, *direct);
    GridChoice choice{0, 0, 0, trial.tally().colors.size(), trial.tally().all};
    for (const int nodes : kResolutions) {
        options.grid = nodes;
        const auto coarse = nodes <= kFinestShared
                                ? models.model(space, options)
                                : std::make_shared<const Upsampler>(space, options);
        const Deviation found = trial.of(*coarse, limit);
        choice.nodes = nodes;
        choice.deviation = found.rms();
        choice.largest = found.largestRms();
        if (choice.deviation <= limit) return choice;
    }
    throw FileError(source.info().path, "the finest grid deviates by more than " +
                                            std::to_string(limit) +
                                            "; solve every texel by itself instead (--per-texel)");
}

}  // namespace specbake::internal
