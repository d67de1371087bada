#include "process.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <set>
#include <thread>

using namespace specbake::testing;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

/// A folder of textures, and bakes of it with -u.
struct Folder {
    Scratch scratch;
    Names textures = {"a.png", "b.png", "c.png", "d.png"};

    Folder() {
        fs::create_directory(scratch.path("in"));
        for (const std::string& name : textures) {
            fs::copy(testImage("17x33.png"), scratch.path("in/" + name));
        }
    }

    Names words(const Names& options = {}) const {
        Names words = {"bake", "-u", scratch.path("in"), "-o", scratch.path("out"), "--stats", "-"};
        words.insert(words.end(), options.begin(), options.end());
        return words;
    }

    /// The textures that were baked, by name.
    std::set<std::string> baked(const Names& options = {}) const {
        const Outcome outcome = runTool(words(options));
        CHECK(outcome.exitCode == 0);
        std::set<std::string> names;
        for (const std::string& line : linesOf(outcome.out)) {
            const auto json = nlohmann::json::parse(line);
            const bool current = json.at("status") == "current";
            CHECK((current || json.at("status") == "baked"));
            if (!current) names.insert(fs::path(json.at("input").get<std::string>()).filename());
        }
        return names;
    }

    std::set<std::string> all() const { return {textures.begin(), textures.end()}; }
};

/// As `cp -p` or `mv` of another file does: other bytes, and no newer.
void replaceOlder(const std::string& path, const std::string& contents) {
    const auto time = fs::last_write_time(path);
    writeFile(path, contents);
    fs::last_write_time(path, time);
}

}  // namespace

TEST_SUITE_BEGIN("update");

TEST_CASE("-u bakes what is missing, touched, or another texture, and nothing else") {
    using Some = std::set<std::string>;
    const Folder folder;
    const Scratch& scratch = folder.scratch;
    CHECK(folder.baked() == folder.all());
    CHECK(folder.baked() == Some{});
    fs::remove(scratch.path("out/b.exr"));
    CHECK(folder.baked() == Some{"b.png"});
    const auto soon = fs::last_write_time(scratch.path("out/c.exr")) + std::chrono::seconds(2);
    fs::last_write_time(scratch.path("in/c.png"), soon);
    CHECK(folder.baked() == Some{"c.png"});
    fs::last_write_time(scratch.path("in/c.png"), soon - std::chrono::seconds(4));
    CHECK(folder.baked() == Some{});
    replaceOlder(scratch.path("in/d.png"), contentsOf(testImage("rgb8.png")));
    CHECK(folder.baked() == Some{"d.png"});
    writeFile(scratch.path("out/a.exr"), "newer, and no spectra");
    CHECK(folder.baked() == Some{"a.png"});
    CHECK(folder.baked() == Some{});
}

TEST_CASE("-u bakes all anew when an option changes that the bytes depend on") {
    const Folder folder;
    CHECK(folder.baked() == folder.all());
    const Names options[] = {{"--bits", "9"},
                             {"--max-de", "0.5"},
                             {"--max-deviation", "0.01"},
                             {"--grid", "9"},
                             {"--per-texel"},
                             {"--method", "descent"},
                             {"--outside", "scale"},
                             {"--illuminant", "A"},
                             {"--space", "lin_rec709"},
                             {"--channels", "R"},
                             {"--part", "0"},
                             {"--orient"},
                             {"--data-type", "float"},
                             {"--compression", "piz"},
                             {"--compression", "zip:2"},
                             {"--tile", "16", "8"},
                             {"--mipmap"}};
    for (const Names& some : options) {
        CAPTURE(some);
        CHECK(folder.baked(some) == folder.all());
        CHECK(folder.baked(some).empty());
    }
    for (const Names& same : {Names{"--mipmap", "-j", "3"}, Names{"--mipmap", "-q"}}) {
        CAPTURE(same);
        CHECK(folder.baked(same).empty());
    }
}

TEST_CASE("-u without a change gives the bytes of a bake without -u") {
    const Folder folder;
    REQUIRE(folder.baked() == folder.all());
    const std::string updated = contentsOf(folder.scratch.path("out/a.exr"));
    const std::string alone = folder.scratch.path("alone.exr");
    REQUIRE(runTool({"bake", folder.scratch.path("in/a.png"), "-o", alone}).exitCode == 0);
    CHECK(updated == contentsOf(alone));
}

TEST_CASE("an interrupted batch run again with -u makes only what is missing") {
    const Folder folder;
    for (const std::string& name : folder.textures) {
        fs::copy(testImage("demo.png"), folder.scratch.path("in/" + name),
                 fs::copy_options::overwrite_existing);
    }
    const Names slow = {"-j", "1", "-d", "float", "--compression", "zip:9"};
    Process batch(folder.words(slow));
    const std::string first = folder.scratch.path("out/a.exr");
    while (!fs::exists(first) && batch.isRunning()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    batch.send(SIGINT);
    CHECK(batch.wait().signal == SIGINT);
    std::set<std::string> missing = folder.all();
    for (const auto& entry : fs::directory_iterator(folder.scratch.path("out"))) {
        CHECK(entry.path().extension() == ".exr");  // nothing half-written
        missing.erase(entry.path().stem().string() + ".png");
    }
    REQUIRE(!missing.empty());
    CHECK(missing.count("a.png") == 0);
    CHECK(folder.baked(slow) == missing);
}

TEST_SUITE_END();
