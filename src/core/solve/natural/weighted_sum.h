#pragma once

#include <specbake/core/spectrum.h>

#include <span>

namespace specbake::internal {

/// A spectrum, and how much it weighs.
struct Weighted {
    double weight;
    const Spectrum* spectrum;
};

/// sum + Σ weight · spectrum, added up in their order. The same bits on every processor: products
/// are rounded before they are added.
void addWeighted(std::span<const Weighted> terms, Spectrum& sum);

}  // namespace specbake::internal
