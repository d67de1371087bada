#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace specbake::tool {

/// One of the parts that a list is baked in, one task of a scheduler each.
struct Shard {
    int index = 1;  ///< from 1; 0: none of them, but how they come out is told
    int count = 1;

    bool planOnly() const { return index == 0; }
};

/// Of `--shard`: "I/N", or "auto" by what a scheduler tells an array's task in its environment:
///
///     Slurm        SLURM_ARRAY_TASK_ID, _MIN, _STEP, _COUNT
///     AWS Batch    AWS_BATCH_JOB_ARRAY_INDEX, _SIZE
///     Kubernetes   JOB_COMPLETION_INDEX; it does not tell of how many: SPECBAKE_SHARDS does
///
/// Throws ArgumentError for a text that is neither, and for an environment that does not tell.
Shard parseShard(const std::string& text);

/// Which shard takes each of the items, by their pixels: from 0. The largest first, each to the
/// shard that has the fewest pixels by then; of such that are equal, to the one with the fewest
/// items. So no shard has more than the mean and one item beyond it.
std::vector<int> assignShards(std::span<const std::uint64_t> pixels, int count);

}  // namespace specbake::tool
