#include "pipeline.h"

#include <specbake/bake/relight.h>
#include <specbake/core/adaptation.h>
#include <specbake/core/observer.h>
#include <specbake/image/preview_writer.h>
#include <specbake/image/spectral_reader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace specbake {

using namespace internal;

namespace {

/// What each band gives to linear Rec.709 R, G, B at reflectance 1: the weights w_m of (1) under
/// the light, adapted if asked for, scaled as relight.h says.
using BandColors = std::array<Imath::V3f, kBandCount>;

BandColors bandColors(const RelightOptions& options) {
    const Observer lit(options.illuminant);
    const XYZ daylight = Observer("D65").white();
    const Imath::M33d shown = xyzFromRGB(*findColorSpace("lin_rec709"), daylight).inverse();
    const Imath::M33d rgbFromXYZ =
        options.adapt ? adaptation(lit.white(), daylight) * shown : shown;
    const Imath::V3d white = lit.white() * rgbFromXYZ;
    const double gain = std::exp2(options.exposure) / std::max({white.x, white.y, white.z});
    BandColors colors;
    for (std::size_t m = 0; m < colors.size(); ++m) {
        colors[m] = Imath::V3f(lit.weights()[m] * rgbFromXYZ * gain);
    }
    return colors;
}

class Relighting {
  public:
    Relighting(const std::string& spectral, const std::filesystem::path& picture,
               const RelightOptions& options)
        : colors_(bandColors(options)), reader_(spectral), writer_(picture, reader_.header()) {}

    void run(const RelightOptions& options) {
        bands_.resize(std::size_t((height() + kRows - 1) / kRows));
        const auto write = [&](int i) {
            writeBand(i);
            if (options.progress) options.progress(double(i + 1) / double(bands_.size()));
        };
        runPipeline(int(bands_.size()),
                    {[&](int i) { read(i); }, [&](int i) { light(bands_[std::size_t(i)]); }, write},
                    options.threads, options.stop);
        writer_.commit();
    }

  private:
    static constexpr int kRows = 16;

    /// Some rows on their way.
    struct Band {
        std::vector<float> samples;  ///< kBandCount a texel
        std::vector<float> alpha;
        std::vector<float> picture;  ///< R, G, B, A a texel
    };

    std::size_t width() const { return std::size_t(reader_.header().data.width); }
    int height() const { return reader_.header().data.height; }

    void read(int i) {
        Band& band = bands_[std::size_t(i)];
        const int rows = std::min(kRows, height() - i * kRows);
        band.alpha.resize(std::size_t(rows) * width(), 1.0F);
        band.samples.resize(band.alpha.size() * kBandCount);
        reader_.readRows(i * kRows, rows, band.samples, band.alpha);
    }

    void light(Band& band) const {
        band.picture.reserve(band.alpha.size() * 4);
        for (std::size_t t = 0; t < band.alpha.size(); ++t) {
            Imath::V3f sum(0.0F);
            for (std::size_t m = 0; m < colors_.size(); ++m) {
                sum += colors_[m] * band.samples[t * kBandCount + m];
            }
            band.picture.insert(band.picture.end(), {sum.x, sum.y, sum.z, band.alpha[t]});
        }
        band.samples = {};
    }

    void writeBand(int i) {
        Band& band = bands_[std::size_t(i)];
        const std::span<const float> picture = band.picture;
        for (std::size_t first = 0; first < picture.size(); first += width() * 4) {
            writer_.writeRow(picture.subspan(first, width() * 4));
        }
        band = {};
    }

    BandColors colors_;
    SpectralReader reader_;
    PreviewWriter writer_;
    std::vector<Band> bands_;
};

}  // namespace

void relight(const std::string& spectral, const std::filesystem::path& picture,
             const RelightOptions& options) {
    Relighting(spectral, picture, options).run(options);
}

}  // namespace specbake
