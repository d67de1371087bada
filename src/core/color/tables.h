#pragma once

#include <specbake/core/wavelengths.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// The tables of data/*.csv, made into arrays by embed_tables.
namespace specbake::internal::tables {

/// Colour-matching functions x̄, ȳ, z̄, a row a band, as exact multiples of 1e-10.
/// The printed decimals decide which vectors are parallel, so they are kept exactly.
using BandMatching = std::array<std::array<std::int64_t, 3>, kBandCount>;
inline constexpr double kMatchingUnitsPerOne = 1e10;
extern const BandMatching colorMatching;       ///< CIE 1931, 2 degree
extern const BandMatching kWideColorMatching;  ///< CIE 1964, 10 degree

struct IlluminantTable {
    std::string_view name;
    std::array<double, kBandCount> power;  ///< relative spectral power
};
extern const std::vector<IlluminantTable> illuminants;

/// x̄, ȳ, z̄ from 360 to 830 nm, a row a nm.
inline constexpr std::size_t kFineRows = 471;
using FineMatching = std::array<std::array<double, 3>, kFineRows>;
extern const FineMatching kFineColorMatching;      ///< CIE 1931, 2 degree
extern const FineMatching kFineWideColorMatching;  ///< CIE 1964, 10 degree

/// The power of an illuminant before 380 nm and beyond 780 nm, every 5 nm, NaN where there is none.
struct IlluminantEnds {
    std::string_view name;
    std::array<double, 4> below;   ///< 360 to 375 nm
    std::array<double, 10> above;  ///< 785 to 830 nm
};
extern const std::vector<IlluminantEnds> kIlluminantEnds;

/// A measured reflectance of data/natural.csv: tables of one set follow each other.
struct ReflectanceTable {
    std::string_view set, name, material;
    std::array<std::uint16_t, kBandCount> value;  ///< in units of 1/kReflectanceScale
};
inline constexpr double kReflectanceScale = 1e4;
extern const std::span<const ReflectanceTable> kReflectances;

}  // namespace specbake::internal::tables
