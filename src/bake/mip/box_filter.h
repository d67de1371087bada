#pragma once

#include <array>
#include <span>
#include <vector>

namespace specbake::internal {

/// What one texel averages of a side: `count` neighbours from `first` on, with these shares.
struct BoxTaps {
    int first = 0;
    int count = 0;
    std::array<double, 3> share{};
};

/// A side of n texels becomes one of m = halvedSide(n). Texel i of these stands for the stretch
/// from i n/m to (i + 1) n/m of the longer side, and takes each texel there by the length it
/// covers:
///
///     n = 1            the one texel
///     n = 2m           2i, 2i + 1          1/2, 1/2
///     n = 2m + 1       2i, 2i + 1, 2i + 2  (m - i)/n, m/n, (i + 1)/n
///
/// The shares of i add up to 1, and every texel of the longer side is taken to m/n in all: the mean
/// of the side stays what it is.
BoxTaps boxTaps(int side, int i);

/// A row of unrounded texels: channel by channel in the file's order, alpha first if there is any.
using TexelRow = std::vector<float>;

/// Averages rows of one level to a row of the level below, by the area that texels cover; channels
/// other than alpha by area times alpha (taken for 0 to 1), as what is transparent is not seen.
/// Where all is transparent, by area. What is equal stays so to the last bit, and no average lies
/// outside the values it was made of.
///
/// `rows`: `vertical.count` of them; `width`: of each, in texels.
TexelRow averageRows(std::span<const TexelRow* const> rows, const BoxTaps& vertical, int width,
                     bool alpha);

/// Texels of a row that follow each other.
struct Stretch {
    int first = 0;
    int count = 0;
};

/// What a stretch of a smaller row is made of, in rows of `width` texels.
Stretch sourceStretch(int width, const Stretch& smaller);

/// The same for a stretch of the smaller row: `rows` hold its source stretch alone, and the result
/// has the bits that it has in the whole row.
TexelRow averageRows(std::span<const TexelRow* const> rows, const BoxTaps& vertical, int width,
                     bool alpha, const Stretch& smaller);

}  // namespace specbake::internal
