#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color.h>
#include <specbake/core/quadrature.h>
#include <specbake/core/spectrum.h>
#include <specbake/core/wavelengths.h>

#include <Imath/ImathVec.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace specbake {

/// An observer under one illuminant: the weights w_m of (1), the 81 products of colour-matching
/// functions and illuminant, scaled so that the perfect reflector has Y = 1. The functions are
/// those of CIE 1931 (2 degree) unless others are named (quadrature.h).
///
/// Made for the fine quadrature, its weights are those of (M21), for any bands: at most 81 of them
/// are the first of a Spectrum, whose other values weigh nothing; more are linear between 81 knots,
/// which are then what a Spectrum holds. They are multiples of kWeightUnit, so that what is decided
/// about them can be decided in integers (generators.h).
class SPECBAKE_API Observer {
  public:
    /// An illuminant of `illuminantNames()` or `furtherIlluminantNames()`, in any case, or a light
    /// of one's own (lightText()). Throws ArgumentError for another name, and says which one is
    /// near.
    explicit Observer(std::string_view illuminant);
    /// Throws ArgumentError for another name, and for bands that the quadrature does not have.
    Observer(std::string_view illuminant, Quadrature quadrature, const Wavelengths& bands,
             std::string_view functions = kUsualObserver);

    /// As the list of names has it, or the text of a light of one's own.
    const std::string& illuminant() const { return illuminant_; }
    Quadrature quadrature() const { return quadrature_; }
    /// The bands that a reader gets.
    const Wavelengths& bands() const { return bands_; }
    /// Where the first knots().count values of a Spectrum stand; the rest weigh nothing.
    Wavelengths knots() const { return bands_.knots(); }
    /// The colour-matching functions: the name in full, or the text of a table of one's own.
    const std::string& functions() const { return functions_; }
    /// The same with the table's step, "CIE 1931 2 degree, 5 nm", which is taken for a name, too.
    std::string name() const;

    /// w_m, the tristimulus of band m at reflectance 1.
    const std::array<Imath::V3d, kBandCount>& weights() const { return weights_; }

    /// The perfect reflector, the sum W·1: not the textbook white.
    const XYZ& white() const { return white_; }

    /// (1): the colour of a reflectance.
    XYZ color(const Spectrum& reflectance) const;

    /// Of the weights of the fine quadrature. As weights are below 2, a determinant of three is
    /// below 2^126 in this unit.
    static constexpr double kWeightUnit = 0x1p-40;

  private:
    std::string illuminant_;
    std::string functions_{kUsualObserver};
    Quadrature quadrature_ = Quadrature::bands;
    Wavelengths bands_;
    std::array<Imath::V3d, kBandCount> weights_{};
    XYZ white_;
};

/// The illuminants that are offered: E, A, C, D50, D55, D60, D65, D75, F2, F11.
SPECBAKE_API const std::vector<std::string>& illuminantNames();

/// Whether an Observer takes it. `reason`, if it is given, says why not: one line.
[[nodiscard]] SPECBAKE_API bool isIlluminant(std::string_view name, std::string* reason = nullptr);

/// Relative spectral power at the bands.
using LightPower = std::array<double, kBandCount>;

/// What a spectrometer or a data sheet tells of a light.
struct LightSample {
    double wavelength = 0;  ///< nm
    double power = 0;       ///< relative, at least 0
};

/// The samples at the bands: where they are nearer together than these, the mean around each band,
/// weighted by the triangle that reaches to its neighbours; else linear between samples. Where they
/// are at the bands, they are taken as they are. Beyond the first and the last, these are repeated.
/// Throws ArgumentError for fewer than two, for wavelengths that do not ascend or do not reach from
/// 400 to 700 nm, and for powers that are not finite, negative, or all 0.
SPECBAKE_API LightPower lightPower(std::span<const LightSample> samples);

/// Illuminants of CIE 15 that are offered beside illuminantNames(): F1 to F12, F3.1 to F3.15,
/// HP1 to HP5, the LED series, ID50, ID65, B.
SPECBAKE_API const std::vector<std::string>& furtherIlluminantNames();

/// A light of one's own, in the form in which every function here takes it for the name of an
/// illuminant: "LABEL: 1.5 1.25 …", 81 numbers. The name of an offered illuminant if it has the
/// same powers, up to a factor, to 10⁻⁹. Control characters in the label become spaces.
SPECBAKE_API std::string lightText(std::string_view label, const LightPower& power);

/// Its inverse, and that of the names of offered illuminants; nothing for other text.
SPECBAKE_API std::optional<LightPower> powerOfLight(std::string_view illuminant);

/// What to call it: the name, or the label.
SPECBAKE_API std::string_view lightLabel(std::string_view illuminant);

}  // namespace specbake
