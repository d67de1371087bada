#pragma once

#include <specbake/bake/bake.h>
#include <specbake/core/descent.h>
#include <specbake/core/shell.h>

#include <optional>
#include <string_view>

namespace specbake {

std::string_view methodName(Method method);

/// The solver of a bake: the method asked for, and the shell (which never fails inside the solid)
/// where that method does. A report says so by `fellBack`.
class MethodSolver : public Solver {
  public:
    /// For the nodes of a grid descent starts `flat`, which is continuous, and releases bounds,
    /// which does not fail (docs/descent.md); texel by texel it is the paper's own, with random
    /// starts and bounds kept.
    MethodSolver(Method method, bool perTexel, const Observer& observer);

    Solution solve(const XYZ& color) const override;

    const Solid& solid() const { return shell_.solid(); }

  private:
    ShellSolver shell_;
    std::optional<DescentSolver> descent_;
};

}  // namespace specbake
