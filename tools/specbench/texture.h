#pragma once

#include <Imath/ImathVec.h>

#include <cstddef>
#include <string>
#include <vector>

namespace specbake::bench {

/// A texture's linear RGB, row by row.
struct Texture {
    std::string path;
    int width = 0, height = 0;
    std::vector<Imath::V3f> texels;
};

/// Of sRGB or linear Rec.709, since the frame of the charts is sRGB's. Throws FileError.
Texture readTexture(const std::string& path);

/// The different colours of a texture, at most `count` of them, evenly thinned.
std::vector<Imath::V3f> distinctColors(const Texture& texture, std::size_t count);

}  // namespace specbake::bench
