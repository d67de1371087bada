#include "solid/face_levels.h"

#include "solid/release_rates.h"
#include "support/each_target.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace specbake::internal;

namespace {

class RandomVectors {
  public:
    explicit RandomVectors(unsigned seed) : random_(seed) {}
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    Imath::V3d vector() { return {(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)}; }
    /// In bundles of near directions, and of lengths that differ by a thousand, as faces are.
    std::vector<Imath::V3d> normals(std::size_t count) {
        std::vector<Imath::V3d> result;
        while (result.size() < count) {
            const Imath::V3d bundle = vector() * std::pow(10.0, (*this)(-1.5, 1.5));
            for (int i = 0; i < 9; ++i) result.push_back(bundle + vector() * 1e-3);
        }
        result.resize(count);
        return result;
    }

  private:
    std::mt19937_64 random_;
};

}  // namespace

TEST_CASE("levels are those that looking at every normal gives, to the bit") {
    RandomVectors random(31);
    for (const std::size_t count : {0U, 1U, 15U, 16U, 17U, 255U, 257U, 2728U, 5417U}) {
        CAPTURE(count);
        const std::vector<Imath::V3d> normals = random.normals(count);
        const FaceLevels levels(normals);
        std::vector<Imath::V3d> directions;
        for (int i = 0; i < 300; ++i) directions.push_back(random.vector());
        onEachTarget([&] {
            for (const Imath::V3d& d : directions) {
                double both = 0;
                double above = 0;
                for (const Imath::V3d& n : normals) {
                    both = std::max(both, std::abs(n.dot(d)));
                    above = std::max(above, n.dot(d));
                }
                CHECK(levels.largest(d) == both);
                CHECK(levels.largestAbove(d) == above);
                std::vector<std::size_t> expected;
                for (std::size_t i = 0; i < normals.size(); ++i) {
                    if (std::abs(normals[i].dot(d)) >= 0.9 * both) expected.push_back(i);
                }
                CHECK(levels.atLeast(0.9 * both, d) == expected);
            }
        });
    }
}

TEST_CASE("the generator to release is the one that looking at each gives") {
    RandomVectors random(32);
    std::vector<Imath::V3d> vectors;
    for (int j = 0; j < 78; ++j) {
        const Imath::V3d v = random.vector() * std::pow(10.0, random(-6, 0));
        vectors.emplace_back(std::abs(v.x), std::abs(v.y), std::abs(v.z));
    }
    vectors[40] = {0, 0, 0};    // a band without light
    vectors[60] = vectors[20];  // a tie: the first wins
    const ReleaseRates rates(vectors);
    onEachTarget([&] {
        RandomVectors trial(33);
        for (int i = 0; i < 2000; ++i) {
            const Imath::V3d gap = trial.vector();
            const Imath::V3d rounding = Imath::V3d(std::abs(gap.x), 0.1, 0) * (i % 4 * 0.2);
            ReleaseRates::Sides sides;
            for (int j = 0; j < 78; ++j) sides.value[std::size_t(j)] = std::round(trial(-1.5, 1.5));
            std::size_t expected = ReleaseRates::kNone;
            double greatest = 0;
            for (std::size_t j = 0; j < vectors.size(); ++j) {
                const double slope = sides.value[j] * gap.dot(vectors[j]);
                if (slope <= rounding.dot(vectors[j])) continue;
                const double rate = slope * slope * (1 / vectors[j].length2());
                if (rate <= greatest) continue;
                greatest = rate;
                expected = j;
            }
            CHECK(rates.fastest(sides, gap, rounding) == expected);
        }
    });
}
