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
    ActiveSet(const std::vector<Imath::V3d>& vectors, const XYZ& target,
              const GeneratorValues& vertex)
        : w_(vectors), target_(target), values_(vertex) {}

    GeneratorValues solve();

  private:
    static constexpr int kNone = -1;
    using Steps = std::array<double, 3>;

    Imath::V3d gap() const;
    int mostViolating(const Imath::V3d& gap) const;
    bool leastSquares(const Imath::V3d& gap, Steps& steps) const;
    void moveFree();
    bool moveUntilHit(const Steps& steps);

    const std::vector<Imath::V3d>& w_;
    Imath::V3d target_;
    GeneratorValues values_{};  ///< exactly 0 or 1 where not free
    std::vector<int> free_;
    GeneratorSet blocked_;  ///< freed without any progress since the last one
};

/// t − W s. Near the boundary it is small beside its terms, and its direction decides between faces
/// that are parallel to 1e-7: hence the compensated sum (A. Neumaier, ZAMM 54, 1974).
Imath::V3d ActiveSet::gap() const {
    Imath::V3d sum = target_;
    Imath::V3d lost(0.0);
    for (std::size_t j = 0; j < w_.size(); ++j) {
        if (values_[j] == 0) continue;
        for (int i = 0; i < 3; ++i) {
            const double term = -values_[j] * w_[j][i];
            const double next = sum[i] + term;
            lost[i] += std::abs(sum[i]) >= std::abs(term) ? (sum[i] - next) + term
                                                          : (term - next) + sum[i];
            sum[i] = next;
        }
    }
    return sum + lost;
}

/// The component at a bound whose release lessens the distance at the greatest rate, beyond doubt:
/// by more than the rounding of gap·w_j, and of gap itself, where the free s_j w_j are rounded.
int ActiveSet::mostViolating(const Imath::V3d& gap) const {
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    Imath::V3d rounding(0.0);
    for (const int j : free_) rounding += u * w_[std::size_t(j)];
    for (int i = 0; i < 3; ++i) rounding[i] += 8 * u * std::abs(gap[i]);
    int worst = kNone;
    double greatest = 0;
    for (std::size_t j = 0; j < w_.size(); ++j) {
        if (std::find(free_.begin(), free_.end(), int(j)) != free_.end()) continue;
        const double slope = values_[j] == 0 ? gap.dot(w_[j]) : -gap.dot(w_[j]);
        if (slope <= rounding.dot(w_[j]) || blocked_[j]) continue;
        const double rate = slope * slope / w_[j].length2();
        if (rate <= greatest) continue;
        greatest = rate;
        worst = int(j);
    }
    return worst;
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
        const Imath::V3d n = generators().normal(free_[0], free_[1]);
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
    if (fraction > 0) blocked_.reset();
    if (hit == free_.size()) return false;
    if (fraction == 0) blocked_[std::size_t(free_[hit])] = true;
    free_.erase(free_.begin() + std::ptrdiff_t(hit));
    return true;
}

/// Moves to the nearest point within the free components' face of the box.
void ActiveSet::moveFree() {
    while (!free_.empty()) {
        Steps steps{};
        if (!leastSquares(gap(), steps)) {
            blocked_[std::size_t(free_.back())] = true;
            free_.pop_back();
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
        const int next = mostViolating(gap());
        if (next == kNone) break;
        free_.push_back(next);
        moveFree();
    }
    return values_;
}

/// A point of the base whose generators with Z > 0 are all at `bound`; but not black or white, the
/// one corner that has a single spectrum to keep exactly.
bool onBase(const GeneratorValues& values, double bound) {
    const Generators& g = generators();
    bool corner = true;
    for (std::size_t j = 0; j < g.bands.size(); ++j) {
        if (values[j] == bound) continue;
        if (!g.isRed[j]) return false;
        corner = false;
    }
    return !corner;
}

/// Of the vertex beside the exit point and the one that is farthest in the colour's direction, the
/// nearer to the colour: the first is good for colours near the solid, the second far from it.
GeneratorValues startVertex(const std::vector<Imath::V3d>& vectors, const XYZ& color,
                            const Imath::V3d& fromCenter, const GeneratorValues& exit) {
    GeneratorValues beside{};
    GeneratorValues farthest{};
    for (std::size_t j = 0; j < vectors.size(); ++j) {
        beside[j] = std::round(exit[j]);
        farthest[j] = vectors[j].dot(fromCenter) > 0 ? 1 : 0;
    }
    const auto distance2 = [&](const GeneratorValues& values) {
        return (color - colorOf(vectors, values)).length2();
    };
    return distance2(beside) < distance2(farthest) ? beside : farthest;
}

}  // namespace

Solid::Nearest Solid::nearest(const XYZ& color) const {
    const Imath::V3d d = color - data_->center;
    const double r = data_->faces.largest(d);
    if (r <= 1) return {color, 0, std::nullopt};
    GeneratorValues values = data_->onBoundary(XYZ(data_->center + d / r)).values;
    if (r > 1 + data_->gaugeError) {
        values =
            ActiveSet(data_->vectors, color, startVertex(data_->vectors, color, d, values)).solve();
    }
    const XYZ reached(colorOf(data_->vectors, values));
    if (onBase(values, 1)) {
        values = data_->onTopBase(reached).values;
    } else if (onBase(values, 0)) {
        values = opposite(data_->onTopBase(XYZ(data_->white - reached)).values);
    }
    const XYZ point(colorOf(data_->vectors, values));
    return {point, (color - point).length(), Data::expand(values)};
}

}  // namespace specbake
