#include "choices.h"
#include "commands.h"
#include "guard/file_names.h"
#include "guard/limit_choices.h"
#include "progress_bar.h"
#include "stop_signals.h"
#include "thread_pool.h"

#include <specbake/bake/relight.h>
#include <specbake/core/error.h>
#include <specbake/core/observer.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>

namespace specbake::tool {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::string spectral;
    std::string picture;
    RelightOptions options;  ///< all but the following
    std::vector<std::string> lights = {RelightOptions().illuminant};
    std::string adapt{adaptationName(RelightOptions().adapt)};
    std::optional<std::string> quadrature;
    bool noAdapt = false;
    bool quiet = false;
};

ExitCode relightCommand(const Arguments& a) {
    FileNames files;
    files.addInput(a.spectral);
    files.addOutput(a.picture, "-o");
    const ThreadPool pool(a.options.threads);
    ProgressBar bar("relighting " + fs::path(a.spectral).filename().string(), !a.quiet);
    RelightOptions options = a.options;
    options.illuminant = a.lights.front();
    options.beside.assign(a.lights.begin() + 1, a.lights.end());
    options.adapt = a.noAdapt ? Adaptation::none : adaptationFromName(a.adapt).value();
    options.quadrature = quadratureOf(a.quadrature);
    options.stop = StopSignals::token();
    options.progress = [&bar](double done) { bar.show(done); };
    relight(a.spectral, a.picture, options);
    return kDone;
}

}  // namespace

Command addRelight(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command =
        program.add_subcommand("relight", "A picture of a spectral image under a light");
    command->add_option("spectral", a->spectral, "spectral image")->required();
    command
        ->add_option("-o,--output", a->picture,
                     "picture to write: sRGB with 8 bits, or linear floats if .exr or .hdr")
        ->required();
    command
        ->add_option("--illuminant", a->lights,
                     "the light, or a file with its spectrum; of several, with commas between "
                     "them, the pictures are side by side")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->transform(knownLight(false))
        ->type_name(lightWords(false))
        ->capture_default_str();
    addObserver(*command, a->options.observer,
                "whose eye it is, instead of the observer that the file names: of 2 or 10 degrees, "
                "or a file with a table");
    command
        ->add_option("--adapt", a->adapt,
                     "how the eye has adapted to the light: white looks white; none shows its tint")
        ->check(adaptationCheck())
        ->capture_default_str();
    command->add_flag("--no-adapt", a->noAdapt, "--adapt none")->excludes("--adapt");
    command->add_option("--exposure", a->options.exposure, "stops, to darken or brighten")
        ->check(CLI::Range(-32.0, 32.0) & isFinite())
        ->capture_default_str();
    addReaderQuadrature(*command, a->quadrature);
    addThreads(*command, a->options.threads);
    addLimits(*command);
    addIsolation(*command);
    addSync(*command, a->options.sync);
    command->add_flag("-q,--quiet", a->quiet, "no progress bar");
    return [a] { return relightCommand(*a); };
}

}  // namespace specbake::tool
