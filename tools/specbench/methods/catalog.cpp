#include "catalog.h"

#include "grid_method.h"
#include "max_entropy.h"
#include "methods/published/glassner1989.h"
#include "methods/published/jakob2019_table.h"
#include "methods/published/mallett2019.h"
#include "methods/published/smits1999.h"
#include "nearest_grey.h"
#include "solve/descent/descent.h"
#include "solve/dual_newton.h"
#include "solve/natural/natural.h"
#include "solve/shell.h"
#include "solve/smooth.h"
#include "solver_method.h"

#include <array>
#include <string_view>

namespace specbake::bench {

using namespace internal;

namespace {

template <class M, class... Arguments>
void add(Methods& list, Arguments&&... arguments) {
    list.push_back(std::make_unique<M>(std::forward<Arguments>(arguments)...));
}

/// specbake's default, `natural`; `smooth`, which it stands on; and the Newton iteration of that
/// alone, which fails next to the boundary. `natural` has no votes of the charts that it is shown.
void addOwn(Methods& list, const Frame& frame, const std::vector<int>& grids,
            const std::vector<int>& smoothGrids) {
    const auto smooth = std::make_shared<const ShellSolver>(frame.observer);
    const auto natural = std::make_shared<const NaturalSolver>(
        frame.observer, smooth,
        builtInSetsWithout(std::array<std::string_view, 2>{"SG", "ColorChecker"}));
    add<SolverMethod>(list, MethodName{"natural", "direct"}, frame, natural);
    for (const int nodes : grids) {
        add<GridMethod>(list, MethodName{"natural", ""}, frame, natural, nodes);
    }
    add<SolverMethod>(list, MethodName{"smooth", "direct"}, frame, smooth);
    for (const int nodes : smoothGrids) {
        add<GridMethod>(list, MethodName{"smooth", ""}, frame, smooth, nodes);
    }
    add<SolverMethod>(list, MethodName{"smooth", "Newton alone"}, frame,
                      std::make_shared<const SmoothSolver>(frame.observer));
}

void addDescent(Methods& list, const Frame& frame, const DescentOptions& options,
                const std::vector<int>& grids) {
    const bool closed = options.path == DescentOptions::Path::closedForm;
    const bool random = options.start == DescentOptions::Start::random;
    const bool kept = options.bound == DescentOptions::Bound::kept;
    const MethodName name{"descent", std::string(closed ? "closed form" : "straight") +
                                         (random ? ", random" : ", flat") +
                                         (kept ? "" : ", released")};
    const auto solver = std::make_shared<const DescentSolver>(frame.observer, options);
    add<SolverMethod>(list, name, frame, solver);
    for (const int nodes : grids) add<GridMethod>(list, name, frame, solver, nodes);
}

/// The paper's path and the straight one from both starts, and the paper's with bounds released.
std::vector<DescentOptions> descentSettings() {
    using D = DescentOptions;
    std::vector<D> settings;
    for (const auto path : {D::Path::closedForm, D::Path::straight}) {
        for (const auto start : {D::Start::random, D::Start::flat}) {
            settings.emplace_back();
            settings.back().path = path;
            settings.back().start = start;
        }
    }
    settings.emplace_back().bound = D::Bound::released;
    return settings;
}

void addDualNewton(Methods& list, const Frame& frame) {
    add<SolverMethod>(list, MethodName{"dual Newton", "nearest to Y"}, frame,
                      std::make_shared<const DualNewtonSolver>(frame.observer));
}

}  // namespace

Methods everyMethod(const std::string& data) {
    const Frame frame = sRGBFrame();
    Methods list;
    addOwn(list, frame, {5, 9, 13, 17, 25, 33, 65}, {17});
    for (const DescentOptions& options : descentSettings()) {
        const bool kept = options.bound == DescentOptions::Bound::kept;
        addDescent(list, frame, options, kept ? std::vector{17} : std::vector<int>{});
    }
    addDualNewton(list, frame);
    add<Jakob2019Direct>(list, frame);
    add<Jakob2019Table>(list, frame);
    add<Mallett2019>(list, frame, data + "/mallett2019.csv");
    add<MaxEntropy>(list, frame);
    add<NearestGrey>(list, frame, NearestGrey::Bounds::clipped);
    add<NearestGrey>(list, frame, NearestGrey::Bounds::none);
    add<Smits1999>(list, frame, data + "/smits1999.csv");
    add<Smits1999>(list, smitsFrame(), data + "/smits1999.csv");
    add<Glassner1989>(list, frame, Glassner1989::Functions::fourier);
    add<Glassner1989>(list, frame, Glassner1989::Functions::boxes);
    return list;
}

Methods oneOfEach(const std::string& data) {
    const Frame frame = sRGBFrame();
    Methods list;
    addOwn(list, frame, {}, {});
    for (const DescentOptions& options : descentSettings()) {
        const bool random = options.start == DescentOptions::Start::random;
        const bool paper = options.path == DescentOptions::Path::closedForm;
        if (random == paper) addDescent(list, frame, options, {});
    }
    addDualNewton(list, frame);
    add<Jakob2019Direct>(list, frame);
    add<Mallett2019>(list, frame, data + "/mallett2019.csv");
    add<MaxEntropy>(list, frame);
    add<NearestGrey>(list, frame, NearestGrey::Bounds::clipped);
    add<Smits1999>(list, frame, data + "/smits1999.csv");
    add<Glassner1989>(list, frame, Glassner1989::Functions::fourier);
    return list;
}

}  // namespace specbake::bench
