#include "solid/generators.h"

#include "color/tables.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace specbake::internal {
namespace {

__extension__ using Exact = __int128;
using ExactVector = std::array<Exact, 3>;

/// The bands' vectors, each up to a positive factor.
using BandVectors = std::vector<ExactVector>;

BandVectors tableVectors() {
    BandVectors vectors;
    for (const auto& row : tables::colorMatching) vectors.push_back({row[0], row[1], row[2]});
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

Imath::V3d unit(const ExactVector& n) {
    return Imath::V3d(double(n[0]), double(n[1]), double(n[2])).normalized();
}

SidePair sidePair(const std::vector<ExactVector>& vectors, int first, int second) {
    ExactVector n = cross(vectors[std::size_t(first)], vectors[std::size_t(second)]);
    if (n[2] < 0) {
        std::swap(first, second);
        n = {-n[0], -n[1], -n[2]};
    }
    SidePair side{first, second, unit(n), {}, {}};
    for (std::size_t j = 0; j < vectors.size(); ++j) {
        side.above[j] = dot(n, vectors[j]) > 0;
        side.below[j] = dot(n, vectors[j]) < 0;
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
            result.sides.push_back(sidePair(vectors, m, k));
        }
    }
    return result;
}

}  // namespace

std::shared_ptr<const Generators> generatorsOf(const Observer& observer) {
    if (observer.quadrature() == Quadrature::fine) {
        return std::make_shared<const Generators>(makeGenerators(weightVectors(observer)));
    }
    static const auto ofTable = std::make_shared<const Generators>(makeGenerators(tableVectors()));
    return ofTable;
}

}  // namespace specbake::internal
