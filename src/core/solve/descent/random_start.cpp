#include "solve/descent/random_start.h"

#include <bit>
#include <cstdint>

namespace specbake::internal {
namespace {

/// SplitMix64: G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number
/// generators", OOPSLA 2014.
class SplitMix {
  public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    /// Uniform in [0, 1): 53 bits.
    double uniform() { return double(next() >> 11) * 0x1p-53; }

  private:
    std::uint64_t state_;
};

std::uint64_t absorb(std::uint64_t seed, std::uint64_t word) {
    return SplitMix(seed ^ word).next();
}

std::uint64_t bitsOf(double value) {
    return std::bit_cast<std::uint64_t>(value + 0.0);  // -0 counts as 0
}

}  // namespace

Spectrum randomStart(const XYZ& color, int number) {
    std::uint64_t seed = absorb(0, bitsOf(color.x));
    seed = absorb(seed, bitsOf(color.y));
    seed = absorb(seed, bitsOf(color.z));
    SplitMix random(absorb(seed, std::uint64_t(number)));
    Spectrum s;
    for (double& value : s) value = random.uniform();
    return s;
}

}  // namespace specbake::internal
