#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color.h>
#include <specbake/core/spectrum.h>

#include <span>
#include <string_view>

namespace specbake {

/// How a solve went. Failure is a value: a caller looks at `status` before it uses the spectrum.
struct SolveReport {
    enum class Status {
        solved,   ///< W s = t to the solver's tolerance and 0 <= s <= 1
        outside,  ///< the colour is outside the object-colour solid; s is a best effort
        failed    ///< the method did not reach the colour; s is where it stopped
    };
    Status status = Status::failed;
    double residual = 0;    ///< max |W s - t| over X, Y, Z
    int iterations = 0;     ///< Newton steps, or path segments, over all starts
    int starts = 1;         ///< starting points tried
    int hits = 0;           ///< components fixed at 0 or 1 on the way (descent)
    bool fellBack = false;  ///< the method asked for failed, and the shell solved
    bool blended = false;   ///< the shell mixed the solution with the boundary's spectrum
};

/// "solved", "outside", "failed".
SPECBAKE_API std::string_view statusName(SolveReport::Status status);

struct [[nodiscard]] Solution {
    Spectrum spectrum{};
    SolveReport report;
    bool solved() const { return report.status == SolveReport::Status::solved; }
};

/// One colour -> one spectrum, under the observer that the solver was made for.
/// A solver is immutable: any number of threads may share it.
class SPECBAKE_API Solver {
  public:
    virtual ~Solver() = default;
    virtual Solution solve(const XYZ& color) const = 0;

    /// Solves `colors[i]` into `solutions[i]`, to the bits that solve() gives, whatever the other
    /// colours are. As many of the one as of the other. Where a method has a way to solve many
    /// colours at once, this is much faster; some hundreds are enough for it.
    virtual void solveMany(std::span<const XYZ> colors, std::span<Solution> solutions) const;
};

}  // namespace specbake
