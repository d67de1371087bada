#include "reading.h"

#include <specbake/bake/inspect.h>
#include <specbake/core/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace specbake {
namespace {

void count(BandStatistics& statistics, std::size_t band, double value) {
    if (!(value >= 0 && value <= 1)) ++statistics.outOfRange;
    if (std::isnan(value)) return;
    statistics.least[band] = std::min(statistics.least[band], value);
    statistics.largest[band] = std::max(statistics.largest[band], value);
    statistics.mean[band] += value;
}

}  // namespace

BandStatistics bandStatistics(const std::string& spectral) {
    SpectralReader reader(spectral);
    const Window& window = reader.header().data;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    BandStatistics statistics;
    const std::size_t bands = reader.wavelengths().size();
    statistics.least.assign(bands, infinity);
    statistics.mean.assign(bands, 0);
    statistics.largest.assign(bands, -infinity);
    statistics.texels = std::size_t(window.width) * std::size_t(window.height);
    const int together = internal::rowsTogether(reader);
    std::vector<float> samples;
    for (int row = 0; row < window.height; row += together) {
        const int rows = std::min(together, window.height - row);
        samples.resize(std::size_t(rows) * std::size_t(window.width) * bands);
        reader.readRows(row, rows, samples);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            count(statistics, i % bands, double(samples[i]));
        }
    }
    for (double& mean : statistics.mean) mean /= double(statistics.texels);
    return statistics;
}

std::vector<double> spectrumAt(SpectralReader& reader, int x, int y) {
    const Window& window = reader.header().data;
    const int column = x - window.x;
    const int row = y - window.y;
    if (column < 0 || column >= window.width || row < 0 || row >= window.height) {
        throw ArgumentError("(" + std::to_string(x) + ", " + std::to_string(y) +
                            ") is outside the data window");
    }
    const auto bands = std::ptrdiff_t(reader.wavelengths().size());
    std::vector<float> samples(std::size_t(window.width) * std::size_t(bands));
    reader.readRows(row, 1, samples);
    const auto first = samples.begin() + column * bands;
    return {first, first + bands};
}

}  // namespace specbake
