#include "process.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

using namespace specbake::testing;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

/// Starts a bake that takes long, waits until its file is begun, and signals it.
Outcome interrupted(const Scratch& scratch, int signal) {
    Process bake({"bake", testImage("demo.png"), "-o", scratch.path("o.exr"), "--grid", "129", "-d",
                  "float", "--compression", "zip:12"});
    const auto begun = [&] {
        const Names names = scratch.names();
        return !names.empty() && names.front().ends_with(".tmp");
    };
    while (!begun() && bake.isRunning()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    REQUIRE(bake.isRunning());
    bake.send(signal);
    return bake.wait();
}

void checkRefused(const Names& arguments, int exitCode, const std::string& says) {
    const Outcome outcome = runTool(arguments);
    CAPTURE(outcome.err);
    CHECK(outcome.exitCode == exitCode);
    CHECK(linesOf(outcome.err).size() == 1);
    CHECK(outcome.err.find(says) != std::string::npos);
}

}  // namespace

TEST_SUITE_BEGIN("output");

TEST_CASE("a signal ends the program by that signal, and nothing is left behind") {
    for (const int signal : {SIGINT, SIGTERM}) {
        const Scratch scratch;
        const Outcome outcome = interrupted(scratch, signal);
        CHECK(outcome.signal == signal);
        CHECK(outcome.err == "");
        CHECK(scratch.names().empty());
    }
}

TEST_CASE("an older output survives a signal and a failed bake") {
    const Scratch scratch;
    writeFile(scratch.path("o.exr"), "older");
    CHECK(interrupted(scratch, SIGTERM).signal == SIGTERM);
    const std::string jpeg = contentsOf(testImage("rgb8.jpg"));
    writeFile(scratch.path("half.jpg"), jpeg.substr(0, jpeg.size() - 100));
    CHECK(runTool({"bake", scratch.path("half.jpg"), "-o", scratch.path("o.exr")}).exitCode == 1);
    CHECK(contentsOf(scratch.path("o.exr")) == "older");
    CHECK(scratch.names() == Names{"half.jpg", "o.exr"});
}

TEST_CASE("an output that cannot be is refused") {
    const Scratch scratch;
    const std::string image = testImage("1x1.png");
    fs::create_symlink("/dev/null", scratch.path("null.exr"));
    fs::create_directory(scratch.path("folder.exr"));
    checkRefused({"bake", image, "-o", scratch.path("null.exr")}, 1, "not a regular file");
    checkRefused({"bake", image, "-o", scratch.path("folder.exr")}, 1, "not a regular file");
    checkRefused({"bake", image, "-o", scratch.path("absent/o.exr")}, 1, "absent/o.exr: No such");
    checkRefused({"bake", image, "-o", "/proc/o.exr"}, 1, "/proc/o.exr: ");  // for root, too
    CHECK(fs::is_character_file("/dev/null"));
    CHECK(scratch.names() == Names{"folder.exr", "null.exr"});
}

TEST_CASE("an output that is no .exr by its name is refused") {
    const Scratch scratch;
    const std::string image = testImage("1x1.png");
    for (const char* name : {"o.png", "o", "exr", ".exr", "o.exr.tif", "o.exr~", "folder.exr/"}) {
        checkRefused({"bake", image, "-o", scratch.path(name)}, 2, "must end in .exr");
    }
    checkRefused({"bake", image, "-o", "/dev/null"}, 2, "/dev/null: a spectral image is an EXR");
    CHECK(scratch.names().empty());
    CHECK(runTool({"bake", image, "-o", scratch.path("o.EXR")}).exitCode == 0);
    CHECK(scratch.names() == Names{"o.EXR"});
}

TEST_CASE("the output must not be the input, by whatever name") {
    const Scratch scratch;
    fs::copy(testImage("1x1.png"), scratch.path("a.png"));
    fs::create_symlink(scratch.path("a.png"), scratch.path("b.png"));
    for (const char* name : {"a.png", "b.png"}) {
        checkRefused({"bake", scratch.path("a.png"), "-o", scratch.path(name)}, 2,
                     "the output is the input");
    }
    CHECK(contentsOf(scratch.path("a.png")) == contentsOf(testImage("1x1.png")));
}

TEST_CASE("--stats says what was done") {
    const Scratch scratch;
    const std::string input = testImage("17x33.png");
    const Outcome outcome = runTool(
        {"bake", input, "-o", scratch.path("o.exr"), "--stats", scratch.path("stats.json")});
    REQUIRE(outcome.exitCode == 0);
    CHECK(outcome.out == "");
    CHECK(outcome.err == "");
    const auto stats = nlohmann::json::parse(contentsOf(scratch.path("stats.json")));
    CHECK(stats.at("input") == input);
    CHECK(stats.at("output") == scratch.path("o.exr"));
    CHECK(stats.at("texels") == 17 * 33);
    CHECK(stats.at("space") == "srgb");
    CHECK(stats.at("illuminant") == "D65");
    CHECK(stats.at("seconds").get<double>() > 0);
    CHECK(scratch.names() == Names{"o.exr", "stats.json"});
}

TEST_CASE("remarks go to stderr, and -q has none") {
    const Scratch scratch;
    const Names bake = {"bake", testImage("orientation6.jpg"), "-o", scratch.path("o.exr")};
    const Outcome outcome = runTool(bake);
    CHECK(outcome.exitCode == 0);
    CHECK(linesOf(outcome.err).size() == 1);
    CHECK(outcome.err.find("orientation6.jpg: its orientation (Exif 6)") != std::string::npos);
    Names quiet = bake;
    quiet.emplace_back("-q");
    CHECK(runTool(quiet).err == "");
}

TEST_CASE("verify returns 3 where files differ") {
    const Scratch scratch;
    const std::string output = scratch.path("o.exr");
    REQUIRE(runTool({"bake", testImage("rgb8.png"), "-o", output}).exitCode == 0);
    CHECK(runTool({"verify", output, testImage("rgb8.png")}).exitCode == 0);
    CHECK(runTool({"verify", output, testImage("rgb_float.exr")}).exitCode == 3);
    CHECK(runTool({"verify", output, testImage("rgb8.png"), "--max-de", "0.001"}).exitCode == 3);
    checkRefused({"verify", output, testImage("1x1.png")}, 1, "not of the size");
}

TEST_CASE("wrong commands return 2, and help 0") {
    checkRefused({}, 2, "specbake: ");
    checkRefused({"boil"}, 2, "specbake: ");
    checkRefused({"bake", "in.png"}, 2, "--output");
    checkRefused({"bake", "in.png", "-o", "o.exr", "--grid", "1"}, 2, "--grid");
    checkRefused({"bake", "in.png", "-o", "o.exr", "--compression", "dwaa"}, 2, "--compression");
    checkRefused({"bake", "in.png", "-o", "o.exr", "--compression", "piz:3"}, 2, "piz:3");
    for (const char* side : {"0", "-16", "1025", "99999999999", "big", "1.5"}) {
        checkRefused({"bake", "in.png", "-o", "o.exr", "--tile", "16", side}, 2, "--tile");
        checkRefused({"bake", "in.png", "-o", "o.exr", "--tile", side, "16"}, 2, "--tile");
    }
    checkRefused({"bake", "in.png", "-o", "o.exr", "--tile", "16"}, 2, "--tile");
    for (const char* command : {"bake", "inspect", "relight", "verify"}) {
        const Outcome help = runTool({command, "--help"});
        CHECK(help.exitCode == 0);
        CHECK(help.err == "");
        CHECK(help.out.find("--help") != std::string::npos);
    }
    CHECK(runTool({"--version"}).out.starts_with("specbake "));
}

TEST_SUITE_END();
