#pragma once

#include "batch/plan.h"
#include "farm/records.h"
#include "farm/shard.h"

#include <specbake/image/texture_reader.h>

#include <string>
#include <vector>

namespace specbake::tool {

/// The items of one shard, in their order; with a shard that is of a plan only, none.
struct Task {
    std::vector<BatchItem> items;
    std::string plan;  ///< how the shards come out, a line
};

/// What a shard takes of a list. All tasks of a farm come to the same shards, whatever is baked
/// already: by the list, and by sizes that they share in the folder of the records. What is passed
/// over is in none. Throws FileError.
Task takeShard(const Shard& shard, std::vector<BatchItem> items, const ReadOptions& read,
               const Records& records);

}  // namespace specbake::tool
