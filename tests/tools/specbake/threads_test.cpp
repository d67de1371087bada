#include "process.h"

#include <specbake/bake/bake.h>
#include <specbake/bake/verify.h>

#include <OpenImageIO/imageio.h>
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

TEST_CASE("one thread means that the libraries beneath start none either") {
    // Of those, OpenEXR alone has threads that it starts without being asked.
    const Scratch scratch;
    BakeOptions options;
    options.threads = 1;
    bake(testImage("tiled_offset.exr"), scratch.path("o.exr"), options);
    CHECK(OIIO::get_int_attribute("exr_threads") == -1);
    verify(scratch.path("o.exr"), testImage("tiled_offset.exr"), {{}, {}, 2});
    CHECK(OIIO::get_int_attribute("exr_threads") == 2);
    verify(scratch.path("o.exr"), testImage("tiled_offset.exr"), {{}, {}, 1});
    CHECK(OIIO::get_int_attribute("exr_threads") == -1);
}

TEST_SUITE_END();
