#include "texture.h"

#include <specbake/core/error.h>
#include <specbake/image/texture_reader.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace specbake::bench {

Texture readTexture(const std::string& path) {
    TextureReader reader(path);
    const TextureInfo& info = reader.info();
    const std::string& space = info.automaticSpace.name;
    if (space != "srgb" && space != "lin_rec709") {
        throw FileError(path,
                        "specbench takes textures of sRGB or linear Rec.709, this is " + space);
    }
    Texture texture{path, info.data.width, info.data.height, {}};
    const auto width = std::size_t(texture.width);
    const TexelDecoder decoder(info, info.automaticSpace);
    std::vector<std::byte> stored(info.bytesPerRow());
    std::vector<std::array<float, 3>> row(width);
    std::vector<float> alpha(width);
    for (int y = 0; y < texture.height; ++y) {
        reader.readRows(y, 1, stored);
        decoder.decode(stored, width, row.data(), alpha.data());
        for (const auto& c : row) texture.texels.emplace_back(c[0], c[1], c[2]);
    }
    return texture;
}

std::vector<Imath::V3f> distinctColors(const Texture& texture, std::size_t count) {
    std::vector<Imath::V3f> colors = texture.texels;
    std::sort(colors.begin(), colors.end(), [](const Imath::V3f& a, const Imath::V3f& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    colors.erase(std::unique(colors.begin(), colors.end()), colors.end());
    if (colors.size() <= count) return colors;
    std::vector<Imath::V3f> thinned;
    const double stride = double(colors.size() - 1) / double(count - 1);
    for (std::size_t i = 0; i < count; ++i) {
        thinned.push_back(colors[std::size_t(double(i) * stride)]);
    }
    return thinned;
}

}  // namespace specbake::bench
