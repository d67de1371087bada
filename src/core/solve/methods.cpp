#include "solve/descent/descent_method.h"
#include "solve/natural/natural.h"
#include "solve/shell.h"

#include <specbake/core/methods.h>

#include <algorithm>
#include <array>

namespace specbake {

using namespace internal;

namespace {

std::shared_ptr<const Solver> makeSmooth(const Observer& observer, const Solid& solid,
                                         SolverUse /*use*/) {
    return std::make_shared<const ShellSolver>(observer, solid);
}

std::shared_ptr<const Solver> makeNatural(const Observer& observer, const Solid& solid,
                                          SolverUse use) {
    return std::make_shared<const NaturalSolver>(observer, makeSmooth(observer, solid, use));
}

constexpr std::array kMethods = {
    Method{"natural", "the smoothest spectrum, moved towards measured surfaces", makeNatural},
    Method{"smooth", "the smoothest spectrum", makeSmooth},
    Method{"descent", "steepest descent in the box", internal::makeDescent},
};

}  // namespace

std::span<const Method> methods() {
    return kMethods;
}

const Method* findMethod(std::string_view name) {
    const auto found = std::find_if(kMethods.begin(), kMethods.end(),
                                    [&](const Method& method) { return method.name == name; });
    return found == kMethods.end() ? nullptr : &*found;
}

}  // namespace specbake
