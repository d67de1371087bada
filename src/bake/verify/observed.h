#pragma once

#include "verify/texel_comparison.h"

#include <specbake/bake/verify.h>
#include <specbake/core/upsampler.h>

#include <functional>
#include <span>
#include <string>

namespace specbake::internal {

/// Rows of texels that were compared.
struct ComparedRows {
    int first = 0;  ///< counted from 0 in the data window
    int count = 0;
    std::span<const float> bands;  ///< of each texel all that the file has
    std::span<const TexelDifference> texels;
};

/// Takes rows as they are done: in order, one call at a time. `model` says under which light and in
/// which space was compared.
using RowsObserver = std::function<void(const ComparedRows& rows, const Upsampler& model)>;

/// verify(), looked at. Without an observer it keeps less.
Verification verifyObserved(const std::string& spectral, const std::string& texture,
                            const VerifyOptions& options, const RowsObserver& observer);

}  // namespace specbake::internal
