#pragma once

#include "beside/image_beside.h"

#include <specbake/core/second_lamp.h>
#include <specbake/image/texel_decoder.h>

#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace specbake::internal {

/// The same texture under a second light: each texel's spectrum is moved until it has that colour
/// under that light as well (specbake/core/second_lamp.h). In the image, (1, 1, 1) of an RGB space
/// is the perfect reflector, as in the texture: a photograph is balanced to the second light.
class SecondColors : public ImageBeside {
  public:
    /// `meaning`: of the image's numbers. `first`: of the texture. `adapt`: from the white of the
    /// image's space to the second light. Throws FileError for another size.
    SecondColors(Texture& image, const TextureInfo& texture, const ColorMeaning& meaning,
                 const Observer& first, const std::string& light, Adaptation adapt);

    /// Missed: texels whose colour under the second light is another than asked for.
    void change(std::span<const Upsampler::Color> colors, std::span<const std::byte> stored,
                std::span<float> samples, BesideCensus& census) const override;

  private:
    struct Answer {
        std::array<float, kBandCount> bands{};
        double miss = 0;  ///< CIEDE2000 under the second light; 0 if the colour is met
    };
    /// What an answer depends on: the bands that there are, and the second colour.
    using Key = std::array<float, kBandCount + 3>;
    /// What a thread keeps from run to run.
    struct Buffers {
        std::vector<Upsampler::Color> seconds;
        std::vector<float> alpha;
        std::map<Key, Answer> known;
    };
    Answer answer(const Spectrum& base, const Upsampler::Color& second) const;
    const Answer& answerFor(const Key& key, Buffers& buffers) const;

    TexelDecoder decoder_;
    SecondLamp lamp_;
    Imath::M33d xyzFromTexel_;
    mutable tbb::enumerable_thread_specific<Buffers> buffers_;
};

}  // namespace specbake::internal
