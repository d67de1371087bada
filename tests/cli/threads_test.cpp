#include "process.h"

#include <doctest/doctest.h>

using namespace specbake::testing;

namespace {

std::string baked(const std::string& image, const char* compression, const char* threads) {
    const Scratch scratch;
    const std::string output = scratch.path("o.exr");
    const Outcome outcome = runTool({"bake", "-q", testImage(image), "-o", output, "-j", threads,
                                     "--compression", compression});
    REQUIRE(outcome.exitCode == 0);
    return contentsOf(output);
}

}  // namespace

TEST_SUITE_BEGIN("threads");

TEST_CASE("bytes do not depend on threads or on the run") {
    for (const char* compression : {"none", "zip", "zips:9", "piz"}) {
        CAPTURE(compression);
        const std::string one = baked("tiled_offset.exr", compression, "1");
        CHECK(one == baked("tiled_offset.exr", compression, "2"));
        CHECK(one == baked("tiled_offset.exr", compression, "2"));
    }
    const std::string one = baked("demo.png", "zip", "1");
    CHECK(one == baked("demo.png", "zip", "1"));
    CHECK(one == baked("demo.png", "zip", "2"));
    CHECK(one == baked("demo.png", "zip", "0"));
}

TEST_SUITE_END();
