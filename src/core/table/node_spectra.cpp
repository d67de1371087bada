#include "table/node_spectra.h"

#include <specbake/core/vector.h>

#include <algorithm>

namespace specbake::internal {

bool NodeSpectra::areAttainable() const {
    return std::find(attainable.begin(), attainable.end(), 0) == attainable.end();
}

NodeSpectra nodeSpectra(const Grid& grid, const Upsampler& upsampler) {
    NodeSpectra nodes;
    nodes.spectrum.resize(grid.nodeCount());
    nodes.attainable.resize(grid.nodeCount());
    for (std::uint32_t node = 0; node < grid.nodeCount(); ++node) {
        const Upsampler::Color point = grid.position(node);
        const XYZ color = upsampler.xyz(point);
        Spectrum& spectrum = nodes.spectrum[node];
        nodes.attainable[node] = upsampler.solid().contains(color) ? 1 : 0;
        if (nodes.attainable[node] == 1) {
            const auto bands = upsampler.sample({&point, 1}, SampleSelection::bands());
            std::copy(bands.begin(), bands.end(), spectrum.begin());
        } else {
            spectrum = upsampler.solid().nearest(color).spectrum.value();
        }
    }
    return nodes;
}

ColorCorrection::ColorCorrection(const Observer& observer) : observer_(observer) {
    Imath::M33d gram(0.0);
    for (const Imath::V3d& w : observer.weights()) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) gram[i][j] += w[i] * w[j];
        }
    }
    inverseGram_ = gram.inverse();
}

void ColorCorrection::apply(Spectrum& spectrum, const XYZ& color) const {
    const Imath::V3d along = (color - observer_.color(spectrum)) * inverseGram_;
    for (std::size_t m = 0; m < spectrum.size(); ++m) {
        spectrum[m] += observer_.weights()[m].dot(along);
    }
}

}  // namespace specbake::internal
