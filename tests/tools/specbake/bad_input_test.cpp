#include "bad_files.h"
#include "process.h"

#include <specbake/bake/bake.h>
#include <specbake/core/error.h>

#include <doctest/doctest.h>

using namespace specbake;
using namespace specbake::testing;

namespace {

/// What bake() says of a file that it refuses; "" if it bakes it.
std::string refusalOf(const std::string& path, const std::string& output) {
    try {
        bake(path, output, {});
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

/// Refused in one line that names the file, and nothing is left behind. Through the library, since
/// starting the program takes longer than its work.
void checkRefused(const BadFile& file) {
    const Scratch scratch;
    const std::string refusal = refusalOf(file.path, scratch.path("o.exr"));
    CAPTURE(file.path);
    CAPTURE(refusal);
    CHECK(refusal.starts_with(file.path + ": "));
    CHECK(linesOf(refusal).size() == 1);
    CHECK(refusal.find(file.says) != std::string::npos);
    CHECK(scratch.names().empty());
}

using MakeFiles = std::vector<BadFile> (*)(const std::string& folder);

void checkAllRefused(MakeFiles make) {
    const Scratch scratch;
    for (const BadFile& file : make(scratch.path(""))) checkRefused(file);
}

}  // namespace

TEST_SUITE_BEGIN("bad_input");

TEST_CASE("truncated files are refused") {
    checkAllRefused(truncatedFiles);
}

TEST_CASE("garbage is refused") {
    checkAllRefused(garbage);
}

TEST_CASE("absurd sizes are refused before they cost memory or time") {
    checkAllRefused(absurdSizes);
}

TEST_CASE("images that are no textures are refused") {
    checkAllRefused(noTextures);
}

TEST_CASE("the program says so in one line, and returns 1") {
    const Scratch scratch;
    const std::string half = contentsOf(testImage("rgb8.jpg")).substr(0, 600);
    writeFile(scratch.path("half.jpg"), half);
    writeFile(scratch.path("half.png"), contentsOf(testImage("demo.png")).substr(0, 30000));
    writeFile(scratch.path("half.exr"), contentsOf(testImage("rgb_half.exr")).substr(0, 700));
    writeFile(scratch.path("empty.tif"), "");
    for (const char* name : {"half.jpg", "half.png", "half.exr", "empty.tif", "absent.hdr"}) {
        const std::string path = scratch.path(name);
        const Outcome outcome = runTool({"bake", path, "-o", scratch.path("o.exr")});
        CAPTURE(outcome.err);
        CHECK(outcome.exitCode == 1);
        CHECK(outcome.out == "");
        CHECK(linesOf(outcome.err).size() == 1);
        CHECK(outcome.err.starts_with("specbake: " + path + ": "));
    }
    CHECK(scratch.names().size() == 4);
}

TEST_CASE("spectral commands refuse what is no spectral image") {
    for (const char* image : {"rgb_half.exr", "rgb8.png", "absent.exr"}) {
        CAPTURE(image);
        const std::string path = testImage(image);
        const Outcome outcome = runTool({"verify", path, testImage("rgb8.png")});
        CHECK(outcome.exitCode == 1);
        CHECK(linesOf(outcome.err).size() == 1);
        CHECK(outcome.err.starts_with("specbake: " + path + ": "));
    }
}

TEST_SUITE_END();
