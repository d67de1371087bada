#pragma once

#include <specbake/core/observer.h>

#include <Imath/ImathVec.h>

#include <array>
#include <bitset>
#include <memory>
#include <vector>

namespace specbake::internal {

/// A set of generators; also a vertex of the solid, the sum of the set.
using GeneratorSet = std::bitset<kBandCount>;

/// A pair of generators, the normal n of its two parallelograms, and the generators on each side.
struct SidePair {
    int first = 0, second = 0;  ///< ordered so that n = w_first x w_second has n_Z > 0
    Imath::V3d normal;          ///< unit length, each component within 4 roundings of its value
    GeneratorSet above;         ///< j with n.w_j > 0: those with s_j = 1 in (13)
    GeneratorSet below;         ///< all others: those with s_j = 1 on the other parallelogram
};

/// The combinatorics of the object-colour solid (paper, section 3).
///
/// The bands' vectors w_m are merged where they are parallel; each group is one generator of the
/// zonohedron, the sum of its bands. Of the sum over the bands an illuminant multiplies each vector
/// by a positive factor, so that parallelism and the sign of each n.w_j follow from the printed
/// table alone. They are decided in integers: a component is below 2^35, a triple determinant below
/// 2^108. A table of more than ten decimals is rounded to these first (matching.h), and the
/// decisions are exact for what it is then. The weights of the fine quadrature are themselves
/// integers of a unit (observer.h); bands that weigh nothing belong to no generator.
///
/// Three generators of one plane, n.w_j = 0, do not occur in the CIE's tables; in one that was
/// interpolated they do. They are put to a side as if the vectors were moved by as little as it
/// takes (generators.cpp), so that their parallelograms tile the plane's face.
struct Generators {
    std::vector<std::vector<int>> bands;  ///< the bands of each generator, ascending
    /// By band; of bands that weigh nothing, that of the one before, or of the first that does.
    std::array<std::size_t, kBandCount> ofBand{};
    std::vector<int> red;         ///< the generators with Z = 0, by ascending angle in the XY plane
    std::vector<bool> isRed;      ///< by generator
    std::vector<SidePair> sides;  ///< every pair that is not red and red: they span the bases
    std::vector<int> sideOfPair;  ///< index into `sides` at pairIndex(), else -1

    int count() const { return int(bands.size()); }

    std::size_t pairIndex(int first, int second) const {
        return std::size_t(first) * bands.size() + std::size_t(second);
    }

    /// The unit normal of the plane of two generators, up to its sign.
    Imath::V3d normal(int first, int second) const {
        const int side = sideOfPair[pairIndex(first, second)];
        return side < 0 ? Imath::V3d(0, 0, 1) : sides[std::size_t(side)].normal;
    }
};

/// Of an observer. That of the sum over the bands by the usual table, the same under every light,
/// is made once.
std::shared_ptr<const Generators> generatorsOf(const Observer& observer);

}  // namespace specbake::internal
