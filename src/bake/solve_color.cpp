#include "solvers.h"

#include <specbake/bake/solve_color.h>
#include <specbake/core/ciede2000.h>
#include <specbake/core/error.h>

#include <cmath>

namespace specbake {
namespace {

XYZ colorOf(const ColorRequest& request, const ColorSpace& space, const Observer& observer) {
    RGB linear;
    for (int i = 0; i < 3; ++i) {
        const double value = request.color[std::size_t(i)];
        if (!std::isfinite(value)) throw ArgumentError("a colour of finite numbers is wanted");
        linear[i] = space.transfer == Transfer::sRGB ? linearFromSRGB(value) : value;
    }
    return XYZ(linear * xyzFromRGB(space, observer.white()));
}

}  // namespace

ColorAnswer solveColor(const ColorRequest& request) {
    const ColorSpace* space = findColorSpace(request.space);
    if (space == nullptr) throw ArgumentError("unknown colour space '" + request.space + "'");
    const Observer observer(request.illuminant.value_or(space->illuminant));
    const MethodSolver solver(request.method, false, observer);
    const Solid& solid = solver.solid();

    ColorAnswer answer;
    answer.illuminant = observer.illuminant();
    answer.asked = colorOf(request, *space, observer);
    answer.gauge = solid.gauge(answer.asked);
    const auto resolved = ColorResolver(solid, solver, request.outside).resolve(answer.asked);
    answer.solution = resolved.solution;
    answer.given = resolved.given;
    answer.outside = resolved.outside;
    answer.difference = ciede2000(labFromXYZ(answer.asked, observer.white()),
                                  labFromXYZ(answer.given, observer.white()));
    return answer;
}

}  // namespace specbake
