#include "colors/random_colors.h"
#include "colors/sets.h"
#include "commands.h"
#include "figures.h"
#include "measures.h"
#include "methods/frame.h"
#include "solve/samples/with_samples.h"
#include "statistics.h"
#include "steepest.h"
#include "tasks.h"

#include <specbake/core/error.h>
#include <specbake/core/methods.h>
#include <specbake/core/upsampler.h>
#include <specbake/core/vector.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace specbake::bench {

namespace {

/// A model that has a spectrum for every colour of the solid.
struct Exhausted {
    std::string method;
    std::string material;  ///< "": none

    std::string name() const { return material.empty() ? method : material; }
    UpsamplerOptions options() const {
        UpsamplerOptions options;
        options.method = method;
        if (!material.empty()) options.material = material;
        return options;
    }
};

const std::array kExhausted = {Exhausted{"smooth", ""}, Exhausted{"natural", ""},
                               Exhausted{"natural", "skin"}};

std::shared_ptr<const Solver> solverOf(const Exhausted& model, const Observer& observer,
                                       const Solid& solid) {
    auto solver = findMethod(model.method)->makeSolver(observer, solid, SolverUse::gridNodes);
    return internal::withSamples(model.options(), observer, std::move(solver)).solver;
}

/// Blue is drawn first: the figures of docs/method.md are those of these colours.
RGB blueFirst(Generator& random, double low, double high) {
    const RGB drawn = uniformRGB(random, low, high);
    return {drawn.z, drawn.y, drawn.x};
}

/// Largest residual and largest step out of [0, 1]; how many colours were not solved.
struct Outcome {
    std::size_t failed = 0;
    double residual = 0;
    double violation = 0;

    void add(const Outcome& other) {
        failed += other.failed;
        residual = std::max(residual, other.residual);
        violation = std::max(violation, other.violation);
    }
};

Outcome solve(const Solver& solver, const Observer& observer, std::span<const XYZ> colors) {
    Outcome outcome;
    std::vector<Solution> solutions(colors.size());
    solver.solveMany(colors, solutions);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const Solution& solution = solutions[i];
        const Imath::V3d miss = observer.color(solution.spectrum) - colors[i];
        outcome.add({.failed = solution.solved() ? 0U : 1U,
                     .residual = largestComponent(miss),
                     .violation = boundsViolation(solution.spectrum)});
    }
    return outcome;
}

/// On all cores; an outcome for each set.
std::vector<Outcome> solveAll(const Solver& solver, const Observer& observer,
                              const std::vector<ColorSet>& sets) {
    constexpr std::size_t slice = 1000;
    std::vector<Task<Outcome>> tasks;
    std::vector<std::size_t> setOfTask;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const std::span<const XYZ> colors = sets[s].colors;
        for (std::size_t i = 0; i < colors.size(); i += slice) {
            const auto some = colors.subspan(i, std::min(slice, colors.size() - i));
            tasks.push_back({sets[s].name,
                             [&solver, &observer, some] { return solve(solver, observer, some); }});
            setOfTask.push_back(s);
        }
    }
    Progress progress("exhaustive, " + observer.illuminant(), tasks.size());
    const std::vector<Outcome> slices = onAllCores(tasks, progress);
    std::vector<Outcome> outcomes(sets.size());
    for (std::size_t i = 0; i < slices.size(); ++i) outcomes[setOfTask[i]].add(slices[i]);
    return outcomes;
}

std::vector<XYZ> uniformInSolid(const Solid& solid, std::size_t count) {
    Generator random(1);
    return firstInSolid(solid, count, [&] { return inBox(solid, blueFirst(random, 0, 1)); });
}

/// From anywhere in the solid towards black, down to a millionth.
std::vector<XYZ> towardsBlack(const Solid& solid, std::size_t count) {
    Generator random(2);
    std::vector<XYZ> colors = uniformInSolid(solid, count);
    for (XYZ& color : colors) color = XYZ(color * std::pow(10.0, -6 * uniform(random, 0, 1)));
    return colors;
}

/// Every 8-bit colour, sRGB-encoded, on the surface of a cube; those that the solid holds.
std::vector<XYZ> surfaceOfCube(const ColorSpace& space, const Observer& observer,
                               const Solid& solid) {
    const Imath::M33d matrix = xyzFromRGB(space, observer.white());
    std::vector<XYZ> colors;
    const auto add = [&](int r, int g, int b) {
        const auto linear = [](int code) { return linearFromSRGB(double(code) / 255); };
        const XYZ color(RGB(linear(r), linear(g), linear(b)) * matrix);
        if (solid.gauge(color) <= 1 + solid.gaugeError()) colors.push_back(color);
    };
    for (int r = 0; r < 256; ++r) {
        for (int g = 0; g < 256; ++g) {
            const bool inside = r > 0 && r < 255 && g > 0 && g < 255;
            for (int b = 0; b < 256; b += inside ? 255 : 1) add(r, g, b);
        }
    }
    return colors;
}

std::vector<ColorSet> setsOf(const Observer& observer, const Solid& solid, std::size_t scale) {
    std::vector<ColorSet> sets;
    const auto add = [&](std::string name, std::vector<XYZ> colors) {
        sets.push_back({.name = std::move(name), .colors = std::move(colors)});
    };
    add("uniform in the solid", uniformInSolid(solid, 10 * scale));
    for (const double gauge : {0.99, 0.999, 0.9999, 0.99999, 0.999999, 1.0}) {
        add(fmt::format("gauge {}", gauge), colorsAtGauge(solid, gauge, scale));
    }
    add("towards black", towardsBlack(solid, scale));
    for (const ColorSpace& space : colorSpaces()) {
        const bool asked =
            space.name == "lin_rec709" || space.name == "lin_rec2020" || space.name == "acescg";
        if (!asked || space.illuminant != observer.illuminant()) continue;
        add("surface of " + space.name, surfaceOfCube(space, observer, solid));
    }
    return sets;
}

/// What a bake gives a linear texel.
Spectrum bakedSpectrum(const Upsampler& upsampler, const RGB& rgb) {
    const Upsampler::Color color = {float(rgb.x), float(rgb.y), float(rgb.z)};
    const std::vector<float> bands = upsampler.sample({&color, 1}, SampleSelection::bands());
    Spectrum spectrum;
    std::ranges::copy(bands, spectrum.begin());
    return spectrum;
}

void addOutcome(Figures& figures, const MethodName& method, const ColorSet& set,
                const Outcome& outcome) {
    fmt::print("{:<12} {:<24} {:>8} colours: {} failed, residual {:.2g}, outside by {:.2g}\n",
               method.full(), set.name, set.colors.size(), outcome.failed, outcome.residual,
               outcome.violation);
    const auto add = [&](const char* quantity, double value, const char* unit) {
        figures.add({set.name, method, quantity, value, unit, {}, ""});
    };
    add("colours", double(set.colors.size()), "1");
    add("failed", double(outcome.failed), "1");
    add("residual max", outcome.residual, "XYZ");
    add("outside [0, 1] max", outcome.violation, "reflectance");
}

struct Pair {
    RGB a, b;
};

struct PairSet {
    const char* name;
    std::vector<Pair> pairs;
};

RGB randomStep(Generator& random, double length) {
    RGB step;
    do {
        step = blueFirst(random, -0.5, 0.5);
    } while (step.length() > 0.5 || step.length() < 0.01);
    return RGB(step * (length / step.length()));
}

bool inCube(const RGB& rgb) {
    return std::min({rgb.x, rgb.y, rgb.z}) >= 0 && std::max({rgb.x, rgb.y, rgb.z}) <= 1;
}

/// Pairs 1e-4 apart: anywhere in the cube, across faces of the grid's cells, across those of the
/// cube.
std::array<PairSet, 3> pairSets(std::size_t count) {
    constexpr double distance = 1e-4;
    constexpr int cells = 16;
    Generator random(3);
    std::array<PairSet, 3> sets = {
        {{"in the sRGB cube", {}}, {"across cells", {}}, {"across the cube's faces", {}}}};
    for (std::size_t i = 0; sets[0].pairs.size() < count; ++i) {
        RGB rgb = blueFirst(random, 0, 1);
        const RGB half = randomStep(random, distance / 2);
        if (!inCube(RGB(rgb - half)) || !inCube(RGB(rgb + half))) continue;
        const auto add = [&](std::size_t set) {
            sets[set].pairs.push_back({RGB(rgb - half), RGB(rgb + half)});
        };
        add(0);
        const int axis = int(i % 3);
        rgb[axis] = std::pow(double(1 + i % (cells - 1)) / cells, 2);
        add(1);
        rgb[axis] = i % 2 == 0 ? 0 : 1;
        add(2);
    }
    return sets;
}

void addContinuity(Figures& figures, const Exhausted& model, std::size_t count) {
    const Frame frame = sRGBFrame();
    const Upsampler upsampler(frame.space, model.options());
    const auto directly = [&](const RGB& rgb) {
        return upsampler.solve(frame.xyz(rgb)).solution.spectrum;
    };
    const auto throughGrid = [&](const RGB& rgb) { return bakedSpectrum(upsampler, rgb); };
    for (const PairSet& set : pairSets(count)) {
        const auto measure = [&](const std::string& way, const auto& spectrumOf) {
            std::vector<double> slopes;
            for (const Pair& pair : set.pairs) {
                slopes.push_back(maxDifference(spectrumOf(pair.a), spectrumOf(pair.b)) /
                                 (pair.a - pair.b).length());
            }
            const double high = quantile(slopes, 0.999);
            const MethodName method{model.name(), way};
            fmt::print("{:<20} {:<24} slope: p99.9 {:.3g}, max {:.3g}\n", method.full(), set.name,
                       high, largest(slopes));
            figures.add({set.name, method, "slope p99.9", high, "reflectance per RGB", {}, ""});
            figures.add(
                {set.name, method, "slope max", largest(slopes), "reflectance per RGB", {}, ""});
        };
        measure("direct", directly);
        measure("grid " + std::to_string(kDefaultGridNodes), throughGrid);
    }
    const auto search = [&](const std::string& way,
                            const std::function<Spectrum(const RGB&)>& spectrumOf) {
        const MethodName method{model.name(), way};
        const auto slopes = steepest(spectrumOf, count / 100);
        for (std::size_t k = 0; k < slopes.size(); ++k) {
            fmt::print("{:<20} steepest found, {:.0e} apart: {:.3g}\n", method.full(),
                       kNarrowing[k], slopes[k]);
            figures.add({"steepest found", method, "slope max", slopes[k], "reflectance per RGB",
                         kNarrowing[k], "RGB"});
        }
    };
    search("direct", directly);
    search("grid " + std::to_string(kDefaultGridNodes), throughGrid);
}

}  // namespace

void runExhaustive(const Options& options) {
    Figures figures("exhaustive", options.commandLine("exhaustive"));
    std::size_t failed = 0;
    struct Eye {
        const char* light;
        const char* functions;
        const char* name;
    };
    for (const auto& [light, functions, illuminant] :
         {Eye{"D65", "2", "D65"}, Eye{"D60", "2", "D60"}, Eye{"E", "2", "E"},
          Eye{"D65", "10", "D65, 10 degree"}, Eye{"E", "10", "E, 10 degree"}}) {
        const Observer observer(light, Quadrature::bands, {}, functions);
        const Solid solid(observer);
        const auto sets = setsOf(observer, solid, options.full ? 100'000 : 10'000);
        for (const Exhausted& model : kExhausted) {
            const auto solver = solverOf(model, observer, solid);
            const std::vector<Outcome> outcomes = solveAll(*solver, observer, sets);
            for (std::size_t s = 0; s < sets.size(); ++s) {
                addOutcome(figures, {model.name(), illuminant}, sets[s], outcomes[s]);
                failed += outcomes[s].failed;
            }
        }
    }
    for (const Exhausted& model : kExhausted) {
        addContinuity(figures, model, options.full ? 100'000 : 20'000);
    }
    figures.write(options.out);
    if (failed > 0) throw Error(fmt::format("{} colours were not solved", failed));
}

}  // namespace specbake::bench
