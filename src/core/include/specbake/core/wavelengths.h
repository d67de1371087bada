#pragma once

/// The wavelength grid of every spectrum here: 380 to 780 nm every 5 nm (paper, section 1).
namespace specbake {

inline constexpr int kBandCount = 81;
inline constexpr int kFirstWavelength = 380;  ///< nm
inline constexpr int kWavelengthStep = 5;     ///< nm

/// The wavelength of a band, nm. 0 <= band < kBandCount.
constexpr int wavelength(int band) {
    return kFirstWavelength + kWavelengthStep * band;
}

}  // namespace specbake
