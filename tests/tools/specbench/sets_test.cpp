#include "colors/sets.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace specbake;
using namespace specbake::bench;

namespace {

const ColorSet& named(const std::vector<ColorSet>& sets, const std::string& name) {
    const auto found = std::ranges::find(sets, name, &ColorSet::name);
    REQUIRE(found != sets.end());
    return *found;
}

double least(const RGB& c) {
    return std::min({c.x, c.y, c.z});
}
double most(const RGB& c) {
    return std::max({c.x, c.y, c.z});
}

constexpr double kRounding = 1e-14;  // RGB -> XYZ -> RGB, condition below 10

}  // namespace

TEST_CASE("sets inside the RGB cube are where they say, and the same every time") {
    const Frame frame = sRGBFrame();
    const auto sets = rgbSets(frame, 500);
    for (const ColorSet& set : sets) {
        CAPTURE(set.name);
        CHECK(set.colors.size() >= 50);
        CHECK(set.colors == named(rgbSets(frame, 500), set.name).colors);
        for (const XYZ& c : set.colors) {
            CHECK(least(frame.rgb(c)) >= -kRounding);
            CHECK(most(frame.rgb(c)) <= 1 + kRounding);
        }
    }
    for (const XYZ& c : named(sets, "dark").colors) CHECK(most(frame.rgb(c)) <= 0.05 + kRounding);
    for (const XYZ& c : named(sets, "near white").colors)
        CHECK(least(frame.rgb(c)) >= 0.99 - kRounding);
    for (const XYZ& c : named(sets, "near black, saturated").colors) {
        CHECK(most(frame.rgb(c)) <= 1e-4);
        CHECK(least(frame.rgb(c)) <= 1e-18);
    }
}

TEST_CASE("the whole lattice has 52 cubed colours, black first and white last") {
    const Frame frame = sRGBFrame();
    const auto sets = rgbSets(frame, 200'000);
    const auto& colors = named(sets, "8-bit lattice").colors;
    CHECK(colors.size() == 52 * 52 * 52);
    CHECK(most(frame.rgb(colors.front())) == 0);
    CHECK(least(frame.rgb(colors.back())) >= 1 - kRounding);
}

TEST_CASE("sets of the solid have the gauges that they are named for") {
    const Frame frame = sRGBFrame();
    const Solid solid(frame.observer);
    const auto sets = solidSets(frame, solid, 200);
    for (const char* inside : {"solid", "Rec.2020 cube", "ACEScg cube"}) {
        for (const XYZ& c : named(sets, inside).colors) CHECK(solid.gauge(c) <= 1);
    }
    for (const XYZ& c : named(sets, "just outside").colors) {
        CHECK(solid.gauge(c) >= 1 - 4 * solid.gaugeError());
        CHECK(solid.gauge(c) <= 1.05 + 4 * solid.gaugeError());
    }
    for (const double gauge : {0.5, 0.99, 1.0}) {
        for (const XYZ& c : colorsAtGauge(solid, gauge, 100)) {
            // the gauge is taken twice, and a point is scaled between
            CHECK(std::abs(solid.gauge(c) - gauge) <= 4 * solid.gaugeError());
        }
    }
}
