#include "support/sample_colors.h"

#include <specbake/core/methods.h>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

using namespace specbake;

TEST_CASE("every method solves many colours as it solves each") {
    for (const char* light : {"D65", "F2"}) {
        const Observer observer(light);
        const Solid solid(observer);
        testing::SampleColors samples(observer, 5);
        std::vector<XYZ> colors = {
            XYZ(0, 0, 0), observer.white(),   XYZ(observer.white() * 0.3), XYZ(std::nan(""), 0, 0),
            XYZ(2, 1, 1), XYZ(-0.1, 0.2, 0.1)};
        for (int i = 0; i < 60; ++i) {
            colors.push_back(samples.sRGB());
            colors.push_back(samples.sRGB(0.01));
            for (const double gauge : {0.99, 0.9999, 1.0, 1.2}) {
                colors.push_back(samples.atGauge(gauge));
            }
        }
        for (const Method& method : methods()) {
            CAPTURE(method.name);
            const auto solver = method.makeSolver(observer, solid, SolverUse::singleColors);
            std::vector<Solution> many(colors.size());
            solver->solveMany(colors, many);
            for (std::size_t i = 0; i < colors.size(); ++i) {
                CAPTURE(i);
                const Solution one = solver->solve(colors[i]);
                CHECK(std::memcmp(&one.spectrum, &many[i].spectrum, sizeof(Spectrum)) == 0);
                CHECK(one.report.status == many[i].report.status);
                CHECK(one.report.iterations == many[i].report.iterations);
                CHECK(one.report.blended == many[i].report.blended);
            }
        }
    }
}
