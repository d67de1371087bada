// specbake/sampler.h: reflectance spectra from RGB, in a renderer. One header, C++17, no
// dependency.
//
//     std::vector<unsigned char> bytes = ...;             // of a .spectab file, or a mapped file
//     specbake::SpectralTable table;
//     if (table.view(bytes.data(), bytes.size()) != specbake::SpectralTable::Status::ok) ...
//     const auto place = table.locate(r, g, b);           // linear RGB of the table's space
//     const auto four = table.wavelengths<4>({450, 520, 580, 650});  // nm, once a light path
//     float reflectance[4];
//     table.eval(place, four, reflectance);
//
// After view() nothing allocates, nothing throws, and any number of threads may share a table.
// Reflectances are linear between the table's bands; below the first band and beyond the last they
// are those bands'. docs/table-format.md describes the file, and the same arithmetic for a shader.
//
// Copyright (c) 2026, specbake contributors. SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(__SSE2__) || defined(_M_X64)
#define SPECBAKE_SAMPLER_SSE2 1
#include <emmintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#define SPECBAKE_SAMPLER_NEON 1
#include <arm_neon.h>
#endif

namespace specbake {

/// The first bytes of a .spectab file, little-endian (docs/table-format.md).
struct SpectralTableHeader {
    unsigned char magic[8];  ///< kMagic
    std::uint32_t version;   ///< kVersion
    std::uint32_t headerBytes;
    std::uint64_t fileBytes;
    std::uint32_t crc32;    ///< of all bytes from `nodes` on (ISO 3309, as in PNG and zip)
    std::uint32_t axisLaw;  ///< 1: node i of n stands at (i / (n - 1))²
    std::uint32_t nodes;    ///< along each axis
    std::uint32_t bands;
    std::uint32_t stride;    ///< samples a node: the bands, and the last of them once more
    std::uint32_t reserved;  ///< 0
    float firstWavelength;   ///< nm
    float wavelengthStep;    ///< nm
    float low;               ///< reflectance of sample 0
    float high;              ///< and of sample 65535
    double
        xyzFromRGB[9];  ///< row i is the tristimulus of primary i: XYZ = R·row0 + G·row1 + B·row2
    double white[3];    ///< of the perfect reflector, the sum over the bands; Y = 1
    float meanError;    ///< CIEDE2000 under the table's light, over the colours of the space
    float p99Error;     ///< that a reflectance can have
    float maxError;
    float reachable;           ///< the share of the cube that they are
    std::uint64_t textOffset;  ///< UTF-8, a line a fact: "name=value\n"
    std::uint64_t textBytes;
    std::uint64_t
        nodesOffset;  ///< nodes³ × stride samples of 16 bits; blue runs fastest, then green
    unsigned char padding[56];  ///< 0

    static constexpr unsigned char kMagic[8] = {0x89, 'S', 'P', 'E', 'C', 'T', 'A', 'B'};
    static constexpr std::uint32_t kVersion = 1;
    static constexpr std::size_t kChecked = 32;  ///< crc32 covers what stands from here on
};
static_assert(sizeof(SpectralTableHeader) == 256, "the header is written as it stands");
static_assert(offsetof(SpectralTableHeader, nodes) == SpectralTableHeader::kChecked, "");

/// A view of a table of spectra over the unit cube of a linear RGB space.
class SpectralTable {
  public:
    enum class Status { ok, truncated, notATable, otherVersion, badSizes, bigEndianHost };
    static constexpr int kMostNodes = 129;
    static constexpr int kMostBands = 1024;

    /// Makes this a view of `size` bytes, which must stay where they are. They are not trusted:
    /// whatever they hold, no call reads beyond them. The checksum is looked at by intact() only.
    [[nodiscard]] Status view(const void* bytes, std::size_t size) noexcept;

    /// Whether the checksum agrees. Reads all bytes, a millisecond a megabyte.
    bool intact() const noexcept;
    /// The checksum of ISO 3309, as zip and PNG have it.
    static std::uint32_t crc32(const unsigned char* bytes, std::size_t size) noexcept;

    const SpectralTableHeader& header() const noexcept { return header_; }
    /// Lines of "name=value", `header().textBytes` characters.
    const char* text() const noexcept {
        return reinterpret_cast<const char*>(bytes_) + header_.textOffset;
    }

    /// Four nodes of the grid, and the barycentric weights of a colour between them.
    struct Place {
        const unsigned char* node[4];
        float weight[4];
    };
    /// Where a colour stands. Components beyond [0, 1] count as 0 or 1, NaN as 0.
    Place locate(float r, float g, float b) const noexcept;

    /// Where wavelengths stand between the bands.
    template <std::size_t N>
    struct Wavelengths {
        std::uint32_t offset[N];  ///< bytes from the node's first sample to the band below
        float fraction[N];        ///< of the band above
    };
    /// Of N wavelengths in nm; NaN counts as the first band's.
    template <std::size_t N>
    Wavelengths<N> wavelengths(const std::array<float, N>& nm) const noexcept;

    /// The reflectances at N wavelengths, in [0, 1]. Paths of different instruction sets differ by
    /// at most 1e-6: up to 16 roundings of numbers that are at most (high - low).
    template <std::size_t N>
    void eval(const Place& place, const Wavelengths<N>& at, float* reflectance) const noexcept;

    /// At one wavelength, nm.
    float eval(const Place& place, float nm) const noexcept {
        float reflectance = 0;
        eval(place, wavelengths<1>({nm}), &reflectance);
        return reflectance;
    }

    /// In all header().bands bands.
    void evalBands(const Place& place, float* reflectance) const noexcept;

  private:
    template <std::size_t N>
    void evalScalar(const Place& place, const Wavelengths<N>& at, std::size_t first,
                    float* to) const noexcept;
    float reflectanceFrom(float sample) const noexcept {
        const float value = header_.low + scale_ * sample;
        return value < 0 ? 0.0F : value > 1 ? 1.0F : value;
    }
    static float sampleAt(const unsigned char* at) noexcept {
        std::uint16_t sample;
        std::memcpy(&sample, at, sizeof sample);
        return float(sample);
    }

    SpectralTableHeader header_{};
    const unsigned char* bytes_ = nullptr;
    const unsigned char* nodes_ = nullptr;
    float scale_ = 0;
    std::uint32_t step_[3] = {};  ///< bytes from a node to the next along red, green, blue
    float position_[kMostNodes] = {};
    float inverseWidth_[kMostNodes] = {};
};

inline SpectralTable::Status SpectralTable::view(const void* bytes, std::size_t size) noexcept {
    *this = {};
    const std::uint16_t one = 1;
    unsigned char first = 0;
    std::memcpy(&first, &one, 1);
    if (first != 1) return Status::bigEndianHost;
    SpectralTableHeader h;
    if (bytes == nullptr || size < sizeof h.magic) return Status::truncated;
    if (std::memcmp(bytes, SpectralTableHeader::kMagic, sizeof h.magic) != 0) {
        return Status::notATable;
    }
    if (size < sizeof h) return Status::truncated;
    std::memcpy(&h, bytes, sizeof h);
    if (h.version != SpectralTableHeader::kVersion || h.axisLaw != 1) return Status::otherVersion;
    if (h.headerBytes != sizeof h || h.nodes < 2 || h.nodes > kMostNodes || h.bands < 2 ||
        h.bands > kMostBands || h.stride != h.bands + 1 || !(h.wavelengthStep > 0) ||
        !std::isfinite(h.wavelengthStep) || !std::isfinite(h.firstWavelength) ||
        !(h.low < h.high) || !(h.low >= -1) || !(h.high <= 2)) {
        return Status::badSizes;
    }
    const std::uint64_t nodeBytes = std::uint64_t(h.nodes) * h.nodes * h.nodes * h.stride * 2;
    if (h.fileBytes > size) return Status::truncated;
    if (h.nodesOffset > h.fileBytes || nodeBytes > h.fileBytes - h.nodesOffset ||
        h.textOffset > h.fileBytes || h.textBytes > h.fileBytes - h.textOffset) {
        return Status::badSizes;
    }
    header_ = h;
    bytes_ = static_cast<const unsigned char*>(bytes);
    nodes_ = bytes_ + h.nodesOffset;
    scale_ = (h.high - h.low) / 65535.0F;
    step_[2] = h.stride * 2;
    step_[1] = step_[2] * h.nodes;
    step_[0] = step_[1] * h.nodes;
    for (std::uint32_t i = 0; i < h.nodes; ++i) {
        const double u = double(i) / double(h.nodes - 1);
        position_[i] = float(u * u);
    }
    for (std::uint32_t i = 0; i + 1 < h.nodes; ++i) {
        inverseWidth_[i] = float(1 / (double(position_[i + 1]) - double(position_[i])));
    }
    return Status::ok;
}

inline bool SpectralTable::intact() const noexcept {
    constexpr std::size_t from = SpectralTableHeader::kChecked;
    return bytes_ != nullptr &&
           crc32(bytes_ + from, std::size_t(header_.fileBytes) - from) == header_.crc32;
}

inline std::uint32_t SpectralTable::crc32(const unsigned char* bytes, std::size_t size) noexcept {
    std::uint32_t remainders[256];
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t r = i;
        for (int bit = 0; bit < 8; ++bit) r = (r >> 1) ^ (0xEDB88320U & (0U - (r & 1U)));
        remainders[i] = r;
    }
    std::uint32_t crc = 0xFFFFFFFFU;
    for (std::size_t i = 0; i < size; ++i) crc = (crc >> 8) ^ remainders[(crc ^ bytes[i]) & 0xFFU];
    return crc ^ 0xFFFFFFFFU;
}

/// The cell by the root of each component; in it, the tetrahedron whose edges go along the axes in
/// the order of the fractions, largest first (H. W. Kuhn 1960).
inline SpectralTable::Place SpectralTable::locate(float r, float g, float b) const noexcept {
    const float color[3] = {r, g, b};
    const auto lastCell = int(header_.nodes) - 2;
    float f[3];
    const unsigned char* corner = nodes_;
    for (int axis = 0; axis < 3; ++axis) {
        const float low = color[axis] > 0 ? color[axis] : 0.0F;  // NaN is not above 0
        const float x = low < 1 ? low : 1.0F;
        const int below = int(std::sqrt(x) * float(lastCell + 1));
        const int cell = below < lastCell ? below : lastCell;
        const float fraction = (x - position_[cell]) * inverseWidth_[cell];
        f[axis] = fraction > 0 ? (fraction < 1 ? fraction : 1.0F) : 0.0F;
        corner += std::size_t(cell) * step_[axis];
    }
    int most = f[1] > f[0] ? 1 : 0;
    int least = 1 - most;
    most = f[2] > f[most] ? 2 : most;
    least = f[2] <= f[least] ? 2 : least;
    const int middle = 3 - most - least;
    Place place;
    place.node[0] = corner;
    place.node[1] = corner + step_[most];
    place.node[2] = place.node[1] + step_[middle];
    place.node[3] = place.node[2] + step_[least];
    place.weight[0] = 1 - f[most];
    place.weight[1] = f[most] - f[middle];
    place.weight[2] = f[middle] - f[least];
    place.weight[3] = f[least];
    return place;
}

template <std::size_t N>
SpectralTable::Wavelengths<N> SpectralTable::wavelengths(
    const std::array<float, N>& nm) const noexcept {
    Wavelengths<N> at;
    const auto last = float(header_.bands - 1);
    for (std::size_t i = 0; i < N; ++i) {
        const float band = (nm[i] - header_.firstWavelength) / header_.wavelengthStep;
        const float low = band > 0 ? band : 0.0F;
        const float inside = low < last ? low : last;
        const auto below = std::uint32_t(inside);
        at.offset[i] = below * 2;
        at.fraction[i] = inside - float(below);
    }
    return at;
}

template <std::size_t N>
void SpectralTable::evalScalar(const Place& place, const Wavelengths<N>& at, std::size_t first,
                               float* to) const noexcept {
    for (std::size_t i = first; i < N; ++i) {
        float below = 0;
        float above = 0;
        for (int k = 0; k < 4; ++k) {
            below += place.weight[k] * sampleAt(place.node[k] + at.offset[i]);
            above += place.weight[k] * sampleAt(place.node[k] + at.offset[i] + 2);
        }
        to[i] = reflectanceFrom(below + at.fraction[i] * (above - below));
    }
}

#if defined(SPECBAKE_SAMPLER_SSE2)
/// Both samples of each wavelength come in one load of 32 bits.
template <std::size_t N>
void SpectralTable::eval(const Place& place, const Wavelengths<N>& at,
                         float* reflectance) const noexcept {
    const auto pair = [](const unsigned char* from) {
        int value;
        std::memcpy(&value, from, sizeof value);
        return value;
    };
    for (std::size_t i = 0; i < N / 4 * 4; i += 4) {
        __m128 below = _mm_setzero_ps();
        __m128 above = _mm_setzero_ps();
        for (int k = 0; k < 4; ++k) {
            const unsigned char* node = place.node[k];
            const __m128i both =
                _mm_set_epi32(pair(node + at.offset[i + 3]), pair(node + at.offset[i + 2]),
                              pair(node + at.offset[i + 1]), pair(node + at.offset[i]));
            const __m128i low = _mm_and_si128(both, _mm_set1_epi32(0xFFFF));
            const __m128 weight = _mm_set1_ps(place.weight[k]);
            below = _mm_add_ps(below, _mm_mul_ps(weight, _mm_cvtepi32_ps(low)));
            above =
                _mm_add_ps(above, _mm_mul_ps(weight, _mm_cvtepi32_ps(_mm_srli_epi32(both, 16))));
        }
        const __m128 fraction = _mm_loadu_ps(at.fraction + i);
        const __m128 sample = _mm_add_ps(below, _mm_mul_ps(fraction, _mm_sub_ps(above, below)));
        const __m128 value =
            _mm_add_ps(_mm_set1_ps(header_.low), _mm_mul_ps(_mm_set1_ps(scale_), sample));
        _mm_storeu_ps(reflectance + i,
                      _mm_min_ps(_mm_max_ps(value, _mm_setzero_ps()), _mm_set1_ps(1)));
    }
    if constexpr (N % 4 != 0) evalScalar(place, at, N / 4 * 4, reflectance);
}
#elif defined(SPECBAKE_SAMPLER_NEON)
template <std::size_t N>
void SpectralTable::eval(const Place& place, const Wavelengths<N>& at,
                         float* reflectance) const noexcept {
    for (std::size_t i = 0; i < N / 4 * 4; i += 4) {
        float32x4_t below = vdupq_n_f32(0);
        float32x4_t above = vdupq_n_f32(0);
        for (int k = 0; k < 4; ++k) {
            std::uint32_t pairs[4];
            for (std::size_t j = 0; j < 4; ++j) {
                std::memcpy(&pairs[j], place.node[k] + at.offset[i + j], sizeof pairs[j]);
            }
            const uint32x4_t both = vld1q_u32(pairs);
            const float32x4_t low = vcvtq_f32_u32(vandq_u32(both, vdupq_n_u32(0xFFFF)));
            below = vaddq_f32(below, vmulq_n_f32(low, place.weight[k]));
            above = vaddq_f32(above,
                              vmulq_n_f32(vcvtq_f32_u32(vshrq_n_u32(both, 16)), place.weight[k]));
        }
        const float32x4_t fraction = vld1q_f32(at.fraction + i);
        const float32x4_t sample = vaddq_f32(below, vmulq_f32(fraction, vsubq_f32(above, below)));
        const float32x4_t value = vaddq_f32(vdupq_n_f32(header_.low), vmulq_n_f32(sample, scale_));
        vst1q_f32(reflectance + i, vminq_f32(vmaxq_f32(value, vdupq_n_f32(0)), vdupq_n_f32(1)));
    }
    if constexpr (N % 4 != 0) evalScalar(place, at, N / 4 * 4, reflectance);
}
#else
template <std::size_t N>
void SpectralTable::eval(const Place& place, const Wavelengths<N>& at,
                         float* reflectance) const noexcept {
    evalScalar(place, at, 0, reflectance);
}
#endif

inline void SpectralTable::evalBands(const Place& place, float* reflectance) const noexcept {
    for (std::uint32_t m = 0; m < header_.bands; ++m) {
        float sample = 0;
        for (int k = 0; k < 4; ++k) {
            sample += place.weight[k] * sampleAt(place.node[k] + 2 * std::size_t(m));
        }
        reflectance[m] = reflectanceFrom(sample);
    }
}

}  // namespace specbake
