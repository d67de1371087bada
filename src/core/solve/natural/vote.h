#pragma once

#include "solve/natural/kernel.h"
#include "solve/natural/measured_set.h"

#include <specbake/core/observer.h>
#include <specbake/core/solver.h>

#include <Imath/ImathVec.h>

#include <vector>

namespace specbake::internal {

/// What measured samples say that a solver misses.
///
/// Sample k has the reflectance s_k and, under the observer, the colour t_k at the place p_k
/// (place.h). What the solver misses there, b_k = s_k − s(t_k), is a metameric black: W b_k = 0. At
/// a colour of the place p, set j has the mass and the mean
///
///     K_k = exp(−|p − p_k|² / 2h²),   m_j = Σ K_k,   b_j = Σ K_k b_k / m_j
///
/// Its vote counts q_j = m_j/(m_j + e), less than 1 however large the set. With
///
///     Q = Σ q_j,   b̄ = Σ q_j b_j / Q,   V = Σ q_j |b_j − b̄|² / Q
///
/// the vote is believed as far as there are sets and as they agree, V/Q being the variance of the
/// mean of Q votes:
///
///     v = φ · Q/(Q + ½) · |b̄|² / (|b̄|² + c V/Q) · b̄                             (M14)
///
/// φ fades the vote towards the greys, which are to stay flat, and towards black, where equal
/// distances in CIELAB are short ones in XYZ:
///
///     φ = C²/(C² + 2²) · L*²/(L*² + 10²),   C = √(p_2² + p_3²)
///
/// W v = 0, and v is continuous: every quotient has a positive denominator where v is not 0.
///
/// h, c, e, κ and φ were chosen with `specbench nature`, each set judged by the votes of the
/// others.
class Vote {
  public:
    static constexpr double kWidth = 3;         ///< h
    static constexpr double kDoubt = 0.1;       ///< c
    static constexpr double kHalfVote = 0.5;    ///< e: the mass at which a set has half its vote
    static constexpr double kHalfBelief = 0.5;  ///< Q at which half is believed

    /// `solver` is the observer's. Samples that it does not solve are left out.
    Vote(const Observer& observer, const Solver& solver, const std::vector<MeasuredSet>& sets);

    /// v. `color` is finite. About 2 µs.
    Spectrum at(const XYZ& color) const;

  private:
    /// Places apart from spectra: all of them are looked at, of few of these.
    struct Blacks {
        Places places;                      ///< p_k
        std::vector<Spectrum> differences;  ///< b_k
    };
    struct LocalMean {
        double vote = 0;  ///< q_j
        Spectrum mean{};  ///< b_j
    };
    static LocalMean localMean(const Blacks& set, const Imath::V3d& place, Near& near);

    XYZ white_;
    std::vector<Blacks> sets_;
};

}  // namespace specbake::internal
