#include "farm/tiles.h"
#include "process.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <map>

using namespace specbake::testing;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

const std::vector<std::pair<int, int>> kFour = {{9, 9}, {8, 8}, {7, 7}, {6, 6}};

/// What the status says of each tile; that it agrees with its own counts and its exit code.
std::map<std::size_t, std::string> statusOf(const Tiles& tiles, Names options = {}) {
    options.emplace_back("--json");
    const Outcome outcome = runTool(tiles.words("status", options));
    CAPTURE(outcome.err);
    const auto json = nlohmann::json::parse(outcome.out);
    std::map<std::size_t, std::string> all;
    for (std::size_t i = 0; i < tiles.pixels.size(); ++i) all[i] = "done";
    for (const auto& open : json.at("open")) {
        for (std::size_t i = 0; i < tiles.pixels.size(); ++i) {
            if (open.at("input") == tiles.name(i)) all[i] = open.at("status");
        }
    }
    CHECK(json.at("textures") == all.size());
    for (const std::string name : {"done", "missing", "out of date", "failed"}) {
        const auto count = std::count_if(all.begin(), all.end(),
                                         [&](const auto& each) { return each.second == name; });
        CHECK(json.at(name) == count);
    }
    CHECK(outcome.exitCode == (json.at("open").empty() ? 0 : 1));
    return all;
}

using All = std::map<std::size_t, std::string>;

void bake(const Tiles& tiles, const Names& options, int exitCode = 0) {
    const Outcome outcome = runTool(tiles.words("bake", options));
    CAPTURE(outcome.err);
    REQUIRE(outcome.exitCode == exitCode);
}

/// With the header as it is, and half of the texels.
void cut(const std::string& path) {
    const std::string contents = contentsOf(path);
    writeFile(path, contents.substr(0, contents.size() - 20));
}

void touch(const std::string& path, int seconds) {
    fs::last_write_time(path, fs::file_time_type::clock::now() + std::chrono::seconds(seconds));
}

}  // namespace

TEST_SUITE_BEGIN("status");

TEST_CASE("what is done, missing and out of date is told, and exit code 0 means all") {
    const Tiles tiles(kFour);
    const All none = {{0, "missing"}, {1, "missing"}, {2, "missing"}, {3, "missing"}};
    const All all = {{0, "done"}, {1, "done"}, {2, "done"}, {3, "done"}};
    CHECK(statusOf(tiles) == none);
    CHECK(!fs::exists(tiles.out));
    bake(tiles, {"-q"});
    for (const Names& quick : {Names{}, Names{"--quick"}}) {
        CAPTURE(quick.size());
        CHECK(statusOf(tiles, quick) == all);
    }
    fs::remove(tiles.result(1));
    touch(tiles.name(2), 2);
    writeFile(tiles.result(3), "no spectra");
    const All some = {{0, "done"}, {1, "missing"}, {2, "out of date"}, {3, "out of date"}};
    for (const Names& quick : {Names{}, Names{"--quick"}}) CHECK(statusOf(tiles, quick) == some);
    const Outcome text = runTool(tiles.words("status"));
    CHECK(text.exitCode == 1);
    CHECK(linesOf(text.out).size() == 6);  // three counts, three textures
    CHECK(text.out.find(tiles.name(2) + ": out of date: older than its texture") !=
          std::string::npos);
    CHECK(runTool(tiles.words("status", {"-q"})).out.empty());
}

TEST_CASE("done is what -u leaves alone, by the same options") {
    const Tiles tiles(kFour);
    bake(tiles, {"-q", "--bits", "9"});
    CHECK(statusOf(tiles, {"--bits", "9"})[0] == "done");
    for (const Names& options : {Names{}, Names{"--quick"}, Names{"--mipmap"}}) {
        CHECK(statusOf(tiles, options)[0] == "out of date");
    }
}

TEST_CASE("--quick goes by length and time, and else all bytes count") {
    const Tiles tiles(kFour);
    bake(tiles, {"-q"});
    const auto time = fs::last_write_time(tiles.name(0));
    std::string contents = contentsOf(tiles.name(0));
    contents[contents.size() - 1] ^= 1;  // of the last checksum, which no one looks at
    writeFile(tiles.name(0), contents);
    fs::last_write_time(tiles.name(0), time);
    CHECK(statusOf(tiles, {"--quick"})[0] == "done");
    CHECK(statusOf(tiles)[0] == "out of date");
    writeFile(tiles.name(0), contents + "longer");
    fs::last_write_time(tiles.name(0), time);
    CHECK(statusOf(tiles, {"--quick"})[0] == "out of date");
}

TEST_CASE("failures of tasks are known until the texture is mended") {
    const Tiles tiles(kFour);
    const std::string whole = contentsOf(tiles.name(1));
    cut(tiles.name(1));
    bake(tiles, {"-q", "--shard", "1/2"}, 0);
    bake(tiles, {"-q", "--shard", "2/2"}, 1);
    const All failed = {{0, "done"}, {1, "failed"}, {2, "done"}, {3, "done"}};
    for (const Names& quick : {Names{}, Names{"--quick"}}) CHECK(statusOf(tiles, quick) == failed);
    const Outcome text = runTool(tiles.words("status"));
    CHECK(text.out.find(tiles.name(1) + ": failed: ") != std::string::npos);
    writeFile(tiles.name(1), whole);
    touch(tiles.name(1), 2);
    CHECK(statusOf(tiles)[1] == "missing");
    touch(tiles.name(1), -2);
    bake(tiles, {"-q", "-u", "--shard", "2/2"});
    CHECK(statusOf(tiles)[1] == "done");
    fs::remove(tiles.result(1));
    CHECK(statusOf(tiles)[1] == "missing");  // the failure is forgotten
}

TEST_CASE("a texture that cannot be read has failed, and its old result does not count") {
    const Tiles tiles(kFour);
    bake(tiles, {"-q"});
    fs::remove(tiles.name(0));
    writeFile(tiles.name(3), "no PNG");
    touch(tiles.name(3), -100);
    const All all = {{0, "failed"}, {1, "done"}, {2, "done"}, {3, "failed"}};
    CHECK(statusOf(tiles) == all);
}

TEST_CASE("what a killed task left is listed, and changes no status") {
    const Tiles tiles(kFour);
    bake(tiles, {"-q"});
    const std::string left = tiles.out + "/.specbake-lost-4711-0.tmp";
    writeFile(left, "half");
    const auto json = nlohmann::json::parse(runTool(tiles.words("status", {"--json"})).out);
    CHECK(json.at("leftovers") == nlohmann::json::array({left}));
    const Outcome text = runTool(tiles.words("status"));
    CHECK(text.exitCode == 0);
    CHECK(text.out.find(left + ": half-written") != std::string::npos);
}

TEST_SUITE_END();
