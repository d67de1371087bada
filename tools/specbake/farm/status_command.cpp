#include "bake_arguments.h"
#include "bake_report.h"
#include "batch/input_names.h"
#include "batch/output_names.h"
#include "batch/plan.h"
#include "commands.h"
#include "farm/records.h"
#include "farm/status.h"
#include "thread_pool.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array kStandings = {Standing::done, Standing::missing, Standing::outdated,
                                   Standing::failed};
constexpr std::size_t kMostLines = 50;  ///< for people; JSON has all

struct Arguments {
    std::vector<std::string> inputs;
    std::string output;
    BakeArguments bake;
    bool quick = false;
    bool json = false;
    bool quiet = false;
};

/// What a batch has done, and what it has left behind.
struct BatchStatus {
    std::vector<BatchItem> items;
    std::vector<ItemStatus> all;  ///< of the items, in their order
    std::vector<fs::path> leftovers;

    std::size_t count(Standing standing) const {
        return std::size_t(std::count_if(all.begin(), all.end(), [&](const ItemStatus& status) {
            return status.standing == standing;
        }));
    }
    bool complete() const { return count(Standing::done) == all.size(); }
};

BatchStatus look(const Arguments& a) {
    const OutputNames names(a.output);
    BatchStatus status{planBatch(expandInputs(a.inputs).all, names), {}, {}};
    std::erase_if(status.items, [](const BatchItem& item) { return item.output.empty(); });
    std::vector<std::string> unused;
    BakeOptions options = a.bake.options(unused);
    const ThreadPool pool(options.threads);
    const Records records(recordsFolder(names.folder()));
    status.all = statusOf(status.items, options, a.quick ? SourceCheck::length : SourceCheck::bytes,
                          records);
    status.leftovers = leftovers(status.items);
    return status;
}

Json jsonOf(const BatchStatus& status) {
    Json json = {{"textures", status.all.size()}};
    for (const Standing standing : kStandings) {
        json[standingName(standing)] = status.count(standing);
    }
    Json open = Json::array();
    for (std::size_t i = 0; i < status.all.size(); ++i) {
        const auto& [standing, reason] = status.all[i];
        if (standing == Standing::done) continue;
        Json line = {{"input", status.items[i].input.path},
                     {"output", status.items[i].output},
                     {"status", standingName(standing)}};
        if (!reason.empty()) line["reason"] = reason;
        open.push_back(std::move(line));
    }
    json["open"] = std::move(open);
    json["leftovers"] = Json::array();
    for (const fs::path& path : status.leftovers) json["leftovers"].push_back(path.string());
    return json;
}

/// A line of the table for each standing that there is, and one for each texture that is open.
std::string textOf(const BatchStatus& status) {
    std::string text;
    for (const Standing standing : kStandings) {
        if (const std::size_t count = status.count(standing)) {
            text += fmt::format("{:>8}  {}\n", count, standingName(standing));
        }
    }
    std::size_t lines = 0;
    const auto add = [&](const std::string& line) {
        if (++lines <= kMostLines) text += fmt::format("{:>8}  {}\n", "", line);
    };
    for (std::size_t i = 0; i < status.all.size(); ++i) {
        const auto& [standing, reason] = status.all[i];
        if (standing == Standing::done) continue;
        add(fmt::format("{}: {}{}{}", status.items[i].input.path, standingName(standing),
                        reason.empty() ? "" : ": ", reason));
    }
    for (const fs::path& path : status.leftovers) {
        add(path.string() + ": half-written, by a process that died or is at it");
    }
    if (lines > kMostLines) {
        text += fmt::format("{:>8}  and {} more, which --json tells\n", "", lines - kMostLines);
    }
    return text;
}

ExitCode statusCommand(const Arguments& a) {
    const BatchStatus status = look(a);
    if (a.json) {
        std::printf("%s\n", jsonText(jsonOf(status), 2).c_str());
    } else if (!a.quiet) {
        std::fputs(textOf(status).c_str(), stdout);
    }
    return status.complete() ? kDone : kFailed;
}

}  // namespace

Command addStatus(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand(
        "status", "What a bake of many textures has done: exit code 0 if that is all");
    addInputsAndOutput(*command, a->inputs, a->output);
    addBakeOptions(*command, a->bake);
    command->add_flag("--quick", a->quick,
                      "compare textures by length and time, and do not read them whole");
    command->add_flag("--json", a->json, "as JSON, with all that is not done");
    command->add_flag("-q,--quiet", a->quiet, "tell nothing but by the exit code")
        ->excludes("--json");
    return [a] { return statusCommand(*a); };
}

}  // namespace specbake::tool
