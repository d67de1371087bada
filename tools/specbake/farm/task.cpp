#include "farm/task.h"

#include "farm/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace specbake::tool {
namespace {

double millions(std::uint64_t pixels) {
    return double(pixels) / 1e6;
}

std::string planOf(std::span<const std::uint64_t> sizes, std::span<const int> shards, int count) {
    std::vector<std::uint64_t> loads(std::size_t(count), 0);
    for (std::size_t i = 0; i < sizes.size(); ++i) loads[std::size_t(shards[i])] += sizes[i];
    const auto [least, most] = std::minmax_element(loads.begin(), loads.end());
    const std::uint64_t all = std::accumulate(loads.begin(), loads.end(), std::uint64_t(0));
    return fmt::format(
        "{} textures of {:.3f} million pixels in {} shards of {:.3f} to {:.3f} million",
        sizes.size(), millions(all), count, millions(*least), millions(*most));
}

}  // namespace

Task takeShard(const Shard& shard, std::vector<BatchItem> items, const ReadOptions& read,
               const Records& records) {
    std::erase_if(items, [](const BatchItem& item) { return item.output.empty(); });
    records.open();
    const auto sizes = sharedSizes(items, read, records.folder());
    const auto shards = assignShards(sizes, shard.count);
    Task task{{}, planOf(sizes, shards, shard.count)};
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (shards[i] == shard.index - 1) task.items.push_back(std::move(items[i]));
    }
    return task;
}

}  // namespace specbake::tool
