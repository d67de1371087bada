#include <specbake/core/outside.h>

#include <array>
#include <cmath>
#include <utility>

namespace specbake {
namespace {

constexpr std::array<std::pair<Outside, std::string_view>, 3> kNames = {
    {{Outside::nearest, "nearest"}, {Outside::scale, "scale"}, {Outside::error, "error"}}};

/// The largest k in (0, 1) for which k·color lies in the solid; nothing if only k = 0 does.
/// The gauge is convex along the ray and 1 at black, so it is below 1 on one interval (0, k).
std::optional<double> largestScale(const Solid& solid, const XYZ& color) {
    double inside = 1e-6 / color.length();
    if (!(solid.gauge(XYZ(color * inside)) < 1)) return {};
    double outside = 1;
    while (true) {
        const double middle = 0.5 * (inside + outside);
        if (middle <= inside || middle >= outside) return inside;  // neighbours among the doubles
        (solid.contains(XYZ(color * middle)) ? inside : outside) = middle;
    }
}

Attainable nearest(const Solid& solid, const XYZ& asked) {
    const Solid::Nearest found = solid.nearest(asked);
    return {found.color, true, found.spectrum};
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
    if (rule == Outside::scale) {
        if (const auto k = largestScale(solid, asked)) return {XYZ(asked * *k), true, {}};
    }
    return nearest(solid, asked);
}

ColorResolver::Resolved ColorResolver::resolve(const XYZ& asked) const {
    using enum SolveReport::Status;
    const Attainable target = attainable(solid_, asked, rule_);
    Resolved resolved{{}, target.color, target.outside};
    if (target.outside && rule_ == Outside::error) {
        resolved.solution.report.status = outside;
    } else if (target.spectrum) {
        resolved.solution.spectrum = *target.spectrum;
        resolved.solution.report.status = solved;
    } else {
        resolved.solution = solver_.solve(target.color);
    }
    return resolved;
}

}  // namespace specbake
