/// solve_bench: how fast colours are solved, one thread. Many at once in the processor's lanes
/// beside the scalar solver that the tests compare with, for each instruction set that is there;
/// and what colours near and beyond the boundary of the object-colour solid cost. Prints tables,
/// Markdown.
///
/// The two ways take turns, so that what else the machine does falls on both alike, and a ratio is
/// the median over rounds. Times are the thread's own.
#include "colors/random_colors.h"
#include "colors/sets.h"
#include "solve/shell.h"
#include "solve/smooth.h"
#include "statistics.h"

#include <specbake/core/outside.h>

#include <fmt/format.h>
#include <hwy/highway.h>

#include <ctime>
#include <exception>
#include <functional>
#include <vector>

namespace specbake::bench {

using namespace internal;

namespace {

constexpr int kRounds = 9;
constexpr std::size_t kColors = 2000;

/// Microseconds of processor time a colour.
double timeOf(std::size_t colors, const std::function<void()>& work) {
    timespec from{};
    timespec to{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &from);
    work();
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &to);
    const double seconds =
        double(to.tv_sec - from.tv_sec) + 1e-9 * double(to.tv_nsec - from.tv_nsec);
    return 1e6 * seconds / double(colors);
}

std::vector<XYZ> cubeColors(const Observer& observer, double top) {
    const Imath::M33d matrix = xyzFromRGB(*findColorSpace("lin_rec709"), observer.white());
    Generator random(1);
    std::vector<XYZ> colors;
    while (colors.size() < kColors) colors.emplace_back(uniformRGB(random, 0, top) * matrix);
    return colors;
}

std::vector<XYZ> gridNodes(const Observer& observer) {
    const Imath::M33d matrix = xyzFromRGB(*findColorSpace("lin_rec709"), observer.white());
    std::vector<XYZ> colors;
    const auto at = [](int i) { return double(i * i) / 256; };
    for (int i = 0; i < 17; ++i) {
        for (int j = 0; j < 17; ++j) {
            for (int k = 0; k < 17; ++k) colors.emplace_back(RGB(at(i), at(j), at(k)) * matrix);
        }
    }
    return colors;
}

/// Of the cube of ACEScg's primaries: the colours that no reflectance has.
std::vector<XYZ> outsideACEScg(const Observer& observer, const Solid& solid) {
    const Imath::M33d matrix = xyzFromRGB(*findColorSpace("acescg"), observer.white());
    Generator random(2);
    std::vector<XYZ> colors;
    while (colors.size() < kColors) {
        const XYZ color(uniformRGB(random, 0, 1) * matrix);
        if (!solid.contains(color)) colors.push_back(color);
    }
    return colors;
}

struct Pair {
    std::vector<double> scalar, lanes;

    double ratio() const {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < scalar.size(); ++i) ratios.push_back(scalar[i] / lanes[i]);
        return median(std::move(ratios));
    }
};

Pair measure(const Observer& observer, const std::vector<XYZ>& colors) {
    const SmoothSolver lanes(observer);
    const ScalarSmoothSolver scalar(observer);
    std::vector<Solution> solutions(colors.size());
    Pair pair;
    for (int round = 0; round < kRounds; ++round) {
        pair.scalar.push_back(timeOf(colors.size(), [&] { scalar.solveMany(colors, solutions); }));
        pair.lanes.push_back(timeOf(colors.size(), [&] { lanes.solveMany(colors, solutions); }));
    }
    return pair;
}

void compareTargets(const Observer& observer, const std::vector<ColorSet>& sets) {
    fmt::print("| solving, µs a colour | scalar |");
    const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    for (const std::int64_t target : targets) fmt::print(" {} | ratio |", hwy::TargetName(target));
    fmt::print("\n|---|---|");
    for (std::size_t i = 0; i < targets.size(); ++i) fmt::print("---|---|");
    for (const ColorSet& set : sets) {
        std::string cells;
        std::vector<double> scalar;
        for (const std::int64_t target : targets) {
            hwy::SetSupportedTargetsForTest(target);
            hwy::GetChosenTarget().DeInit();
            const Pair pair = measure(observer, set.colors);
            scalar.insert(scalar.end(), pair.scalar.begin(), pair.scalar.end());
            cells += fmt::format(" {:.2f} | {:.1f} |", median(pair.lanes), pair.ratio());
        }
        fmt::print("\n| {} | {:.2f} |{}", set.name, median(scalar), cells);
    }
    fmt::print("\n");
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().DeInit();
}

/// The median over rounds, after one that does not count.
double medianTime(std::size_t colors, const std::function<void()>& work) {
    std::vector<double> times;
    work();
    for (int round = 0; round < kRounds; ++round) times.push_back(timeOf(colors, work));
    return median(std::move(times));
}

void nearBoundary(const Observer& observer, const Solid& solid, const std::vector<ColorSet>& sets) {
    const ShellSolver solver(observer, solid);
    fmt::print("\n| µs a colour | gauge | boundary | nearest | `nearest` | `scale` |\n");
    fmt::print("|---|---|---|---|---|---|\n");
    for (const ColorSet& set : sets) {
        const std::size_t count = set.colors.size();
        double sum = 0;  // of something, so that nothing is left out
        const auto each = [&](const auto& part) {
            return medianTime(count, [&] {
                for (const XYZ& color : set.colors) sum += part(color);
            });
        };
        const auto whole = [&](Outside rule) {
            const ColorResolver resolver(solid, solver, rule);
            std::vector<ColorResolver::Resolved> resolved(count);
            return medianTime(count, [&] { resolver.resolveMany(set.colors, resolved); });
        };
        const double gauge = each([&](const XYZ& c) { return solid.gauge(c); });
        const double boundary = each([&](const XYZ& c) { return solid.boundary(c).spectrum[0]; });
        const double nearest = each([&](const XYZ& c) { return solid.nearest(c).distance; });
        fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.2f} | {:.2f} |\n", set.name, gauge,
                   boundary, nearest, whole(Outside::nearest), whole(Outside::scale));
        if (sum < 0) fmt::print("\n");
    }
}

void run() {
    const Observer observer("D65");
    const Solid solid(observer);
    const auto at = [&](double gauge) { return colorsAtGauge(solid, gauge, kColors); };
    compareTargets(observer, {{"nodes of 17³", gridNodes(observer)},
                              {"sRGB cube", cubeColors(observer, 1)},
                              {"dark, below 0.05", cubeColors(observer, 0.05)},
                              {"gauge 0.99", at(0.99)}});
    nearBoundary(observer, solid,
                 {{"gauge 0.9999", at(0.9999)},
                  {"gauge 1.00001", at(1.00001)},
                  {"gauge 1.2", at(1.2)},
                  {"gauge 10", at(10)},
                  {"ACEScg cube, outside", outsideACEScg(observer, solid)}});
}

}  // namespace
}  // namespace specbake::bench

int main() try {
    specbake::bench::run();
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
}
