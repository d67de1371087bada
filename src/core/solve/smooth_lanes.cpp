// Compiled once for each instruction set by foreach_target.h; solveInLanes() chooses at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solve/smooth_lanes.cpp"
#include "solve/smooth_lanes.h"

#include "solve/newton_limits.h"

#include <specbake/core/vector.h>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>

#ifdef HWY_TARGET  // after foreach_target.h only: once for each instruction set
#include <hwy/contrib/math/math-inl.h>
#endif

HWY_BEFORE_NAMESPACE();
namespace specbake::internal::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
constexpr Doubles kDoubles;
using Vector = hn::Vec<Doubles>;
constexpr std::size_t kLanes = hn::MaxLanes(kDoubles);
constexpr std::size_t kLast = kBandCount - 1;
constexpr std::size_t kMiddle = kLast / 2;  ///< where the eliminations from both ends meet

/// A number for each lane.
struct alignas(64) Lanes {
    std::array<double, kLanes> value{};

    HWY_INLINE Vector load() const { return hn::Load(kDoubles, value.data()); }
    HWY_INLINE void store(Vector v) { hn::Store(v, kDoubles, value.data()); }
};
using Bands = std::array<Lanes, kBandCount>;

HWY_INLINE Vector constant(double value) {
    return hn::Set(kDoubles, value);
}

/// What a band's equation takes of the three multipliers, and its right side.
struct Row {
    Vector x, y, z, right;

    HWY_INLINE void addMultiple(Vector factor, const Row& other) {
        x = hn::MulAdd(factor, other.x, x);
        y = hn::MulAdd(factor, other.y, y);
        z = hn::MulAdd(factor, other.z, z);
        right = hn::MulAdd(factor, other.right, right);
    }
};

/// Exchanges two rows in the lanes of the mask.
template <class Mask>
HWY_INLINE void exchange(Mask mask, Vector& a, Vector& b) {
    const Vector first = hn::IfThenElse(mask, b, a);
    b = hn::IfThenElse(mask, a, b);
    a = first;
}

/// Four equations, of the middle x and the three multipliers, with their right sides.
using Dense = std::array<std::array<Vector, 5>, 4>;

/// Gauss elimination, each lane with pivots of its own.
HWY_INLINE std::array<Vector, 4> solveDense(Dense rows) {
    for (std::size_t p = 0; p < 4; ++p) {
        for (std::size_t i = p + 1; i < 4; ++i) {
            const auto larger = hn::Gt(hn::Abs(rows[i][p]), hn::Abs(rows[p][p]));
            for (std::size_t c = p; c < 5; ++c) exchange(larger, rows[p][c], rows[i][c]);
        }
        const Vector inverse = hn::Div(constant(1), rows[p][p]);
        for (std::size_t c = p; c < 5; ++c) rows[p][c] = hn::Mul(rows[p][c], inverse);
        for (std::size_t i = 0; i < 4; ++i) {
            if (i == p) continue;
            const Vector factor = rows[i][p];
            for (std::size_t c = p; c < 5; ++c) {
                rows[i][c] = hn::NegMulAdd(factor, rows[p][c], rows[i][c]);
            }
        }
    }
    return {rows[0][4], rows[1][4], rows[2][4], rows[3][4]};
}

/// The iteration of kLanes colours, and their places among all.
class Iteration {
  public:
    Iteration(const LaneModel& model, std::span<const XYZ> colors,
              std::span<const std::size_t> places, std::span<Solution> solutions)
        : model_(model), colors_(colors), places_(places), solutions_(solutions) {}

    void run() {
        for (std::size_t lane = 0; lane < kLanes; ++lane) refill(lane);
        while (busy_ > 0) {
            takeExponentials();
            solveSystem();
            for (std::size_t lane = 0; lane < kLanes; ++lane) look(lane);
            step();
        }
    }

  private:
    /// The next colour, from where its first step leads; if none is left, the lane idles.
    void refill(std::size_t lane) {
        place_[lane] = colors_.size();
        if (next_ == places_.size()) return;
        place_[lane] = places_[next_++];
        const XYZ& color = colors_[place_[lane]];
        const FirstStep::Point start = model_.firstStep.from(color);
        for (std::size_t m = 0; m < kBandCount; ++m) z_[m].value[lane] = start.z[m];
        for (std::size_t c = 0; c < 3; ++c) {
            target_[c].value[lane] = color[int(c)];
            multiplier_[c].value[lane] = start.multipliers[int(c)];
        }
        iterations_[lane] = 1;
        fresh_[lane] = true;
        ++busy_;
    }

    /// s = ½(1 + tanh z), ds/dz, and d²s/dz² / (ds/dz), none with cancellation (smooth.cpp).
    HWY_INLINE void takeExponentials() {
        for (std::size_t m = 0; m < kBandCount; ++m) {
            const Vector z = z_[m].load();
            const Vector held = hn::Min(hn::Abs(z), constant(kHeldAt));
            const Vector e = hn::Exp(kDoubles, hn::Mul(constant(-2), held));
            const Vector larger = hn::Div(constant(1), hn::Add(constant(1), e));
            const Vector smaller = hn::Mul(e, larger);
            const auto negative = hn::Lt(z, hn::Zero(kDoubles));
            const Vector bend = hn::Add(hn::Sub(larger, smaller), hn::Sub(larger, smaller));
            s_[m].store(hn::IfThenElse(negative, smaller, larger));
            slope_[m].store(hn::Mul(hn::Mul(constant(2), larger), smaller));
            bend_[m].store(hn::IfThenElse(negative, bend, hn::Neg(bend)));
        }
    }

    /// Elimination from one end of the spectrum towards the middle.
    struct Arm {
        Row row;
        Vector inversePivot;
    };

    /// What elimination leaves in the three equations of the colour: minus Σ u uᵀ / pivot, which is
    /// symmetric, and the right sides.
    struct Schur {
        Vector xx, xy, xz, yy, yz, zz, x, y, z;

        HWY_INLINE void subtract(const Row& row, Vector inversePivot) {
            const Vector ux = hn::Mul(row.x, inversePivot);
            const Vector uy = hn::Mul(row.y, inversePivot);
            const Vector uz = hn::Mul(row.z, inversePivot);
            xx = hn::NegMulAdd(ux, row.x, xx);
            xy = hn::NegMulAdd(ux, row.y, xy);
            xz = hn::NegMulAdd(ux, row.z, xz);
            yy = hn::NegMulAdd(uy, row.y, yy);
            yz = hn::NegMulAdd(uy, row.z, yz);
            zz = hn::NegMulAdd(uz, row.z, zz);
            x = hn::NegMulAdd(ux, row.right, x);
            y = hn::NegMulAdd(uy, row.right, y);
            z = hn::NegMulAdd(uz, row.right, z);
        }
    };

    /// The gradient of the Lagrangian, and the solution of (M6). Bands are eliminated from both
    /// ends at once, so that neither arm has to wait for the other's divisions:
    ///
    ///     d_m x_m − x_{m+1} + u_m·y = r_m   ⇒   x_m = (r_m + x_{m+1} − u_m·y) / d_m
    ///
    /// goes into the next band's equation and into the three of the colour.
    HWY_INLINE void solveSystem() {
        const Vector zero = hn::Zero(kDoubles);
        for (std::size_t c = 0; c < 3; ++c) sum_[c] = hn::Neg(target_[c].load());
        Vector steepest = zero;
        Schur schur{zero, zero, zero, zero, zero, zero, zero, zero, zero};
        Arm lower{};
        Arm upper{};
        for (std::size_t i = 0; i < kMiddle; ++i) {
            eliminate(i, i == 0, lower, schur, steepest);
            eliminate(kLast - i, i == 0, upper, schur, steepest);
        }
        Vector diagonal;
        Row middle = rowOf(kMiddle, 2, diagonal, steepest);
        for (const Arm& arm : {lower, upper}) {
            middle.addMultiple(arm.inversePivot, arm.row);
            diagonal = hn::Sub(diagonal, arm.inversePivot);
        }
        residual_.store(hn::Max(hn::Abs(sum_[0]), hn::Max(hn::Abs(sum_[1]), hn::Abs(sum_[2]))));
        steepest_.store(steepest);
        const std::array<Vector, 4> x =
            solveDense({{{diagonal, middle.x, middle.y, middle.z, middle.right},
                         {middle.x, schur.xx, schur.xy, schur.xz, hn::Add(sum_[0], schur.x)},
                         {middle.y, schur.xy, schur.yy, schur.yz, hn::Add(sum_[1], schur.y)},
                         {middle.z, schur.xz, schur.yz, schur.zz, hn::Add(sum_[2], schur.z)}}});
        for (std::size_t c = 0; c < 3; ++c) change_[c].store(x[c + 1]);
        substitute(x);
    }

    /// A band's row of (M6), and its diagonal; adds its part to the sums over all bands.
    HWY_INLINE Row rowOf(std::size_t m, double neighbours, Vector& diagonal, Vector& steepest) {
        const Vector ds = slope_[m].load();
        const Imath::V3d& weight = model_.observer.weights()[m];
        const std::array<Vector, 3> w = {constant(weight.x), constant(weight.y),
                                         constant(weight.z)};
        Vector pull = hn::Mul(w[0], multiplier_[0].load());
        pull = hn::MulAdd(w[1], multiplier_[1].load(), pull);
        pull = hn::MulAdd(w[2], multiplier_[2].load(), pull);
        const Vector gradient = hn::MulAdd(ds, pull, stretch(m));
        steepest = hn::Max(steepest, hn::Abs(gradient));
        for (std::size_t c = 0; c < 3; ++c) sum_[c] = hn::MulAdd(w[c], s_[m].load(), sum_[c]);
        diagonal = hn::MulAdd(hn::Mul(bend_[m].load(), ds), pull, constant(neighbours));
        return {hn::Mul(w[0], ds), hn::Mul(w[1], ds), hn::Mul(w[2], ds), gradient};
    }

    HWY_INLINE void eliminate(std::size_t m, bool atEnd, Arm& arm, Schur& schur, Vector& steepest) {
        Vector diagonal;
        Row row = rowOf(m, atEnd ? 1 : 2, diagonal, steepest);
        row.addMultiple(arm.inversePivot, arm.row);
        const Vector pivot = awayFromZero(hn::Sub(diagonal, arm.inversePivot));
        arm = {row, hn::Div(constant(1), pivot)};
        schur.subtract(row, arm.inversePivot);
        inverse_[m].store(arm.inversePivot);
        storeRow(m, row);
    }

    /// From the middle outwards.
    HWY_INLINE void substitute(const std::array<Vector, 4>& solution) {
        Vector longest = hn::Abs(solution[0]);
        Vector lower = solution[0];
        Vector upper = solution[0];
        right_[kMiddle].store(solution[0]);
        for (std::size_t i = kMiddle; i-- > 0;) {
            lower = substituteBand(i, lower, solution);
            upper = substituteBand(kLast - i, upper, solution);
            longest = hn::Max(longest, hn::Max(hn::Abs(lower), hn::Abs(upper)));
        }
        longest_.store(longest);
    }

    HWY_INLINE Vector substituteBand(std::size_t m, Vector inner,
                                     const std::array<Vector, 4>& solution) {
        const Row row = loadRow(m);
        Vector x = hn::NegMulAdd(row.x, solution[1], row.right);
        x = hn::NegMulAdd(row.y, solution[2], x);
        x = hn::NegMulAdd(row.z, solution[3], x);
        x = hn::Mul(hn::Add(x, inner), inverse_[m].load());
        right_[m].store(x);
        return x;
    }

    /// What a lane's colour has come to: solved, hopeless, or to go on.
    void look(std::size_t lane) {
        fresh_[lane] = false;
        if (place_[lane] == colors_.size()) return;
        const XYZ& color = colors_[place_[lane]];
        const bool converged = residual_.value[lane] <= kTolerance * largestComponent(color) &&
                               steepest_.value[lane] <= kSlopeTolerance;
        const bool hopeless =
            iterations_[lane] == kMaxIterations || !std::isfinite(longest_.value[lane]);
        if (!converged && !hopeless) {
            ++iterations_[lane];
            return;
        }
        Solution& solution = solutions_[place_[lane]];
        for (std::size_t m = 0; m < kBandCount; ++m) solution.spectrum[m] = s_[m].value[lane];
        using enum SolveReport::Status;
        solution.report = {converged ? solved : failed, residual_.value[lane], iterations_[lane]};
        --busy_;
        refill(lane);
    }

    /// The damped Newton step of all lanes but those that have just begun.
    HWY_INLINE void step() {
        Lanes begun;
        for (std::size_t lane = 0; lane < kLanes; ++lane) begun.value[lane] = fresh_[lane] ? 0 : 1;
        const Vector damping = hn::Mul(
            begun.load(), hn::Min(constant(1), hn::Div(constant(kLongestStep), longest_.load())));
        const auto moves = hn::Gt(damping, hn::Zero(kDoubles));
        const auto move = [&](Lanes& value, const Lanes& change) {
            const Vector moved = hn::NegMulAdd(damping, change.load(), value.load());
            value.store(hn::IfThenElse(moves, moved, value.load()));
        };
        for (std::size_t m = 0; m < kBandCount; ++m) move(z_[m], right_[m]);
        for (std::size_t c = 0; c < 3; ++c) move(multiplier_[c], change_[c]);
    }

    /// (K z)_m
    HWY_INLINE Vector stretch(std::size_t m) const {
        const Vector z = z_[m].load();
        const Vector toLower = m > 0 ? hn::Sub(z, z_[m - 1].load()) : hn::Zero(kDoubles);
        const Vector toUpper = m < kLast ? hn::Sub(z, z_[m + 1].load()) : hn::Zero(kDoubles);
        return hn::Add(toLower, toUpper);
    }

    static HWY_INLINE Vector awayFromZero(Vector pivot) {
        const auto small = hn::Lt(hn::Abs(pivot), constant(kLeastPivot));
        return hn::IfThenElse(small, hn::CopySign(constant(kLeastPivot), pivot), pivot);
    }

    HWY_INLINE void storeRow(std::size_t m, const Row& row) {
        x_[m].store(row.x);
        y_[m].store(row.y);
        zRow_[m].store(row.z);
        right_[m].store(row.right);
    }
    HWY_INLINE Row loadRow(std::size_t m) const {
        return {x_[m].load(), y_[m].load(), zRow_[m].load(), right_[m].load()};
    }

    const LaneModel& model_;
    std::span<const XYZ> colors_;
    std::span<const std::size_t> places_;
    std::span<Solution> solutions_;
    std::size_t next_ = 0;  ///< in places_: the first that no lane has taken
    int busy_ = 0;
    std::array<std::size_t, kLanes> place_{};  ///< of each lane's colour; beyond all: it idles
    std::array<int, kLanes> iterations_{};
    std::array<bool, kLanes> fresh_{};
    Bands z_, s_, slope_, bend_, inverse_, x_, y_, zRow_, right_;
    std::array<Lanes, 3> multiplier_, target_, change_;
    std::array<Vector, 3> sum_;  ///< W s - t, while it is added up
    Lanes residual_, steepest_, longest_;
};

void solveColors(const LaneModel& model, std::span<const XYZ> colors,
                 std::span<const std::size_t> places, std::span<Solution> solutions) {
    Iteration(model, colors, places, solutions).run();
}

}  // namespace
}  // namespace specbake::internal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace specbake::internal {
namespace {
HWY_EXPORT(solveColors);
}  // namespace

void solveInLanes(const LaneModel& model, std::span<const XYZ> colors,
                  std::span<const std::size_t> places, std::span<Solution> solutions) {
    HWY_DYNAMIC_DISPATCH(solveColors)(model, colors, places, solutions);
}

}  // namespace specbake::internal
#endif
