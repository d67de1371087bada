#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace testimages {

/// Interleaved floats, row by row: what is to be written, before it is quantised.
struct Picture {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;

    Picture(int w, int h, int c);
    float* at(int x, int y);
};

/// A colour wheel along x, dark to light along y, as saturated as said (0: grey, 1: the cube's
/// edges). With `patches`, the first row begins with white, black and greys of 0.5 and 0.18.
Picture wheel(int width, int height, double saturation, bool patches = true);

/// The green of a picture alone: grey.
Picture greyOf(const Picture& rgb);

/// With an alpha of 0, 1/5, … 1 in turn along y; colours are left as they are.
Picture withAlpha(const Picture& picture);

/// Colours multiplied by alpha, the last channel.
Picture associated(const Picture& picture);

/// Each colour times a 3x3 matrix, row vector by matrix.
Picture transformed(const Picture& rgb, const std::array<std::array<double, 3>, 3>& matrix);

/// The picture of `./dev demo`: a mosaic of glazed tiles around a grey middle, sRGB-encoded.
Picture mosaic(int width, int height);

}  // namespace testimages
