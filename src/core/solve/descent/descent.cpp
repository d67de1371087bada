#include "solve/descent/descent.h"

#include "solve/descent/face_path.h"
#include "solve/descent/random_start.h"
#include "solve/polish.h"

#include <specbake/core/error.h>
#include <specbake/core/vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace specbake::internal {
namespace {

/// The share of the residual that a release has to have gained for another one: colours outside
/// the solid would approach its nearest point for ever.
constexpr double kLeastGain = 1e-6;

/// One descent from one start.
class Descent {
  public:
    Descent(const Observer& observer, const XYZ& color, const Spectrum& start,
            const DescentOptions& options)
        : observer_(observer), color_(color), options_(options), s_(start) {
        residual_ = observer_.color(s_) - color_;
    }

    template <class Path>
    Solution run() {
        while (!(largestComponent(residual_) <= options_.tolerance) &&
               (advance<Path>() || release())) {
            ++segments_;
        }
        SolveReport report;
        report.iterations = segments_;
        report.hits = int(s_.size() - free_.size());
        report.residual = largestComponent(residual_);
        if (report.residual <= options_.tolerance) {
            report.status = SolveReport::Status::solved;
            report.residual = polish(observer_, color_, s_);
        }
        return {s_, report};
    }

  private:
    /// One segment of the path, up to the next hit or to the limit. False where the start has
    /// failed: too few components are left, or the limit is not nearer to the colour.
    template <class Path>
    bool advance() {
        if (free_.size() < fewest()) return false;
        const Path path(observer_.weights(), free_, s_, residual_);
        if (fixOutward(path)) return true;
        const std::optional<Hit> hit = path.firstHit();
        moveAlong(path, hit ? hit->time : path.end());
        if (hit) {
            s_[hit->band] = hit->bound;
            free_.removeIf([&](std::size_t m) { return m == hit->band; });
        }
        const double before = largestComponent(residual_);
        residual_ = observer_.color(s_) - color_;
        return hit || largestComponent(residual_) <= before / 2;
    }

    /// The paper gives up below three components. Fewer may still do where others can be freed.
    std::size_t fewest() const { return options_.bound == DescentOptions::Bound::kept ? 3 : 1; }

    /// Where the start is stuck: frees the components at a bound that the gradient pushes inward.
    /// False where too little was gained since the last time, and where bounds are kept.
    bool release() {
        if (options_.bound == DescentOptions::Bound::kept) return false;
        if (!(residual_.length() < (1 - kLeastGain) * residualAtRelease_)) return false;
        residualAtRelease_ = residual_.length();
        free_ = FreeSet();
        free_.removeIf([&](std::size_t m) {
            const double v = -observer_.weights()[m].dot(residual_);
            return (s_[m] == 0 && v <= 0) || (s_[m] == 1 && v >= 0);
        });
        return true;
    }

    /// Fixes the components that are at a bound and would leave the box at once.
    template <class Path>
    bool fixOutward(const Path& path) {
        const std::size_t before = free_.size();
        free_.removeIf([&](std::size_t m) {
            const double v = path.velocity(m);
            return (s_[m] == 0 && v < 0) || (s_[m] == 1 && v > 0);
        });
        return free_.size() < before;
    }

    /// The bounds are kept exactly, against rounding.
    template <class Path>
    void moveAlong(const Path& path, double time) {
        Spectrum next = s_;
        for (const std::size_t m : free_) next[m] = std::clamp(path.value(m, time), 0.0, 1.0);
        s_ = next;
    }

    const Observer& observer_;
    const XYZ& color_;
    const DescentOptions& options_;
    Spectrum s_;
    FreeSet free_;
    Imath::V3d residual_;
    double residualAtRelease_ = std::numeric_limits<double>::infinity();
    int segments_ = 0;
};

Solution descend(const Observer& observer, const XYZ& color, const Spectrum& start,
                 const DescentOptions& options) {
    Descent descent(observer, color, start, options);
    return options.path == DescentOptions::Path::closedForm ? descent.run<FlowPath>()
                                                            : descent.run<StraightPath>();
}

bool isFinite(const XYZ& color) {
    return std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z);
}

/// What there is to say of a colour that is not one.
Solution noSolution() {
    Solution none;
    none.report.residual = std::numeric_limits<double>::infinity();
    return none;
}

}  // namespace

DescentSolver::DescentSolver(const Observer& observer, const DescentOptions& options)
    : observer_(observer), options_(options) {
    if (options.maxStarts < 1) throw ArgumentError("descent: maxStarts must be at least 1");
    if (!(options.tolerance > 0)) throw ArgumentError("descent: the tolerance must be above 0");
}

Solution DescentSolver::solve(const XYZ& color) const {
    Solution best = noSolution();
    if (!isFinite(color)) return best;
    int segments = 0;
    int start = 0;
    while (start < options_.maxStarts && !best.solved()) {
        Solution next = descend(observer_, color, startPoint(color, start++), options_);
        segments += next.report.iterations;
        if (next.solved() || next.report.residual < best.report.residual) best = next;
    }
    best.report.starts = start;
    best.report.iterations = segments;
    return best;
}

Solution DescentSolver::solveFrom(const XYZ& color, const Spectrum& start) const {
    if (!isFinite(color)) return noSolution();
    Spectrum inBox = start;
    for (double& value : inBox) value = std::clamp(value, 0.0, 1.0);
    return descend(observer_, color, inBox, options_);
}

Spectrum DescentSolver::startPoint(const XYZ& color, int number) const {
    if (number == 0 && options_.start == DescentOptions::Start::flat) {
        return constantSpectrum(std::clamp(color.y, 0.0, 1.0));
    }
    return randomStart(color, number);
}

}  // namespace specbake::internal
