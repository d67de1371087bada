#include "farm/shard.h"

#include <specbake/core/error.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>

namespace specbake::tool {
namespace {

constexpr int kMostShards = 1'000'000;

std::optional<int> number(const std::string& text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return {};
    return value;
}

bool isSet(const char* name) {
    return std::getenv(name) != nullptr;
}

/// Of a variable that has to be there.
int fromEnvironment(const char* name) {
    const char* text = std::getenv(name);
    const auto value = number(text == nullptr ? "" : text);
    if (value) return *value;
    throw ArgumentError(std::string("--shard auto: ") + name +
                        (text == nullptr ? " is not set" : " is no number: " + std::string(text)));
}

Shard checked(Shard shard, const std::string& source) {
    if (shard.count >= 1 && shard.count <= kMostShards && shard.index >= 0 &&
        shard.index <= shard.count) {
        return shard;
    }
    throw ArgumentError("--shard " + source + ": there is no shard " + std::to_string(shard.index) +
                        " of " + std::to_string(shard.count));
}

/// A part of an array, as of `--array=3,5`, does not know of how many shards it is a part.
Shard ofSlurm() {
    const int id = fromEnvironment("SLURM_ARRAY_TASK_ID");
    const int first = fromEnvironment("SLURM_ARRAY_TASK_MIN");
    const int last = fromEnvironment("SLURM_ARRAY_TASK_MAX");
    const int count = fromEnvironment("SLURM_ARRAY_TASK_COUNT");
    const int step = isSet("SLURM_ARRAY_TASK_STEP") ? fromEnvironment("SLURM_ARRAY_TASK_STEP") : 1;
    if (step < 1 || (last - first) / step + 1 != count || (id - first) % step != 0) {
        throw ArgumentError(
            "--shard auto: the tasks of this Slurm array are not all of a row, so that they "
            "cannot be counted; name the shard as I/N");
    }
    return checked({(id - first) / step + 1, count}, "auto");
}

Shard ofEnvironment() {
    if (isSet("SLURM_ARRAY_TASK_ID")) return ofSlurm();
    Shard shard;
    if (isSet("AWS_BATCH_JOB_ARRAY_INDEX")) {
        shard.index = fromEnvironment("AWS_BATCH_JOB_ARRAY_INDEX");
        shard.count = fromEnvironment("AWS_BATCH_JOB_ARRAY_SIZE");
    } else if (isSet("JOB_COMPLETION_INDEX")) {
        shard.index = fromEnvironment("JOB_COMPLETION_INDEX");
        shard.count = fromEnvironment("SPECBAKE_SHARDS");
    } else {
        throw ArgumentError(
            "--shard auto: the environment is of no array's task: it has none of "
            "SLURM_ARRAY_TASK_ID, AWS_BATCH_JOB_ARRAY_INDEX and JOB_COMPLETION_INDEX");
    }
    ++shard.index;
    if (shard.index == 0) shard.index = -1;  // which would be a plan
    return checked(shard, "auto");
}

}  // namespace

Shard parseShard(const std::string& text) {
    if (text == "auto") return ofEnvironment();
    const std::size_t sign = text.find('/');
    const auto index = number(text.substr(0, sign));
    const auto count = sign == std::string::npos ? std::nullopt : number(text.substr(sign + 1));
    if (!index || !count) throw ArgumentError("--shard: I/N, as 3/8, or auto, not " + text);
    return checked({*index, *count}, text);
}

std::vector<int> assignShards(std::span<const std::uint64_t> pixels, int count) {
    std::vector<std::size_t> order(pixels.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return pixels[a] > pixels[b]; });
    using Load = std::tuple<std::uint64_t, std::size_t, int>;  // pixels, items, shard
    std::priority_queue<Load, std::vector<Load>, std::greater<>> least;
    for (int shard = 0; shard < count; ++shard) least.emplace(0, 0, shard);
    std::vector<int> shards(pixels.size());
    for (const std::size_t item : order) {
        const auto [load, items, shard] = least.top();
        least.pop();
        shards[item] = shard;
        least.emplace(load + pixels[item], items + 1, shard);
    }
    return shards;
}

}  // namespace specbake::tool
