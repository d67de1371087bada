#include "attribute_choices.h"
#include "bake_report.h"
#include "batch/batch_command.h"
#include "batch/input_names.h"
#include "batch/plan.h"
#include "choices.h"
#include "commands.h"
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
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::vector<std::string> inputs;
    std::string output;
    ReadArguments read;
    ColorArguments color;
    ModelArguments model;
    std::string materialMap;  ///< an image, "" for none
    std::string second;       ///< LIGHT=IMAGE, "" for none
    int grid = kDefaultGridNodes;
    bool perTexel = false;
    std::string sampleType{sampleTypeName(StorageOptions().sampleType)};
    std::string compression{compressionName(StorageOptions().compression)};
    std::vector<int> tile;  ///< none, or width and height
    std::vector<std::pair<std::string, std::string>> attributes;
    std::string wrap;     ///< "" or one of two of a wrap mode
    BakeOptions options;  ///< all else
    std::string statsFile;
    std::string reportFile;
    bool update = false;
    bool verbose = false;
    bool quiet = false;
};

/// With a map, the materials are the map's.
UpsamplerOptions modelOf(const Arguments& a, BakeOptions& options,
                         std::vector<std::string>& notes) {
    ModelArguments model = a.model;
    if (!a.materialMap.empty()) {
        options.materialMap = a.materialMap;
        options.mappedMaterials = model.materials();
        model.material.clear();
    }
    return model.options(notes);
}

/// "A=IMAGE" to the light and the image.
void parseSecond(const std::string& text, BakeOptions& options) {
    if (text.empty()) return;
    const auto sign = text.find('=');
    if (sign == std::string::npos || sign == 0 || sign + 1 == text.size()) {
        throw ArgumentError("--second: LIGHT=IMAGE, as A=lamp.png, not " + text);
    }
    options.secondLight = lightFrom(text.substr(0, sign));
    options.second = text.substr(sign + 1);
}

/// `notes`: what there is to tell of the files that options name.
BakeOptions optionsOf(const Arguments& a, std::vector<std::string>& notes) {
    BakeOptions options = a.options;
    options.read = a.read.options();
    options.color = a.color.wishes();
    options.model = modelOf(a, options, notes);
    parseSecond(a.second, options);
    options.model.grid = a.perTexel ? std::nullopt : std::optional(a.grid);
    options.storage.sampleType = parseSampleType(a.sampleType);
    if (options.storage.sampleType == SampleType::float32 &&
        (options.maxDE || options.bits != BakeOptions::kMostMantissaBits)) {
        throw ArgumentError("--bits and --max-de are of half samples, not of -d float");
    }
    parseCompression(a.compression, options.storage);
    for (const auto& [name, text] : a.attributes) {
        options.attributes.insert_or_assign(name, attributeValue(text));
    }
    if (!a.wrap.empty()) options.attributes["wrapmodes"] = wrapModes(a.wrap);
    if (!a.tile.empty()) options.storage.tile = TileSize{a.tile.at(0), a.tile.at(1)};
    return options;
}

/// To the file that --stats names, or to stdout.
void writeStats(const nlohmann::ordered_json& json, const Arguments& a) {
    const std::string text = jsonText(json, 2) + '\n';
    if (a.statsFile == "-") {
        std::fputs(text.c_str(), stdout);
        return;
    }
    OutputFile file(a.statsFile);
    std::ofstream out(file.temporaryPath());
    out << text;
    out.close();
    if (!out) throw FileError(a.statsFile, "cannot be written");
    file.commit();
}

void report(const BakeStatistics& s, const Arguments& a, const std::string& input) {
    const bool toStdout = a.statsFile != "-";
    if (!a.quiet && toStdout) std::fputs(choicesText(a.output, s).c_str(), stdout);
    if (!a.quiet) printRemarks(input, s, a.model.outside);
    if (a.verbose && toStdout) std::printf("%s\n", bakeLine(input, a.output, s).c_str());
}

void checkOutput(const Arguments& a, const std::string& texture) {
    const std::string second = a.second.substr(a.second.find('=') + 1);
    for (const std::string& input : {texture, a.materialMap, second, a.model.samples}) {
        std::error_code missing;
        if (!input.empty() && fs::equivalent(input, a.output, missing)) {
            throw ArgumentError(a.output + ": the output is the input");
        }
    }
    checkSpectralName(a.output);
}

ExitCode bakeOne(const Arguments& a, const std::string& input) {
    checkOutput(a, input);
    const ThreadPool pool(a.options.threads);
    StopSignals signals;
    try {
        ProgressBar bar("baking " + fs::path(input).filename().string(), !a.quiet);
        std::vector<std::string> notes;
        BakeOptions options = optionsOf(a, notes);
        options.stop = signals.token();
        options.progress = [&bar](double done) { bar.show(done); };
        if (a.update && !outdated(input, a.output, options)) {
            if (a.verbose) std::printf("%s is up to date\n", a.output.c_str());
            return kDone;
        }
        BakeStatistics s = bake(input, a.output, options);
        s.notes.insert(s.notes.end(), notes.begin(), notes.end());
        bar.clear();
        if (!a.statsFile.empty()) writeStats(bakeJson(input, a.output, s), a);
        if (!a.reportFile.empty()) writePage(a.reportFile, input, a.output, options, s);
        report(s, a, input);
    } catch (const Cancelled&) {
        signals.passOn();
        throw;
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
    if (inputs.single && !namesByInput(a.output)) return bakeOne(a, inputs.all.front().path);
    if (!a.second.empty()) throw ArgumentError("--second is of one texture, not of several");
    std::vector<std::string> notes;
    const BakeOptions options = optionsOf(a, notes);
    for (const std::string& note : notes) {
        if (!a.quiet) std::fprintf(stderr, "specbake: %s\n", note.c_str());
    }
    return batchCommand({std::move(inputs),
                         a.output,
                         a.reportFile,
                         options,
                         a.update,
                         {a.statsFile, a.model.outside, a.verbose, a.quiet}});
}

}  // namespace

Command addBake(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("bake", "A texture to a spectral EXR");
    command
        ->add_option("input", a->inputs,
                     "textures: images that OpenImageIO reads, folders of them, patterns such as "
                     "'tex/*.png', 'wood.<UDIM>.png' or 'rust.####.tif', and @LIST, a file of such "
                     "words, one a line")
        ->type_name("IN ...")
        ->required();
    command
        ->add_option("-o,--output", a->output,
                     "spectral image to write (.exr); of several textures the folder to write "
                     "into, or a pattern such as '{dir}/{stem}.spectral.exr' or "
                     "'out/wood.<UDIM>.exr'")
        ->required();
    addReadOptions(*command, a->read, "else the colours of the file");
    addColorOptions(*command, a->color, "what the file says");
    addModelOptions(*command, a->model, "the space's white, E for xyz");
    addOutsideOption(*command, a->model);
    command
        ->add_option("--material-map", a->materialMap,
                     "an image of the texture's size: its channels are how much of each --material "
                     "(up to three, with commas, in the order of the channels) a texel is, from 0 "
                     "to 1")
        ->needs("--material");
    command
        ->add_option("--second", a->second,
                     "the same texture under a second light: spectra have these colours under it "
                     "where reflectances have both; white is (1, 1, 1) in both")
        ->type_name("LIGHT=IMAGE");
    command->add_flag("--per-texel", a->perTexel,
                      "solve every distinct colour by itself, without the grid");
    command->add_option("--grid", a->grid, "nodes of the lookup grid along each axis")
        ->check(CLI::Range(kFewestGridNodes, kMostGridNodes))
        ->capture_default_str()
        ->excludes("--per-texel");
    command
        ->add_option(
            "--max-deviation", a->options.maxDeviation,
            "instead of --grid: the coarsest grid whose spectra deviate by no more from the "
            "directly solved ones, RMS over bands and texels; the default grid comes to 0.0002 to "
            "0.002, by the texture")
        ->check(CLI::PositiveNumber & isFinite())
        ->excludes("--per-texel")
        ->excludes("--grid");
    command
        ->add_option("--bits", a->options.bits,
                     "bits of mantissa that half samples keep: fewer make smaller files")
        ->check(CLI::Range(BakeOptions::kFewestMantissaBits, BakeOptions::kMostMantissaBits))
        ->capture_default_str();
    command
        ->add_option(
            "--max-de", a->options.maxDE,
            "instead of --bits: the fewest bits that keep every texel within this CIEDE2000")
        ->check(CLI::PositiveNumber & isFinite())
        ->excludes("--bits");
    command->add_option("-d,--data-type", a->sampleType, "samples of the spectral image")
        ->check(CLI::IsMember(sampleTypeNames()))
        ->capture_default_str();
    command
        ->add_option(
            "--compression", a->compression,
            "none, zip[:LEVEL], zips[:LEVEL] or piz; levels 1-3 are fast, 3 the default; 4-9 "
            "take 3 to 45 times as long for at most 3 % less, 4-7 for more on smooth "
            "textures; 10-12 take 50 to 80 times as long, for 3 % less")
        ->capture_default_str();
    command->add_option("--tile", a->tile, "store tiles of this size instead of scan lines")
        ->expected(2)
        ->check(CLI::Range(1, TileSize::kLargestSide))
        ->type_name("W H");
    command->add_flag("--mipmap", a->options.storage.mipmap,
                      "store all mip levels, averages of spectra; tiles of 64 x 64 unless --tile");
    command
        ->add_option("--wrap", a->wrap,
                     "how renderers that go by OpenImageIO continue the texture beyond its edges: "
                     "black, clamp, periodic or mirror, or two of them for s,t; of tiled files, "
                     "black is the default")
        ->check(wrapCheck())
        ->type_name("MODE[,MODE]");
    command
        ->add_option("--attrib", a->attributes,
                     "metadata to write, as often as wanted: an int, a float or a string by its "
                     "looks")
        ->type_name("NAME VALUE")
        ->allow_extra_args(false);
    addThreads(*command, a->options.threads);
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
    command->add_flag("-v,--verbose", a->verbose, "say what was done");
    command->add_flag("-q,--quiet", a->quiet, "no progress bar and no remarks")
        ->excludes("--verbose");
    return [a] { return bakeCommand(*a); };
}

}  // namespace specbake::tool
