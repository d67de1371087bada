#pragma once

/// The wavelengths of spectra. Those of every solver are 380 to 780 nm every 5 nm (paper,
/// section 1), unless an Observer is made for others.
namespace specbake {

inline constexpr int kBandCount = 81;
inline constexpr int kFirstWavelength = 380;  ///< nm
inline constexpr int kWavelengthStep = 5;     ///< nm

/// The wavelength of a band, nm. 0 <= band < kBandCount.
constexpr int wavelength(int band) {
    return kFirstWavelength + kWavelengthStep * band;
}

/// Where the bands of a spectrum stand: evenly spaced, ascending.
struct Wavelengths {
    double first = kFirstWavelength;  ///< nm
    double step = kWavelengthStep;    ///< nm, above 0
    int count = kBandCount;

    constexpr double at(int band) const { return first + step * band; }
    constexpr double last() const { return at(count - 1); }
    bool operator==(const Wavelengths&) const = default;

    /// Where a spectrum of these bands is free: in the bands themselves, or if they are more than
    /// kBandCount, at as many knots from the first to the last, linear between.
    constexpr Wavelengths knots() const {
        if (count <= kBandCount) return *this;
        return {first, (last() - first) / (kBandCount - 1), kBandCount};
    }
};

}  // namespace specbake
