#include "process.h"
#include "support/csv.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

using namespace specbake::testing;
using nlohmann::json;

namespace {

using Triple = std::array<double, 3>;

/// Equation (1) by the printed table, under equal energy.
Triple colorUnderE(const std::vector<double>& reflectance) {
    const auto table = readCsv("data/cie1931_2deg_5nm.csv");
    REQUIRE(table.size() == reflectance.size());
    Triple color{};
    double whiteY = 0;
    for (std::size_t m = 0; m < table.size(); ++m) {
        for (std::size_t c = 0; c < 3; ++c) color[c] += std::stod(table[m][1 + c]) * reflectance[m];
        whiteY += std::stod(table[m][2]);
    }
    for (double& v : color) v /= whiteY;
    return color;
}

std::vector<double> column(const std::string& csv) {
    std::vector<double> values;
    int nm = 380;
    for (const std::string& line : linesOf(csv)) {
        if (line == "nm,reflectance") continue;
        std::istringstream row(line);
        int wavelength = 0;
        char comma = 0;
        double value = 0;
        row >> wavelength >> comma >> value;
        CHECK(wavelength == nm);
        nm += 5;
        values.push_back(value);
    }
    return values;
}

double largestDifference(const Triple& a, const Triple& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

Outcome solve(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "solve");
    return runTool(arguments);
}

}  // namespace

TEST_SUITE_BEGIN("solve");

TEST_CASE("81 values that have the colour, by every method; the same in JSON") {
    const Triple asked = {0.3, 0.4, 0.2};
    for (const char* method : {"natural", "smooth", "descent"}) {
        CAPTURE(method);
        const std::vector<std::string> arguments = {"--xyz", "0.3",      "0.4",
                                                    "0.2",   "--method", method};
        const Outcome outcome = solve(arguments);
        REQUIRE(outcome.exitCode == 0);
        CHECK(linesOf(outcome.err).size() == 1);
        const std::vector<double> values = column(outcome.out);
        REQUIRE(values.size() == 81);
        CHECK(*std::min_element(values.begin(), values.end()) >= 0);
        CHECK(*std::max_element(values.begin(), values.end()) <= 1);
        CHECK(largestDifference(colorUnderE(values), asked) < 1e-9);
        std::vector<std::string> inJson = arguments;
        inJson.emplace_back("--json");
        const json report = json::parse(solve(inJson).out);
        CHECK(report["status"] == "solved");
        CHECK(report["illuminant"] == "E");
        CHECK(report["asked_xyz"] == asked);
        CHECK(report["reflectance"].get<std::vector<double>>() == values);
    }
}

TEST_CASE("white, black and grey are 1, 0 and flat in every space") {
    for (const char* space : {"srgb", "lin_rec709", "lin_rec2020", "acescg", "lin_prophoto"}) {
        CAPTURE(space);
        const bool encoded = std::string(space) == "srgb";
        for (const double grey : {0.0, 0.5, 1.0}) {
            const std::string g = std::to_string(grey);
            const Outcome outcome = solve({"--rgb", g, g, g, "--space", space});
            REQUIRE(outcome.exitCode == 0);
            const double expected =
                encoded && grey == 0.5 ? std::pow((0.5 + 0.055) / 1.055, 2.4) : grey;
            for (const double v : column(outcome.out)) CHECK(std::abs(v - expected) <= 1e-12);
        }
    }
}

TEST_CASE("a colour that no reflectance has: the nearest, a darker one, or an error") {
    const std::vector<std::string> tooBright = {"--rgb", "3", "0.6", "0.3", "--json"};
    const auto given = [&](const char* rule) {
        std::vector<std::string> arguments = tooBright;
        arguments.insert(arguments.end(), {"--outside", rule});
        const Outcome outcome = solve(arguments);
        REQUIRE(outcome.exitCode == 0);
        return json::parse(outcome.out);
    };
    const json scaled = given("scale");
    const auto asked = scaled["asked_xyz"].get<Triple>();
    const auto darker = scaled["given_xyz"].get<Triple>();
    const double share = darker[1] / asked[1];
    CHECK(share < 1);
    for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(darker[c] - share * asked[c]) < 1e-12);
    const auto distance = [&](const Triple& t) {
        return std::hypot(t[0] - asked[0], t[1] - asked[1], t[2] - asked[2]);
    };
    CHECK(distance(given("nearest")["given_xyz"].get<Triple>()) < distance(darker));

    std::vector<std::string> arguments = tooBright;
    arguments.insert(arguments.end(), {"--outside", "error"});
    const Outcome refused = solve(arguments);
    CHECK(refused.exitCode == 1);
    CHECK(linesOf(refused.err).size() == 1);
}

TEST_CASE("wrong commands return 2, colours that are not finite 1 or 2, and nothing is solved") {
    const std::vector<std::vector<std::string>> wrong = {
        {},
        {"--xyz", "0.1", "0.2"},
        {"--xyz", "0.1", "0.2", "0.3", "--rgb", "0", "0", "0"},
        {"--rgb", "a", "b", "c"},
        {"--rgb", "0", "0", "0", "--method", "guess"},
        {"--rgb", "0", "0", "0", "--illuminant", "lamp"}};
    for (const auto& arguments : wrong) {
        const Outcome outcome = solve(arguments);
        CHECK(outcome.exitCode == 2);
        CHECK(outcome.out == "");
        CHECK(linesOf(outcome.err).size() == 1);
    }
    for (const char* value : {"nan", "inf", "-inf"}) {
        const Outcome outcome = solve({"--xyz", value, "0.2", "0.3"});
        CHECK((outcome.exitCode == 1 || outcome.exitCode == 2));
        CHECK(outcome.out == "");
        CHECK(linesOf(outcome.err).size() == 1);
    }
}

TEST_CASE("white and greys come out flat where the table makes them so but for its rounding") {
    using Words = std::vector<std::string>;
    const std::vector<std::pair<std::string, Words>> greys = {
        {"E", {"1", "1", "1"}},
        {"E", {"0.999999", "0.999999", "0.999999"}},
        {"E", {"0.5", "0.5", "0.5"}},
        {"E", {"0", "0", "0"}},
        {"D65", {"0.95047", "1", "1.08883"}},  // ASTM E308
        {"D65", {"0.19009", "0.2", "0.21777"}},
        {"A", {"1.0985", "1", "0.3558"}}};
    for (const auto& [light, color] : greys) {
        CAPTURE(light);
        CAPTURE(color[0]);
        const Outcome outcome =
            solve({"--illuminant", light, "--xyz", color[0], color[1], color[2]});
        REQUIRE(outcome.exitCode == 0);
        for (const double value : column(outcome.out)) CHECK(value == std::stod(color[1]));
        CHECK(outcome.err.find("outside the solid") == std::string::npos);
    }
    // What differs by more is solved as it stands, to the last digit.
    const std::vector<Words> colors = {{"0.5", "0.5003", "0.5"}, {"0.4", "0.4", "0.4002"}};
    for (const Words& color : colors) {
        const Outcome outcome = solve({"--xyz", color[0], color[1], color[2]});
        const Triple asked = {std::stod(color[0]), std::stod(color[1]), std::stod(color[2])};
        CHECK(largestDifference(colorUnderE(column(outcome.out)), asked) < 1e-12);
    }
}

TEST_SUITE_END();
