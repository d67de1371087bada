#include "batch/batch_command.h"

#include "batch/output_names.h"
#include "batch/plan.h"
#include "batch/run.h"
#include "farm/records.h"
#include "farm/shard.h"
#include "farm/task.h"
#include "guard/file_names.h"
#include "guard/streams.h"
#include "progress_bar.h"
#include "stop_signals.h"
#include "thread_pool.h"

#include <specbake/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

namespace specbake::tool {
namespace {

/// A record that cannot be kept is told, and stops nothing: the texture's result counts.
void record(const Records& records, const BatchItem& item, const BatchResult& result) {
    try {
        records.note(item, result);
    } catch (const FileError& error) {
        std::fprintf(stderr, "specbake: %s\n", shown(error.what()).c_str());
    }
}

/// Throws ArgumentError if anything is read and written, or written twice.
void checkFiles(std::span<const BatchItem> items, const std::string& statsFile) {
    FileNames files;
    for (const BatchItem& item : items) {
        if (!item.output.empty()) files.addInput(item.input.path);  // others are passed over
    }
    for (const BatchItem& item : items) {
        files.addOutput(item.output, "-o");
        files.addOutput(item.page, "--report");
    }
    files.addOutput(statsFile, "--stats");
}

}  // namespace

ExitCode batchCommand(const BatchArguments& a) {
    std::optional<OutputNames> pages;
    if (!a.pages.empty()) pages.emplace(a.pages, ".html", "--report");
    const OutputNames names(a.output);
    auto items = planBatch(a.inputs.all, names, pages);
    checkFiles(items, a.report.statsFile);
    const Records records(recordsFolder(names.folder()));
    if (!a.shard.empty()) {
        const Shard shard = parseShard(a.shard);
        Task task = takeShard(shard, std::move(items), a.options.read, records);
        if (shard.planOnly() || a.report.verbose) std::printf("%s\n", task.plan.c_str());
        if (shard.planOnly()) return kDone;
        items = std::move(task.items);
    }
    const bool recorded = records.kept();
    const ThreadPool pool(a.options.threads);
    const auto start = std::chrono::steady_clock::now();
    std::vector<BatchResult> results;
    {
        ProgressBar bar(fmt::format("baking {} textures", items.size()), !a.report.quiet);
        BatchReport report(a.report, bar);
        BatchOptions options{a.options, a.update, {}, {}};
        options.bake.stop = StopSignals::token();
        options.progress = [&](double done) { bar.show(done); };
        options.finished = [&](const auto& item, const auto& result) {
            report.tell(item, result);
            if (recorded) record(records, item, result);
        };
        results = runBatch(items, options);
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        report.end(items, results, elapsed.count(), a.options.threads);
    }
    const bool failed = std::any_of(results.begin(), results.end(), [](const auto& result) {
        return result.outcome == Outcome::failed;
    });
    return failed ? kFailed : kDone;
}

}  // namespace specbake::tool
