#include "upsample/blend.h"

#include "support/each_target.h"

#include <Imath/half.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

using namespace specbake;
using namespace specbake::internal;

namespace {

/// Spectra to blend, some with values beyond [0, 1], and mixes of them.
class Scene {
  public:
    explicit Scene(unsigned seed) : random_(seed), nodes_(40) {
        std::uniform_real_distribution<float> value(-0.2F, 1.2F);
        for (NodeValues& node : nodes_) {
            for (std::size_t p = 0; p < kTexelSamples; ++p) node.value[p] = value(random_);
        }
    }

    /// Runs of texels between the same nodes, of random length, `longest` at most.
    std::vector<Mix> mixes(std::size_t count, std::size_t longest) {
        std::vector<Mix> result;
        while (result.size() < count) {
            const std::size_t run = 1 + random_() % longest;
            const Mix first = mix();
            for (std::size_t i = 0; i < run && result.size() < count; ++i) {
                result.push_back({first.values, weights()});
            }
        }
        return result;
    }

  private:
    Mix mix() {
        if (random_() % 8 == 0) return only(node());
        return {{node(), node(), node(), node()}, weights()};
    }
    const float* node() { return nodes_[random_() % nodes_.size()].value.data(); }
    /// As Grid::locate() makes them: differences of descending fractions.
    std::array<float, 4> weights() {
        std::uniform_real_distribution<float> uniform(0, 1);
        std::array<float, 3> f = {uniform(random_), uniform(random_), uniform(random_)};
        std::sort(f.begin(), f.end(), std::greater<>());
        return {1 - f[0], f[0] - f[1], f[1] - f[2], f[2]};
    }

    std::mt19937 random_;
    std::vector<NodeValues> nodes_;
};

constexpr std::byte kUntouched{0xA5};

/// Planes with room before, between and after them that nothing may write to.
template <class Sample>
class Planes {
  public:
    Planes(std::size_t texels, std::size_t offset, std::size_t gap)
        : texels_(texels),
          begin_(offset * sizeof(Sample)),
          stride_((texels + gap) * sizeof(Sample)),
          bytes_(begin_ + stride_ * kTexelSamples + 64, kUntouched) {}

    void blend(std::span<const Mix> mixes) {
        constexpr auto type = sizeof(Sample) == 2 ? SampleType::half : SampleType::float32;
        specbake::internal::blend(mixes, type, bytes_.data() + begin_, stride_);
    }
    Sample at(std::size_t plane, std::size_t texel) const {
        Sample sample;
        std::memcpy(&sample, address(plane) + texel * sizeof sample, sizeof sample);
        return sample;
    }
    bool gapsAreUntouched() const {
        const auto untouched = [](const std::byte* from, const std::byte* to) {
            return std::all_of(from, to, [](std::byte b) { return b == kUntouched; });
        };
        bool all = untouched(bytes_.data(), address(0));
        for (std::size_t p = 0; p < kTexelSamples; ++p) {
            all = all && untouched(address(p) + texels_ * sizeof(Sample), address(p + 1));
        }
        return all && untouched(address(kTexelSamples), bytes_.data() + bytes_.size());
    }

  private:
    const std::byte* address(std::size_t plane) const {
        return bytes_.data() + begin_ + plane * stride_;
    }
    std::size_t texels_, begin_, stride_;
    std::vector<std::byte> bytes_;
};

double clampedTo(std::size_t plane, double value) {
    return plane < kPreviewSamples ? std::max(value, 0.0) : std::clamp(value, 0.0, 1.0);
}

/// How far a blended sample is from the exact one, in units of the bound on four products and three
/// sums in float, fused or not: each term meets at most four roundings of 2^-24.
double errorInBounds(const Mix& mix, std::size_t plane, float sample) {
    double exact = 0;
    double magnitude = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const double term = double(mix.weights[k]) * double(mix.values[k][plane]);
        exact += term;
        magnitude += std::abs(term);
    }
    const double bound = magnitude * (std::pow(1 + 0x1p-24, 4) - 1);
    const double error = std::abs(double(sample) - clampedTo(plane, exact));
    return error == 0 ? 0 : error / bound;
}

}  // namespace

TEST_CASE("blended samples are those of double precision, to rounding, whatever the row's length") {
    onEachTarget([] {
        Scene scene(1);
        double worst = 0;
        for (std::size_t texels = 0; texels <= 140; ++texels) {
            const auto mixes = scene.mixes(texels, texels % 2 == 0 ? 1 : 40);
            Planes<float> planes(texels, texels % 19, texels % 5);
            planes.blend(mixes);
            CHECK(planes.gapsAreUntouched());
            for (std::size_t p = 0; p < kTexelSamples; ++p) {
                for (std::size_t i = 0; i < texels; ++i) {
                    worst = std::max(worst, errorInBounds(mixes[i], p, planes.at(p, i)));
                }
            }
        }
        CHECK(worst <= 1);
    });
}

TEST_CASE("half samples are the float samples, rounded to nearest even") {
    onEachTarget([] {
        Scene scene(2);
        int differences = 0;
        for (std::size_t texels = 0; texels <= 140; texels += 1 + texels % 3) {
            const auto mixes = scene.mixes(texels, 20);
            Planes<float> floats(texels, 0, 0);
            Planes<Imath::half> halves(texels, texels % 37, texels % 5);
            floats.blend(mixes);
            halves.blend(mixes);
            CHECK(halves.gapsAreUntouched());
            for (std::size_t p = 0; p < kTexelSamples; ++p) {
                for (std::size_t i = 0; i < texels; ++i) {
                    const Imath::half expected = floats.at(p, i);
                    differences += expected.bits() != halves.at(p, i).bits();
                }
            }
        }
        CHECK(differences == 0);
    });
}

TEST_CASE("every half is met from above, from below and from its ties") {
    onEachTarget([] {
        int differences = 0;
        NodeValues node;
        const Mix mix = only(node.value.data());
        for (std::uint16_t bits = 0; bits < 0x3C00; ++bits) {  // 0 to below 1
            Imath::half low, high;
            low.setBits(bits);
            high.setBits(std::uint16_t(bits + 1));
            const float tie = (float(low) + float(high)) / 2;  // exact
            node.value[3] = tie;
            node.value[4] = std::nextafter(tie, 0.0F);
            node.value[5] = std::nextafter(tie, 1.0F);
            Planes<Imath::half> planes(1, 0, 0);
            planes.blend(std::span(&mix, 1));
            differences += planes.at(3, 0).bits() != (bits % 2 == 0 ? bits : bits + 1);
            differences += planes.at(4, 0).bits() != bits;
            differences += planes.at(5, 0).bits() != bits + 1;
        }
        CHECK(differences == 0);
    });
}

TEST_CASE("a texel's samples do not depend on its neighbours or on its place in the row") {
    onEachTarget([] {
        Scene scene(3);
        int differences = 0;
        for (const std::size_t longest : {1U, 5U, 24U, 200U}) {
            const auto mixes = scene.mixes(333, longest);
            Planes<float> row(mixes.size(), 1, 0);
            row.blend(mixes);
            for (std::size_t i = 0; i < mixes.size(); ++i) {
                Planes<float> alone(1, 0, 0);
                alone.blend(std::span(mixes).subspan(i, 1));
                for (std::size_t p = 0; p < kTexelSamples; ++p) {
                    differences += row.at(p, i) != alone.at(p, 0);
                }
            }
        }
        CHECK(differences == 0);
    });
}

TEST_CASE("a spectrum alone is kept, clamped: bands to [0, 1], previews to what is not negative") {
    onEachTarget([] {
        NodeValues node;
        for (std::size_t p = 0; p < kTexelSamples; ++p) node.value[p] = float(p % 5) - 2.0F;
        const std::vector<Mix> mixes(70, only(node.value.data()));
        Planes<float> planes(mixes.size(), 0, 0);
        planes.blend(mixes);
        for (std::size_t p = 0; p < kTexelSamples; ++p) {
            CHECK(double(planes.at(p, 69)) == clampedTo(p, double(node.value[p])));
            CHECK(!std::signbit(planes.at(p, 0)));
        }
    });
}
