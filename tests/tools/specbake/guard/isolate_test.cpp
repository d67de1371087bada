#include "process.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <utility>

using namespace specbake::testing;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

std::string big(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += char(value >> (8 * i));
    return text;
}

std::string chunk(const std::string& name, const std::string& data) {
    return name + big(data.size(), 4) + data;
}

/// A Maya IFF of 2048 × 2048 pixels whose only tile ends after ten of them: OpenImageIO 2.4.7 reads
/// beyond it, and is stopped.
std::string deadlyImage() {
    const std::string header = big(2048, 4) + big(2048, 4) + big(1, 2) + big(1, 2) + big(3, 4) +
                               big(0, 2) + big(1, 2) + big(0, 4) + big(0, 8);
    const std::string tile =
        chunk("RGBA", big(0, 4) + big(2047, 2) + big(2047, 2) + std::string(40, '\x10'));
    return chunk("FOR4", "CIMG" + chunk("TBHD", header) + chunk("FOR4", "TBMP" + tile));
}

/// Where AddressSanitizer sees a crash first, it is to end the program as the crash would.
void endByCrashes() {
    const char* const options = std::getenv("ASAN_OPTIONS");
    const std::string all = (options == nullptr ? "" : options) + std::string(":abort_on_error=1");
    REQUIRE(setenv("ASAN_OPTIONS", all.c_str(), 1) == 0);
}

/// The processes that this one has begun.
Names childrenOf(pid_t id) {
    Names children;
    const std::string process = "/proc/" + std::to_string(id) + "/task";
    for (const auto& task : fs::directory_iterator(process)) {
        const std::string list = contentsOf(task.path().string() + "/children");
        std::string number;
        for (const char c : list) {
            if (c != ' ') {
                number += c;
            } else if (!number.empty()) {
                children.push_back(std::exchange(number, ""));
            }
        }
    }
    return children;
}

}  // namespace

TEST_SUITE_BEGIN("isolate");

TEST_CASE("a reader that crashes is an error of its file") {
    const Scratch scratch;
    const std::string image = scratch.path("deadly.iff");
    writeFile(image, deadlyImage());
    endByCrashes();
    const Outcome alone = runTool({"bake", image, "-o", scratch.path("o.exr")});
    CHECK(alone.exitCode == 1);
    CHECK(alone.err.starts_with("specbake: " + image + ": its reader crashed (SIG"));
    CHECK(linesOf(alone.err).size() == 1);
    const Outcome among = runTool({"bake", testImage("rgb8.bmp"), image, testImage("17x33.png"),
                                   "-o", scratch.path("out"), "-q", "-j", "1"});
    CHECK(among.exitCode == 1);
    CHECK(linesOf(among.err).size() == 1);
    CHECK(fs::exists(scratch.path("out/rgb8.exr")));
    CHECK(runTool({"bake", image, "-o", scratch.path("o.exr"), "--isolate", "never"}).signal != 0);
}

TEST_CASE("what is read in another process is the same, and what it says too") {
    const Scratch scratch;
    const auto baked = [&](const std::string& image, const std::string& isolation) {
        const std::string output = scratch.path("o.exr");
        fs::remove(output);
        const Outcome outcome =
            runTool({"bake", testImage(image), "-o", output, "--isolate", isolation, "-v"});
        const std::string said = outcome.out.substr(0, outcome.out.find(" in "));
        return std::to_string(outcome.exitCode) + said + outcome.err +
               (fs::exists(output) ? contentsOf(output) : "");
    };
    for (const std::string& image : testImages()) {
        CAPTURE(image);
        CHECK(baked(image, "always") == baked(image, "never"));
    }
}

TEST_CASE("a spectral image can be read in another process") {
    const Scratch scratch;
    const std::string output = scratch.path("o.exr");
    REQUIRE(runTool({"bake", testImage("17x33.png"), "-o", output}).exitCode == 0);
    const Names inspect = {"inspect", output, "--isolate", "always"};
    CHECK(runTool(inspect).out == runTool({"inspect", output, "--isolate", "never"}).out);
    CHECK(runTool({"verify", output, testImage("17x33.png"), "--isolate", "always"}).exitCode == 0);
}

TEST_CASE("a reader that is killed is told, and none outlives the program") {
    const Scratch scratch;
    const Names arguments = {
        "bake",  testImage("demo.png"), "-o",     scratch.path("o.exr"), "--grid", "129", "-d",
        "float", "--compression",       "zip:12", "--isolate",           "always"};
    for (const bool killReader : {true, false}) {
        Process bake(arguments);
        while (scratch.names().empty() && bake.isRunning()) usleep(2000);
        REQUIRE(bake.isRunning());
        const Names readers = childrenOf(bake.id());
        REQUIRE(readers.size() == 1);
        const pid_t reader = pid_t(std::stoi(readers.front()));
        if (killReader) {
            kill(reader, SIGKILL);
        } else {
            bake.send(SIGKILL);
        }
        const Outcome outcome = bake.wait();
        if (killReader && outcome.exitCode != 0) {  // it may have read all by then
            CHECK(outcome.exitCode == 1);
            CHECK(outcome.err.find("its reader crashed (SIGKILL)") != std::string::npos);
        }
        for (int i = 0; i < 500 && kill(reader, 0) == 0; ++i) usleep(10000);
        CHECK(kill(reader, 0) != 0);
    }
}

TEST_SUITE_END();
