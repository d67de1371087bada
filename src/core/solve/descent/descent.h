#pragma once

#include <specbake/core/observer.h>
#include <specbake/core/solver.h>

namespace specbake::internal {

struct DescentOptions {
    /// How to go towards the solution within a face of the box. Both have the same limit.
    enum class Path {
        closedForm,  ///< the gradient flow itself, (17)-(19)
        straight     ///< the line to the flow's limit: cheaper, and it fails less (docs/descent.md)
    };
    enum class Start {
        random,  ///< uniform in the box, as the paper has it
        flat     ///< first the constant Y, so that greys are flat; random after that
    };
    /// What becomes of a component that has reached a bound.
    enum class Bound {
        kept,     ///< it stays there for the rest of the start, as the paper has it
        released  ///< a start that is stuck frees what the gradient pushes inward, and goes on
    };
    Path path = Path::closedForm;
    Bound bound = Bound::kept;
    Start start = Start::random;
    int maxStarts = 100;      ///< at least 1
    double tolerance = 1e-9;  ///< of max |W s - t|; > 0. Results are usually at rounding, 1e-15.
};

/// The paper's method (its section 4): from a start in the box, descend along the gradient flow of
/// |W s - t|^2; a component that reaches 0 or 1 stays there; where fewer than three are left, or
/// those left do not reach the colour, another start is tried.
///
/// Random starts come from the colour's bits alone, so equal colours have equal spectra, bit for
/// bit, whatever was solved before and by whichever thread. A spectrum never leaves [0, 1].
/// Colours outside the solid, and those that are not finite, have status `failed`: this solver
/// does not know the solid.
class DescentSolver : public Solver {
  public:
    /// Throws ArgumentError for options outside their ranges.
    explicit DescentSolver(const Observer& observer, const DescentOptions& options = {});

    /// The report's `iterations` are the segments of the path over all starts, its `hits` the
    /// components fixed in the start that is returned: of those that failed, the nearest.
    Solution solve(const XYZ& color) const override;

    /// One descent from a given spectrum, clamped to [0, 1] (a neighbour's solution, say): near
    /// colours then get near spectra. No other start is tried.
    Solution solveFrom(const XYZ& color, const Spectrum& start) const;

  private:
    Spectrum startPoint(const XYZ& color, int number) const;

    Observer observer_;
    DescentOptions options_;
};

}  // namespace specbake::internal
