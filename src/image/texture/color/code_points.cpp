#include "texture/color/code_points.h"

namespace specbake::internal {
namespace {

constexpr Chromaticity kD65{0.3127, 0.3290};
constexpr Chromaticity kC{0.310, 0.316};
constexpr Primaries kSmpte170{{0.630, 0.340}, {0.310, 0.595}, {0.155, 0.070}, kD65};

/// ITU-T H.273, table 2.
std::optional<Primaries> primariesOf(int code) {
    switch (code) {
        case 1:
            return findColorSpace("lin_rec709")->primaries;
        case 4:
            return Primaries{{0.67, 0.33}, {0.21, 0.71}, {0.14, 0.08}, kC};
        case 5:
            return Primaries{{0.64, 0.33}, {0.29, 0.60}, {0.15, 0.06}, kD65};
        case 6:
        case 7:
            return kSmpte170;
        case 8:
            return Primaries{{0.681, 0.319}, {0.243, 0.692}, {0.145, 0.049}, kC};
        case 9:
            return findColorSpace("lin_rec2020")->primaries;
        case 11:
            return findColorSpace("lin_dcip3")->primaries;
        case 12:
            return findColorSpace("lin_displayp3")->primaries;
        case 22:
            return Primaries{{0.630, 0.340}, {0.295, 0.605}, {0.155, 0.077}, kD65};
        default:
            return {};
    }
}

/// ITU-T H.273, table 3.
std::optional<Transfer> transferOf(int code) {
    switch (code) {
        case 1:
        case 6:
        case 14:
        case 15:
            return Transfer::rec709;
        case 4:
            return Transfer::power(2.2);
        case 5:
            return Transfer::power(2.8);
        case 8:
            return Transfer::linear;
        case 13:
            return Transfer::sRGB;
        default:
            return {};
    }
}

}  // namespace

std::optional<ColorSpace> spaceOf(const CodePoints& points, std::string& problem) {
    const auto primaries = primariesOf(points.primaries);
    const auto transfer = transferOf(points.transfer);
    if (points.matrix != 0 || !points.fullRange) {
        problem = "no full-range RGB";
    } else if (!primaries) {
        problem = "primaries " + std::to_string(points.primaries) + " are not known";
    } else if (!transfer) {
        problem = "transfer " + std::to_string(points.transfer) + " is not known";
    } else {
        return colorSpaceFromPrimaries(*primaries, *transfer);
    }
    return {};
}

bool isHighDynamicRange(const CodePoints& points) {
    return points.transfer == 16 || points.transfer == 18;
}

}  // namespace specbake::internal
