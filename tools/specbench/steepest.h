#pragma once

#include "methods/method.h"

#include <array>
#include <cstddef>
#include <functional>

namespace specbake::bench {

/// How far the two colours of a pair are apart, in linear RGB, while the search narrows down.
inline constexpr std::array<double, 4> kNarrowing = {1e-4, 1e-5, 1e-6, 1e-7};

/// Largest slope max_m |Δs_m| / |ΔRGB| that a search in the cube [0, 1]³ finds at each distance.
/// From `starts` seeded pairs it climbs: the pair moves where its slope grows, by ever smaller
/// steps. Then each pair is halved again and again, towards the half that changes more, so that a
/// jump anywhere between the two shows as a slope that grows as the distance shrinks.
std::array<double, kNarrowing.size()> steepest(
    const std::function<Spectrum(const RGB&)>& spectrumOf, std::size_t starts);

}  // namespace specbake::bench
