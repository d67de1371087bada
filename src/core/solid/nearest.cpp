// The point of the solid nearest to a colour outside: min ‖W s − t‖² over 0 <= s <= 1 by an active
// set, after P. B. Stark and R. L. Parker, "Bounded-variable least-squares: an algorithm and
// applications", Computational Statistics 10, 1995. At most three components are free at a time, so
// each step is a closed form. The squared distance falls with each step, which is why it ends.
#include "solid/solid_data.h"

#include <specbake/core/solid.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace specbake {

using namespace internal;

namespace {

class ActiveSet {
  public:
    /// Starts from a vertex, best one that is near already.
    ActiveSet(const Generators& generators, const std::vector<Imath::V3d>& vectors,
              const ReleaseRates& rates, const Vertex& vertex)
        : generators_(generators), w_(vectors), rates_(rates), fixedGap_(vertex.gap) {
        for (std::size_t j = 0; j < w_.size(); ++j) {
            values_[j] = vertex.ones[j] ? 1 : 0;
            sides_.value[j] = vertex.ones[j] ? -1 : 1;
        }
    }

    GeneratorValues solve();

  private:
    using Steps = std::array<double, 3>;

    Imath::V3d gap() const;
    std::size_t mostViolating(const Imath::V3d& gap) const;
    void release(std::size_t j);
    void fix(std::size_t place, bool block);
    void unblock();
    bool leastSquares(const Imath::V3d& gap, Steps& steps) const;
    void moveFree();
    bool moveUntilHit(const Steps& steps);

    const Generators& generators_;
    const std::vector<Imath::V3d>& w_;
    const ReleaseRates& rates_;
    GeneratorValues values_{};  ///< exactly 0 or 1 where not free
    ExactSum fixedGap_;         ///< t − Σ w_j over those fixed at 1
    std::vector<int> free_;
    std::vector<std::size_t> blocked_;  ///< freed without any progress since the last one
    ReleaseRates::Sides sides_;         ///< 0 for those that are free or blocked
};

/// t − W s. Near the boundary it is small beside its terms, and its direction decides between faces
/// that are parallel to 1e-7: hence the sum without roundings, but those of the free s_j w_j.
Imath::V3d ActiveSet::gap() const {
    ExactSum sum = fixedGap_;
    for (const int j : free_) sum.add(-values_[std::size_t(j)] * w_[std::size_t(j)]);
    return sum.rounded();
}

/// The component at a bound whose release lessens the distance at the greatest rate, beyond doubt:
/// by more than the rounding of gap·w_j, and of gap itself, where the free s_j w_j are rounded.
std::size_t ActiveSet::mostViolating(const Imath::V3d& gap) const {
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    Imath::V3d rounding(0.0);
    for (const int j : free_) rounding += u * w_[std::size_t(j)];
    for (int i = 0; i < 3; ++i) rounding[i] += 8 * u * std::abs(gap[i]);
    return rates_.fastest(sides_, gap, rounding);
}

void ActiveSet::release(std::size_t j) {
    if (values_[j] == 1) fixedGap_.add(w_[j]);
    sides_.value[j] = 0;
    free_.push_back(int(j));
}

/// Of the free components, one that is at a bound.
void ActiveSet::fix(std::size_t place, bool block) {
    const auto j = std::size_t(free_[place]);
    if (values_[j] == 1) fixedGap_.add(-w_[j]);
    sides_.value[j] = values_[j] == 0 ? 1 : -1;
    if (block) {
        sides_.value[j] = 0;
        blocked_.push_back(j);
    }
    free_.erase(free_.begin() + std::ptrdiff_t(place));
}

void ActiveSet::unblock() {
    for (const std::size_t j : blocked_) sides_.value[j] = values_[j] == 0 ? 1 : -1;
    blocked_.clear();
}

/// The steps of the free components to the nearest point of their plane, or false where they do not
/// span one (three reds).
bool ActiveSet::leastSquares(const Imath::V3d& gap, Steps& steps) const {
    const auto vector = [&](std::size_t i) { return w_[std::size_t(free_[i])]; };
    Imath::V3d rest = gap;
    if (free_.size() == 3) {
        const Imath::V3d plane = vector(1).cross(vector(2));
        const double det = vector(0).dot(plane);
        constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
        if (std::abs(det) <= rounding * vector(0).length() * plane.length()) return false;
        steps[2] = gap.dot(vector(0).cross(vector(1))) / det;
        rest -= steps[2] * vector(2);
    }
    if (free_.size() >= 2) {
        const Imath::V3d n = generators_.normal(free_[0], free_[1]);
        steps[1] = vector(0).cross(rest).dot(n) / vector(0).cross(vector(1)).dot(n);
        rest -= steps[1] * vector(1);
    }
    steps[0] = rest.dot(vector(0)) / vector(0).length2();
    return true;
}

/// Takes the steps as far as the box allows. True if a bound stopped them; what reached it is
/// fixed.
bool ActiveSet::moveUntilHit(const Steps& steps) {
    double fraction = 1;
    std::size_t hit = free_.size();
    for (std::size_t i = 0; i < free_.size(); ++i) {
        const double s = values_[std::size_t(free_[i])];
        const double room = steps[i] > 0 ? 1 - s : s;
        if (steps[i] == 0 || std::abs(steps[i]) * fraction < room) continue;
        fraction = room / std::abs(steps[i]);
        hit = i;
    }
    for (std::size_t i = 0; i < free_.size(); ++i) {
        double& s = values_[std::size_t(free_[i])];
        s = i == hit ? (steps[i] > 0 ? 1 : 0) : std::clamp(s + fraction * steps[i], 0.0, 1.0);
    }
    if (fraction > 0) unblock();
    if (hit == free_.size()) return false;
    fix(hit, fraction == 0);
    return true;
}

/// Moves to the nearest point within the free components' face of the box.
void ActiveSet::moveFree() {
    while (!free_.empty()) {
        Steps steps{};
        if (!leastSquares(gap(), steps)) {
            fix(free_.size() - 1, true);
            return;
        }
        if (!moveUntilHit(steps)) return;
    }
}

GeneratorValues ActiveSet::solve() {
    // Each round ends at another face of the box, nearer than all before; some 20 are usual. The
    // limit only cuts off a walk among faces that are equally near to rounding.
    constexpr int limit = 20 * kBandCount;
    for (int round = 0; round < limit && free_.size() < 3; ++round) {
        const std::size_t next = mostViolating(gap());
        if (next == ReleaseRates::kNone) break;
        release(next);
        moveFree();
    }
    return values_;
}

/// A point of the base whose generators with Z > 0 are all at `bound`; but not black or white, the
/// one corner that has a single spectrum to keep exactly.
bool onBase(const Generators& g, const GeneratorValues& values, double bound) {
    bool corner = true;
    for (std::size_t j = 0; j < g.bands.size(); ++j) {
        if (values[j] == bound) continue;
        if (!g.isRed[j]) return false;
        corner = false;
    }
    return !corner;
}

/// The vertex that is farthest in a direction.
Vertex farthest(const std::vector<Imath::V3d>& vectors, const XYZ& color,
                const Imath::V3d& direction) {
    Vertex vertex{{}, ExactSum(color)};
    for (std::size_t j = 0; j < vectors.size(); ++j) {
        if (!(vectors[j].dot(direction) > 0)) continue;
        vertex.ones[j] = true;
        vertex.gap.add(-vectors[j]);
    }
    return vertex;
}

}  // namespace

/// The corner of a face at which its two generators are 0, or, on the other side of the centre, 1.
Vertex Solid::Data::corner(std::size_t face, bool otherSide, const XYZ& color) const {
    const SidePair& side = generators->sides[face];
    Vertex vertex{side.above, ExactSum(color)};
    if (!otherSide) {
        vertex.gap.subtract(corners()[face]);
        return vertex;
    }
    for (std::size_t j = 0; j < vectors.size(); ++j) vertex.ones[j] = !side.above[j];
    vertex.gap.subtract(all);
    vertex.gap.add(corners()[face]);
    return vertex;
}

/// A vertex to start from. The exit point's face is good for colours near the solid, the vertex
/// farthest in the colour's direction for those far from it.
Vertex Solid::Data::near(const XYZ& color, double gauge) const {
    constexpr double far = 2;
    const Imath::V3d d = color - center;
    const std::size_t face = faces.atLeast(gauge, d).front();
    if (gauge > far || face == generators->sides.size()) return farthest(vectors, color, d);
    return corner(face, faces.level(face, d) < 0, color);
}

Solid::Nearest Solid::nearest(const XYZ& color) const {
    const Imath::V3d d = color - data_->center;
    const double r = data_->faces.largest(d);
    if (r <= 1) return {color, 0, std::nullopt};
    GeneratorValues values =
        r > 1 + data_->gaugeError
            ? ActiveSet(*data_->generators, data_->vectors, data_->rates, data_->near(color, r))
                  .solve()
            : data_->onBoundary(XYZ(data_->center + d / r)).values;
    XYZ point(colorOf(data_->vectors, values));
    const bool onTop = onBase(*data_->generators, values, 1);
    if (onTop || onBase(*data_->generators, values, 0)) {
        values = onTop ? data_->onTopBase(point).values
                       : opposite(data_->onTopBase(XYZ(data_->white - point)).values);
        point = XYZ(colorOf(data_->vectors, values));
    }
    return {point, (color - point).length(), data_->expand(values)};
}

}  // namespace specbake
