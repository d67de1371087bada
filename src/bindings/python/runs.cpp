#include "runs.h"

#include <specbake/core/error.h>

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace specbake::python {

int threadsHere(int threads) {
    if (threads < 0) throw ArgumentError("a number of threads below 0");
    const int cores = tbb::info::default_concurrency();
    return threads == 0 ? cores : std::min(threads, cores);
}

void forEachRun(std::size_t count, std::size_t run, int threads, const Watch& watch,
                const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t runs = (count + run - 1) / run;
    std::atomic<std::size_t> done = 0;
    tbb::task_arena(threads).execute([&] {
        tbb::parallel_for(std::size_t(0), runs, [&](std::size_t i) {
            if (watch.stop.stop_requested()) throw Cancelled();
            body(i * run, std::min(run, count - i * run));
            watch.progress(double(++done) / double(runs));
        });
    });
}

void forEachRunInterruptibly(std::size_t count, std::size_t run, int threads,
                             const std::function<void(std::size_t, std::size_t)>& body) {
    const int workers = threadsHere(threads);
    if (count <= run) {
        const pybind11::gil_scoped_release released;
        if (count > 0) body(0, count);
        return;
    }
    runInterruptibly([&](const Watch& watch) { forEachRun(count, run, workers, watch, body); });
}

}  // namespace specbake::python
