#pragma once

#include <specbake/core/upsampler.h>

#include <random>

namespace specbake::internal {

/// Colours of the unit cube, drawn evenly in the root of each component: so that each cell of the
/// grid gets as many, and the dark, where the eye is sharp, its share. The same for the same seed,
/// with every standard library.
class CubeColors {
  public:
    explicit CubeColors(unsigned seed) : random_(seed) {}

    Upsampler::Color next() { return {component(), component(), component()}; }

  private:
    float component() {
        const double root = double(random_()) / double(std::mt19937::max());
        return float(root * root);
    }

    std::mt19937 random_;
};

}  // namespace specbake::internal
