#include "reading.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <algorithm>
#include <cmath>

namespace specbake::internal {
namespace {

/// As near as the six decimals of a channel's name tell.
bool standAt(const std::vector<double>& wavelengths, const Wavelengths& bands) {
    if (wavelengths.size() != std::size_t(bands.count)) return false;
    for (int m = 0; m < bands.count; ++m) {
        if (std::abs(wavelengths[std::size_t(m)] - bands.at(m)) > 1e-5) return false;
    }
    return true;
}

constexpr std::size_t kEnough = std::size_t(1) << 26;  ///< bytes of rows

std::size_t bytesOfRow(const SpectralReader& spectral) {
    return std::size_t(spectral.header().data.width) * spectral.wavelengths().size() *
           sizeof(float);
}

bool isUsual(const SpectralReader& spectral) {
    return standAt(spectral.wavelengths(), Wavelengths());
}

}  // namespace

int rowsTogether(const SpectralReader& spectral) {
    constexpr std::size_t most = 16;
    return int(std::clamp<std::size_t>(kEnough / bytesOfRow(spectral), 1, most));
}

int threadsFor(const SpectralReader& spectral, int threads) {
    return bytesOfRow(spectral) > kEnough / 2 ? 1 : threads;
}

Quadrature statedQuadrature(const std::string& path, const SpectralReader& spectral) {
    const auto stated = spectral.text("specbake:quadrature");
    if (!stated) return isUsual(spectral) ? Quadrature::bands : Quadrature::fine;
    if (const auto quadrature = quadratureFromText(*stated)) return *quadrature;
    throw FileError(path, "specbake:quadrature is '" + *stated + "', which is not known");
}

std::string statedObserver(const std::string& path, const SpectralReader& spectral) {
    const auto stated = spectral.text("specbake:observer");
    if (!stated) return std::string(kUsualObserver);
    if (isObserver(*stated)) return *stated;
    throw FileError(path, "specbake:observer is '" + std::string(observerLabel(*stated)) +
                              "', which is not known");
}

Wavelengths modelBands(const SpectralReader& spectral) {
    const std::vector<double>& nm = spectral.wavelengths();
    if (nm.size() < 2) return {};
    const double step = (nm.back() - nm.front()) / double(nm.size() - 1);
    // What six decimals leave open is settled by the nearest round number.
    const Wavelengths bands{nm.front(), std::round(step * 1e6) / 1e6, int(nm.size())};
    for (const Wavelengths& even : {bands, Wavelengths{nm.front(), step, int(nm.size())}}) {
        if (standAt(nm, even) && wavelengthsProblem(even).empty()) return even;
    }
    return {};
}

XYZ whiteOf(const std::vector<Imath::V3d>& weights) {
    XYZ white;
    for (const Imath::V3d& w : weights) white += w;
    return white;
}

std::vector<Imath::V3d> readerWeights(const std::string& path, const SpectralReader& spectral,
                                      std::string_view illuminant, Quadrature quadrature,
                                      std::string_view observer) {
    if (quadrature == Quadrature::fine) {
        return fineWeights(illuminant, spectral.wavelengths(), observer);
    }
    if (!isUsual(spectral)) {
        throw FileError(path,
                        "the sum over the bands is that of 380 to 780 nm every 5 nm; these "
                        "bands are read by the quadrature 'fine'");
    }
    const Observer reader(illuminant, quadrature, {}, observer);
    return {reader.weights().begin(), reader.weights().end()};
}

}  // namespace specbake::internal
