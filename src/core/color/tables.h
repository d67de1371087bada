#pragma once

#include <specbake/core/wavelengths.h>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// The tables of data/*.csv, made into arrays by embed_tables.
namespace specbake::internal::tables {

/// Colour-matching functions x̄, ȳ, z̄, a row a band, as exact multiples of 1e-10.
/// The printed decimals decide which vectors are parallel, so they are kept exactly.
extern const std::array<std::array<std::int64_t, 3>, kBandCount> colorMatching;
inline constexpr double kColorMatchingUnit = 1e-10;

struct IlluminantTable {
    std::string_view name;
    std::array<double, kBandCount> power;  ///< relative spectral power
};
extern const std::vector<IlluminantTable> illuminants;

/// A measured reflectance of data/natural.csv: tables of one set follow each other.
struct ReflectanceTable {
    std::string_view set, name, material;
    std::array<std::uint16_t, kBandCount> value;  ///< in units of 1/kReflectanceScale
};
inline constexpr double kReflectanceScale = 1e4;
extern const std::span<const ReflectanceTable> kReflectances;

}  // namespace specbake::internal::tables
