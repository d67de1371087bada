#include "solid/from_black.h"

#include "solid/generators.h"

#include <algorithm>
#include <limits>

namespace specbake::internal {
namespace {

/// H = Σ n·w_j over the generators that are 1 on the face: 0 exactly if there are none, and a sum
/// of positive terms, so that a face that all but touches black has its distance to a few
/// roundings.
double distanceFromBlack(const std::vector<Imath::V3d>& vectors, const GeneratorSet& ones,
                         const Imath::V3d& outward) {
    double distance = 0;
    for (std::size_t j = 0; j < vectors.size(); ++j) {
        if (ones[j]) distance += std::max(0.0, outward.dot(vectors[j]));
    }
    return distance;
}

}  // namespace

FromBlack::FromBlack(const Generators& generators, const std::vector<Imath::V3d>& vectors) {
    std::vector<Imath::V3d> caps;
    GeneratorSet lit;
    double blue = 0;
    for (std::size_t j = 0; j < vectors.size(); ++j) {
        lit[j] = vectors[j].length2() > 0;
        blue += vectors[j].z;
    }
    const auto add = [&](const GeneratorSet& ones, const Imath::V3d& outward) {
        const double distance = distanceFromBlack(vectors, ones & lit, outward);
        if (distance == 0) {
            cone_.push_back(outward);
        } else {
            caps.push_back(outward / distance);
        }
    };
    for (const SidePair& side : generators.sides) {
        if (!lit[std::size_t(side.first)] || !lit[std::size_t(side.second)]) continue;
        add(side.above, side.normal);
        add(side.below, -side.normal);
    }
    cone_.emplace_back(0, 0, -1);  // the base at Z = 0, whose generators are all in its plane
    if (blue > 0) caps.emplace_back(0, 0, 1 / blue);
    caps_ = FaceLevels(caps);
}

double FromBlack::gauge(const Imath::V3d& t) const {
    return caps_.largestAbove(t);
}

double FromBlack::depth(const Imath::V3d& t) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Imath::V3d& n : cone_) least = std::min(least, -n.dot(t));
    return least / t.length();
}

}  // namespace specbake::internal
