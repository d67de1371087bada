// specbench: measures what docs/charts.md shows.
//
//     specbench charts|accuracy|stability|scene|spectra|exhaustive [--out DIR] [--full]
//               [--reflectances FILE...] [--textures FILE...]
//     specbench nature [--out DIR] [--reflectances FILE...]
//     specbench fit natural --data DIR -o FILE
#include "commands.h"
#include "fit/natural_samples.h"

#include <specbake/core/error.h>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cstdio>
#include <exception>

namespace {

using namespace specbake::bench;

enum ExitCode { done = 0, couldNot = 1, wrongCommand = 2 };

using Command = void (*)(const Options&);

void addCommand(CLI::App& app, const char* name, const char* help, Command command,
                Options& options, Command& chosen) {
    CLI::App* sub = app.add_subcommand(name, help);
    sub->add_option("-o,--out", options.out, "folder of the results")->capture_default_str();
    sub->add_option("--data", options.data, "folder of the tables");
    sub->add_option("--reflectances", options.reflectances,
                    "more measured reflectances, CSV: a name and 81 values a row");
    sub->add_option("--textures", options.textures, "more textures, sRGB or linear Rec.709");
    sub->add_option("--charts", options.charts, "folder of the charts")->capture_default_str();
    sub->add_flag("--full", options.full, "more colours and longer runs");
    sub->callback([command, &chosen] { chosen = command; });
}

struct FitArguments {
    std::string folder;
    std::string output;
};

CLI::App* addFit(CLI::App& app, FitArguments& arguments) {
    CLI::App* fit = app.add_subcommand("fit", "make what a method has built in");
    fit->require_subcommand(1);
    CLI::App* natural = fit->add_subcommand("natural", "the measured samples of `natural`");
    natural->add_option("--data", arguments.folder, "folder of refl_*.csv")->required();
    natural->add_option("-o,--output", arguments.output, "CSV to write")->required();
    return natural;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Speed, accuracy and stability of ways from a colour to a spectrum"};
    app.require_subcommand(1);
    Options options;
    Command chosen = nullptr;
    addCommand(app, "accuracy", "speed and accuracy of every method", runAccuracy, options, chosen);
    addCommand(app, "spectra", "the spectra of a dozen colours", runSpectra, options, chosen);
    addCommand(app, "stability", "failures and continuity towards the boundary", runStability,
               options, chosen);
    addCommand(app, "scene", "what textures need of the grid and of the half floats", runScene,
               options, chosen);
    addCommand(app, "exhaustive", "whether any colour of the solid fails", runExhaustive, options,
               chosen);
    addCommand(app, "nature", "measured sets rebuilt, each without its own votes", runNature,
               options, chosen);
    FitArguments fitting;
    const CLI::App* fit = addFit(app, fitting);
    addCommand(app, "charts", "all of these, then the charts", runCharts, options, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? done : wrongCommand;
    }
    try {
        if (fit->parsed()) {
            fitNatural(fitting.folder, fitting.output);
        } else {
            chosen(options);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "specbench: {}\n", error.what());
        return couldNot;
    }
    return done;
}
