#include "choices.h"
#include "commands.h"
#include "progress_bar.h"
#include "stop_signals.h"
#include "thread_pool.h"

#include <specbake/bake/bake.h>
#include <specbake/bake/report.h>
#include <specbake/core/error.h>
#include <specbake/image/output_file.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::string input;
    std::string output;
    ReadArguments read;
    std::string space = "auto";
    ModelArguments model;
    std::string materialMap;  ///< an image, "" for none
    int grid = kDefaultGridNodes;
    bool perTexel = false;
    std::string sampleType{sampleTypeName(StorageOptions().sampleType)};
    std::string compression{compressionName(StorageOptions().compression)};
    std::vector<int> tile;  ///< none, or width and height
    BakeOptions options;    ///< all else
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

/// `notes`: what there is to tell of the files that options name.
BakeOptions optionsOf(const Arguments& a, const std::stop_token& stop, ProgressBar& bar,
                      std::vector<std::string>& notes) {
    BakeOptions options = a.options;
    options.read = a.read.options();
    options.space = unlessAuto(a.space);
    options.model = modelOf(a, options, notes);
    options.model.grid = a.perTexel ? std::nullopt : std::optional(a.grid);
    options.storage.sampleType = parseSampleType(a.sampleType);
    parseCompression(a.compression, options.storage);
    if (!a.tile.empty()) options.storage.tile = TileSize{a.tile.at(0), a.tile.at(1)};
    options.stop = stop;
    options.progress = [&bar](double done) { bar.show(done); };
    return options;
}

bool isUpToDate(const Arguments& a) {
    std::error_code missing;
    const auto made = fs::last_write_time(a.output, missing);
    return !missing && made >= fs::last_write_time(a.input, missing) && !missing;
}

void writeStats(const BakeStatistics& s, const Arguments& a) {
    nlohmann::ordered_json json = {{"input", a.input},
                                   {"output", a.output},
                                   {"space", s.space},
                                   {"illuminant", s.illuminant},
                                   {"texels", s.texels},
                                   {"direct_texels", s.directTexels},
                                   {"outside_texels", s.outsideTexels},
                                   {"outside_max_de2000", s.largestMove},
                                   {"nodes_solved", s.nodesSolved},
                                   {"grid", s.grid},
                                   {"bits", s.bits},
                                   {"seconds", s.seconds},
                                   {"notes", s.notes}};
    if (s.deviation) {
        json["deviation"] = *s.deviation;
        json["deviation_largest"] = s.largestDeviation;
        json["deviation_colors"] = s.deviationColors;
        json["deviation_of_all"] = s.deviationOfAll;
    }
    if (s.difference) json["de2000"] = *s.difference;
    OutputFile file(a.statsFile);
    std::ofstream out(file.temporaryPath());
    out << json.dump(2) << '\n';
    out.close();
    if (!out) throw FileError(a.statsFile, "cannot be written");
    file.commit();
}

void report(const BakeStatistics& s, const Arguments& a) {
    for (const std::string& note : s.notes) {
        if (!a.quiet) std::fprintf(stderr, "specbake: %s: %s\n", a.input.c_str(), note.c_str());
    }
    if (s.deviation && !a.quiet) {
        std::printf(
            "%s: a grid of %d nodes deviates by %.5f RMS, by %.4f in one texel (%s%zu colours)\n",
            a.output.c_str(), s.grid, *s.deviation, s.largestDeviation,
            s.deviationOfAll ? "" : "a sample of ", s.deviationColors);
    }
    if (s.difference && !a.quiet) {
        std::printf("%s: %d bits of mantissa keep every texel within CIEDE2000 %.4f\n",
                    a.output.c_str(), s.bits, *s.difference);
    }
    if (s.outsideTexels > 0 && !a.quiet) {
        std::fprintf(stderr,
                     "specbake: %s: %zu texels have a colour that no reflectance has; they were "
                     "moved by up to CIEDE2000 %.2f (--outside %s)\n",
                     a.input.c_str(), s.outsideTexels, s.largestMove, a.model.outside.c_str());
    }
    if (a.verbose) {
        std::printf(
            "%s -> %s: %zu texels (%s, %s) in %.2f s; %zu nodes solved, %zu texels one by one\n",
            a.input.c_str(), a.output.c_str(), s.texels, s.space.c_str(), s.illuminant.c_str(),
            s.seconds, s.nodesSolved, s.directTexels);
    }
}

/// The page about the file as it was written: it is read back and compared.
void writePage(const BakeStatistics& s, const Arguments& a) {
    ReportOptions page;
    page.verify.read = a.read.options();
    page.verify.space = unlessAuto(a.space);
    page.verify.threads = a.options.threads;
    page.facts = {{"texels", std::to_string(s.texels)},
                  {"texels outside the solid", std::to_string(s.outsideTexels)},
                  {"furthest moved, CIEDE2000", fmt::format("{:.3g}", s.largestMove)},
                  {"texels solved one by one", std::to_string(s.directTexels)},
                  {"nodes solved", std::to_string(s.nodesSolved)},
                  {"seconds", fmt::format("{:.2f}", s.seconds)}};
    writeReport(a.output, a.input, a.reportFile, page);
}

void checkOutput(const Arguments& a) {
    for (const std::string& input : {a.input, a.materialMap, a.model.samples}) {
        std::error_code missing;
        if (!input.empty() && fs::equivalent(input, a.output, missing)) {
            throw ArgumentError(a.output + ": the output is the input");
        }
    }
    std::string extension = fs::path(a.output).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    if (extension != ".exr") {
        throw ArgumentError(a.output + ": a spectral image is an EXR; its name must end in .exr");
    }
}

ExitCode bakeCommand(const Arguments& a) {
    checkOutput(a);
    if (a.update && isUpToDate(a)) {
        if (a.verbose) std::printf("%s is up to date\n", a.output.c_str());
        return kDone;
    }
    const ThreadPool pool(a.options.threads);
    StopSignals signals;
    try {
        ProgressBar bar("baking " + fs::path(a.input).filename().string(), !a.quiet);
        std::vector<std::string> notes;
        BakeStatistics s = bake(a.input, a.output, optionsOf(a, signals.token(), bar, notes));
        s.notes.insert(s.notes.end(), notes.begin(), notes.end());
        if (!a.statsFile.empty()) writeStats(s, a);
        if (!a.reportFile.empty()) writePage(s, a);
        report(s, a);
    } catch (const Cancelled&) {
        signals.passOn();
        throw;
    }
    return kDone;
}

}  // namespace

Command addBake(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("bake", "A texture to a spectral EXR");
    command->add_option("input", a->input, "texture: any image that OpenImageIO reads")->required();
    command->add_option("-o,--output", a->output, "spectral image to write (.exr)")->required();
    addReadOptions(*command, a->read, "else the colours of the file");
    command->add_option("--space", a->space, "colour space of the texture")
        ->check(CLI::IsMember(spaceChoices()))
        ->capture_default_str();
    addModelOptions(*command, a->model, "the space's white, E for xyz");
    command
        ->add_option("--material-map", a->materialMap,
                     "an image of the texture's size: its channels are how much of each --material "
                     "(up to three, with commas, in the order of the channels) a texel is, from 0 "
                     "to 1")
        ->needs("--material");
    command->add_flag("--per-texel", a->perTexel,
                      "solve every distinct colour by itself, without the grid");
    command->add_option("--grid", a->grid, "nodes of the lookup grid along each axis")
        ->check(CLI::Range(kFewestGridNodes, kMostGridNodes))
        ->capture_default_str();
    command
        ->add_option(
            "--max-deviation", a->options.maxDeviation,
            "instead of --grid: the coarsest grid whose spectra deviate by no more from the "
            "directly solved ones, RMS over bands and texels; the default grid comes to 0.0002 to "
            "0.002, by the texture")
        ->check(CLI::PositiveNumber)
        ->excludes("--per-texel");
    command
        ->add_option("--bits", a->options.bits,
                     "bits of mantissa that half samples keep: fewer make smaller files")
        ->check(CLI::Range(BakeOptions::kFewestMantissaBits, BakeOptions::kMostMantissaBits))
        ->capture_default_str();
    command
        ->add_option(
            "--max-de", a->options.maxDE,
            "instead of --bits: the fewest bits that keep every texel within this CIEDE2000")
        ->check(CLI::PositiveNumber);
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
    addThreads(*command, a->options.threads);
    command->add_option("--stats", a->statsFile, "write what was done to this JSON file");
    command->add_option("--report", a->reportFile,
                        "read the result back, and write a page about it to this HTML file");
    command->add_flag("-u,--update", a->update, "do nothing if the output is newer than the input");
    command->add_flag("-v,--verbose", a->verbose, "say what was done");
    command->add_flag("-q,--quiet", a->quiet, "no progress bar and no remarks");
    return [a] { return bakeCommand(*a); };
}

}  // namespace specbake::tool
