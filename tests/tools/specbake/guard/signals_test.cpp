#include "process.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

using namespace specbake::testing;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ};

void waitABit() {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

/// Whether the process looks at the signal by now: a bit of a mask that the kernel tells.
bool handles(const Process& process, int signal, const std::string& mask) {
    const std::string status = contentsOf("/proc/" + std::to_string(process.id()) + "/status");
    const auto at = status.find(mask + ":\t");
    if (at == std::string::npos) return false;
    const auto bits = std::stoull(status.substr(at + mask.size() + 2, 16), nullptr, 16);
    return (bits >> (signal - 1) & 1) != 0;
}

void waitUntilHandled(Process& process) {
    while (process.isRunning() && !handles(process, SIGTERM, "SigCgt")) waitABit();
    REQUIRE(process.isRunning());
    std::this_thread::sleep_for(std::chrono::milliseconds(50));  // it is about to open the file
}

void checkEnds(Process& process, int signal) {
    CAPTURE(signal);
    process.send(signal);
    const auto sent = Clock::now();
    while (process.isRunning() && Clock::now() - sent < std::chrono::seconds(20)) waitABit();
    REQUIRE(!process.isRunning());
    const Outcome outcome = process.wait();
    CHECK(outcome.signal == signal);
    CHECK(outcome.err == "");
}

Names longBake(const std::string& output) {
    return {"bake",  testImage("demo.png"), "-o",    output, "--grid", "129", "-d",
            "float", "--compression",       "zip:12"};
}

void waitUntilBegun(const Scratch& scratch, Process& process) {
    while (scratch.names().empty() && process.isRunning()) waitABit();
    REQUIRE(process.isRunning());
}

}  // namespace

TEST_SUITE_BEGIN("signals");

TEST_CASE("each signal ends a bake, and leaves nothing") {
    for (const int signal : kSignals) {
        const Scratch scratch;
        Process bake(longBake(scratch.path("o.exr")));
        waitUntilBegun(scratch, bake);
        checkEnds(bake, signal);
        CHECK(scratch.names().empty());
    }
}

TEST_CASE("each signal ends a program that waits for a file to be opened") {
    const Scratch scratch;
    const std::string fifo = scratch.path("fifo.png");
    REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
    for (const int signal : kSignals) {
        Process bake({"bake", fifo, "-o", scratch.path("o.exr")});
        waitUntilHandled(bake);
        checkEnds(bake, signal);
    }
    Process inspect({"inspect", fifo, "--json"});
    waitUntilHandled(inspect);
    checkEnds(inspect, SIGTERM);
    Process endless({"bake", "/dev/zero", "-o", scratch.path("o.exr")});
    while (endless.isRunning() && !handles(endless, SIGTERM, "SigCgt")) waitABit();
    endless.send(SIGTERM);
    const Outcome outcome = endless.wait();
    CHECK((outcome.signal == SIGTERM || outcome.exitCode == 1));
    CHECK(scratch.names() == Names{"fifo.png"});
}

TEST_CASE("a signal in the middle of a picture, a page or a batch leaves nothing") {
    const Scratch scratch;
    Process batch({"bake", testImage("demo.png"), testImage("rgb8.png"), "-o", scratch.path(""),
                   "--grid", "129", "-d", "float", "--compression", "zip:12"});
    waitUntilBegun(scratch, batch);
    checkEnds(batch, SIGHUP);
    for (const std::string& name : scratch.names()) CHECK(name.ends_with(".exr"));
}

TEST_CASE("SIGUSR1 does not disarm the others") {
    const Scratch scratch;
    Process bake(longBake(scratch.path("o.exr")));
    waitUntilBegun(scratch, bake);
    bake.send(SIGUSR1);  // it ends by that, as any program
    CHECK(bake.wait().signal == SIGUSR1);
}

TEST_CASE("what is ignored stays ignored") {
    const Scratch scratch;
    Process bake("trap '' INT HUP", longBake(scratch.path("o.exr")));
    waitUntilBegun(scratch, bake);
    CHECK(handles(bake, SIGINT, "SigIgn"));
    CHECK(handles(bake, SIGHUP, "SigIgn"));
    bake.send(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    CHECK(bake.isRunning());
    checkEnds(bake, SIGTERM);
    CHECK(scratch.names().empty());
}

TEST_CASE("a reader of the output who goes ends the program by SIGPIPE") {
    const Scratch scratch;
    const std::string status = scratch.path("status");
    const std::string script = "{ \"" SPECBAKE_PROGRAM "\" solve --rgb 0.5 0.4 0.3; echo $? >\"" +
                               status + "\"; } | :; true";
    for (int i = 0; i < 5; ++i) {
        const Outcome ignored = runIn(script, {"--version"});
        CHECK(ignored.exitCode == 0);
        const std::string code = contentsOf(status);
        CHECK((code == "141\n" || code == "0\n"));  // it may be faster than its reader goes
    }
}

TEST_CASE("a file beyond the limit of the process is an error of that file") {
    const Scratch scratch;
    const Outcome outcome =
        runIn("ulimit -f 1", {"bake", testImage("17x33.png"), "-o", scratch.path("o.exr")});
    CHECK(outcome.signal == 0);
    CHECK(outcome.exitCode == 1);
    CHECK(outcome.err.find("o.exr: File too large") != std::string::npos);
    CHECK(scratch.names().empty());
}

TEST_SUITE_END();
