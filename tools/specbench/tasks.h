#pragma once

#include "progress.h"

#include <tbb/parallel_for.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace specbake::bench {

/// A piece of work, and what to call it while it runs.
template <class Result>
struct Task {
    std::string what;
    std::function<Result()> work;
};

/// Carries the tasks out on all cores, in any order; their results in the order of the tasks.
template <class Result>
std::vector<Result> onAllCores(const std::vector<Task<Result>>& tasks, Progress& progress) {
    std::vector<Result> results(tasks.size());
    tbb::parallel_for(
        std::size_t(0), tasks.size(),
        [&](std::size_t i) {
            progress.next(tasks[i].what);
            results[i] = tasks[i].work();
        },
        tbb::simple_partitioner());
    return results;
}

}  // namespace specbake::bench
