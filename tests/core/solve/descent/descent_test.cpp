#include "solve/descent/descent.h"

#include "solve/descent/random_start.h"
#include "support/sample_colors.h"

#include <specbake/core/error.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace specbake;
using namespace specbake::internal;

namespace {

using Options = DescentOptions;

std::vector<XYZ> sampleColors(const Observer& observer, unsigned seed, int count) {
    testing::SampleColors colors(observer, seed);
    std::vector<XYZ> list;
    for (int i = 0; i < count; ++i) {
        list.push_back(colors.sRGB());
        list.push_back(colors.sRGB(0.05));
        for (const double gauge : {0.9, 0.99, 0.999}) list.push_back(colors.atGauge(gauge));
    }
    return list;
}

std::vector<Options> allOptions() {
    std::vector<Options> list;
    for (const auto path : {Options::Path::closedForm, Options::Path::straight}) {
        for (const auto bound : {Options::Bound::kept, Options::Bound::released}) {
            for (const auto start : {Options::Start::random, Options::Start::flat}) {
                Options options;
                options.path = path;
                options.bound = bound;
                options.start = start;
                options.maxStarts = 10;
                list.push_back(options);
            }
        }
    }
    return list;
}

double largest(const Imath::V3d& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

TEST_CASE("what counts as solved has the colour, and every spectrum is within the bounds") {
    const Observer observer("D65");
    const auto colors = sampleColors(observer, 1, 20);
    for (const Options& options : allOptions()) {
        const DescentSolver solver(observer, options);
        for (const XYZ& color : colors) {
            const Solution solution = solver.solve(color);
            CHECK(boundsViolation(solution.spectrum) == 0);
            const double residual = largest(observer.color(solution.spectrum) - color);
            CHECK(residual == solution.report.residual);
            CHECK(solution.solved() == (residual <= options.tolerance));
            CHECK(solution.report.starts <= options.maxStarts);
        }
    }
}

TEST_CASE("100 starts are enough for every sRGB colour, and one where bounds are released") {
    const Observer observer("D65");
    testing::SampleColors colors(observer, 2);
    for (const auto path : {Options::Path::closedForm, Options::Path::straight}) {
        Options options;
        options.path = path;
        const DescentSolver kept(observer, options);
        options.bound = Options::Bound::released;
        options.maxStarts = 1;
        const DescentSolver released(observer, options);
        for (int i = 0; i < 100; ++i) {
            CHECK(kept.solve(colors.sRGB()).solved());
            CHECK(kept.solve(colors.sRGB(0.05)).solved());
            for (const double gauge : {0.99, 0.999, 0.99999, 1.0}) {
                CAPTURE(gauge);
                CHECK(released.solve(colors.atGauge(gauge)).solved());
            }
        }
    }
}

TEST_CASE("a colour has one spectrum, bit for bit, whatever was solved before") {
    const Observer observer("E");
    auto colors = sampleColors(observer, 3, 10);
    const DescentSolver solver(observer);
    std::vector<Spectrum> forwards;
    for (const XYZ& color : colors) forwards.push_back(solver.solve(color).spectrum);
    const DescentSolver another(observer);
    for (std::size_t i = colors.size(); i-- > 0;) {
        CHECK(another.solve(colors[i]).spectrum == forwards[i]);
    }
}

TEST_CASE("random starts: in [0, 1), uniform, their own for each colour and number") {
    std::set<double> first;
    double sum = 0, squares = 0;
    const int colors = 1000;
    for (int i = 0; i < colors; ++i) {
        const XYZ color(0.2, 0.2 + i * 0x1p-52, 0.2);  // neighbours by one bit
        for (const int number : {0, 1}) {
            const Spectrum s = randomStart(color, number);
            first.insert(s[0]);
            for (const double value : s) {
                REQUIRE((value >= 0 && value < 1));
                sum += value;
                squares += value * value;
            }
        }
    }
    CHECK(first.size() == 2 * colors);
    // Mean 1/2 and mean square 1/3 within 5 standard deviations, sqrt(1/12) and sqrt(4/45) a draw.
    const double draws = 2.0 * colors * kBandCount;
    CHECK(std::abs(sum / draws - 1.0 / 2) < 5 * std::sqrt(1.0 / 12 / draws));
    CHECK(std::abs(squares / draws - 1.0 / 3) < 5 * std::sqrt(4.0 / 45 / draws));
    CHECK(randomStart(XYZ(0.0, 0.1, 0.2), 0) == randomStart(XYZ(-0.0, 0.1, 0.2), 0));
    CHECK(randomStart(XYZ(0.1, 0.2, 0.3), 0) != randomStart(XYZ(0.3, 0.2, 0.1), 0));
}

TEST_CASE("greys from a flat start are flat, white and black included") {
    for (const char* illuminant : {"E", "D65", "F11"}) {
        const Observer observer(illuminant);
        Options options;
        options.start = Options::Start::flat;
        const DescentSolver solver(observer, options);
        for (int i = 0; i <= 100; ++i) {
            const double level = i / 100.0;
            const Solution grey = solver.solve(XYZ(observer.white() * level));
            CHECK(grey.solved());
            // the white's Y is 1 but for the rounding of 81 terms
            CHECK(maxDifference(grey.spectrum, constantSpectrum(level)) <= 81 * 0x1p-53);
        }
    }
}

TEST_CASE("a solution is its own nearest start, and a near colour gets a near spectrum from it") {
    const Observer observer("D65");
    testing::SampleColors colors(observer, 4);
    Options options;
    options.bound = Options::Bound::released;
    const DescentSolver solver(observer, options);
    for (int i = 0; i < 100; ++i) {
        const XYZ color = colors.atGauge(0.9);
        const Solution one = solver.solve(color);
        const Solution again = solver.solveFrom(color, one.spectrum);
        CHECK(again.spectrum == one.spectrum);
        CHECK(again.report.iterations == 0);
        const XYZ near(color + Imath::V3d(1e-6, -1e-6, 1e-6));
        const Solution neighbour = solver.solveFrom(near, one.spectrum);
        CHECK(neighbour.solved());
        // With all bands free the least-norm correction is at most |dt| / sqrt(7e-3), the smallest
        // rate of G: 2e-5. A factor 50 is left for the bands that rest at a bound.
        CHECK(maxDifference(neighbour.spectrum, one.spectrum) < 1e-3);
    }
}

TEST_CASE("what is not a colour of a surface has failed, and says so") {
    const Observer observer("D65");
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (Options options : allOptions()) {
        options.maxStarts = 3;
        const DescentSolver solver(observer, options);
        for (const XYZ& color :
             {XYZ(-0.1, 0.2, 0.3), XYZ(0.5, 1.5, 0.5), XYZ(0.9, 0.1, 0.1), XYZ(1e300, 1, 1),
              XYZ(nan, 0.1, 0.1), XYZ(0.1, nan, 0.1), XYZ(0.1, inf, 0.1), XYZ(0.1, 0.1, -inf)}) {
            const Solution solution = solver.solve(color);
            CHECK(solution.report.status == SolveReport::Status::failed);
            for (const double value : solution.spectrum) CHECK((value >= 0 && value <= 1));
            CHECK(!solver.solveFrom(color, constantSpectrum(0.5)).solved());
        }
    }
}

TEST_CASE("options outside their ranges are refused") {
    Options options;
    options.maxStarts = 0;
    CHECK_THROWS_AS(DescentSolver(Observer("E"), options), ArgumentError);
    options.maxStarts = 1;
    options.tolerance = 0;
    CHECK_THROWS_AS(DescentSolver(Observer("E"), options), ArgumentError);
}
