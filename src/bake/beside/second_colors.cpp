#include "beside/second_colors.h"

#include <specbake/core/ciede2000.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace specbake::internal {

SecondColors::SecondColors(Texture& itsImage, const TextureInfo& texture,
                           const ColorMeaning& meaning, const Observer& first,
                           const std::string& light, Adaptation adapt)
    : ImageBeside(itsImage, texture, "a texture under a second light"),
      decoder_(image().info(), meaning),
      lamp_(first, Observer(light, first.quadrature(), first.bands(), first.functions())),
      xyzFromTexel_(xyzFromRGB(meaning.space, lamp_.second(), adapt)) {}

SecondColors::Answer SecondColors::answer(const Spectrum& base,
                                          const Upsampler::Color& second) const {
    const RGB rgb{double(second[0]), double(second[1]), double(second[2])};
    const XYZ asked(rgb * xyzFromTexel_);
    const SecondLamp::Answer moved = lamp_.move(base, asked);
    Answer answer;
    for (std::size_t m = 0; m < base.size(); ++m) answer.bands[m] = float(moved.spectrum[m]);
    if (!moved.met) {
        const Observer& light = lamp_.second();
        const XYZ given = light.color(moved.spectrum);
        answer.miss = ciede2000(labFromXYZ(asked, light.white()), labFromXYZ(given, light.white()));
    }
    return answer;
}

const SecondColors::Answer& SecondColors::answerFor(const Key& key, Buffers& buffers) const {
    constexpr std::size_t most = 10'000;  // answers that a thread keeps
    const auto found = buffers.known.find(key);
    if (found != buffers.known.end()) return found->second;
    if (buffers.known.size() >= most) buffers.known.clear();
    Spectrum base;
    std::copy_n(key.begin(), base.size(), base.begin());
    const float* second = key.data() + base.size();
    return buffers.known.emplace(key, answer(base, {second[0], second[1], second[2]}))
        .first->second;
}

void SecondColors::change(std::span<const Upsampler::Color> colors,
                          std::span<const std::byte> stored, std::span<float> samples,
                          BesideCensus& census) const {
    const std::size_t texels = colors.size();
    Buffers& buffers = buffers_.local();
    buffers.seconds.resize(texels);
    buffers.alpha.resize(texels);
    decoder_.decode(stored, texels, buffers.seconds.data(), buffers.alpha.data());
    const auto bands = samples.last(std::size_t(kBandCount) * texels);
    for (std::size_t i = 0; i < texels; ++i) {
        Key key;
        for (std::size_t m = 0; m < kBandCount; ++m) key[m] = bands[m * texels + i];
        std::ranges::copy(buffers.seconds[i], key.begin() + kBandCount);
        const auto isFinite = [](float value) { return std::isfinite(value); };
        if (!std::ranges::all_of(key, isFinite)) {
            census.add({1, std::numeric_limits<double>::infinity()});
            continue;
        }
        const Answer& found = answerFor(key, buffers);
        for (std::size_t m = 0; m < kBandCount; ++m) bands[m * texels + i] = found.bands[m];
        if (found.miss > 0) census.add({1, found.miss});
    }
}

}  // namespace specbake::internal
