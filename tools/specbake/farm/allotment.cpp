#include "farm/allotment.h"

#include <sched.h>
#include <tbb/info.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> split(const std::string& text, char sign) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, sign);) parts.push_back(part);
    return parts;
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::optional<double> ratio(double quota, double period) {
    if (!(quota > 0) || !(period > 0)) return {};
    return quota / period;
}

/// Of "QUOTA PERIOD" or "max PERIOD", in microseconds.
std::optional<double> quotaOfV2(const fs::path& group) {
    std::ifstream in(group / "cpu.max");
    double quota = 0;
    double period = 0;
    if (!(in >> quota >> period)) return {};
    return ratio(quota, period);
}

/// A quota of -1 is none.
std::optional<double> quotaOfV1(const fs::path& group) {
    double quota = 0;
    double period = 0;
    std::ifstream(group / "cpu.cfs_quota_us") >> quota;
    std::ifstream(group / "cpu.cfs_period_us") >> period;
    return ratio(quota, period);
}

/// A mounted tree of control groups, as a line of /proc/self/mountinfo has it (proc(5)):
/// "36 35 98:0 ROOT POINT OPTIONS [TAGS] - TYPE SOURCE OPTIONS".
struct Mount {
    fs::path root;   ///< of the hierarchy, where it is mounted
    fs::path point;  ///< where
    std::string type;
    std::vector<std::string> controllers;  ///< of v1
};

std::vector<Mount> cgroupMounts(const fs::path& root) {
    std::vector<Mount> mounts;
    std::ifstream in(root / "proc/self/mountinfo");
    for (std::string line; std::getline(in, line);) {
        const std::vector<std::string> words = split(line, ' ');
        const auto dash = std::find(words.begin(), words.end(), "-");
        if (words.size() < 6 || words.end() - dash < 4) continue;
        Mount mount{words[3], root / fs::path(words[4]).relative_path(), dash[1],
                    split(dash[3], ',')};
        if (mount.type == "cgroup" || mount.type == "cgroup2") mounts.push_back(std::move(mount));
    }
    return mounts;
}

/// The least of a group and of those that it is in, up to the mount.
template <class Quota>
std::optional<double> leastQuota(const Mount& mount, const fs::path& path, const Quota& quotaOf) {
    fs::path below = path.lexically_relative(mount.root);
    if (below.empty() || *below.begin() == "..") below = ".";
    std::optional<double> least;
    for (fs::path group = (mount.point / below).lexically_normal();; group = group.parent_path()) {
        if (const auto quota = quotaOf(group)) least = std::min(least.value_or(*quota), *quota);
        if (group == mount.point.lexically_normal() || group == group.root_path()) return least;
    }
}

}  // namespace

std::optional<double> processorQuota(const fs::path& root) {
    const std::vector<Mount> mounts = cgroupMounts(root);
    std::optional<double> least;
    std::ifstream in(root / "proc/self/cgroup");
    for (std::string line; std::getline(in, line);) {  // "NUMBER:CONTROLLERS:PATH"
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const auto controllers = split(line.substr(first + 1, second - first - 1), ',');
        const bool v2 = controllers.empty();
        if (!v2 && !contains(controllers, "cpu")) continue;
        for (const Mount& mount : mounts) {
            const bool mine = v2 ? mount.type == "cgroup2"
                                 : mount.type == "cgroup" && contains(mount.controllers, "cpu");
            if (!mine) continue;
            const fs::path path = line.substr(second + 1);
            const auto quota =
                v2 ? leastQuota(mount, path, quotaOfV2) : leastQuota(mount, path, quotaOfV1);
            if (quota) least = std::min(least.value_or(*quota), *quota);
        }
    }
    return least;
}

int allottedThreads() {
    int threads = tbb::info::default_concurrency();
    cpu_set_t processors;
    if (sched_getaffinity(0, sizeof processors, &processors) == 0) {
        threads = CPU_COUNT(&processors);  // fails on machines of more than 1024
    }
    if (const auto quota = processorQuota()) {
        threads = int(std::min(double(threads), std::ceil(*quota)));
    }
    const char* slurm = std::getenv("SLURM_CPUS_PER_TASK");
    const long granted = slurm == nullptr ? 0 : std::strtol(slurm, nullptr, 10);
    if (granted > 0) threads = int(std::min(long(threads), granted));
    return std::max(threads, 1);
}

}  // namespace specbake::tool
