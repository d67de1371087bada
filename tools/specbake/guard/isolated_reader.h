#pragma once

#include <specbake/image/isolation.h>

namespace specbake::tool {

/// Has images read by processes of this program.
void isolate(Isolation isolation);

/// Whether this process is one of those; nothing that a user types makes it one.
bool isIsolatedReader(int argc, char** argv);

/// What it does then. Returns what the process returns.
int serveReads();

}  // namespace specbake::tool
