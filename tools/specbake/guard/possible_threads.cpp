#include "guard/possible_threads.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace specbake::tool {
namespace {

/// By the limit on addresses, of which a thread takes many: its stack, and what malloc() reserves
/// for it. Half is left for the work.
int byAddresses(int wanted) {
    constexpr std::uint64_t perThread = std::uint64_t(80) << 20;
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return wanted;
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const std::uint64_t used = pages * std::uint64_t(sysconf(_SC_PAGESIZE));
    const std::uint64_t left = limit.rlim_cur > used ? limit.rlim_cur - used : 0;
    return int(std::min<std::uint64_t>(std::uint64_t(wanted), left / 2 / perThread));
}

/// By trying: a user, or a container, may have a limited number of them.
int byTrying(int wanted) {
    std::mutex begin;
    std::vector<std::thread> threads;
    begin.lock();
    try {
        for (int i = 1; i < wanted; ++i) {
            threads.emplace_back([&begin] { const std::lock_guard wait(begin); });
        }
    } catch (const std::system_error&) {  // so many, then, and half of them for others
        wanted = int(threads.size() / 2) + 1;
    }
    begin.unlock();
    for (std::thread& thread : threads) thread.join();
    return wanted;
}

}  // namespace

int possibleThreads(int wanted) {
    return std::max(byTrying(byAddresses(wanted)), 1);
}

}  // namespace specbake::tool
