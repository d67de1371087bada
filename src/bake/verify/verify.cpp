#include "pipeline.h"
#include "verify/histogram.h"
#include "verify/stated_model.h"

#include <specbake/bake/verify.h>
#include <specbake/core/ciede2000.h>
#include <specbake/core/error.h>
#include <specbake/core/upsampler.h>
#include <specbake/core/vector.h>
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
    std::vector<float> samples;
    std::vector<std::byte> texture;
    double sumDE2000 = 0;
    std::size_t worstTexel = 0;
    Verification found;
};

class Comparison {
  public:
    Comparison(const std::string& spectral, const std::string& texture,
               const VerifyOptions& options)
        : spectral_(spectral),
          texture_(texture),
          upsampler_(statedSpace(spectral_, texture_.info(), options),
                     statedModel(spectral_, options)),
          decoder_(texture_.info(), upsampler_.space()) {
        if (spectral_.header().data.width != width() ||
            spectral_.header().data.height != height()) {
            throw FileError(spectral, "not of the size of " + texture);
        }
    }

    Verification run(int threads) {
        const int count = (height() + kRows - 1) / kRows;
        rows_.resize(std::size_t(count));
        runPipeline(
            count, {[&](int i) { read(i); }, [&](int i) { compare(i); }, [&](int i) { gather(i); }},
            threads, {});
        if (total_.texels > 0) total_.meanDE2000 /= double(total_.texels);
        total_.p99DE2000 = histogram_.percentile(0.99, total_.texels);
        return total_;
    }

  private:
    static constexpr int kRows = 16;

    int width() const { return texture_.info().data.width; }
    int height() const { return texture_.info().data.height; }
    int rowCount(int i) const { return std::min(kRows, height() - i * kRows); }

    void read(int i) {
        Rows& rows = rows_[std::size_t(i)];
        rows.samples.resize(std::size_t(rowCount(i)) * std::size_t(width()) * kBandCount);
        spectral_.readRows(i * kRows, rowCount(i), rows.samples);
        rows.texture.resize(std::size_t(rowCount(i)) * texture_.info().bytesPerRow());
        texture_.readRows(i * kRows, rowCount(i), rows.texture);
    }

    void compare(int i) {
        Rows& rows = rows_[std::size_t(i)];
        const std::size_t texels = std::size_t(rowCount(i)) * std::size_t(width());
        std::vector<std::array<float, 3>> colors(texels);
        std::vector<float> alpha(texels);
        decoder_.decode(rows.texture, texels, colors.data(), alpha.data());
        for (std::size_t t = 0; t < texels; ++t) {
            const RGB rgb{double(colors[t][0]), double(colors[t][1]), double(colors[t][2])};
            compareTexel(rows, t, upsampler_.xyz(rgb));
        }
        rows.samples = {};
        rows.texture = {};
    }

    /// Beside the colour that the file had to give: that of the texel, or what the file's rule
    /// for colours outside the solid makes of it.
    void compareTexel(Rows& rows, std::size_t t, const XYZ& texel) {
        const Attainable target = upsampler_.attainable(texel);
        const XYZ& asked = target.color;
        if (target.outside) ++rows.found.outsideSolid;
        Spectrum s;
        for (std::size_t m = 0; m < s.size(); ++m) {
            const float sample = rows.samples[t * kBandCount + m];
            if (!(sample >= 0 && sample <= 1)) ++rows.found.outOfRange;
            s[m] = double(sample);
        }
        const Observer& observer = upsampler_.observer();
        const XYZ given = observer.color(s);
        const double difference =
            ciede2000(labFromXYZ(asked, observer.white()), labFromXYZ(given, observer.white()));
        ++rows.found.texels;
        rows.sumDE2000 += difference;
        histogram_.add(difference);
        if (difference > rows.found.maxDE2000) {
            rows.found.maxDE2000 = difference;
            rows.worstTexel = t;
        }
        rows.found.maxXYZDifference =
            std::max(rows.found.maxXYZDifference, largestComponent(asked - given));
    }

    /// In order, so that the mean does not depend on the threads.
    void gather(int i) {
        const Rows& rows = rows_[std::size_t(i)];
        total_.texels += rows.found.texels;
        total_.meanDE2000 += rows.sumDE2000;
        total_.outOfRange += rows.found.outOfRange;
        total_.outsideSolid += rows.found.outsideSolid;
        total_.maxXYZDifference = std::max(total_.maxXYZDifference, rows.found.maxXYZDifference);
        if (rows.found.maxDE2000 > total_.maxDE2000) {
            total_.maxDE2000 = rows.found.maxDE2000;
            const auto w = std::size_t(width());
            total_.worstX = rows.worstTexel % w;
            total_.worstY = rows.worstTexel / w + std::size_t(i) * kRows;
        }
        rows_[std::size_t(i)] = {};
    }

    SpectralReader spectral_;
    TextureReader texture_;
    Upsampler upsampler_;
    TexelDecoder decoder_;
    std::vector<Rows> rows_;
    Histogram histogram_;
    Verification total_;
};

}  // namespace

Verification verify(const std::string& spectral, const std::string& texture,
                    const VerifyOptions& options) {
    return Comparison(spectral, texture, options).run(options.threads);
}

}  // namespace specbake
