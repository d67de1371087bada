#include "pipeline.h"

#include <specbake/core/error.h>

#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace specbake::internal {

int threadCount(int threads) {
    return threads > 0 ? threads : tbb::info::default_concurrency();
}

void runPipeline(int count, const Stages& stages, int threads, const std::stop_token& stop) {
    const int workers = threadCount(threads);
    int next = 0;
    const auto read = [&](tbb::flow_control& flow) {
        if (stop.stop_requested()) throw Cancelled();
        if (next == count) {
            flow.stop();
            return next;
        }
        stages.read(next);
        return next++;
    };
    const auto process = [&](int band) {
        stages.process(band);
        return band;
    };
    const auto inFlight = std::size_t(workers) + 1;  // one to be read or written beside them
    tbb::task_arena(workers).execute([&] {
        using enum tbb::filter_mode;
        tbb::parallel_pipeline(inFlight,
                               tbb::make_filter<void, int>(serial_in_order, read) &
                                   tbb::make_filter<int, int>(parallel, process) &
                                   tbb::make_filter<int, void>(serial_in_order, stages.write));
    });
}

}  // namespace specbake::internal
