#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace specbake::internal {

/// "Reordering and predictor" of the OpenEXR file layout document: the bytes at even places, then
/// those at odd ones, each as its difference to the one before it, plus 128. The first stays as it
/// is. The spans have the same length and do not overlap.
void splitAndPredict(std::span<const std::uint8_t> samples, std::span<std::uint8_t> predicted);

/// Undoes splitAndPredict().
void restore(std::span<const std::uint8_t> predicted, std::span<std::uint8_t> samples);

}  // namespace specbake::internal
