#pragma once

#include "methods/method.h"

#include <array>
#include <string>

namespace specbake::bench {

/// B. Smits, "An RGB-to-Spectrum Conversion for Reflectances", Journal of Graphics Tools 4(4),
/// 1999: seven spectra of ten bins, for white and the six corners of the RGB cube; a colour is
/// white by its least component, a secondary by the next, a primary by the rest.
///
/// | quantity | domain              | scale                                           |
/// |----------|---------------------|-------------------------------------------------|
/// | RGB      | [0, 1]              | linear; his phosphors, equal-energy white       |
/// | spectrum | his red exceeds 1   | 1 = perfect reflector; ten bins, 380-720 nm     |
///
/// Nothing is clamped: he proposes to clamp where energy has to be conserved, which then changes
/// the colour. Beyond 720 nm the last bin goes on.
class Smits1999 : public Method {
  public:
    /// `table`: data/smits1999.csv. The frame may be his own (`smitsFrame`) or, as renderers use
    /// it, linear sRGB.
    Smits1999(const Frame& frame, std::string table);

    /// Throws FileError.
    void setUp() override;
    Reconstruction reconstruct(const XYZ& color) const override;
    void reconstructTexels(std::span<const Imath::V3f> rgb,
                           std::span<float> spectra) const override;

    enum Name { white, cyan, magenta, yellow, red, green, blue };
    /// A basis spectrum, averaged over each band of 5 nm.
    const Spectrum& basis(Name name) const { return basis_[name]; }

  private:
    std::string table_;
    std::array<Spectrum, 7> basis_{};
    std::array<std::array<float, kBandCount>, 7> floatBasis_{};
};

}  // namespace specbake::bench
