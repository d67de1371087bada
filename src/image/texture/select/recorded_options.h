#pragma once

#include <specbake/image/texture_reader.h>

namespace specbake::internal {

/// The attributes from which ReadOptions::orAsIn() takes the options again.
Attributes recorded(const ReadOptions& options);

}  // namespace specbake::internal
