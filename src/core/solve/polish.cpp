#include "solve/polish.h"

#include "solve/face_modes.h"

#include <specbake/core/vector.h>

#include <cmath>

namespace specbake::internal {

double polish(const Observer& observer, const XYZ& color, Spectrum& spectrum) {
    constexpr double roundings = 4 * 0x1p-52;  // a few of a sum near 1: not worth a correction
    const auto inside = [](double value) { return value > 0 && value < 1; };
    FreeSet free;
    free.removeIf([&](std::size_t m) { return !inside(spectrum[m]); });
    const FaceModes modes = faceModes(observer.weights(), free);
    Imath::V3d residual = observer.color(spectrum) - color;
    for (int round = 0; round < 3 && largestComponent(residual) > roundings; ++round) {
        const Imath::V3d direction = modes.solve(residual);
        Spectrum corrected = spectrum;
        for (const std::size_t m : free) {
            corrected[m] -= observer.weights()[m].dot(direction);
            if (!inside(corrected[m])) return largestComponent(residual);
        }
        const Imath::V3d left = observer.color(corrected) - color;
        if (!(largestComponent(left) < largestComponent(residual))) break;
        spectrum = corrected;
        residual = left;
    }
    return largestComponent(residual);
}

}  // namespace specbake::internal
