#pragma once

#include "batch/plan.h"

#include <specbake/bake/bake.h>

#include <exception>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace specbake::tool {

enum class Outcome {
    baked,
    current,  ///< it was so already, and -u was given
    passed,   ///< found in a folder or by a pattern, and a spectral image itself
    failed,
    left  ///< not begun, or not ended, when the program was stopped
};

/// What became of one texture.
struct BatchResult {
    Outcome outcome = Outcome::left;
    std::string reason;         ///< of a failure: one line, without the texture's name
    BakeStatistics statistics;  ///< of a bake
};

struct BatchOptions {
    BakeOptions bake;  ///< of each texture: `progress` apart, `threads` for all together
    bool update = false;
    std::function<void(double)> progress;  ///< called with 0 to 1
    /// Called when a texture is through; by one thread at a time, as `progress` is.
    std::function<void(const BatchItem&, const BatchResult&)> finished;
};

/// Of "FILE: REASON" the reason.
std::string reasonOf(const std::exception& error, const std::string& file);

/// Bakes all items, with models that they share: small textures side by side, large ones with all
/// threads. One that fails does not stop the others. The results are in the order of the items; the
/// files have the bytes that they would have if each was baked alone.
std::vector<BatchResult> runBatch(std::span<const BatchItem> items, const BatchOptions& options);

}  // namespace specbake::tool
