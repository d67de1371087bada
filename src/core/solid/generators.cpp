#include "solid/generators.h"

#include "color/matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace specbake::internal {
namespace {

__extension__ using Exact = __int128;
using ExactVector = std::array<Exact, 3>;

/// The bands' vectors, each up to a positive factor.
using BandVectors = std::vector<ExactVector>;

BandVectors tableVectors(const tables::BandMatching& table) {
    BandVectors vectors;
    for (const auto& row : table) vectors.push_back({row[0], row[1], row[2]});
    return vectors;
}

BandVectors weightVectors(const Observer& observer) {
    BandVectors vectors;
    for (const Imath::V3d& w : observer.weights()) {
        const Imath::V3d whole = w / Observer::kWeightUnit;
        vectors.push_back({Exact(whole.x), Exact(whole.y), Exact(whole.z)});
    }
    return vectors;
}

ExactVector cross(const ExactVector& a, const ExactVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Exact dot(const ExactVector& a, const ExactVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool parallel(const ExactVector& a, const ExactVector& b) {
    return cross(a, b) == ExactVector{};
}

std::vector<std::vector<int>> mergeParallelBands(const BandVectors& bandVectors) {
    std::vector<std::vector<int>> groups;
    for (int band = 0; band < kBandCount; ++band) {
        const ExactVector& vector = bandVectors[std::size_t(band)];
        if (vector == ExactVector{}) continue;
        const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) {
            return parallel(bandVectors[std::size_t(g.front())], vector);
        });
        if (group == groups.end()) {
            groups.push_back({band});
        } else {
            group->push_back(band);
        }
    }
    return groups;
}

std::array<std::size_t, kBandCount> generatorsOfBands(const std::vector<std::vector<int>>& groups) {
    std::array<std::size_t, kBandCount> ofBand;
    ofBand.fill(groups.size());
    for (std::size_t j = 0; j < groups.size(); ++j) {
        for (const int band : groups[j]) ofBand[std::size_t(band)] = j;
    }
    std::size_t before = 0;  // the first group is that of the first band with weight
    for (std::size_t& generator : ofBand) {
        if (generator == groups.size()) generator = before;
        before = generator;
    }
    return ofBand;
}

/// On which side of the plane of a pair a third vector lies that is in it, as if every vector that
/// is not red, v_j, were v_j + ε^(j+1) (0, 0, 1) with an ε as small as it must be: the sign is that
/// of the first of its terms, in which one vector stands replaced by (0, 0, 1). As the plane is not
/// that of the red ones, no term is 0; of the three vectors one at the most is red.
bool isAbove(const std::vector<ExactVector>& vectors, int first, int second, int third) {
    const auto at = [&](int j) -> const ExactVector& { return vectors[std::size_t(j)]; };
    int moved = int(vectors.size());
    for (const int j : {first, second, third}) {
        if (at(j)[2] != 0) moved = std::min(moved, j);
    }
    if (moved == first) return cross(at(second), at(third))[2] > 0;
    if (moved == second) return cross(at(third), at(first))[2] > 0;
    return cross(at(first), at(second))[2] > 0;
}

Imath::V3d rounded(const ExactVector& v) {
    return {double(v[0]), double(v[1]), double(v[2])};
}

/// n·v, exact in its sign: of most vectors it follows from doubles.
class Plane {
  public:
    explicit Plane(const ExactVector& normal) : exact_(normal), normal_(rounded(normal)) {}

    /// `v`: the same as a vector of doubles, which the bands' are.
    int sideOf(const ExactVector& vector, const Imath::V3d& v) const {
        // n is rounded once, each product once, the sum twice: 4 roundings of what is added.
        constexpr double error = 4 * std::numeric_limits<double>::epsilon();
        const double x = normal_.x * v.x;
        const double y = normal_.y * v.y;
        const double z = normal_.z * v.z;
        const double sum = x + y + z;
        const double doubt = error * (std::abs(x) + std::abs(y) + std::abs(z));
        if (std::abs(sum) > doubt) return sum > 0 ? 1 : -1;
        const Exact distance = dot(exact_, vector);
        return distance > 0 ? 1 : distance < 0 ? -1 : 0;
    }

  private:
    ExactVector exact_;
    Imath::V3d normal_;
};

SidePair sidePair(const std::vector<ExactVector>& vectors, const std::vector<Imath::V3d>& asDoubles,
                  int first, int second) {
    ExactVector n = cross(vectors[std::size_t(first)], vectors[std::size_t(second)]);
    if (n[2] < 0) {
        std::swap(first, second);
        n = {-n[0], -n[1], -n[2]};
    }
    const Plane plane(n);
    SidePair side{first, second, rounded(n).normalized(), {}, {}};
    for (int j = 0; j < int(vectors.size()); ++j) {
        if (j == first || j == second) continue;
        const int of = plane.sideOf(vectors[std::size_t(j)], asDoubles[std::size_t(j)]);
        const bool above = of == 0 ? isAbove(vectors, first, second, j) : of > 0;
        (above ? side.above : side.below)[std::size_t(j)] = true;
    }
    return side;
}

std::vector<int> redByAngle(const std::vector<ExactVector>& vectors) {
    std::vector<int> red;
    for (std::size_t j = 0; j < vectors.size(); ++j) {
        if (vectors[j][2] == 0) red.push_back(int(j));
    }
    // No component is negative: all of them lie within a quarter turn, where the cross product's
    // sign is an order.
    std::sort(red.begin(), red.end(), [&](int a, int b) {
        return cross(vectors[std::size_t(a)], vectors[std::size_t(b)])[2] > 0;
    });
    return red;
}

Generators makeGenerators(const BandVectors& bandVectors) {
    Generators result;
    result.bands = mergeParallelBands(bandVectors);
    result.ofBand = generatorsOfBands(result.bands);
    std::vector<ExactVector> vectors;
    for (const auto& bands : result.bands) {
        vectors.push_back(bandVectors[std::size_t(bands.front())]);
    }
    std::vector<Imath::V3d> asDoubles;
    for (const ExactVector& v : vectors) asDoubles.push_back(rounded(v));
    const int count = result.count();
    result.red = redByAngle(vectors);
    result.isRed.assign(vectors.size(), false);
    for (const int j : result.red) result.isRed[std::size_t(j)] = true;
    result.sideOfPair.assign(vectors.size() * vectors.size(), -1);
    for (int m = 0; m < count; ++m) {
        for (int k = m + 1; k < count; ++k) {
            if (result.isRed[std::size_t(m)] && result.isRed[std::size_t(k)]) continue;
            const int index = int(result.sides.size());
            result.sideOfPair[result.pairIndex(m, k)] = index;
            result.sideOfPair[result.pairIndex(k, m)] = index;
            result.sides.push_back(sidePair(vectors, asDoubles, m, k));
        }
    }
    return result;
}

}  // namespace

std::shared_ptr<const Generators> generatorsOf(const Observer& observer) {
    if (observer.quadrature() == Quadrature::fine) {
        return std::make_shared<const Generators>(makeGenerators(weightVectors(observer)));
    }
    static const auto ofUsual =
        std::make_shared<const Generators>(makeGenerators(tableVectors(tables::colorMatching)));
    if (observer.functions() == kUsualObserver) return ofUsual;
    const auto matching = matchingNamed(observer.functions());
    return std::make_shared<const Generators>(makeGenerators(tableVectors(matching->bands)));
}

}  // namespace specbake::internal
