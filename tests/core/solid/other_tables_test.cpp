#include "support/brute_solid.h"
#include "support/csv.h"
#include "support/solid_samples.h"

#include <specbake/core/methods.h>
#include <specbake/core/solid_mesh.h>
#include <specbake/core/vector.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace specbake;
using namespace specbake::testing;

/// The solid of other colour-matching functions than the usual ones.
TEST_SUITE_BEGIN("other tables");

namespace {

constexpr const char* kWideTable = "data/cie1964_10deg_1nm.csv";

/// The usual table of every second band, the others linear between: 27 triples of vectors
/// then lie in one plane, to the last digit.
std::vector<MatchingSample> everySecondBand() {
    std::vector<MatchingSample> table;
    for (const auto& row : readCsv("data/cie1931_2deg_5nm.csv")) {
        const double nm = std::stod(row[0]);
        if (std::fmod(nm, 10) != 0) continue;
        // An even number of units, of which the mean of two is whole.
        const auto even = [](const std::string& text) {
            return 2e-10 * std::round(std::stod(text) * 5e9);
        };
        table.push_back({nm, {even(row[1]), even(row[2]), even(row[3])}});
    }
    return table;
}

Observer of(const std::string& functions, const char* light = "D65") {
    return Observer(light, Quadrature::bands, {}, functions);
}

/// What the gauge cannot be below: planes in random directions, each touching the solid.
double supportedGauge(const Solid& solid, const XYZ& color, Random& random) {
    double largest = 0;
    for (int i = 0; i < 50; ++i) {
        const Imath::V3d n = random.direction();
        const double h = solid.support(n) - n.dot(solid.center());
        largest = std::max(largest, n.dot(color - solid.center()) / h);
    }
    return largest;
}

void checkBoundary(const Observer& observer) {
    const Solid solid(observer);
    Random random(4);
    double residual = 0;
    for (int i = 0; i < 5000; ++i) {
        const XYZ color = random.inBox(solid, 0.5);
        const Solid::Boundary boundary = solid.boundary(color);
        residual = std::max(residual,
                            largestComponent(observer.color(boundary.spectrum) - boundary.color));
        CHECK(withinBounds(boundary.spectrum));
        CHECK(supportedGauge(solid, color, random) <= boundary.gauge + 1e-12);
    }
    // The gauge's error of a point at most as far from the centre as the box's corners are.
    CHECK(residual <= 100 * solid.gaugeError());
}

void checkMesh(const Observer& observer) {
    const SolidMesh mesh = solidMesh(Solid(observer));
    std::size_t edges = 0;
    for (const auto& face : mesh.parallelograms) edges += face.size();
    for (const auto& base : mesh.bases) edges += base.size();
    const std::size_t faces = mesh.parallelograms.size() + mesh.bases.size();
    // Euler: each edge is on two faces
    CHECK(mesh.vertices.size() + faces == edges / 2 + 2);
}

}  // namespace

TEST_CASE("the observer of 10 degrees: names, white and no third generator in a plane") {
    const Observer observer = of("10");
    CHECK(observer.functions() == "CIE 1964 10 degree");
    CHECK(observer.name() == "CIE 1964 10 degree, 5 nm");
    CHECK(of(observer.name()).functions() == observer.functions());
    // CIE 15, table T.3, which sums every 5 nm from 380 to 780: D65 has 94.81, 100, 107.32.
    CHECK(std::abs(observer.white().x - 0.9481) < 1e-4);
    CHECK(std::abs(observer.white().z - 1.0732) < 1e-4);
    const BruteSolid brute(observer, kWideTable);
    CHECK(brute.coplanarTriples() == 0);
    CHECK(brute.faceCount() == solidMesh(Solid(observer)).parallelograms.size());
}

TEST_CASE("of 10 degrees, gauge and nearest colour agree with brute force") {
    for (const char* light : {"D65", "A", "F11"}) {
        CAPTURE(light);
        const Observer observer = of("10", light);
        const Solid solid(observer);
        const BruteSolid brute(observer, kWideTable);
        Random random(1);
        double worst = 0;
        for (int i = 0; i < 2000; ++i) {
            const XYZ t = random.inBox(solid, 0.5);
            const double expected = brute.gauge(t);
            worst = std::max(worst, std::abs(solid.gauge(t) - expected) / std::max(1.0, expected));
            if (i % 10 != 0 || expected <= 1) continue;
            const XYZ nearest = solid.nearest(t).color;
            CHECK(std::abs((nearest - t).length() - brute.distance(t)) < 1e-9);
        }
        CHECK(worst <= 2 * solid.gaugeError());
        checkBoundary(observer);
        checkMesh(observer);
    }
}

TEST_CASE("a table of one's own: its text is taken back, that of an offered observer is its name") {
    const auto table = everySecondBand();
    const std::string text = observerText("half\n", table);
    CHECK(text.starts_with("half : 380:780:10 0.001368 "));
    CHECK(observerLabel(text) == "half ");
    CHECK(isObserver(text));
    CHECK(of(text).functions() == text);
    CHECK(of(text).weights()[1] == of(text).weights()[1]);
    std::vector<MatchingSample> usual;
    for (const auto& row : readCsv("data/cie1931_2deg_5nm.csv")) {
        usual.push_back(
            {std::stod(row[0]), {std::stod(row[1]), std::stod(row[2]), std::stod(row[3])}});
    }
    CHECK(observerText("any", usual) == kUsualObserver);
    std::string reason;
    CHECK(!isObserver("3", &reason));
    CHECK(reason.find("2 and 10") != std::string::npos);
    for (const char* wrong : {"a: 380:780:10", "a: 380:780:10 1 2", "a: 380:390:10 1 1 1 1 1 1"}) {
        CHECK(!isObserver(wrong));
    }
    usual[3].value.x = -0.1;
    CHECK_THROWS(observerText("negative", usual));
    usual.erase(usual.begin() + 3);
    CHECK_THROWS(observerText("uneven", usual));
}

TEST_CASE("where vectors lie in one plane by threes, faces tile the plane") {
    const Observer observer = of(observerText("half", everySecondBand()));
    checkMesh(observer);
    checkBoundary(observer);
    const Solid solid(observer);
    const auto solver = findMethod("natural")->makeSolver(observer, solid, SolverUse::gridNodes);
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const XYZ color = i % 2 == 0 ? random.onBoundary(observer, solid) : random.inBox(solid, 0);
        if (solid.gauge(color) > 1 + solid.gaugeError()) continue;
        const Solution solution = solver->solve(color);
        CHECK(solution.solved());
        CHECK(largestComponent(observer.color(solution.spectrum) - color) < 1e-9);
        CHECK(withinBounds(solution.spectrum));
    }
}

TEST_SUITE_END();
