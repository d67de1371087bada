#include "pipeline.h"
#include "reading.h"
#include "verify/largest_values.h"
#include "verify/observed.h"
#include "verify/stated_model.h"
#include "verify/texel_comparison.h"

#include <specbake/bake/verify.h>
#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/core/upsampler.h>
#include <specbake/image/spectral_reader.h>
#include <specbake/image/texel_decoder.h>
#include <specbake/image/texture_reader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace specbake {

using namespace internal;

namespace {

/// Rows of both files on their way through the pipeline, and what was found in them.
struct Rows {
    std::vector<std::byte> texture;
    std::vector<float> bands;
    std::vector<float> alpha;    ///< of the spectral file, 1 where it has none
    std::vector<float> preview;  ///< R, G, B; empty if the file has none
    std::vector<TexelDifference> texels;
    std::vector<SampleDifference> previews, alphas;
};

class Comparison {
  public:
    Comparison(const std::string& spectral, const std::string& texture,
               const VerifyOptions& options, const RowsObserver& observer)
        : observer_(observer),
          spectral_(spectral),
          texture_(texture, options.read.orAsIn(spectral_)),
          meaning_(statedMeaning(spectral_, texture_.info(), options)),
          model_(meaning_.space, statedModel(spectral, spectral_, options)),
          decoder_(texture_.info(), meaning_),
          texel_(model_, weightsOf(spectral), statedRounding(spectral_)),
          alphaRounding_(roundingOf(spectral_.storedType(), 10)),
          largest_(descendingRankOfP99(width() * std::size_t(height()))) {
        const Window& window = spectral_.header().data;
        if (std::size_t(window.width) != width() || window.height != height()) {
            throw FileError(spectral, "not of the size of " + texture);
        }
        total_.illuminant = lightLabel(model_.observer().illuminant());
        total_.observer = observerLabel(model_.observer().functions());
        total_.quadrature = model_.observer().quadrature();
    }

    Verification run(int threads) {
        const int count = (height() + rowsTogether_ - 1) / rowsTogether_;
        rows_.resize(std::size_t(count));
        runPipeline(count,
                    {[&](int i) { read(i); }, [&](int i) { compare(i); }, [&](int i) { gather(i); },
                     2 * std::size_t(rowsTogether_) * width() * bandCount() * sizeof(float)},
                    threadsFor(spectral_, threads), {});
        if (const std::size_t compared = total_.texels - total_.notFinite) {
            total_.meanDE2000 /= double(compared);
            total_.p99DE2000 = largest_.ranked(descendingRankOfP99(compared));
        }
        return total_;
    }

  private:
    TexelComparison::BandWeights weightsOf(const std::string& path) const {
        const Observer& observer = model_.observer();
        return {readerWeights(path, spectral_, observer.illuminant(), observer.quadrature(),
                              observer.functions()),
                readerWeights(path, spectral_, "D65", observer.quadrature())};
    }

    std::size_t bandCount() const { return spectral_.wavelengths().size(); }
    std::size_t width() const { return std::size_t(texture_.info().data.width); }
    int height() const { return texture_.info().data.height; }
    int rowCount(int i) const { return std::min(rowsTogether_, height() - i * rowsTogether_); }

    void read(int i) {
        Rows& rows = rows_[std::size_t(i)];
        const std::size_t texels = std::size_t(rowCount(i)) * width();
        rows.bands.resize(texels * bandCount());
        rows.alpha.resize(texels, 1.0F);
        rows.preview.resize(spectral_.hasPreview() ? texels * kPreviewSamples : 0);
        spectral_.readRows(i * rowsTogether_, rowCount(i), rows.bands, rows.alpha, rows.preview);
        rows.texture.resize(std::size_t(rowCount(i)) * texture_.info().bytesPerRow());
        texture_.readRows(i * rowsTogether_, rowCount(i), rows.texture);
    }

    void compare(int i) {
        Rows& rows = rows_[std::size_t(i)];
        const std::size_t texels = rows.alpha.size();
        std::vector<std::array<float, 3>> colors(texels);
        std::vector<float> alpha(texels, 1.0F);
        decoder_.decode(rows.texture, texels, colors.data(), alpha.data());
        for (std::size_t t = 0; t < texels; ++t) {
            const std::span<const float> bands(&rows.bands[t * bandCount()], bandCount());
            rows.texels.push_back(texel_.compare(colors[t], bands));
            rows.alphas.push_back(compareAlpha(alpha[t], rows.alpha[t]));
            if (rows.preview.empty()) continue;
            const std::span<const float, 3> preview(&rows.preview[t * kPreviewSamples], 3);
            rows.previews.push_back(texel_.comparePreview(preview, bands));
        }
        if (!observer_) rows.bands = {};
        rows.texture = {};
    }

    SampleDifference compareAlpha(float asked, float stored) const {
        const double off = std::abs(double(stored) - double(asked));
        return {off, !(off <= alphaRounding_.of(double(stored)))};
    }

    /// In order, so that the mean does not depend on the threads.
    void gather(int i) {
        const Rows& rows = rows_[std::size_t(i)];
        if (observer_) observer_({i * rowsTogether_, rowCount(i), rows.bands, rows.texels}, model_);
        for (std::size_t t = 0; t < rows.texels.size(); ++t) {
            const TexelDifference& found = rows.texels[t];
            ++total_.texels;
            total_.outOfRange += found.outOfRange;
            total_.notFinite += found.finite ? 0 : 1;
            if (found.finite)
                gatherTexel(found, std::size_t(i) * std::size_t(rowsTogether_) * width() + t);
        }
        for (const SampleDifference& found : rows.previews) {
            total_.previewBeyondRounding += found.beyondRounding ? 1 : 0;
            total_.maxPreviewDifference = std::max(total_.maxPreviewDifference, found.size);
        }
        for (const SampleDifference& found : rows.alphas) {
            total_.alphaBeyondRounding += found.beyondRounding ? 1 : 0;
            total_.maxAlphaDifference = std::max(total_.maxAlphaDifference, found.size);
        }
        rows_[std::size_t(i)] = {};
    }

    void gatherTexel(const TexelDifference& found, std::size_t texel) {
        total_.meanDE2000 += found.de2000;
        largest_.add(found.de2000);
        total_.outsideSolid += found.outside ? 1 : 0;
        total_.beyondRounding += found.beyondRounding ? 1 : 0;
        total_.maxXYZDifference = std::max(total_.maxXYZDifference, found.xyz);
        if (found.de2000 <= total_.maxDE2000) return;
        total_.maxDE2000 = found.de2000;
        total_.worstX = texel % width();
        total_.worstY = texel / width();
    }

    const RowsObserver& observer_;
    SpectralReader spectral_;
    int rowsTogether_ = rowsTogether(spectral_);
    TextureReader texture_;
    ColorMeaning meaning_;
    Upsampler model_;
    TexelDecoder decoder_;
    TexelComparison texel_;
    SampleRounding alphaRounding_;
    LargestValues largest_;
    std::vector<Rows> rows_;
    Verification total_;
};

}  // namespace

bool Verification::passes(std::optional<double> maxDE) const {
    const bool sound =
        notFinite == 0 && outOfRange == 0 && previewBeyondRounding == 0 && alphaBeyondRounding == 0;
    if (maxDE) return sound && maxDE2000 <= *maxDE;
    return sound && beyondRounding == 0 && maxDE2000 <= kUsualLimit;
}

Verification internal::verifyObserved(const std::string& spectral, const std::string& texture,
                                      const VerifyOptions& options, const RowsObserver& observer) {
    return Comparison(spectral, texture, options, observer).run(options.threads);
}

Verification verify(const std::string& spectral, const std::string& texture,
                    const VerifyOptions& options) {
    return verifyObserved(spectral, texture, options, {});
}

}  // namespace specbake
