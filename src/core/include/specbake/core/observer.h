#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color.h>
#include <specbake/core/spectrum.h>

#include <Imath/ImathVec.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace specbake {

/// The CIE 1931 2-degree observer under one illuminant: the weights w_m of (1), the 81 products of
/// colour-matching functions and illuminant, scaled so that the perfect reflector has Y = 1.
class SPECBAKE_API Observer {
  public:
    /// An illuminant of `illuminantNames()`, in any case. Throws ArgumentError for another name,
    /// and says which known one is near.
    explicit Observer(std::string_view illuminant);

    /// As `illuminantNames()` has it.
    const std::string& illuminant() const { return illuminant_; }
    /// Of the colour-matching functions.
    std::string_view name() const { return "CIE 1931 2 degree, 5 nm"; }

    /// w_m, the tristimulus of band m at reflectance 1.
    const std::array<Imath::V3d, kBandCount>& weights() const { return weights_; }

    /// The perfect reflector, the 81-term sum W·1: not the textbook white.
    const XYZ& white() const { return white_; }

    /// (1): the colour of a reflectance.
    XYZ color(const Spectrum& reflectance) const;

  private:
    std::string illuminant_;
    std::array<Imath::V3d, kBandCount> weights_;
    XYZ white_;
};

/// The illuminants that are offered: E, A, C, D50, D55, D60, D65, D75, F2, F11.
SPECBAKE_API const std::vector<std::string>& illuminantNames();

/// Whether it is one of them, in any case. `reason`, if it is given, says why not: one line.
[[nodiscard]] SPECBAKE_API bool isIlluminant(std::string_view name, std::string* reason = nullptr);

}  // namespace specbake
