#include "choices.h"
#include "commands.h"
#include "thread_pool.h"

#include <specbake/bake/verify.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <memory>

namespace specbake::tool {
namespace {

struct Arguments {
    std::string spectral;
    std::string texture;
    VerifyOptions options;
    double maxDE = 0.5;
    bool json = false;
    bool quiet = false;
};

void printJson(const Verification& v) {
    const nlohmann::ordered_json json = {
        {"texels", v.texels},
        {"de2000", {{"mean", v.meanDE2000}, {"p99", v.p99DE2000}, {"max", v.maxDE2000}}},
        {"xyz_max_abs", v.maxXYZDifference},
        {"out_of_range", v.outOfRange},
        {"outside_solid", v.outsideSolid},
        {"worst", {v.worstX, v.worstY}}};
    std::cout << json.dump(2) << '\n';
}

void printText(const Verification& v) {
    std::printf(
        "%zu texels: CIEDE2000 mean %.4f, p99 %.4f, max %.4f at (%zu, %zu); "
        "largest |dXYZ| %.2e; %zu samples outside [0, 1]; %zu colours outside the solid\n",
        v.texels, v.meanDE2000, v.p99DE2000, v.maxDE2000, v.worstX, v.worstY, v.maxXYZDifference,
        v.outOfRange, v.outsideSolid);
}

ExitCode verifyCommand(const Arguments& a) {
    const ThreadPool pool(a.options.threads);
    const Verification v = verify(a.spectral, a.texture, a.options);
    if (a.json) {
        printJson(v);
    } else if (!a.quiet) {
        printText(v);
    }
    return v.maxDE2000 <= a.maxDE && v.outOfRange == 0 ? kDone : kDifferent;
}

}  // namespace

Command addVerify(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand(
        "verify", "Integrates a spectral image and compares it with its texture");
    command->add_option("spectral", a->spectral, "spectral image")->required();
    command->add_option("texture", a->texture, "the texture that it was made from")->required();
    command->add_option("--max-de", a->maxDE, "exit 3 if a texel differs by more (CIEDE2000)")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command->add_option("--space", a->options.space,
                        "colour space of the texture, if the file names none");
    command->add_option("--illuminant", a->options.illuminant,
                        "illuminant, if the file names none");
    addThreads(*command, a->options.threads);
    command->add_flag("--json", a->json, "print the figures as JSON");
    command->add_flag("-q,--quiet", a->quiet, "print nothing: the exit code tells");
    return [a] { return verifyCommand(*a); };
}

}  // namespace specbake::tool
