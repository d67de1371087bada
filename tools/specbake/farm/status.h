#pragma once

#include "batch/plan.h"
#include "farm/records.h"

#include <specbake/bake/bake.h>
#include <specbake/bake/up_to_date.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace specbake::tool {

/// How a texture of a batch stands.
enum class Standing {
    done,      ///< its result is current, as `-u` has it
    missing,   ///< it has no result
    outdated,  ///< its result is of another texture, of other options, of another version
    failed     ///< not done, and it cannot be read, or a record tells why it could not be baked
};

struct ItemStatus {
    Standing standing = Standing::missing;
    std::string reason;  ///< of what is outdated or failed
};

/// "done", "missing", "out of date", "failed"
const char* standingName(Standing standing);

/// How each of the items stands. Nothing is written.
std::vector<ItemStatus> statusOf(std::span<const BatchItem> items, BakeOptions options,
                                 SourceCheck check, const Records& records);

/// Temporary files in the folders of the results: a process died, or is at it.
std::vector<std::filesystem::path> leftovers(std::span<const BatchItem> items);

}  // namespace specbake::tool
