#include "choices.h"
#include "commands.h"
#include "guard/file_names.h"
#include "guard/limit_choices.h"
#include "guard/streams.h"

#include <specbake/core/table.h>
#include <specbake/image/output_file.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace specbake::tool {
namespace {

struct Arguments {
    std::string output;
    ColorArguments color;
    ModelArguments model;
    int grid = kDefaultGridNodes;
    bool sync = false;
};

ColorSpace spaceOf(const Arguments& a) {
    return linearSpaceOf(meaningOfNumbers(*findColorSpace("srgb"), a.color.wishes()));
}

void print(const char* where, const TableErrors& errors) {
    std::printf("  %-20s mean %.4f, 99th percentile %.4f, largest %.4f\n", where, errors.mean,
                errors.p99, errors.max);
}

void print(Quadrature quadrature, const TableErrors& everywhere, const TableErrors& atBoundary) {
    std::printf("CIEDE2000 from the colour asked for, by the %s:\n",
                quadrature == Quadrature::bands ? "sum over the bands, 380 to 780 nm every 5 nm"
                                                : "integral from 360 to 830 nm every 1 nm");
    print("all colours", everywhere);
    if (atBoundary.colors > 0) print("at the boundary", atBoundary);
}

ExitCode tableCommand(const Arguments& a) {
    FileNames files;
    files.addInput(a.model.samples);
    files.addOutput(a.output, "-o");
    const ColorSpace space = spaceOf(a);
    std::vector<std::string> notes;
    UpsamplerOptions options = a.model.options(notes);
    options.grid = a.grid;
    const Upsampler upsampler(space, options);
    printNotes(notes, upsampler);
    const SpectralTableFile table = spectralTable(upsampler);
    writeWhole(a.output, {reinterpret_cast<const char*>(table.bytes.data()), table.bytes.size()},
               a.sync);
    std::printf("%s: %d nodes an axis, %.2f MB\n", shown(a.output).c_str(), a.grid,
                double(table.bytes.size()) / 1e6);
    const bool isFine = table.quadrature == Quadrature::fine;
    const SpectralTableFile& t = table;
    print(Quadrature::bands, isFine ? t.everywhereOtherwise : t.everywhere,
          isFine ? t.atBoundaryOtherwise : t.atBoundary);
    print(Quadrature::fine, isFine ? t.everywhere : t.everywhereOtherwise,
          isFine ? t.atBoundary : t.atBoundaryOtherwise);
    std::printf("  The table is made for the %s.\n",
                isFine ? "second of these" : "first of these; --quadrature fine: for the second");
    std::printf(
        "  %.1f %% of the cube are colours that a reflectance can have; %.1f %% lie in "
        "cells that their boundary cuts\n",
        table.everywhere.share * 100, table.atBoundary.share * 100);
    return kDone;
}

}  // namespace

Command addTable(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand(
        "table", "A table of spectra for renderers, which look texels up by specbake/sampler.h");
    command->footer("What is looked up is linear RGB of the space.");
    command->add_option("-o,--output", a->output, "the table, NAME.spectab")->required();
    addSpaceOptions(*command, a->color, "srgb");
    addConfigOption(*command, a->color);
    addModelOptions(*command, a->model, "the space's white");
    command->add_option("--grid", a->grid, "nodes of the table along each axis")
        ->check(CLI::Range(kFewestGridNodes, kMostGridNodes))
        ->capture_default_str();
    addSync(*command, a->sync);
    return [a] { return tableCommand(*a); };
}

}  // namespace specbake::tool
