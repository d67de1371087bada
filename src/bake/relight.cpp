#include "lit_bands.h"
#include "pipeline.h"

#include <specbake/bake/relight.h>
#include <specbake/image/preview_writer.h>
#include <specbake/image/spectral_reader.h>

#include <algorithm>
#include <vector>

namespace specbake {

using namespace internal;

namespace {

class Relighting {
  public:
    Relighting(const std::string& spectral, const std::filesystem::path& picture,
               const RelightOptions& options)
        : colors_(litBands(options)), reader_(spectral), writer_(picture, reader_.header()) {}

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

    LitBands colors_;
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
