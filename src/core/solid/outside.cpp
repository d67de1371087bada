#include "solve/solve_list.h"

#include <specbake/core/outside.h>

#include <algorithm>
#include <array>
#include <utility>

namespace specbake {
namespace {

constexpr std::array<std::pair<Outside, std::string_view>, 3> kNames = {
    {{Outside::nearest, "nearest"}, {Outside::scale, "scale"}, {Outside::error, "error"}}};

/// How deep in the cone the colours begin to fade into the nearest ones; see (M17).
constexpr double kRim = 1.0 / 32;

Attainable nearest(const Solid& solid, const XYZ& asked) {
    const Solid::Nearest found = solid.nearest(asked);
    return {found.color, true, found.spectrum};
}

/// (M17), for a colour outside the solid.
Attainable scaled(const Solid& solid, const XYZ& asked) {
    const double share = std::clamp(solid.depthInCone(asked) / kRim, 0.0, 1.0);
    if (share == 0) return nearest(solid, asked);
    const Imath::V3d brightest = asked / std::max(1.0, solid.gaugeFromBlack(asked));
    if (share == 1) return {XYZ(brightest), true, {}};
    return {XYZ(brightest * share + solid.nearest(asked).color * (1 - share)), true, {}};
}

}  // namespace

std::span<const Outside> outsideRules() {
    static constexpr std::array rules = {Outside::nearest, Outside::scale, Outside::error};
    return rules;
}

std::string_view outsideName(Outside rule) {
    for (const auto& [value, name] : kNames) {
        if (value == rule) return name;
    }
    return {};
}

std::optional<Outside> outsideFromName(std::string_view name) {
    for (const auto& [value, known] : kNames) {
        if (known == name) return value;
    }
    return {};
}

Attainable attainable(const Solid& solid, const XYZ& asked, Outside rule) {
    if (solid.contains(asked)) return {asked, false, {}};
    if (rule == Outside::error) return {asked, true, {}};
    return rule == Outside::scale ? scaled(solid, asked) : nearest(solid, asked);
}

ColorResolver::Resolved ColorResolver::resolve(const XYZ& asked) const {
    Resolved resolved;
    resolveMany({&asked, 1}, {&resolved, 1});
    return resolved;
}

void ColorResolver::resolveMany(std::span<const XYZ> asked, std::span<Resolved> resolved) const {
    using enum SolveReport::Status;
    internal::SolveList unsolved;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const Attainable target = attainable(solid_, asked[i], rule_);
        resolved[i] = {{}, target.color, target.outside};
        if (target.outside && rule_ == Outside::error) {
            resolved[i].solution.report.status = outside;
        } else if (target.spectrum) {
            resolved[i].solution.spectrum = *target.spectrum;
            resolved[i].solution.report.status = solved;
        } else {
            unsolved.add(i, target.color);
        }
    }
    unsolved.solve(solver_);
    for (std::size_t k = 0; k < unsolved.size(); ++k) {
        resolved[unsolved.places[k]].solution = unsolved.solutions[k];
    }
}

}  // namespace specbake
