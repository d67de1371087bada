#include "target.h"
#include "texture/color/icc_profile.h"

#include <array>

namespace specbake::fuzz {

void run(std::span<const std::uint8_t> bytes) {
    const std::string profile(textOf(bytes));
    try {
        for (const int channels : {1, 3}) {
            const ColorMeaning meaning =
                internal::meaningOfProfile(profile, ColorModel::rgb, channels);
            if (!meaning.transform) continue;
            const std::array<float, 6> stored = {0, 0.5F, 1, 0.25F, 0.75F, 0.125F};
            std::array<std::array<float, 3>, 2> linear{};
            meaning.transform->run(stored.data(), 2, linear.data());
        }
    } catch (const internal::ProfileError&) {  // it says so
    }
}

}  // namespace specbake::fuzz
