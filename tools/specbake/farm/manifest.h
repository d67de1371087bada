#pragma once

#include "batch/plan.h"

#include <specbake/image/texture_reader.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace specbake::tool {

/// The pixels of each item that is to be baked, as its header tells; 0 for what cannot be read.
///
/// They are read once for a list and kept in `folder`, in a file whose name is of the list alone:
/// the first task that has them all puts the file there whole, the others take what is there. So
/// all tasks see the same numbers, even where a texture changes between their starts. Throws
/// FileError if the folder cannot be written.
std::vector<std::uint64_t> sharedSizes(std::span<const BatchItem> items, const ReadOptions& read,
                                       const std::filesystem::path& folder);

}  // namespace specbake::tool
