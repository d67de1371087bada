#pragma once

#include <specbake/sampler.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace specbake::testing {

/// The lookup as docs/table-format.md writes it for a shader: a buffer of 32-bit words, no
/// pointers, no samples of 16 bits. Floats and unsigned integers only, as GLSL and HLSL have them.
class ShaderTable {
  public:
    explicit ShaderTable(const std::vector<std::byte>& file) {
        SpectralTableHeader h;
        std::memcpy(&h, file.data(), sizeof h);
        n_ = h.nodes;
        stride_ = h.stride;
        low_ = h.low;
        scale_ = (h.high - h.low) / 65535.0F;
        first_ = h.firstWavelength;
        step_ = h.wavelengthStep;
        last_ = float(h.bands - 1);
        words_.resize((std::size_t(h.fileBytes - h.nodesOffset) + 3) / 4);
        std::memcpy(words_.data(), file.data() + h.nodesOffset,
                    std::size_t(h.fileBytes - h.nodesOffset));
    }

    float reflectance(const std::array<float, 3>& rgb, float nm) const {
        std::array<float, 3> f;
        std::array<std::uint32_t, 3> cell;
        for (std::size_t c = 0; c < 3; ++c) {
            const float x = std::clamp(rgb[c], 0.0F, 1.0F);
            const float cells = float(n_ - 1);
            cell[c] = std::min(std::uint32_t(std::sqrt(x) * cells), n_ - 2);
            const float below = float(cell[c]) / cells;
            const float above = float(cell[c] + 1) / cells;
            f[c] = std::clamp((x - below * below) / (above * above - below * below), 0.0F, 1.0F);
        }
        const std::array<std::uint32_t, 3> strides = {n_ * n_, n_, 1};
        std::array<std::size_t, 3> axis = {0, 1, 2};
        if (f[axis[0]] < f[axis[1]]) std::swap(axis[0], axis[1]);
        if (f[axis[1]] < f[axis[2]]) std::swap(axis[1], axis[2]);
        if (f[axis[0]] < f[axis[1]]) std::swap(axis[0], axis[1]);
        const float band = std::clamp((nm - first_) / step_, 0.0F, last_);
        std::uint32_t node = (cell[0] * n_ + cell[1]) * n_ + cell[2];
        float sum = (1 - f[axis[0]]) * sample(node, band);
        for (std::size_t k = 0; k < 3; ++k) {
            node += strides[axis[k]];
            const float next = k < 2 ? f[axis[k + 1]] : 0.0F;
            sum += (f[axis[k]] - next) * sample(node, band);
        }
        return std::clamp(low_ + scale_ * sum, 0.0F, 1.0F);
    }

  private:
    float sample(std::uint32_t node, float band) const {
        const auto below = std::uint32_t(band);
        const std::uint32_t at = node * stride_ + below;
        return std::lerp(half(at), half(at + 1), band - float(below));
    }
    float half(std::uint32_t i) const { return float((words_[i / 2] >> (16 * (i % 2))) & 0xFFFFU); }

    std::vector<std::uint32_t> words_;
    std::uint32_t n_, stride_;
    float low_, scale_, first_, step_, last_;
};

}  // namespace specbake::testing
