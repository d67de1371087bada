#include "process.h"

#include <doctest/doctest.h>

using namespace specbake;
using namespace specbake::testing;

namespace {

std::string baked(const std::string& image, const char* compression, const char* threads,
                  const std::vector<std::string>& more = {}) {
    const Scratch scratch;
    const std::string output = scratch.path("o.exr");
    std::vector<std::string> arguments = {"bake", "-q",    testImage(image), "-o",       output,
                                          "-j",   threads, "--compression",  compression};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = runTool(arguments);
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
    for (const char* compression : {"none", "zip", "piz"}) {
        CAPTURE(compression);
        const std::vector<std::string> levels = {"--mipmap", "--tile", "8", "5"};
        const std::string one = baked("tiled_offset.exr", compression, "1", levels);
        CHECK(one == baked("tiled_offset.exr", compression, "2", levels));
        CHECK(one == baked("tiled_offset.exr", compression, "7", levels));
    }
    CHECK(baked("demo.png", "zip", "1", {"--mipmap"}) ==
          baked("demo.png", "zip", "3", {"--mipmap"}));
    const std::string one = baked("demo.png", "zip", "1");
    CHECK(one == baked("demo.png", "zip", "1"));
    CHECK(one == baked("demo.png", "zip", "2"));
    CHECK(one == baked("demo.png", "zip", "0"));
}

TEST_SUITE_END();
