#include "process.h"

#include <specbake/sampler.h>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

using namespace specbake;
using namespace specbake::testing;

TEST_SUITE_BEGIN("table");

TEST_CASE("a table's nodes are the spectra that solve gives, whatever the space and the light") {
    struct Case {
        const char* space;
        const char* illuminant;
    };
    for (const Case& c :
         {Case{"lin_rec709", "D65"}, Case{"lin_rec709", "A"}, Case{"acescg", "D60"}}) {
        CAPTURE(c.space);
        CAPTURE(c.illuminant);
        const Scratch scratch;
        const std::string path = scratch.path("t.spectab");
        const Outcome made = runTool(
            {"table", "-o", path, "--space", c.space, "--illuminant", c.illuminant, "--grid", "5"});
        REQUIRE(made.exitCode == 0);
        CHECK(made.out.find("5 nodes an axis") != std::string::npos);
        const std::string bytes = contentsOf(path);
        SpectralTable table;
        REQUIRE(table.view(bytes.data(), bytes.size()) == SpectralTable::Status::ok);
        CHECK(table.intact());
        // A node of the grid: (1/4)² and (2/4)² of the axis.
        const Outcome solved = runTool({"solve", "--json", "--rgb", "0.25", "0.25", "0.0625",
                                        "--space", c.space, "--illuminant", c.illuminant});
        REQUIRE(solved.exitCode == 0);
        const auto json = nlohmann::json::parse(solved.out);
        std::array<float, 81> bands;
        table.evalBands(table.locate(0.25F, 0.25F, 0.0625F), bands.data());
        double worst = 0;
        for (std::size_t m = 0; m < bands.size(); ++m) {
            const double expected = json["reflectance"][m].get<double>();
            worst = std::max(worst, std::abs(double(bands[m]) - expected));
        }
        CHECK(worst <= 0.75 / 65535 + 4 * 0x1p-24);  // half a step of the range from -1/4 to 5/4
    }
}

TEST_CASE("what cannot be a table is refused, and leaves no file") {
    const Scratch scratch;
    CHECK(runTool({"table", "-o", scratch.path("x.spectab"), "--space", "xyz"}).exitCode == 2);
    CHECK(runTool({"table", "-o", scratch.path("x.spectab"), "--grid", "1"}).exitCode == 2);
    CHECK(runTool({"table", "-o", scratch.path("no/x.spectab"), "--grid", "3"}).exitCode == 1);
    CHECK(runTool({"table"}).exitCode == 2);
    CHECK(scratch.names().empty());
}

TEST_SUITE_END();
