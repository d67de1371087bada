#pragma once

#include <specbake/core/api.h>
#include <specbake/core/wavelengths.h>

#include <Imath/ImathVec.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace specbake {

/// How a reader integrates a spectrum. The colour of a spectrum is exact for one of them.
enum class Quadrature {
    bands,  ///< (1): the sum over the 81 bands, by the 5 nm table. The default
    fine    ///< (M21): every 1 nm from 360 to 830, linear between bands, the end bands repeated
};

inline constexpr std::array kQuadratures = {Quadrature::bands, Quadrature::fine};

/// "bands", "fine".
SPECBAKE_API std::string_view quadratureName(Quadrature quadrature);
SPECBAKE_API std::optional<Quadrature> quadratureFromName(std::string_view name);

/// The same in words, for a file: "sum over the bands", "every 1 nm from 360 to 830 nm, …".
SPECBAKE_API std::string_view quadratureText(Quadrature quadrature);
SPECBAKE_API std::optional<Quadrature> quadratureFromText(std::string_view text);

/// Whose colour-matching functions colours are computed by. By name: "CIE 1931 2 degree", also "2",
/// and "CIE 1964 10 degree", also "10"; or a table of one's own (observerText()).
inline constexpr std::string_view kUsualObserver = "CIE 1931 2 degree";

/// The names in full, the default first.
SPECBAKE_API const std::vector<std::string>& observerNames();

/// Whether `observer` is one of these, or the text of a table. `reason`, if it is given, says why
/// not: one line.
[[nodiscard]] SPECBAKE_API bool isObserver(std::string_view observer,
                                           std::string* reason = nullptr);

/// A row of a table of colour-matching functions.
struct MatchingSample {
    double wavelength = 0;               ///< nm
    Imath::V3d value = Imath::V3d(0.0);  ///< x̄, ȳ, z̄
};

/// A table of one's own, as a text that is taken for the name of an observer everywhere:
/// "LABEL: START:STOP:STEP 0.0013 …", three numbers a wavelength. The name of an offered observer
/// if the bands have the same numbers. Control characters in the label become spaces.
/// Throws ArgumentError unless the wavelengths ascend evenly by 10 nm at most and reach from 400 to
/// 700 nm, and the numbers are from 0 to 3 and none of the functions is 0 everywhere.
SPECBAKE_API std::string observerText(std::string_view label,
                                      std::span<const MatchingSample> table);

/// What to call it: the name, or the label.
SPECBAKE_API std::string_view observerLabel(std::string_view observer);

/// Of the fine quadrature, nm.
inline constexpr int kFinestFirst = 360;
inline constexpr int kFinestLast = 830;

/// The tristimulus of each band at reflectance 1, for a reader that integrates every 1 nm:
///
///     w_m = Σ h_m(λ) x̄(λ) S(λ) / Σ ȳ(λ) S(λ),   λ = 360, 361, …, 830 nm                     (M21)
///
/// x̄ standing for the observer's three functions, S for the light. h_m is what band m gives to λ
/// by linear interpolation, the end bands being repeated outside. As Σ h_m = 1, white is the fine
/// integral itself, whatever the bands are.
/// `wavelengths`: nm, strictly ascending, at least one. Throws ArgumentError for an unknown light
/// or observer.
SPECBAKE_API std::vector<Imath::V3d> fineWeights(std::string_view illuminant,
                                                 std::span<const double> wavelengths,
                                                 std::string_view observer = kUsualObserver);

/// "400:700:10" as START:STOP:STEP in nm, within 360 to 830, a whole number of steps of at least
/// 1 nm. Throws ArgumentError with the reason.
SPECBAKE_API Wavelengths parseWavelengths(const std::string& text);
/// Its inverse.
SPECBAKE_API std::string wavelengthsText(const Wavelengths& wavelengths);

/// What is wrong with wavelengths that a model shall have; empty if nothing is.
SPECBAKE_API std::string wavelengthsProblem(const Wavelengths& wavelengths);

/// The wavelengths one by one, nm.
SPECBAKE_API std::vector<double> listed(const Wavelengths& wavelengths);

}  // namespace specbake
