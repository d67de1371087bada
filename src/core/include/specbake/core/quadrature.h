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

/// Of the fine quadrature, nm.
inline constexpr int kFinestFirst = 360;
inline constexpr int kFinestLast = 830;

/// The tristimulus of each band at reflectance 1, for a reader that integrates every 1 nm:
///
///     w_m = Σ h_m(λ) x̄(λ) S(λ) / Σ ȳ(λ) S(λ),   λ = 360, 361, …, 830 nm                     (M21)
///
/// x̄ standing for the three functions of CIE 1931, S for the light. h_m is what band m gives to λ
/// by linear interpolation, the end bands being repeated outside. As Σ h_m = 1, white is the fine
/// integral itself, whatever the bands are.
/// `wavelengths`: nm, strictly ascending, at least one. Throws ArgumentError for an unknown light.
SPECBAKE_API std::vector<Imath::V3d> fineWeights(std::string_view illuminant,
                                                 std::span<const double> wavelengths);

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
