#include "process.h"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

using namespace specbake::testing;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

/// A spectral image in the folder.
std::string baked(const Scratch& scratch) {
    const std::string output = scratch.path("o.exr");
    REQUIRE(runTool({"bake", testImage("demo.png"), "-o", output}).exitCode == 0);
    return output;
}

/// Fails in one line about the file, which stays as it was.
void checkKept(const Outcome& outcome, const std::string& file, const std::string& before) {
    CAPTURE(file);
    CAPTURE(outcome.err);
    CHECK(outcome.exitCode == 1);
    CHECK(outcome.signal == 0);
    CHECK(linesOf(outcome.err).size() == 1);
    CHECK(outcome.err.starts_with("specbake: " + file + ": "));
    CHECK(contentsOf(file) == before);
}

constexpr const char* kLittleRoom = "ulimit -f 1";  // 512 or 1024 bytes a file

}  // namespace

TEST_SUITE_BEGIN("durability");

TEST_CASE("what cannot be written whole leaves the old picture, in every format") {
    const Scratch scratch;
    const std::string spectral = baked(scratch);
    for (const char* kind :
         {"png", "bmp", "tga", "gif", "sgi", "jpg", "tif", "hdr", "exr", "webp", "ppm", "rla"}) {
        const std::string picture = scratch.path(std::string("o.") + kind);
        if (fs::path(picture) == spectral) continue;
        writeFile(picture, "older");
        const Names before = scratch.names();
        checkKept(runIn(kLittleRoom, {"relight", spectral, "-o", picture, "-q"}), picture, "older");
        CHECK(scratch.names() == before);
        CHECK(runTool({"relight", spectral, "-o", picture, "-q"}).exitCode == 0);
        CHECK(fs::file_size(picture) > 512);
    }
}

TEST_CASE("neither does any other writer leave less than there was") {
    const Scratch scratch;
    const std::string spectral = baked(scratch);
    const std::string file = scratch.path("file");
    const std::vector<std::pair<std::string, Names>> writers = {
        {".exr", {"bake", testImage("17x33.png"), "-q", "-o"}},
        {".spectab", {"table", "--grid", "3", "-o"}},
        {".obj", {"region", "--obj"}},
        {".svg", {"inspect", spectral, "--plot"}},
        {".html", {"verify", spectral, testImage("demo.png"), "--report"}}};
    for (const auto& [extension, command] : writers) {
        const std::string output = file + extension;
        writeFile(output, "older");
        const Names before = scratch.names();
        Names arguments = command;
        arguments.push_back(output);
        checkKept(runIn(kLittleRoom, arguments), output, "older");
        CHECK(scratch.names() == before);
        arguments.emplace_back("--sync");
        CHECK(runTool(arguments).exitCode == 0);
        CHECK(contentsOf(output) != "older");
    }
}

TEST_CASE("the next run removes what a killed one left") {
    const Scratch scratch;
    {
        Process bake({"bake", testImage("demo.png"), "-o", scratch.path("o.exr"), "--grid", "129",
                      "-d", "float", "--compression", "zip:12"});
        while (scratch.names().empty() && bake.isRunning()) usleep(2000);
        REQUIRE(bake.isRunning());
        bake.send(SIGKILL);
        CHECK(bake.wait().signal == SIGKILL);
    }
    CHECK(scratch.names().size() == 1);
    baked(scratch);
    CHECK(scratch.names() == Names{"o.exr"});
}

TEST_CASE("a file that is replaced keeps its permissions") {
    const Scratch scratch;
    const std::string spectral = baked(scratch);
    chmod(spectral.c_str(), 0640);
    baked(scratch);
    CHECK(fs::status(spectral).permissions() == fs::perms(0640));
}

TEST_CASE("a full or closed standard output is told, and is nobody's file") {
    const Scratch scratch;
    const std::string spectral = baked(scratch);
    const std::vector<Names> commands = {{"solve", "--rgb", "0.5", "0.4", "0.3"},
                                         {"inspect", spectral},
                                         {"inspect", spectral, "--json"},
                                         {"verify", spectral, testImage("demo.png")},
                                         {"region"},
                                         {"--help"},
                                         {"--version"}};
    for (const Names& command : commands) {
        for (const char* redirection : {">/dev/full", ">&-"}) {
            CAPTURE(command.front());
            CAPTURE(redirection);
            const Outcome outcome = runIn("", command, redirection);
            CHECK(outcome.exitCode == 1);
            CHECK(outcome.err.find("specbake: standard output: ") != std::string::npos);
        }
    }
    const std::string before = contentsOf(spectral);
    const Outcome silent =
        runIn("", {"bake", testImage("demo.png"), "-o", spectral}, ">&- 2>&- <&-");
    CHECK(silent.exitCode == 0);
    CHECK(contentsOf(spectral) == before);
    CHECK(runIn("", {"bake", testImage("demo.png"), "-o", spectral, "-v"}, ">&-").exitCode == 1);
    CHECK(contentsOf(spectral) == before);
}

TEST_SUITE_END();
