#include "texture/color/icc_matrix.h"

#include "texture/color/icc_profile.h"

#include <specbake/core/adaptation.h>
#include <specbake/core/ciede2000.h>
#include <specbake/core/error.h>

#include <algorithm>
#include <cmath>

namespace specbake::internal {
namespace {

using Curves = std::array<const cmsToneCurve*, 3>;

/// A profile's parts: XYZ(rgb * colorants) beside the white of the connection space.
struct Matrix {
    Imath::M33d colorants;
    Curves curves{};
};

Matrix matrixOf(const IccProfile& profile) {
    constexpr std::array colorants = {cmsSigRedColorantTag, cmsSigGreenColorantTag,
                                      cmsSigBlueColorantTag};
    constexpr std::array curves = {cmsSigRedTRCTag, cmsSigGreenTRCTag, cmsSigBlueTRCTag};
    Matrix matrix;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto* c = static_cast<const cmsCIEXYZ*>(cmsReadTag(profile.get(), colorants[i]));
        matrix.curves[i] = static_cast<const cmsToneCurve*>(cmsReadTag(profile.get(), curves[i]));
        if (c == nullptr || matrix.curves[i] == nullptr) {
            throw ProfileError(profile.context()->complaint("a matrix that lacks a part"));
        }
        matrix.colorants[int(i)][0] = c->X;
        matrix.colorants[int(i)][1] = c->Y;
        matrix.colorants[int(i)][2] = c->Z;
    }
    return matrix;
}

/// Whether all colours of a lattice are those of a known space, to kSameSpace.
bool isSame(const Matrix& matrix, const ColorSpace& known) {
    constexpr int steps = 8;
    const XYZ white = pcsWhite();
    const Imath::M33d knownMatrix = xyzFromRGB(known, xyzOf(known.primaries->white)) *
                                    adaptation(xyzOf(known.primaries->white), white);
    std::array<RGB, steps + 1> a;
    std::array<double, steps + 1> b{};
    for (int i = 0; i <= steps; ++i) {
        const double encoded = double(i) / steps;
        for (int c = 0; c < 3; ++c) {
            a[std::size_t(i)][c] =
                double(cmsEvalToneCurveFloat(matrix.curves[std::size_t(c)], float(encoded)));
        }
        b[std::size_t(i)] = linearFrom(encoded, known.transfer);
    }
    constexpr int count = (steps + 1) * (steps + 1) * (steps + 1);
    for (int i = count - 1; i >= 0; --i) {
        const auto red = std::size_t(i % (steps + 1));
        const auto green = std::size_t(i / (steps + 1) % (steps + 1));
        const auto blue = std::size_t(i / ((steps + 1) * (steps + 1)));
        const XYZ ours(RGB(a[red].x, a[green].y, a[blue].z) * matrix.colorants);
        const XYZ theirs(RGB(b[red], b[green], b[blue]) * knownMatrix);
        if (!(ciede2000(labFromXYZ(ours, white), labFromXYZ(theirs, white)) <= kSameSpace)) {
            return false;
        }
    }
    return true;
}

const ColorSpace* knownSpaceOf(const Matrix& matrix) {
    const auto& spaces = colorSpaces();
    const auto same = std::find_if(spaces.begin(), spaces.end(), [&](const ColorSpace& space) {
        return !space.isXYZ() && isSame(matrix, space);
    });
    return same == spaces.end() ? nullptr : &*same;
}

/// From colours beside the device's own white to those of the connection space: what the profile
/// says of that (v4), or Bradford's adaptation from the white that it names (v2).
Imath::M33d adaptationOf(const IccProfile& profile) {
    const auto* chad =
        static_cast<const cmsCIEXYZ*>(cmsReadTag(profile.get(), cmsSigChromaticAdaptationTag));
    if (chad != nullptr) {
        const Imath::M33d rows(chad[0].X, chad[0].Y, chad[0].Z, chad[1].X, chad[1].Y, chad[1].Z,
                               chad[2].X, chad[2].Y, chad[2].Z);
        if (std::abs(rows.determinant()) > 1e-3) return rows.transposed();
    }
    const auto* white =
        static_cast<const cmsCIEXYZ*>(cmsReadTag(profile.get(), cmsSigMediaWhitePointTag));
    const bool display = cmsGetDeviceClass(profile.get()) == cmsSigDisplayClass;
    if (!display || white == nullptr || !(white->Y > 0)) return {};
    return adaptation(XYZ(white->X, white->Y, white->Z), pcsWhite());
}

Chromaticity chromaticityOf(const Imath::V3d& color) {
    const double sum = color.x + color.y + color.z;
    if (!(std::abs(sum) > 1e-6)) throw ProfileError("a colorant without chromaticity");
    return {color.x / sum, color.y / sum};
}

ColorSpace spaceOf(const IccProfile& profile, const Matrix& matrix) {
    const Imath::M33d own = adaptationOf(profile).inverse();
    const Imath::M33d colorants = matrix.colorants * own;
    const auto at = [&](int i) {
        return chromaticityOf({colorants[i][0], colorants[i][1], colorants[i][2]});
    };
    const Primaries primaries{at(0), at(1), at(2), chromaticityOf(pcsWhite() * own)};
    ColorSpace space = colorSpaceFromPrimaries(primaries);
    space.name = "icc";
    space.primaries = primaries;
    static_cast<void>(xyzFromRGB(space, xyzOf(primaries.white)));  // throws if there is none
    return space;
}

}  // namespace

ColorMeaning meaningOfMatrix(const IccProfile& profile) try {
    const Matrix matrix = matrixOf(profile);
    ColorMeaning meaning;
    if (const ColorSpace* known = knownSpaceOf(matrix)) {
        meaning.space = *known;
        return meaning;
    }
    meaning.space = spaceOf(profile, matrix);
    meaning.curves = std::make_shared<SampledCurves>(
        SampledCurves{sampledCurve(*matrix.curves[0]), sampledCurve(*matrix.curves[1]),
                      sampledCurve(*matrix.curves[2])});
    return meaning;
} catch (const ArgumentError& error) {
    throw ProfileError(error.what());
}

}  // namespace specbake::internal
