#include "png_filter.h"

#include <cstdlib>

namespace specbake {
namespace {

/// PNG specification, 9.4.
std::uint8_t paeth(std::uint8_t left, std::uint8_t above, std::uint8_t corner) {
    const int p = left + above - corner;
    const int toLeft = std::abs(p - left);
    const int toAbove = std::abs(p - above);
    const int toCorner = std::abs(p - corner);
    if (toLeft <= toAbove && toLeft <= toCorner) return left;
    return toAbove <= toCorner ? above : corner;
}

}  // namespace

bool unfilter(int filter, std::size_t pixelBytes, std::span<const std::uint8_t> above,
              std::span<std::uint8_t> row) {
    const auto add = [&](auto&& prediction) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool inside = i >= pixelBytes;
            const std::uint8_t left = inside ? row[i - pixelBytes] : 0;
            const std::uint8_t corner = inside ? above[i - pixelBytes] : 0;
            row[i] = std::uint8_t(row[i] + prediction(left, above[i], corner));
        }
    };
    switch (filter) {
        case 0:
            return true;
        case 1:
            add([](auto left, auto, auto) { return left; });
            return true;
        case 2:
            add([](auto, auto up, auto) { return up; });
            return true;
        case 3:
            add([](auto left, auto up, auto) { return (left + up) / 2; });
            return true;
        case 4:
            add(paeth);
            return true;
        default:
            return false;
    }
}

}  // namespace specbake
