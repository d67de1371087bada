#include "methods/published/jakob2019_table.h"

#include "methods/clones.h"

#include <algorithm>
#include <cmath>

namespace specbake::bench {
namespace {

double smoothstep(double x) {
    return x * x * (3 - 2 * x);
}

/// The node below a position of a uniform axis, and the fraction of the way to the next.
struct Place {
    int node;
    float fraction;
};

Place placeOnUniformAxis(float position, int resolution) {
    const float scaled = position * float(resolution - 1);
    const int node = std::min(int(scaled), resolution - 2);
    return {node, scaled - float(node)};
}

Place placeAmong(const std::vector<float>& nodes, float position) {
    const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, position);
    const float low = *(above - 1);
    return {int(above - nodes.begin()) - 1, (position - low) / (*above - low)};
}

int largestComponent(const Imath::V3f& c) {
    if (c.x > c.y) return c.x > c.z ? 0 : 2;
    return c.y > c.z ? 1 : 2;
}

SPECBENCH_CLONES
void evaluate(const Imath::V3f& c, float* out) {
    constexpr float step = 1.0F / (kBandCount - 1);
    for (int m = 0; m < kBandCount; ++m) {
        const float u = float(m) * step;
        const float x = (c.x * u + c.y) * u + c.z;
        out[m] = 0.5F + 0.5F * x / std::sqrt(1 + x * x);
    }
}

}  // namespace

Jakob2019Table::Jakob2019Table(Frame frame, int resolution)
    : Method({"Jakob & Hanika 2019", "table " + std::to_string(resolution)}, std::move(frame)),
      resolution_(resolution) {}

std::size_t Jakob2019Table::index(int largest, int i, int j, int k) const {
    const auto n = std::size_t(resolution_);
    return ((std::size_t(largest) * n + std::size_t(k)) * n + std::size_t(j)) * n + std::size_t(i);
}

RGB Jakob2019Table::nodeColor(int largest, int i, int j, int k) const {
    const double b = double(scale_[std::size_t(k)]);
    RGB color;
    color[largest] = b;
    color[(largest + 1) % 3] = b * i / (resolution_ - 1);
    color[(largest + 2) % 3] = b * j / (resolution_ - 1);
    return color;
}

void Jakob2019Table::fitLine(int largest, int i, int j) {
    const auto fitNode = [&](int k, const SigmoidCoefficients& start) {
        const XYZ color = frame().xyz(nodeColor(largest, i, j, k));
        const SigmoidCoefficients c = fitSigmoid(color, frame().observer, start).coefficients;
        nodes_[index(largest, i, j, k)] = Coefficients(float(c[0]), float(c[1]), float(c[2]));
        return c;
    };
    const int first = resolution_ / 5;  // where the authors start: a colour easy to reach from ½
    const SigmoidCoefficients middle = fitNode(first, {});
    SigmoidCoefficients c = middle;
    for (int k = first + 1; k < resolution_; ++k) c = fitNode(k, c);
    c = middle;
    for (int k = first - 1; k >= 0; --k) c = fitNode(k, c);
}

void Jakob2019Table::setUp() {
    scale_.clear();
    for (int k = 0; k < resolution_; ++k) {
        scale_.push_back(float(smoothstep(smoothstep(double(k) / (resolution_ - 1)))));
    }
    nodes_.assign(index(3, 0, 0, 0), {});
    for (int largest = 0; largest < 3; ++largest) {
        for (int j = 0; j < resolution_; ++j) {
            for (int i = 0; i < resolution_; ++i) fitLine(largest, i, j);
        }
    }
}

Jakob2019Table::Coefficients Jakob2019Table::lookUp(const Imath::V3f& rgb) const {
    const Imath::V3f c(std::clamp(rgb.x, 0.0F, 1.0F), std::clamp(rgb.y, 0.0F, 1.0F),
                       std::clamp(rgb.z, 0.0F, 1.0F));
    if (c.x == c.y && c.y == c.z) return {0, 0, float(sigmoidInverse(double(c.x)))};
    const int largest = largestComponent(c);
    const float b = c[largest];
    const float inverse = b > 0 ? 1 / b : 0;
    const Place x = placeOnUniformAxis(c[(largest + 1) % 3] * inverse, resolution_);
    const Place y = placeOnUniformAxis(c[(largest + 2) % 3] * inverse, resolution_);
    const Place z = placeAmong(scale_, b);
    const auto along = [&](int j, int k) {
        const Coefficients* at = &nodes_[index(largest, x.node, y.node + j, z.node + k)];
        return at[0] * (1 - x.fraction) + at[1] * x.fraction;
    };
    const auto plane = [&](int k) {
        return along(0, k) * (1 - y.fraction) + along(1, k) * y.fraction;
    };
    return plane(0) * (1 - z.fraction) + plane(1) * z.fraction;
}

Reconstruction Jakob2019Table::reconstruct(const XYZ& color) const {
    const RGB rgb = frame().rgb(color);
    const Coefficients c = lookUp(Imath::V3f(float(rgb.x), float(rgb.y), float(rgb.z)));
    return {sigmoidSpectrum({double(c.x), double(c.y), double(c.z)}), true};
}

void Jakob2019Table::reconstructTexels(std::span<const Imath::V3f> rgb,
                                       std::span<float> spectra) const {
    float* out = spectra.data();
    for (const Imath::V3f& texel : rgb) {
        evaluate(lookUp(texel), out);
        out += kBandCount;
    }
}

}  // namespace specbake::bench
