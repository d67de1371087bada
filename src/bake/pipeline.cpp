#include "pipeline.h"

#include <specbake/core/error.h>
#include <specbake/image/limits.h>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

namespace specbake::internal {

int threadCount(int threads) {
    using Limit = tbb::global_control;
    const std::size_t most = Limit::active_value(Limit::max_allowed_parallelism);
    const int wanted = threads > 0 ? threads : tbb::info::default_concurrency();
    return int(std::min(std::size_t(wanted), most));
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
    const std::size_t room = limits().memory / std::max<std::size_t>(stages.bandBytes, 1);
    // One to be read or written beside those of the workers, of whom no more work at once than
    // there are processors: more bands would take memory alone.
    const auto busy = std::size_t(std::min(workers, tbb::info::default_concurrency()));
    const std::size_t inFlight = std::clamp<std::size_t>(room, 1, busy + 1);
    tbb::task_arena(workers).execute([&] {
        using enum tbb::filter_mode;
        tbb::parallel_pipeline(inFlight,
                               tbb::make_filter<void, int>(serial_in_order, read) &
                                   tbb::make_filter<int, int>(parallel, process) &
                                   tbb::make_filter<int, void>(serial_in_order, stages.write));
    });
}

}  // namespace specbake::internal
