#include "batch/batch_command.h"

#include "batch/output_names.h"
#include "batch/plan.h"
#include "batch/run.h"
#include "progress_bar.h"
#include "stop_signals.h"
#include "thread_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

namespace specbake::tool {

ExitCode batchCommand(const BatchArguments& a) {
    std::optional<OutputNames> pages;
    if (!a.pages.empty()) pages.emplace(a.pages, ".html", "--report");
    const auto items = planBatch(a.inputs.all, OutputNames(a.output), pages);
    const ThreadPool pool(a.options.threads);
    StopSignals signals;
    const auto start = std::chrono::steady_clock::now();
    std::vector<BatchResult> results;
    {
        ProgressBar bar(fmt::format("baking {} textures", items.size()), !a.report.quiet);
        BatchReport report(a.report, bar);
        BatchOptions options{a.options, a.update, {}, {}};
        options.bake.stop = signals.token();
        options.progress = [&](double done) { bar.show(done); };
        options.finished = [&](const auto& item, const auto& result) { report.tell(item, result); };
        results = runBatch(items, options);
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        report.end(items, results, elapsed.count());
    }
    signals.passOn();
    const bool failed = std::any_of(results.begin(), results.end(), [](const auto& result) {
        return result.outcome == Outcome::failed;
    });
    return failed ? kFailed : kDone;
}

}  // namespace specbake::tool
