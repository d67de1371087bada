#include "farm/tiles.h"
#include "process.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numeric>

using namespace specbake::testing;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

const std::vector<std::pair<int, int>> kSides = {{40, 30}, {1, 1},   {17, 5},  {64, 64}, {3, 50},
                                                 {64, 64}, {20, 20}, {33, 31}, {8, 9},   {64, 63}};

std::string shard(int index, int count) {
    return std::to_string(index) + '/' + std::to_string(count);
}

/// The tiles that a shard took, all baked.
std::vector<std::size_t> taken(const Tiles& tiles, const std::string& shard) {
    const Outcome outcome = runTool(tiles.words("bake", {"--shard", shard, "--stats", "-", "-q"}));
    CAPTURE(outcome.err);
    CHECK(outcome.exitCode == 0);
    std::vector<std::size_t> numbers;
    for (const auto& [tile, status] : throughOf(tiles, outcome.out)) {
        CHECK(status == "baked");
        numbers.push_back(tile);
    }
    return numbers;
}

std::vector<std::vector<std::size_t>> allTaken(const Tiles& tiles, int count) {
    std::vector<std::vector<std::size_t>> all;
    for (int i = 1; i <= count; ++i) all.push_back(taken(tiles, shard(i, count)));
    return all;
}

/// 0, 1, … once each, in whatever shard.
void checkComplete(const std::vector<std::vector<std::size_t>>& shards, std::size_t tiles) {
    std::vector<std::size_t> all;
    for (const auto& some : shards) all.insert(all.end(), some.begin(), some.end());
    std::sort(all.begin(), all.end());
    std::vector<std::size_t> expected(tiles);
    std::iota(expected.begin(), expected.end(), std::size_t(0));
    CHECK(all == expected);
}

/// The manifests of a farm.
Names manifests(const Tiles& tiles) {
    Names names;
    for (const auto& entry : fs::directory_iterator(tiles.out + "/.specbake")) {
        if (entry.is_regular_file()) names.push_back(entry.path().string());
    }
    return names;
}

}  // namespace

TEST_SUITE_BEGIN("shard");

TEST_CASE("shards take each texture once, and are alike in pixels") {
    for (const int count : {1, 2, 3, 7, 12}) {
        CAPTURE(count);
        const Tiles tiles(kSides);
        const auto shards = allTaken(tiles, count);
        checkComplete(shards, tiles.pixels.size());
        // When the shard with the most was given its last tile, it had no more than the mean of
        // what was given by then: load - last <= (all - last) / count.
        const auto& pixels = tiles.pixels;
        const auto all = std::accumulate(pixels.begin(), pixels.end(), std::uint64_t(0));
        const auto largest = *std::max_element(pixels.begin(), pixels.end());
        for (const auto& some : shards) {
            std::uint64_t load = 0;
            for (const std::size_t tile : some) load += pixels[tile];
            CHECK(load * std::uint64_t(count) <= all + (std::uint64_t(count) - 1) * largest);
        }
    }
}

TEST_CASE("shards are the list's alone, whatever is baked and whatever becomes of the tiles") {
    const Tiles tiles(kSides);
    const auto before = allTaken(tiles, 3);
    const Names known = manifests(tiles);
    REQUIRE(known.size() == 1);
    tiles.write(1, 300, 200);  // was the smallest, and is the largest
    fs::remove(tiles.result(0));
    CHECK(allTaken(tiles, 3) == before);
    CHECK(manifests(tiles) == known);
    writeFile(tiles.scratch.path("list.txt"), tiles.name(4) + '\n' + tiles.name(2) + '\n');
    CHECK(taken(tiles, "1/2") == std::vector<std::size_t>{4});
    CHECK(manifests(tiles).size() == 2);
}

TEST_CASE("a manifest that is damaged is made again") {
    const Tiles tiles(kSides);
    const auto before = taken(tiles, "2/3");
    const std::string manifest = manifests(tiles).at(0);
    const std::string contents = contentsOf(manifest);
    for (const std::string& damaged : {std::string(), contents.substr(0, contents.size() / 2)}) {
        writeFile(manifest, damaged);
        CHECK(taken(tiles, "2/3") == before);
        CHECK(contentsOf(manifest) == contents);
    }
}

TEST_CASE("tasks that begin at once agree, and the same tile twice does no harm") {
    const Tiles tiles(kSides);
    std::vector<std::unique_ptr<Process>> tasks;
    for (const char* shard : {"1/3", "2/3", "3/3", "1/3", "2/3", "3/3"}) {
        tasks.push_back(std::make_unique<Process>(
            tiles.words("bake", {"--shard", shard, "--stats", "-", "-q", "-j", "1"})));
    }
    std::vector<std::vector<std::size_t>> taken;
    for (const auto& task : tasks) {
        const Outcome outcome = task->wait();
        CAPTURE(outcome.err);
        CHECK(outcome.exitCode == 0);
        taken.emplace_back();
        for (const auto& [tile, _] : throughOf(tiles, outcome.out)) taken.back().push_back(tile);
    }
    CHECK(taken[0] == taken[3]);
    CHECK(taken[1] == taken[4]);
    CHECK(taken[2] == taken[5]);
    checkComplete({taken[0], taken[1], taken[2]}, tiles.pixels.size());
    CHECK(manifests(tiles).size() == 1);
    for (std::size_t i = 0; i < tiles.pixels.size(); ++i) {
        const std::string alone = tiles.scratch.path("alone.exr");
        REQUIRE(runTool({"bake", "-q", tiles.name(i), "-o", alone}).exitCode == 0);
        CHECK(contentsOf(tiles.result(i)) == contentsOf(alone));
    }
    CHECK(std::distance(fs::directory_iterator(tiles.out), {}) ==
          std::ptrdiff_t(tiles.pixels.size()) + 1);  // and the folder of records
}

TEST_CASE("a task that is run again with -u goes on where it was") {
    const Tiles tiles(kSides);
    const auto first = taken(tiles, "2/2");
    fs::remove(tiles.result(first.at(1)));
    const Outcome again =
        runTool(tiles.words("bake", {"--shard", "2/2", "-u", "--stats", "-", "-q"}));
    CHECK(again.exitCode == 0);
    for (const auto& [tile, status] : throughOf(tiles, again.out)) {
        CHECK(status == (tile == first.at(1) ? "baked" : "current"));
    }
}

TEST_CASE("0/N tells of the shards, and bakes nothing") {
    const Tiles tiles({{1000, 1}, {1000, 1}, {500, 2}, {100, 10}, {1000, 1}});
    const Outcome outcome = runTool(tiles.words("bake", {"--shard", "0/2"}));
    CHECK(outcome.exitCode == 0);
    CHECK(outcome.out ==
          "5 textures of 0.005 million pixels in 2 shards of 0.002 to 0.003 million\n");
    CHECK(manifests(tiles).size() == 1);
    CHECK(!fs::exists(tiles.result(0)));
}

TEST_CASE("auto is what a scheduler says") {
    struct Case {
        std::vector<std::pair<std::string, std::string>> environment;
        std::string shard;  ///< empty: refused
    };
    const auto slurm = [](const std::string& id, const std::string& first, const std::string& last,
                          const std::string& step, const std::string& count) {
        return std::vector<std::pair<std::string, std::string>>{{"SLURM_ARRAY_TASK_ID", id},
                                                                {"SLURM_ARRAY_TASK_MIN", first},
                                                                {"SLURM_ARRAY_TASK_MAX", last},
                                                                {"SLURM_ARRAY_TASK_STEP", step},
                                                                {"SLURM_ARRAY_TASK_COUNT", count}};
    };
    const std::vector<Case> cases = {
        {slurm("1", "1", "3", "1", "3"), "1/3"},
        {slurm("2", "0", "2", "1", "3"), "3/3"},
        {slurm("20", "10", "30", "10", "3"), "2/3"},
        {slurm("20", "10", "35", "10", "3"), "2/3"},
        {slurm("5", "3", "5", "1", "2"), ""},  // --array=3,5: two of how many?
        {slurm("x", "1", "3", "1", "3"), ""},
        {{{"SLURM_ARRAY_TASK_ID", "1"}}, ""},
        {{{"AWS_BATCH_JOB_ARRAY_INDEX", "0"}, {"AWS_BATCH_JOB_ARRAY_SIZE", "3"}}, "1/3"},
        {{{"AWS_BATCH_JOB_ARRAY_INDEX", "2"}, {"AWS_BATCH_JOB_ARRAY_SIZE", "3"}}, "3/3"},
        {{{"AWS_BATCH_JOB_ARRAY_INDEX", "3"}, {"AWS_BATCH_JOB_ARRAY_SIZE", "3"}}, ""},
        {{{"AWS_BATCH_JOB_ARRAY_INDEX", "-1"}, {"AWS_BATCH_JOB_ARRAY_SIZE", "3"}}, ""},
        {{{"JOB_COMPLETION_INDEX", "1"}, {"SPECBAKE_SHARDS", "3"}}, "2/3"},
        {{{"JOB_COMPLETION_INDEX", "1"}}, ""},
        {{}, ""}};
    const Tiles tiles({{9, 9}, {8, 8}, {7, 7}});
    for (const auto& [environment, shard] : cases) {
        CAPTURE(shard);
        std::vector<std::unique_ptr<SetVariable>> variables;
        for (const auto& [name, value] : environment) {
            CAPTURE(name);
            variables.push_back(std::make_unique<SetVariable>(name, value));
        }
        if (!shard.empty()) {
            CHECK(taken(tiles, "auto") == taken(tiles, shard));
            continue;
        }
        const Outcome refused = runTool(tiles.words("bake", {"--shard", "auto"}));
        CHECK(refused.exitCode == 2);
        CHECK(linesOf(refused.err).size() == 1);
    }
    for (const char* text : {"3", "0/0", "4/3", "-1/3", "1/x", "/", "1/3/3", "1/-3", "all"}) {
        CAPTURE(text);
        CHECK(runTool(tiles.words("bake", {std::string("--shard=") + text})).exitCode == 2);
    }
}

TEST_SUITE_END();
