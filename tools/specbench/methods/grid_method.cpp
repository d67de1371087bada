#include "grid_method.h"

#include "upsample/node_values.h"

#include <algorithm>

namespace specbake::bench {
namespace {

MethodName named(MethodName solver, int nodes) {
    const std::string grid = "grid " + std::to_string(nodes);
    solver.parameters = solver.parameters.empty() ? grid : solver.parameters + ", " + grid;
    return solver;
}

}  // namespace

GridMethod::GridMethod(MethodName solver, Frame frame, std::shared_ptr<const Solver> direct,
                       int nodes)
    : Method(named(std::move(solver), nodes), std::move(frame)),
      solver_(std::move(direct)),
      nodes_(nodes) {}

void GridMethod::setUp() {
    UpsamplerOptions options;
    options.grid = nodes_;
    upsampler_.emplace(frame().space, options, solver_);
    upsampler_->solveNodes();
}

std::size_t GridMethod::bytes() const {
    return upsampler_->nodesSolved() * sizeof(internal::NodeValues);
}

Reconstruction GridMethod::reconstruct(const XYZ& color) const {
    const RGB rgb = frame().rgb(color);
    const Imath::V3f texel(float(rgb.x), float(rgb.y), float(rgb.z));
    std::array<float, kBandCount> spectrum;
    reconstructTexels({&texel, 1}, spectrum);
    Reconstruction r;
    std::ranges::copy(spectrum, r.spectrum.begin());
    return r;
}

void GridMethod::reconstructTexels(std::span<const Imath::V3f> rgb,
                                   std::span<float> spectra) const {
    constexpr std::size_t run = 256;  // texels at a time
    std::array<Upsampler::Color, run> colors;
    Upsampler::Workspace workspace;
    for (std::size_t first = 0; first < rgb.size(); first += run) {
        const auto some = rgb.subspan(first, std::min(run, rgb.size() - first));
        std::ranges::transform(some, colors.begin(), [](const Imath::V3f& c) {
            return Upsampler::Color{c.x, c.y, c.z};
        });
        const auto target = SampleTarget::interleaved(
            SampleType::float32, reinterpret_cast<std::byte*>(&spectra[first * kBandCount]),
            bands_);
        // A colour without a spectrum fails by its round trip.
        static_cast<void>(
            upsampler_->sample(std::span(colors).first(some.size()), bands_, target, workspace));
    }
}

}  // namespace specbake::bench
