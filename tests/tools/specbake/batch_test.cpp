#include "process.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <thread>

using namespace specbake::testing;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

void copyTo(const Scratch& scratch, const std::string& image, const std::string& name) {
    fs::create_directories(fs::path(scratch.path(name)).parent_path());
    fs::copy(testImage(image), scratch.path(name), fs::copy_options::overwrite_existing);
}

/// The lines of --stats, by their inputs' names in the folder.
std::map<std::string, nlohmann::json> statsOf(const Scratch& scratch, const std::string& text) {
    std::map<std::string, nlohmann::json> stats;
    for (const std::string& line : linesOf(text)) {
        const auto json = nlohmann::json::parse(line);
        const fs::path input = json.at("input").get<std::string>();
        stats[input.lexically_relative(scratch.path("")).string()] = json;
    }
    return stats;
}

/// How many textures came to each status.
std::map<std::string, int> statuses(const std::string& stats) {
    std::map<std::string, int> counts;
    for (const std::string& line : linesOf(stats)) {
        ++counts[nlohmann::json::parse(line).at("status").get<std::string>()];
    }
    return counts;
}

/// The files below a folder, as paths from there.
Names tree(const std::string& folder) {
    Names names;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            names.push_back(entry.path().lexically_relative(folder).string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string baked(const std::string& image, const Names& options) {
    const Scratch scratch;
    Names words = {"bake", "-q", image, "-o", scratch.path("o.exr")};
    words.insert(words.end(), options.begin(), options.end());
    REQUIRE(runTool(words).exitCode == 0);
    return contentsOf(scratch.path("o.exr"));
}

void checkRefused(const Scratch& scratch, const Names& words, const std::string& says) {
    const Names before = tree(scratch.path(""));
    const Outcome outcome = runTool(words);
    CAPTURE(outcome.err);
    CHECK(outcome.exitCode == 2);
    CHECK(linesOf(outcome.err).size() == 1);
    CHECK(outcome.err.find(says) != std::string::npos);
    CHECK(tree(scratch.path("")) == before);
}

}  // namespace

TEST_SUITE_BEGIN("batch");

TEST_CASE("many at once have the bytes that each has alone") {
    struct Case {
        Names images, options;
    };
    const Names few = {"17x33.png", "rgba_half.exr", "rgb8.png", "rgb16.png"};
    const Case cases[] = {{testImages(), {}},
                          {few, {"--max-de", "0.5", "--mipmap"}},
                          {few, {"--max-deviation", "0.02", "-d", "float"}}};
    for (const auto& [images, options] : cases) {
        CAPTURE(options);
        const Scratch scratch;
        Names words = {"bake", "-q", "--stats", scratch.path("stats")};
        for (const std::string& image : images) words.push_back(testImage(image));
        words.insert(words.end(), options.begin(), options.end());
        for (const std::string threads : {"1", "3"}) {
            Names some = words;
            some.insert(some.end(), {"-j", threads, "-o", scratch.path(threads + "/{name}.exr")});
            CHECK(runTool(some).exitCode == 0);
            CHECK(statuses(contentsOf(scratch.path("stats")))["baked"] == int(images.size()));
        }
        for (const std::string& image : images) {
            CAPTURE(image);
            const std::string alone = baked(testImage(image), options);
            CHECK(contentsOf(scratch.path(std::string("1/") + image + ".exr")) == alone);
            CHECK(contentsOf(scratch.path(std::string("3/") + image + ".exr")) == alone);
        }
    }
}

TEST_CASE("a large texture among small ones has the bytes that it has alone") {
    const Scratch scratch;
    std::string pixels;
    for (int i = 0; i < 1024 * 1024; ++i) pixels += {char(i / 65536 * 8), char(90), char(200)};
    fs::create_directory(scratch.path("in"));
    writeFile(scratch.path("in/large.ppm"), "P6 1024 1024 255\n" + pixels);
    copyTo(scratch, "17x33.png", "in/small.png");
    const Outcome outcome = runTool({"bake", scratch.path("in"), "-o", scratch.path("out")});
    CHECK(outcome.exitCode == 0);
    CHECK(contentsOf(scratch.path("out/large.exr")) == baked(scratch.path("in/large.ppm"), {}));
    CHECK(contentsOf(scratch.path("out/small.exr")) == baked(testImage("17x33.png"), {}));
}

TEST_CASE("a folder is all its images, and results lie in like folders") {
    const Scratch scratch;
    copyTo(scratch, "1x1.png", "tex/a.png");
    copyTo(scratch, "rgb8.jpg", "tex/hull/b.JPG");
    copyTo(scratch, "rgb_half.exr", "tex/hull/deep/c.exr");
    copyTo(scratch, "1x1.png", "tex/.hidden.png");
    copyTo(scratch, "1x1.png", "tex/.git/d.png");
    writeFile(scratch.path("tex/notes.txt"), "no image");
    const Names bake = {"bake", scratch.path("tex"), "-o", scratch.path("out")};
    CHECK(runTool(bake).exitCode == 0);
    CHECK(tree(scratch.path("out")) == Names{"a.exr", "hull/b.exr", "hull/deep/c.exr"});
}

TEST_CASE("results beside their textures are no textures of the next run") {
    const Scratch scratch;
    copyTo(scratch, "1x1.png", "a.png");
    copyTo(scratch, "rgb_half.exr", "b.exr");
    const Names bake = {"bake", scratch.path(""), "-o", "{dir}/{stem}.spectral.exr", "--stats",
                        "-"};
    CHECK(statuses(runTool(bake).out) == std::map<std::string, int>{{"baked", 2}});
    const std::map<std::string, int> again = {{"baked", 2}, {"passed over", 2}};
    CHECK(statuses(runTool(bake).out) == again);
    CHECK(scratch.names() == Names{"a.png", "a.spectral.exr", "b.exr", "b.spectral.exr"});
}

TEST_CASE("tiles and frames are found by their tokens, and keep their numbers") {
    struct Case {
        std::string token, number, other;
    };
    for (const Case& c : {Case{"<UDIM>", "1001", "0999"}, Case{"%(UDIM)d", "1042", "101"},
                          Case{"_MAPID_", "1010", "10100"}, Case{"<UVTILE>", "u1_v12", "u0_v1"},
                          Case{"%(UVTILE)d", "u3_v1", "1001"}, Case{"%04d", "0007", "007"},
                          Case{"%04d", "12345", "7"}, Case{"####", "0010", "10"},
                          Case{"#", "0010", "010"}, Case{"##", "07", "7"}, Case{"%d", "7", "x7"}}) {
        CAPTURE(c.token);
        const Scratch scratch;
        copyTo(scratch, "1x1.png", "w." + c.number + ".png");
        copyTo(scratch, "1x1.png", "w." + c.other + ".png");
        const std::string words = scratch.path("w." + c.token + ".png");
        CHECK(runTool({"bake", words, "-o", scratch.path("o/x" + c.token + ".exr")}).exitCode == 0);
        CHECK(tree(scratch.path("o")) == Names{"x" + c.number + ".exr"});
        CHECK(runTool({"bake", words, "-o", scratch.path("p/{number}_{stem}.exr")}).exitCode == 0);
        CHECK(tree(scratch.path("p")) == Names{c.number + "_w." + c.number + ".exr"});
        CHECK(runTool({"bake", words, "-o", scratch.path("q")}).exitCode == 0);
        CHECK(tree(scratch.path("q")) == Names{"w." + c.number + ".exr"});
    }
}

TEST_CASE("patterns, lists and names together are each file once") {
    const Scratch scratch;
    for (const char* name : {"a.png", "b.png", "c d.png", "e[1].png"}) {
        copyTo(scratch, "1x1.png", name);
    }
    writeFile(scratch.path("list.txt"), "# what is wanted\r\n" + scratch.path("c d.png") +
                                            "\r\n\n" + scratch.path("[ab].png"));
    const Names bake = {
        "bake", scratch.path("a.png"),      std::string("@") + scratch.path("list.txt"),
        "-o",   scratch.path("out"),        scratch.path("e[1].png"),
        "-v",   scratch.path("{b,c d}.*ng")};
    const Outcome outcome = runTool(bake);
    CHECK(outcome.exitCode == 0);
    CHECK(tree(scratch.path("out")) == Names{"a.exr", "b.exr", "c d.exr", "e[1].exr"});
    CHECK(linesOf(outcome.out).size() == 9);  // two a file, and the table
}

TEST_CASE("one texture goes into a folder that is there, or where a pattern says") {
    const Scratch scratch;
    copyTo(scratch, "1x1.png", "a.b.png");
    fs::create_directory(scratch.path("out"));
    CHECK(runTool({"bake", scratch.path("a.b.png"), "-o", scratch.path("out")}).exitCode == 0);
    CHECK(
        runTool({"bake", scratch.path("a.b.png"), "-o", "{dir}/x/{ext}.{{{name}}}.exr"}).exitCode ==
        0);
    CHECK(tree(scratch.path("")) == Names{"a.b.png", "out/a.b.exr", "x/png.{a.b.png}.exr"});
}

TEST_CASE("--report of several writes a page about each") {
    const Scratch scratch;
    copyTo(scratch, "1x1.png", "in/a.png");
    copyTo(scratch, "17x33.png", "in/sub/b.png");
    const std::string in = scratch.path("in");
    const std::string out = scratch.path("out");
    const std::string pages = scratch.path("pages");
    REQUIRE(runTool({"bake", "-q", in, "-o", out, "--report", pages}).exitCode == 0);
    CHECK(tree(pages) == Names{"a.html", "sub/b.html"});
    CHECK(contentsOf(pages + "/a.html").find("a.png") != std::string::npos);
    CHECK(contentsOf(pages + "/sub/b.html").find("b.png") != std::string::npos);
    checkRefused(scratch, {"bake", in, "-o", out, "--report", out + ".html"},
                 "several textures need a folder");
    checkRefused(scratch, {"bake", in, "-o", out, "--report", pages + "/{ext}.html"},
                 "would become this file");
    checkRefused(scratch, {"bake", in, "-o", out, "--report", "{dir}/{stem}.png"}, "is an input");
}

TEST_CASE("what could not come out well is refused before anything is begun") {
    const Scratch scratch;
    for (const char* name : {"a.png", "b.exr", "a.tif", "sub/a.png", "w.1001.png"}) {
        copyTo(scratch, "1x1.png", name);
    }
    fs::create_directory(scratch.path("empty"));
    const std::string a = scratch.path("a.png");
    const std::string tif = scratch.path("a.tif");
    const std::string exr = scratch.path("b.exr");
    const std::string out = scratch.path("out");
    checkRefused(scratch, {"bake", a, tif, "-o", out}, "would become this file");
    checkRefused(scratch, {"bake", a, tif, "-o", out + ".exr"}, "several textures need a folder");
    checkRefused(scratch, {"bake", a, exr, "-o", "{dir}/{stem}.exr"}, "the output is an input");
    checkRefused(scratch, {"bake", tif, exr, "-o", "{dir}/b.exr"}, "the output is an input");
    checkRefused(scratch, {"bake", a, tif, "-o", out + "/{name}"}, "must end in .exr");
    checkRefused(scratch, {"bake", a, tif, "-o", out + "/{base}.exr"}, "there is no {base}");
    checkRefused(scratch, {"bake", a, tif, "-o", out + "/{stem.exr"}, "without its other half");
    checkRefused(scratch, {"bake", a, tif, "-o", out + "/stem}.exr"}, "without its other half");
    checkRefused(scratch, {"bake", a, tif, "-o", out + "/w.<UDIM>.exr"}, "has no number");
    checkRefused(scratch, {"bake", scratch.path("*.jpg"), "-o", out}, "*.jpg: no file matches");
    checkRefused(scratch, {"bake", scratch.path("a.<UDIM>.png"), "-o", out}, "no file matches");
    checkRefused(scratch, {"bake", scratch.path("empty"), "-o", out}, "no images in this folder");
    CHECK(runTool({"bake", std::string("@") + scratch.path("absent"), "-o", out}).exitCode == 1);
}

TEST_CASE("one that fails does not stop the rest, and every file has its line") {
    const Scratch scratch;
    copyTo(scratch, "1x1.png", "in/a.png");
    copyTo(scratch, "17x33.png", "in/z.png");
    writeFile(scratch.path("in/b.png"), "no PNG");
    writeFile(scratch.path("in/c.jpg"), contentsOf(testImage("rgb8.jpg")).substr(0, 300));
    const Names bake = {"bake", scratch.path("in"), scratch.path("absent.png"), "-o",
                        scratch.path("out")};
    const Outcome outcome = runTool(bake);
    CHECK(outcome.exitCode == 1);
    CHECK(tree(scratch.path("out")) == Names{"a.exr", "z.exr"});
    CHECK(linesOf(outcome.err).size() == 3);
    CHECK(outcome.out.find("       2  baked") != std::string::npos);
    CHECK(outcome.out.find("       3  failed") != std::string::npos);
    CHECK(outcome.out.find(std::string(10, ' ') + scratch.path("absent.png") + ": ") !=
          std::string::npos);

    Names withStats = bake;
    withStats.insert(withStats.end(), {"--stats", "-", "-q"});
    const Outcome told = runTool(withStats);
    CHECK(told.exitCode == 1);
    const auto stats = statsOf(scratch, told.out);
    CHECK(stats.size() == 5);
    CHECK(stats.at("in/z.png").at("status") == "baked");
    CHECK(stats.at("in/z.png").at("texels") == 17 * 33);
    CHECK(stats.at("in/z.png").at("output") == scratch.path("out/z.exr"));
    for (const char* name : {"in/b.png", "in/c.jpg", "absent.png"}) {
        CHECK(stats.at(name).at("status") == "failed");
        CHECK(!stats.at(name).at("error").get<std::string>().empty());
    }

    withStats[withStats.size() - 2] = scratch.path("stats");
    CHECK(runTool(withStats).exitCode == 1);
    const Names lines = linesOf(contentsOf(scratch.path("stats")));
    REQUIRE(lines.size() == 5);  // in the order of the inputs
    CHECK(lines.front().find("in/a.png") != std::string::npos);
    CHECK(lines.back().find("absent.png") != std::string::npos);
}

TEST_CASE("--stats of one texture tells a failure, and goes to stdout as -") {
    const Scratch scratch;
    const std::string output = scratch.path("o.exr");
    const auto stats = [&](const std::string& input) {
        return nlohmann::json::parse(
            runTool({"bake", input, "-v", "-o", output, "--stats", "-"}).out);
    };
    CHECK(stats(testImage("1x1.png")).at("texels") == 1);
    writeFile(scratch.path("b.png"), "no PNG");
    CHECK(stats(scratch.path("b.png")).at("error").get<std::string>().find("b.png: ") !=
          std::string::npos);
    copyTo(scratch, "1x1.png", "caf\xe9.png");  // Latin-1
    CHECK(stats(scratch.path("caf\xe9.png")).at("texels") == 1);
    CHECK(!fs::exists("-"));
}

TEST_SUITE_END();
