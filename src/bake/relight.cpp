#include "lit_bands.h"
#include "pipeline.h"
#include "reading.h"

#include <specbake/bake/relight.h>
#include <specbake/core/error.h>
#include <specbake/image/preview_writer.h>
#include <specbake/image/spectral_reader.h>

#include <algorithm>
#include <vector>

namespace specbake {

using namespace internal;

namespace {

std::vector<LitBands> allLitBands(const std::string& path, const SpectralReader& reader,
                                  const RelightOptions& options) {
    std::vector<LitBands> all = {litBands(path, reader, options)};
    for (const std::string& light : options.beside) {
        RelightOptions other = options;
        other.illuminant = light;
        all.push_back(litBands(path, reader, other));
    }
    return all;
}

/// Of `count` pictures side by side.
SpectralHeader widened(SpectralHeader header, std::size_t count) {
    if (count == 1) return header;
    const auto width = std::size_t(header.data.width) * count;
    if (width > std::size_t(kLargestSide)) {
        throw ArgumentError("the pictures side by side are wider than " +
                            std::to_string(kLargestSide) + " texels");
    }
    header.data = {0, 0, int(width), header.data.height};
    header.display = header.data;
    return header;
}

class Relighting {
  public:
    Relighting(const std::string& spectral, const std::filesystem::path& picture,
               const RelightOptions& options)
        : reader_(spectral),
          lights_(allLitBands(spectral, reader_, options)),
          writer_(picture, widened(reader_.header(), lights_.size()), options.sync) {}

    void run(const RelightOptions& options) {
        bands_.resize(std::size_t((height() + rowsTogether_ - 1) / rowsTogether_));
        const auto write = [&](int i) {
            writeBand(i);
            if (options.progress) options.progress(double(i + 1) / double(bands_.size()));
        };
        runPipeline(int(bands_.size()),
                    {[&](int i) { read(i); }, [&](int i) { light(bands_[std::size_t(i)]); }, write,
                     bandBytes()},
                    threadsFor(reader_, options.threads), options.stop);
        writer_.commit();
    }

  private:
    /// Some rows on their way.
    struct Band {
        std::vector<float> samples;  ///< of each texel its bands
        std::vector<float> alpha;
        std::vector<float> picture;  ///< R, G, B, A a texel; in each row the pictures in turn
    };

    std::size_t width() const { return std::size_t(reader_.header().data.width); }
    int height() const { return reader_.header().data.height; }

    std::size_t bandBytes() const {
        const std::size_t floats = reader_.wavelengths().size() + 1 + 4 * lights_.size();
        return std::size_t(rowsTogether_) * width() * floats * sizeof(float);
    }

    void read(int i) {
        Band& band = bands_[std::size_t(i)];
        const int rows = std::min(rowsTogether_, height() - i * rowsTogether_);
        band.alpha.resize(std::size_t(rows) * width(), 1.0F);
        band.samples.resize(band.alpha.size() * lights_.front().size());
        reader_.readRows(i * rowsTogether_, rows, band.samples, band.alpha);
    }

    void light(Band& band) const {
        band.picture.reserve(band.alpha.size() * 4 * lights_.size());
        for (std::size_t first = 0; first < band.alpha.size(); first += width()) {
            for (const LitBands& colors : lights_) lightRow(band, first, colors);
        }
        band.samples = {};
    }

    /// Of the row that begins with that texel.
    void lightRow(Band& band, std::size_t first, const LitBands& colors) const {
        for (std::size_t t = first; t < first + width(); ++t) {
            Imath::V3f sum(0.0F);
            for (std::size_t m = 0; m < colors.size(); ++m) {
                sum += colors[m] * band.samples[t * colors.size() + m];
            }
            band.picture.insert(band.picture.end(), {sum.x, sum.y, sum.z, band.alpha[t]});
        }
    }

    void writeBand(int i) {
        Band& band = bands_[std::size_t(i)];
        const std::span<const float> picture = band.picture;
        const std::size_t row = width() * 4 * lights_.size();
        for (std::size_t first = 0; first < picture.size(); first += row) {
            writer_.writeRow(picture.subspan(first, row));
        }
        band = {};
    }

    SpectralReader reader_;
    int rowsTogether_ = rowsTogether(reader_);
    std::vector<LitBands> lights_;
    PreviewWriter writer_;
    std::vector<Band> bands_;
};

}  // namespace

void relight(const std::string& spectral, const std::filesystem::path& picture,
             const RelightOptions& options) {
    Relighting(spectral, picture, options).run(options);
}

}  // namespace specbake
