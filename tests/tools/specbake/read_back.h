#pragma once

#include <OpenImageIO/imageio.h>

#include <array>
#include <string>
#include <vector>

namespace specbake::testing {

/// A whole image by OpenImageIO, none of whose readers is ours: the oracle of what a file holds.
struct ReadBack {
    OIIO::ImageSpec spec;
    std::vector<float> samples;  ///< interleaved, row by row

    /// Throws std::runtime_error where it cannot be read. Colours are not multiplied by alpha
    /// unless the file holds them so.
    explicit ReadBack(const std::string& path, int mipLevel = 0);

    /// A channel by its name, at a texel counted from the data window's corner.
    float at(int x, int y, const std::string& channel) const;

    /// The 81 bands of a texel, from 380 nm up.
    std::array<float, 81> bands(int x, int y) const;
};

/// The name that the layout gives a band, spelled independently of the library.
std::string bandName(int nm);

/// Writes an image through OpenImageIO.
void writeImage(const std::string& path, const OIIO::ImageSpec& spec,
                const std::vector<float>& samples);

}  // namespace specbake::testing
