#pragma once

#include <filesystem>
#include <optional>

namespace specbake::tool {

/// How many threads this process was given: the least of
///
///     the processors that it may run on (sched_getaffinity)
///     the quota of processor time of its control groups, v1 or v2, rounded up
///     $SLURM_CPUS_PER_TASK, which Slurm sets where it does not itself bind a task
///
/// but at least 1.
int allottedThreads();

/// The least quota of processor time, in processors, among the control groups of this process and
/// those that these are in; nothing if there is none. `root`: where /proc and the mounts that it
/// names are looked for.
std::optional<double> processorQuota(const std::filesystem::path& root = "/");

}  // namespace specbake::tool
