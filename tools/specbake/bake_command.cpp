#include "bake_arguments.h"
#include "bake_report.h"
#include "batch/batch_command.h"
#include "batch/input_names.h"
#include "batch/plan.h"
#include "commands.h"
#include "guard/file_names.h"
#include "guard/streams.h"
#include "progress_bar.h"
#include "stop_signals.h"
#include "thread_pool.h"

#include <specbake/bake/bake.h>
#include <specbake/bake/up_to_date.h>
#include <specbake/core/error.h>
#include <specbake/image/output_file.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::vector<std::string> inputs;
    std::string output;
    BakeArguments bake;
    std::string statsFile;
    std::string reportFile;
    std::string shard;  ///< "" for all
    bool update = false;
    bool verbose = false;
    bool quiet = false;
};

/// To the file that --stats names, or to stdout.
void writeStats(const nlohmann::ordered_json& json, const Arguments& a) {
    const std::string text = jsonText(json, 2) + '\n';
    if (a.statsFile == "-") {
        std::fputs(text.c_str(), stdout);
        return;
    }
    writeWhole(a.statsFile, text, a.bake.rest.storage.sync);
}

void report(const BakeStatistics& s, const Arguments& a, const std::string& input) {
    const bool toStdout = a.statsFile != "-";
    if (!a.quiet && toStdout) std::fputs(choicesText(a.output, s).c_str(), stdout);
    if (!a.quiet) printRemarks(input, s, a.bake.model.outside);
    if (a.verbose && toStdout) std::printf("%s\n", bakeLine(input, a.output, s).c_str());
}

/// What is read beside textures.
void noteSideInputs(const Arguments& a) {
    for (const std::string& word : a.inputs) {
        if (word.starts_with('@')) noteInput(word.substr(1));
    }
    const auto sign = a.bake.second.find('=');
    if (sign != std::string::npos) {  // its light may be a file
        noteInput(a.bake.second.substr(0, sign));
        noteInput(a.bake.second.substr(sign + 1));
    }
    for (const auto& input : {a.bake.materialMap, a.bake.model.samples}) noteInput(input);
}

void checkOutput(const Arguments& a, const std::string& texture) {
    FileNames files;
    files.addInput(texture);
    files.addOutput(a.output, "-o");
    files.addOutput(a.statsFile, "--stats");
    files.addOutput(a.reportFile, "--report");
    checkSpectralName(a.output);
}

ExitCode bakeOne(const Arguments& a, const std::string& input) {
    checkOutput(a, input);
    const ThreadPool pool(a.bake.rest.threads);
    try {
        std::vector<std::string> notes;
        BakeOptions options = a.bake.options(notes);
        ProgressBar bar("baking " + fs::path(input).filename().string(), !a.quiet);
        options.stop = StopSignals::token();
        options.progress = [&bar](double done) { bar.show(done); };
        if (a.update && !outdated(input, a.output, options)) {
            if (a.verbose) std::printf("%s is up to date\n", shown(a.output).c_str());
            return kDone;
        }
        BakeStatistics s = bake(input, a.output, options);
        s.notes.insert(s.notes.end(), notes.begin(), notes.end());
        bar.clear();
        if (!a.statsFile.empty()) writeStats(bakeJson(input, a.output, s), a);
        if (!a.reportFile.empty()) writePage(a.reportFile, input, a.output, options, s);
        report(s, a, input);
    } catch (const FileError& error) {
        if (!a.statsFile.empty()) writeStats(failureJson(input, a.output, error.what()), a);
        throw;
    }
    return kDone;
}

/// Whether `-o` says where one texture goes by a folder that is there, or by a pattern.
bool namesByInput(const std::string& output) {
    std::error_code ignored;
    return output.find('{') != std::string::npos ||
           (fs::is_directory(output, ignored) && fs::path(output).extension() != ".exr");
}

ExitCode bakeCommand(const Arguments& a) {
    Inputs inputs = expandInputs(a.inputs);
    noteSideInputs(a);
    const bool toFile = !namesByInput(a.output) && a.shard.empty();
    if (inputs.single && toFile) return bakeOne(a, inputs.all.front().path);
    if (!a.bake.second.empty()) throw ArgumentError("--second is of one texture, not of several");
    std::vector<std::string> notes;
    const BakeOptions options = a.bake.options(notes);
    for (const std::string& note : notes) {
        if (!a.quiet) std::fprintf(stderr, "specbake: %s\n", note.c_str());
    }
    return batchCommand(
        {std::move(inputs),
         a.output,
         a.reportFile,
         options,
         a.update,
         a.shard,
         {a.statsFile, a.bake.model.outside, a.verbose, a.quiet, a.bake.rest.storage.sync}});
}

}  // namespace

Command addBake(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("bake", "A texture to a spectral EXR");
    addInputsAndOutput(*command, a->inputs, a->output);
    addBakeOptions(*command, a->bake);
    command->add_option("--stats", a->statsFile,
                        "write what was done, or why not, to this JSON file, - for stdout; of "
                        "several textures a line each");
    command->add_option(
        "--report", a->reportFile,
        "read the result back, and write a page about it to this HTML file; of several "
        "textures into this folder, or by a pattern such as "
        "'{dir}/{stem}.html'");
    command->add_flag("-u,--update", a->update,
                      "bake only what is missing, older than its texture, or made of another "
                      "texture, by other options or by another version");
    command
        ->add_option(
            "--shard", a->shard,
            "bake the I-th of N parts of the textures, that are alike in pixels: for tasks "
            "of a scheduler; auto: by the environment of Slurm's, AWS Batch's and "
            "Kubernetes' arrays; 0/N: tell of the parts, and bake nothing")
        ->type_name("I/N|auto");
    command->add_flag("-v,--verbose", a->verbose, "say what was done");
    command->add_flag("-q,--quiet", a->quiet, "no progress bar and no remarks")
        ->excludes("--verbose");
    return [a] { return bakeCommand(*a); };
}

}  // namespace specbake::tool
