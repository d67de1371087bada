#include "methods/published/glassner1989.h"

#include <cmath>
#include <numbers>

namespace specbake::bench {
namespace {

Basis fourier() {
    Basis f;
    for (int m = 0; m < kBandCount; ++m) {
        const double angle = 2 * std::numbers::pi * m / (kBandCount - 1);
        const auto i = std::size_t(m);
        f[0][i] = 1;
        f[1][i] = std::cos(angle);
        f[2][i] = std::sin(angle);
    }
    return f;
}

Basis boxes() {
    constexpr int firstGreen = 490, firstRed = 590;  // nm
    Basis f{};
    for (int m = 0; m < kBandCount; ++m) {
        const int box = wavelength(m) < firstGreen ? 0 : wavelength(m) < firstRed ? 1 : 2;
        f[std::size_t(box)][std::size_t(m)] = 1;
    }
    return f;
}

}  // namespace

Glassner1989::Glassner1989(Frame frame, Functions functions)
    : LinearMethod({"Glassner 1989", functions == Functions::fourier ? "Fourier" : "boxes"},
                   std::move(frame)),
      functions_(functions) {}

void Glassner1989::setUp() {
    setBasis(basisSpannedBy(functions_ == Functions::fourier ? fourier() : boxes(), frame()));
}

}  // namespace specbake::bench
