#include "batch/report.h"

#include "bake_report.h"
#include "guard/streams.h"

#include <specbake/core/error.h>
#include <specbake/image/output_file.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace specbake::tool {
namespace {

using Json = nlohmann::ordered_json;

const char* statusOf(Outcome outcome) {
    switch (outcome) {
        case Outcome::baked:
            return "baked";
        case Outcome::current:
            return "current";
        case Outcome::passed:
            return "passed over";
        case Outcome::failed:
            return "failed";
        case Outcome::left:
            break;
    }
    return "left";
}

std::string lineOf(const BatchItem& item, const BatchResult& result) {
    switch (result.outcome) {
        case Outcome::baked:
            return choicesText(item.output, result.statistics) +
                   bakeLine(item.input.path, item.output, result.statistics);
        case Outcome::current:
            return shown(item.output) + " is up to date";
        case Outcome::passed:
            return shown(item.input.path) + ": passed over, a spectral image itself";
        case Outcome::failed:
        case Outcome::left:
            break;
    }
    return {};
}

/// A row of the table; nothing if there are none.
std::string row(std::size_t count, const std::string& what) {
    return count == 0 ? "" : fmt::format("{:>8}  {}\n", count, what);
}

std::string tableOf(std::span<const BatchItem> items, std::span<const BatchResult> results,
                    double seconds, int threads) {
    const auto count = [&](Outcome outcome) {
        return std::size_t(std::count_if(results.begin(), results.end(), [&](const auto& result) {
            return result.outcome == outcome;
        }));
    };
    double texels = 0;
    for (const BatchResult& result : results) texels += double(result.statistics.texels);
    std::string table = row(count(Outcome::baked),
                            fmt::format("baked: {:.1f} million texels in {:.1f} s on {} thread{}",
                                        texels / 1e6, seconds, threads, threads == 1 ? "" : "s")) +
                        row(count(Outcome::current), "up to date") +
                        row(count(Outcome::passed), "passed over: spectral images themselves") +
                        row(count(Outcome::left), "left when it was stopped") +
                        row(count(Outcome::failed), "failed");
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (results[i].outcome == Outcome::failed) {
            const std::string what = items[i].input.path + ": " + results[i].reason;
            table += fmt::format("{:>8}  {}\n", "", shown(what));
        }
    }
    return table;
}

void writeStats(const std::string& path, std::span<const BatchItem> items,
                std::span<const BatchResult> results, bool sync) {
    std::string lines;
    for (std::size_t i = 0; i < items.size(); ++i) {
        lines += jsonText(batchJson(items[i], results[i]), -1) + '\n';
    }
    writeWhole(path, lines, sync);
}

}  // namespace

Json batchJson(const BatchItem& item, const BatchResult& result) {
    const bool baked = result.outcome == Outcome::baked;
    const bool failed = result.outcome == Outcome::failed;
    Json json = {
        {"input", item.input.path}, {"output", item.output}, {"status", statusOf(result.outcome)}};
    if (baked) json.update(bakeJson(item.input.path, item.output, result.statistics));
    if (failed) json.update(failureJson(item.input.path, item.output, result.reason));
    return json;
}

BatchReport::BatchReport(Options options, ProgressBar& bar)
    : options_(std::move(options)),
      bar_(bar),
      lines_(!options_.quiet && !statsToStdout() &&
             (options_.verbose || isatty(STDOUT_FILENO) == 0)) {}

void BatchReport::tell(const BatchItem& item, const BatchResult& result) {
    bar_.clear();
    if (statsToStdout()) std::printf("%s\n", jsonText(batchJson(item, result), -1).c_str());
    if (result.outcome == Outcome::failed) {
        const std::string what = item.input.path + ": " + result.reason;
        std::fprintf(stderr, "specbake: %s\n", shown(what).c_str());
    } else if (lines_) {
        std::printf("%s\n", lineOf(item, result).c_str());
    }
    std::fflush(stdout);
    if (!options_.quiet) printRemarks(item.input.path, result.statistics, options_.outside);
}

void BatchReport::end(std::span<const BatchItem> items, std::span<const BatchResult> results,
                      double seconds, int threads) const {
    bar_.clear();
    if (!options_.statsFile.empty() && !statsToStdout()) {
        writeStats(options_.statsFile, items, results, options_.sync);
    }
    if (options_.quiet) return;
    std::fputs(tableOf(items, results, seconds, threads).c_str(),
               statsToStdout() ? stderr : stdout);
}

}  // namespace specbake::tool
