#include "solvers.h"

#include <specbake/core/descent.h>
#include <specbake/core/smooth.h>

namespace specbake {

std::string_view methodName(Method method) {
    return method == Method::smooth ? "smooth" : "descent";
}

std::unique_ptr<Solver> makeSolver(const BakeOptions& options, const Observer& observer,
                                   const Solid&) {
    if (options.method == Method::smooth) return std::make_unique<SmoothSolver>(observer);
    DescentOptions descent;
    descent.start = options.perTexel ? DescentOptions::Start::random : DescentOptions::Start::flat;
    return std::make_unique<DescentSolver>(observer, descent);
}

}  // namespace specbake
