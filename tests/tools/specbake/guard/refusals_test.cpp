#include "process.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace specbake::testing;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

void checkRefused(const Names& arguments, int exitCode, const std::string& says) {
    const Outcome outcome = runTool(arguments);
    CAPTURE(says);
    CAPTURE(outcome.err);
    CHECK(outcome.exitCode == exitCode);
    CHECK(linesOf(outcome.err).size() == 1);
    CHECK(outcome.err.find(says) != std::string::npos);
}

}  // namespace

TEST_SUITE_BEGIN("refusals");

TEST_CASE("no output of a command is one of its inputs") {
    const Scratch scratch;
    const std::string image = scratch.path("a.png");
    const std::string light = scratch.path("light.csv");
    const std::string spectral = scratch.path("o.exr");
    fs::copy(testImage("1x1.png"), image);
    writeFile(light, "380,1\n480,2\n580,1.5\n680,1\n780,1\n");
    fs::create_hard_link(image, scratch.path("hard.png"));
    fs::create_symlink("a.png", scratch.path("soft.png"));
    REQUIRE(runTool({"bake", image, "-o", spectral}).exitCode == 0);
    const std::string before = contentsOf(spectral);
    writeFile(scratch.path("list"), image + "\n" + scratch.path("hard.png") + "\n");
    const std::string list = "@" + scratch.path("list");
    const std::string many = scratch.path("{stem}.made.exr");
    const std::vector<Names> commands = {
        {"bake", image, "-o", scratch.path("b.exr"), "--stats", image},
        {"bake", image, "-o", scratch.path("b.exr"), "--stats", scratch.path("hard.png")},
        {"bake", image, "-o", scratch.path("b.exr"), "--report", scratch.path("soft.png")},
        {"bake", image, "-o", scratch.path("b.exr"), "--illuminant", light, "--stats", light},
        {"bake", spectral, "-o", spectral},
        {"bake", list, "-o", many, "--stats", image},
        {"bake", list, "-o", many, "--stats", scratch.path("list")},
        {"relight", spectral, "-o", spectral},
        {"relight", spectral, "-o", light, "--illuminant", light},
        {"inspect", spectral, "--plot", scratch.path("plot.svg")},
        {"verify", spectral, image, "--report", image},
        {"verify", spectral, image, "--report", spectral},
        {"region", "--illuminant", light, "--obj", light},
        {"table", "--illuminant", light, "-o", light}};
    fs::create_symlink("o.exr", scratch.path("plot.svg"));
    for (const Names& command : commands) {
        CAPTURE(command.front());
        checkRefused(command, 2, "the output is the input");
    }
    CHECK(contentsOf(image) == contentsOf(testImage("1x1.png")));
    CHECK(contentsOf(spectral) == before);
    CHECK(contentsOf(light).starts_with("380,1\n"));
}

TEST_CASE("no file is written twice") {
    const Scratch scratch;
    const std::string image = testImage("1x1.png");
    const std::string output = scratch.path("o.exr");
    checkRefused({"bake", image, "-o", output, "--stats", output}, 2, "both -o and --stats");
    checkRefused({"bake", image, "-o", output, "--report", scratch.path("./o.exr")}, 2,
                 "both -o and --report");
    checkRefused({"bake", image, testImage("17x33.png"), "-o", scratch.path(""), "--stats",
                  scratch.path("1x1.exr")},
                 2, "both -o and --stats");
    CHECK(scratch.names().empty());
}

TEST_CASE("a name is told in one line, whatever is in it") {
    const Scratch scratch;
    const std::string name = scratch.path("two\nlines\x1bm.png");
    checkRefused({"bake", name, "-o", scratch.path("o.exr")}, 1, "two\\nlines\\x1bm.png: ");
    fs::copy(testImage("orientation6.jpg"), scratch.path("two\nlines.jpg"));
    checkRefused({"bake", scratch.path("two\nlines.jpg"), "-o", scratch.path("o.exr")}, 0,
                 "two\\nlines.jpg: its orientation");
    const std::string spectral = scratch.path("o\n.exr");
    fs::rename(scratch.path("o.exr"), spectral);
    CHECK(runTool({"inspect", spectral}).out.find("o\\n.exr: ") != std::string::npos);
    const Outcome verified = runTool({"verify", spectral, scratch.path("two\nlines.jpg")});
    CHECK(verified.out.find('\n' + scratch.path("two\\nlines.jpg")) != std::string::npos);
}

TEST_CASE("names that are no UTF-8 are told in JSON") {
    const Scratch scratch;
    const std::string image = scratch.path("b\xe4ume.png");
    fs::copy(testImage("1x1.png"), image);
    const Outcome outcome = runTool({"bake", image, "-o", scratch.path("o.exr"), "--stats", "-"});
    CHECK(outcome.exitCode == 0);
    CHECK(outcome.out.find("b\xef\xbf\xbdume.png") != std::string::npos);
    CHECK(runTool({"bake", testImage("1x1.png"), "-o", scratch.path("p.exr"), "--attrib", "owner",
                   "B\xe4r"})
              .exitCode == 0);
    const Outcome facts = runTool({"inspect", scratch.path("p.exr"), "--json"});
    CHECK(facts.exitCode == 0);
    CHECK(facts.err == "");
}

TEST_CASE("numbers that are none, and options that contradict each other, are refused") {
    const std::string image = testImage("1x1.png");
    const Names bake = {"bake", image, "-o", "/nowhere/o.exr"};
    const auto with = [&](Names more) {
        more.insert(more.begin(), bake.begin(), bake.end());
        return more;
    };
    checkRefused(with({"--max-de", "nan"}), 2, "--max-de");
    checkRefused(with({"--max-deviation", "nan"}), 2, "--max-deviation");
    checkRefused(with({"--bits", "7", "--max-de", "1"}), 2, "--bits");
    checkRefused(with({"--grid", "33", "--max-deviation", "0.1"}), 2, "--grid");
    checkRefused(with({"--bits", "7", "-d", "float"}), 2, "--bits");
    checkRefused({"relight", image, "-o", "o.png", "--exposure", "nan"}, 2, "--exposure");
    checkRefused({"inspect", image, "--plot", "x.png"}, 2, ".svg");
    checkRefused(with({"--thread", "2"}), 2, "--threads");
}

TEST_CASE("a folder is no texture, and says so") {
    checkRefused({"verify", testImage("rgb8.png"), testImage("")}, 1, ": ");
    checkRefused({"inspect", testImage("")}, 1, "a folder");
}

TEST_SUITE_END();
