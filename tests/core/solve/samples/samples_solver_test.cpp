#include "solve/samples/samples_solver.h"

#include "solve/natural/measured_set.h"
#include "solve/natural/natural.h"
#include "solve/samples/distinct_samples.h"
#include "solve/shell.h"
#include "support/solid_samples.h"

#include <specbake/core/ciede2000.h>
#include <specbake/core/color_space.h>
#include <specbake/core/vector.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

using namespace specbake;
using namespace specbake::internal;
using namespace specbake::testing;

namespace {

std::vector<MeasuredSample> samplesOf(std::string_view set) {
    const auto& sets = builtInSets();
    return std::ranges::find_if(sets, [&](const MeasuredSet& s) { return s.name == set; })->samples;
}

/// A user's chart on top of the smooth method.
struct Bench {
    explicit Bench(const std::string& light, std::string_view set = "DuPont")
        : observer(light),
          smooth(std::make_shared<const ShellSolver>(observer)),
          samples(distinctSamples(observer, samplesOf(set)).samples),
          solver(observer, smooth, samples) {}

    const Solid& solid() const { return smooth->solid(); }
    XYZ atGauge(Random& random, double gauge) const {
        const XYZ boundary = random.onBoundary(observer, solid());
        return XYZ(solid().center() + (boundary - solid().center()) * gauge);
    }
    Spectrum spectrum(const XYZ& color) const { return solver.solve(color).spectrum; }

    Observer observer;
    std::shared_ptr<const ShellSolver> smooth;
    std::vector<MeasuredSample> samples;
    SamplesSolver solver;
};

/// What the mean difference under A becomes if each sample in turn is rebuilt by the others.
double leaveOneOut(const Bench& bench, const FieldShape& shape) {
    const Observer lamp("A");
    const auto lab = [&](const Spectrum& s) { return labFromXYZ(lamp.color(s), lamp.white()); };
    double sum = 0;
    for (std::size_t k = 0; k < bench.samples.size(); ++k) {
        std::vector<MeasuredSample> others = bench.samples;
        others.erase(others.begin() + std::ptrdiff_t(k));
        const SamplesSolver solver(bench.observer, bench.smooth, others, shape);
        const Spectrum& sample = bench.samples[k].reflectance;
        const Spectrum rebuilt = solver.solve(bench.observer.color(sample)).spectrum;
        sum += ciede2000(lab(rebuilt), lab(sample));
    }
    return sum / double(bench.samples.size());
}

}  // namespace

TEST_CASE("at a sample's colour the spectrum is the sample, under any light, on any method") {
    for (const char* light : {"D65", "A", "F11"}) {
        CAPTURE(light);
        for (const char* set : {"DuPont", "objects", "skin"}) {
            const Bench bench(light, set);
            const auto natural =
                std::make_shared<const NaturalSolver>(bench.observer, bench.smooth);
            const SamplesSolver onNatural(bench.observer, natural, bench.samples);
            for (const MeasuredSample& sample : bench.samples) {
                const XYZ color = bench.observer.color(sample.reflectance);
                // Coefficients and values are of the order of 1; Φ's condition is below 10⁵ for
                // places 0.1 apart.
                CHECK(maxDifference(bench.spectrum(color), sample.reflectance) <= 1e-9);
                CHECK(maxDifference(onNatural.solve(color).spectrum, sample.reflectance) <= 1e-9);
            }
        }
    }
}

TEST_CASE("every colour of the solid is exact and bounded: 20,000, under four lights") {
    for (const char* light : {"D65", "A", "F11", "E"}) {
        CAPTURE(light);
        const Bench bench(light, "AMPAS");
        Random random(71);
        for (int i = 0; i < 5000; ++i) {
            const double scale = i % 3 == 0 ? std::pow(10.0, random(-9, 0)) : 1;
            const XYZ color(bench.atGauge(random, 1 - std::pow(10.0, random(-7, 0))) * scale);
            const Solution solution = bench.solver.solve(color);
            CAPTURE(color);
            REQUIRE(solution.solved());
            REQUIRE(withinBounds(solution.spectrum));
            // natural_test.cpp, and the sum of as many blacks as there are samples, of 2e-12 each
            // and with coefficients of the order of 1.
            const double residual =
                largestComponent(bench.observer.color(solution.spectrum) - color);
            REQUIRE(residual <= 1e-10);
            REQUIRE(std::abs(solution.report.residual - residual) <=
                    2 * sumRounding(bench.solid()));
        }
    }
}

TEST_CASE("about a sample spectra lean towards it, far from all samples they are the base's") {
    const Bench bench("D65");
    const MeasuredSample sample = samplesOf("objects").at(3);
    const SamplesSolver solver(bench.observer, bench.smooth, {sample});
    const XYZ color = bench.observer.color(sample.reflectance);
    double before = 0;
    for (const double away : {0.0, 0.05, 0.1, 0.2, 0.4}) {
        const XYZ t(color * (1 - away) + XYZ(bench.observer.white() * 0.5) * away);
        const Spectrum base = bench.smooth->solve(t).spectrum;
        const double lean = maxDifference(solver.solve(t).spectrum, base);
        CAPTURE(away);
        CHECK((away == 0 || lean < before));
        CHECK(lean > 0);
        before = lean;
    }
    const auto matrix = xyzFromRGB(*findColorSpace("lin_rec709"), bench.observer.white());
    const XYZ blue(RGB(0.02, 0.05, 0.9) * matrix);
    CHECK(maxDifference(solver.solve(blue).spectrum, bench.smooth->solve(blue).spectrum) <= 1e-3);
}

TEST_CASE("white is 1 and black 0, whatever the samples") {
    std::vector<MeasuredSample> samples = samplesOf("SG");  // with its white and its black
    for (const char* light : {"D65", "A"}) {
        const Observer observer(light);
        const auto smooth = std::make_shared<const ShellSolver>(observer);
        const SamplesSolver solver(observer, smooth, distinctSamples(observer, samples).samples);
        CHECK(solver.solve(observer.white()).spectrum == constantSpectrum(1));
        CHECK(solver.solve(XYZ(0, 0, 0)).spectrum == constantSpectrum(0));
    }
}

TEST_CASE("halving a segment towards its greater change ends at no jump, with samples too") {
    const Bench bench("D65", "objects");
    Random random(72);
    for (int i = 0; i < 300; ++i) {
        XYZ a = i % 3 == 0 ? bench.observer.color(bench.samples[std::size_t(i / 3)].reflectance)
                           : bench.atGauge(random, random(0, 0.98));
        XYZ b = i % 2 == 0 ? bench.atGauge(random, random(0, 0.98)) : XYZ(a * random(0.9, 1.0));
        Spectrum atA = bench.spectrum(a), atB = bench.spectrum(b);
        while ((b - a).length() > 1e-9) {
            const XYZ middle((a + b) * 0.5);
            const Spectrum between = bench.spectrum(middle);
            const bool first = maxDifference(atA, between) > maxDifference(between, atB);
            (first ? b : a) = middle;
            (first ? atB : atA) = between;
        }
        // Twice the steepest slope that was met.
        CHECK(maxDifference(atA, atB) <= 2 * 100 * 1e-9 + 1e-10);
    }
}

TEST_CASE("samples of one colour are averaged, and the remark names them") {
    const Observer observer("D65");
    const ShellSolver smooth(observer);
    MeasuredSample one = samplesOf("objects").at(20);
    const Spectrum solved = smooth.solve(observer.color(one.reflectance)).spectrum;
    const MeasuredSample other{"a metamer", solved, ""};
    const auto rest = samplesOf("DuPont");
    std::vector<MeasuredSample> samples{rest.at(0), one, rest.at(1), other};
    const DistinctSamples distinct = distinctSamples(observer, samples);
    REQUIRE(distinct.samples.size() == 3);
    Spectrum mean;
    for (std::size_t m = 0; m < mean.size(); ++m) {
        mean[m] = (one.reflectance[m] + solved[m]) / 2;
    }
    CHECK(maxDifference(distinct.samples[1].reflectance, mean) <= 0x1p-53);
    CHECK(distinct.samples[0] == rest.at(0));
    CHECK(distinct.samples[2] == rest.at(1));
    REQUIRE(distinct.notes.size() == 1);
    CHECK(distinct.notes[0].find("'" + one.name + "', 'a metamer'") != std::string::npos);
    samples.pop_back();
    CHECK(distinctSamples(observer, samples).notes.empty());
}

TEST_CASE("the shape is the one that rebuilds samples best by the others") {
    Bench bench("D65", "ColorChecker");
    const ShapeChoice choice = chooseShape(bench.observer, *bench.smooth, bench.samples);
    CHECK(choice.samples == bench.samples.size());
    CHECK(choice.light == "A");
    CHECK(std::abs(choice.difference - leaveOneOut(bench, choice.shape)) <= 1e-9);
    for (const FieldShape& other :
         {FieldShape{}, FieldShape{4, 0}, FieldShape{32, 0}, FieldShape{16, 1}}) {
        CHECK(choice.difference <= leaveOneOut(bench, other) + 1e-9);
    }
    CHECK(choice.difference < choice.without);
    const Observer lamp("A");
    CHECK(chooseShape(lamp, ShellSolver(lamp), bench.samples).light == "D65");
}

TEST_CASE("one sample alone, and two that are one, can be left out as well") {
    const Observer observer("D65");
    const ShellSolver smooth(observer);
    const std::vector<MeasuredSample> one{samplesOf("CES").at(4)};
    const ShapeChoice choice = chooseShape(observer, smooth, one);
    CHECK(choice.samples == 1);
    CHECK(choice.difference == doctest::Approx(choice.without));
    CHECK(choice.shape.range == FieldShape{}.range);
    CHECK(chooseShape(observer, smooth, {}).samples == 0);
}
