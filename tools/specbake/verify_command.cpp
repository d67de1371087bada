#include "choices.h"
#include "commands.h"
#include "guard/file_names.h"
#include "guard/limit_choices.h"
#include "guard/streams.h"
#include "thread_pool.h"

#include <specbake/bake/compare_spectra.h>
#include <specbake/bake/report.h>
#include <specbake/bake/verify.h>
#include <specbake/core/error.h>
#include <specbake/image/second_reading.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

namespace specbake::tool {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
    std::string spectral;
    std::string texture;
    std::string reference;
    std::string report;
    ReadArguments read;
    ColorArguments color;
    std::optional<std::string> adapt;
    VerifyOptions options;
    std::optional<std::string> quadrature;
    std::optional<double> maxDE;
    double maxBand = 0.001;
    bool independent = true;
    bool json = false;
    bool quiet = false;
    bool sync = false;
};

Json jsonOf(const Verification& v) {
    return {
        {"texels", v.texels},
        {"illuminant", v.illuminant},
        {"observer", v.observer},
        {"quadrature", quadratureName(v.quadrature)},
        {"de2000", {{"mean", v.meanDE2000}, {"p99", v.p99DE2000}, {"max", v.maxDE2000}}},
        {"xyz_max_abs", v.maxXYZDifference},
        {"beyond_rounding", v.beyondRounding},
        {"not_finite", v.notFinite},
        {"out_of_range", v.outOfRange},
        {"outside_solid", v.outsideSolid},
        {"preview",
         {{"beyond_rounding", v.previewBeyondRounding}, {"max_abs", v.maxPreviewDifference}}},
        {"alpha", {{"beyond_rounding", v.alphaBeyondRounding}, {"max_abs", v.maxAlphaDifference}}},
        {"worst", {v.worstX, v.worstY}}};
}

Json jsonOf(const SpectralDifference& d) {
    return {
        {"texels", d.texels},        {"max_abs", d.largest},          {"rms", d.rms},
        {"not_finite", d.notFinite}, {"worst", {d.worstX, d.worstY}}, {"worst_nm", d.worstBand}};
}

/// One more reason why a file does not pass, if any texel has it.
void complain(const Arguments& a, std::size_t texels, const std::string& what) {
    if (texels > 0)
        std::printf("%s\n",
                    shown(fmt::format("{}: {} texels {}", a.spectral, texels, what)).c_str());
}

std::string upTo(double difference) {
    char text[32];
    std::snprintf(text, sizeof text, " (off by up to %.2g)", difference);
    return text;
}

void printText(const Arguments& a, const Verification& v) {
    std::printf(
        "%s: %zu texels under %s%s%s: CIEDE2000 mean %.4f, p99 %.4f, max %.4f at (%zu, %zu); "
        "largest |dXYZ| %.2e; %zu samples outside [0, 1]; %zu colours outside the solid\n",
        shown(a.spectral).c_str(), v.texels, v.illuminant.c_str(), byWhom(v.observer).c_str(),
        v.quadrature == Quadrature::fine ? ", integrated every 1 nm" : "", v.meanDE2000,
        v.p99DE2000, v.maxDE2000, v.worstX, v.worstY, v.maxXYZDifference, v.outOfRange,
        v.outsideSolid);
    complain(a, v.notFinite, "have a number that is not finite, here or in " + a.texture);
    complain(a, v.beyondRounding,
             "differ by more than the rounding of the samples: from another texture, or under "
             "another light or in another space than the file names");
    complain(a, v.previewBeyondRounding,
             "have a preview (R, G, B) that is not the colour of their bands" +
                 upTo(v.maxPreviewDifference));
    complain(a, v.alphaBeyondRounding,
             "have another alpha than in " + a.texture + upTo(v.maxAlphaDifference));
}

void printText(const Arguments& a, const SpectralDifference& d) {
    std::printf("%s: %zu texels beside %s: bands differ by %.2e RMS, %.2e at most",
                shown(a.spectral).c_str(), d.texels, shown(a.reference).c_str(), d.rms, d.largest);
    if (d.largest > 0) std::printf(", at (%zu, %zu), %g nm", d.worstX, d.worstY, d.worstBand);
    std::printf("\n");
    complain(a, d.notFinite, "have a number that is not finite, here or in " + a.reference);
}

/// Prints what was found as the user wants it; `json` gathers it by a name.
template <class Found>
void show(const Arguments& a, const Found& found, const char* name, Json& json) {
    json[name] = jsonOf(found);
    if (!a.json && !a.quiet) printText(a, found);
}

/// Reads the texture once more by another reader than the bake did; false if that finds it
/// different.
bool confirmReading(const Arguments& a, Json& json) {
    if (!a.independent) return true;
    const SecondReading second = compareReadings(a.texture);
    const std::string result = !second.possible ? "only one reader knows this file; not confirmed"
                               : second.difference
                                   ? "OpenImageIO reads otherwise: " + *second.difference
                                   : "OpenImageIO reads the same";
    json["colors"]["reading"] = result;
    const bool agree = !second.difference;
    if (!a.json && !a.quiet) std::printf("%s\n", shown(a.texture + ": " + result).c_str());
    return agree;
}

Verification verified(const Arguments& a) {
    VerifyOptions options = a.options;
    options.read = a.read.options();
    options.color = a.color.wishes();
    if (a.adapt) options.adapt = adaptationFromName(*a.adapt);
    options.quadrature = quadratureOf(a.quadrature);
    if (a.report.empty()) return verify(a.spectral, a.texture, options);
    ReportOptions page;
    page.verify = options;
    page.sync = a.sync;
    return writeReport(a.spectral, a.texture, a.report, page);
}

bool isExr(const std::string& path) {
    return path.ends_with(".exr") || path.ends_with(".EXR");
}

ExitCode verifyCommand(const Arguments& a) {
    if (a.texture.empty() && a.reference.empty()) {
        throw ArgumentError("verify: a texture, or --spectra REFERENCE, is needed to compare with");
    }
    if (!isExr(a.spectral) && isExr(a.texture)) {
        throw ArgumentError("verify: the spectral image comes first, the texture after it");
    }
    FileNames files;
    for (const auto& input : {a.spectral, a.texture, a.reference}) files.addInput(input);
    files.addOutput(a.report, "--report");
    const ThreadPool pool(a.options.threads);
    Json json;
    bool passed = true;
    if (!a.texture.empty()) {
        const Verification v = verified(a);
        show(a, v, "colors", json);
        passed = confirmReading(a, json) && v.passes(a.maxDE);
    }
    if (!a.reference.empty()) {
        const SpectralDifference d = compareSpectra(a.spectral, a.reference, a.options.threads);
        show(a, d, "spectra", json);
        passed = d.passes(a.maxBand) && passed;
    }
    // What stood alone before spectra could be compared still does.
    if (a.json) std::cout << (a.reference.empty() ? json["colors"] : json).dump(2) << '\n';
    return passed ? kDone : kDifferent;
}

}  // namespace

Command addVerify(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand(
        "verify", "Compares a spectral image with its texture, or with another spectral image");
    command->footer(
        "With a texture: integrates the bands and compares the colours, the preview and the "
        "alpha.\n"
        "What no colour shows, such as 380 nm, only --spectra does. Exit code 3 if the file does\n"
        "not pass; a number that is not finite never passes.");
    command->add_option("spectral", a->spectral, "spectral image")->required();
    auto* texture = command->add_option("texture", a->texture, "the texture that it was made from");
    command
        ->add_option("--report", a->report,
                     "write a page about it to this HTML file: the texture under lamps, spectra, "
                     "differences")
        ->needs(texture);
    command
        ->add_option("--max-de", a->maxDE,
                     "exit 3 if a texel differs by more (CIEDE2000); without it, by more than the "
                     "rounding of the file's samples explains, or by more than 0.5")
        ->check(CLI::NonNegativeNumber & isFinite());
    auto* spectra = command->add_option("--spectra", a->reference,
                                        "compare band by band with this spectral image");
    command->add_option("--max-band", a->maxBand, "exit 3 if a band of --spectra differs by more")
        ->check(CLI::NonNegativeNumber & isFinite())
        ->capture_default_str()
        ->needs(spectra);
    addReadOptions(*command, a->read, "else what the spectral file was made of");
    addColorOptions(*command, a->color, "what the spectral image says");
    addConfigOption(*command, a->color, kFileRules);
    command
        ->add_option("--illuminant", a->options.illuminant,
                     "light, or a file with its spectrum, instead of the one that the file names")
        ->transform(knownLight(false));
    addObserver(*command, a->options.observer,
                "observer of 2 or 10 degrees, or a file with a table, instead of the one that the "
                "file names");
    command->add_option("--adapt", a->adapt, "adaptation, instead of the one that the file names")
        ->check(adaptationCheck());
    command->add_flag("--independent,!--no-independent", a->independent,
                      "read the texture by OpenImageIO too, where the bake reads it by a reader of "
                      "its own, and exit 3 if they differ; the default");
    addReaderQuadrature(*command, a->quadrature);
    addThreads(*command, a->options.threads);
    command->add_flag("--json", a->json, "print the figures as JSON");
    command->add_flag("-q,--quiet", a->quiet, "print nothing: the exit code tells");
    addLimits(*command);
    addIsolation(*command);
    addSync(*command, a->sync);
    return [a] { return verifyCommand(*a); };
}

}  // namespace specbake::tool
