#include "colors/texture.h"

#include "choose/color_survey.h"

#include <specbake/core/error.h>
#include <specbake/image/texture_reader.h>

#include <algorithm>

namespace specbake::bench {

std::vector<RGB> distinctColors(const std::string& texture, std::size_t count) {
    TextureReader reader(texture);
    const TextureInfo& info = reader.info();
    const std::string& space = info.color.space.name;
    if (space != "srgb" && space != "lin_rec709") {
        throw FileError(texture,
                        "specbench takes textures of sRGB or linear Rec.709, this is " + space);
    }
    const TexelDecoder decoder(info, info.color);
    std::vector<internal::TexelColor> colors;
    const auto append = [&](std::span<const internal::ColorCount> some) {
        for (const auto& counted : some) colors.push_back(counted.color);
    };
    internal::surveyColors({reader, decoder, 1, {}}, append);
    std::sort(colors.begin(), colors.end());
    colors.erase(std::unique(colors.begin(), colors.end()), colors.end());
    std::vector<RGB> thinned;
    const double stride = std::max(1.0, double(colors.size() - 1) / double(count - 1));
    for (std::size_t i = 0; i < std::min(count, colors.size()); ++i) {
        const auto& [r, g, b] = colors[std::size_t(double(i) * stride)];
        thinned.emplace_back(r, g, b);
    }
    return thinned;
}

}  // namespace specbake::bench
