#include "choices.h"

#include "farm/allotment.h"
#include "guard/streams.h"

#include <specbake/core/error.h>
#include <specbake/core/methods.h>
#include <specbake/core/observer.h>
#include <specbake/image/measured_file.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <utility>

namespace specbake::tool {
namespace {

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::vector<std::string> adaptationNames() {
    std::vector<std::string> names;
    for (const Adaptation adaptation : adaptations())
        names.emplace_back(adaptationName(adaptation));
    return names;
}

/// A check that words can be read in one place of the wishes.
CLI::Validator wishCheck(std::optional<std::string> ColorWishes::*part) {
    const auto check = [part](std::string& text) {
        ColorWishes wishes;
        wishes.*part = text;
        std::string problem;
        return wishes.isValid(&problem) ? std::string() : problem;
    };
    return {check, "", ""};
}

std::vector<std::string> methodNames() {
    std::vector<std::string> names;
    for (const Method& method : methods()) names.emplace_back(method.name);
    return names;
}

std::vector<std::string> outsideNames() {
    std::vector<std::string> names;
    for (const Outside rule : outsideRules()) names.emplace_back(outsideName(rule));
    return names;
}

std::vector<std::string> quadratureNames() {
    std::vector<std::string> names;
    for (const Quadrature quadrature : kQuadratures) {
        names.emplace_back(quadratureName(quadrature));
    }
    return names;
}

/// "smooth: the smoothest spectrum; …"
std::string methodSummaries() {
    std::string text;
    for (const Method& method : methods()) {
        text += (text.empty() ? "" : "; ") + std::string(method.name) + ": ";
        text += method.summary;
    }
    return text;
}

std::string materialWords() {
    std::string words;
    for (const std::string_view name : materialNames()) {
        words += (words.empty() ? "" : "|") + std::string(name);
    }
    return words;
}

std::string compressionWords() {
    std::string words;
    for (const Compression compression : compressions()) {
        const std::string name(compressionName(compression));
        words += (words.empty() ? "" : ", ") + name + (name.starts_with("zip") ? "[:LEVEL]" : "");
    }
    return words;
}

}  // namespace

ColorWishes ColorArguments::wishes() const {
    ColorWishes wishes{unlessAuto(space), transfer, primaries, config};
    std::string reason;
    if (!wishes.isValid(&reason)) throw ArgumentError("--space: " + reason);
    return wishes;
}

void addSpaceOptions(CLI::App& command, ColorArguments& arguments, const std::string& automatic) {
    std::vector<std::string> names;
    for (const ColorSpace& space : colorSpaces()) names.push_back(space.name);
    command
        .add_option("--space", arguments.space,
                    "what the numbers mean, by name or another name of it (docs/color.md): " +
                        joined(names) + (automatic.empty() ? "" : "; auto: " + automatic))
        ->capture_default_str();
    command
        .add_option("--primaries", arguments.primaries,
                    "the primaries and the white, instead of the space's: rx,ry,gx,gy,bx,by,wx,wy "
                    "or the name of a space")
        ->check(wishCheck(&ColorWishes::primaries));
}

void addColorOptions(CLI::App& command, ColorArguments& arguments, const std::string& automatic) {
    addSpaceOptions(command, arguments, automatic);
    command
        .add_option("--transfer", arguments.transfer,
                    "the curve, instead of the space's: linear, srgb, rec709, romm or gamma:2.2")
        ->check(wishCheck(&ColorWishes::transfer));
}

void addConfigOption(CLI::App& command, ColorArguments& arguments, const std::string& automatic) {
    command
        .add_option(
            "--colorconfig", arguments.config,
            "a configuration of OpenColorIO: --space then takes its spaces and roles" + automatic)
        ->envname("OCIO")
        ->type_name("FILE.ocio");
}

CLI::Validator adaptationCheck() {
    return CLI::IsMember(adaptationNames());
}

std::optional<std::string> unlessAuto(const std::string& name) {
    if (name == "auto") return {};
    return name;
}

std::vector<std::string> ModelArguments::materials() const {
    return material.empty() ? std::vector<std::string>{} : CLI::detail::split(material, ',');
}

Wavelengths BandArguments::bands() const {
    return wavelengths ? parseWavelengths(*wavelengths) : Wavelengths();
}

Quadrature BandArguments::usedQuadrature() const {
    if (quadrature) return quadratureFromName(*quadrature).value();
    return wavelengths ? Quadrature::fine : Quadrature::bands;
}

UpsamplerOptions ModelArguments::options(std::vector<std::string>& notes) const {
    UpsamplerOptions options;
    const std::vector<std::string> names = materials();
    if (names.size() > 1) throw ArgumentError("--material: several need a --material-map");
    if (!names.empty()) options.material = names.front();
    if (!samples.empty()) {
        MeasuredFile file = readMeasuredFile(samples);
        options.samples = std::move(file.samples);
        std::ranges::move(file.notes, std::back_inserter(notes));
    }
    options.illuminant = unlessAuto(illuminant);
    options.method = method;
    options.outside = outsideFromName(outside).value();
    options.adapt = adaptationFromName(adapt).value();
    options.observer = observer;
    options.bands = reader.bands();
    options.quadrature = reader.usedQuadrature();
    std::string reason;
    if (!options.isValid(&reason)) throw ArgumentError(reason);
    return options;
}

void addModelOptions(CLI::App& command, ModelArguments& arguments, const std::string& white) {
    addLight(command, arguments.illuminant,
             "light under which the colours hold, or a file with its spectrum: two columns, nm and "
             "power; auto: " +
                 white,
             true);
    addObserver(command, arguments.observer,
                "who sees the colours so: the CIE's observer of 2 degrees (1931, the default) or "
                "of 10 (1964), or a file with a table: nm, x, y, z");
    command
        .add_option("--adapt", arguments.adapt,
                    "how colours of a space with another white are adapted to the light")
        ->check(adaptationCheck())
        ->capture_default_str();
    command.add_option("--method", arguments.method, methodSummaries())
        ->check(CLI::IsMember(methodNames()))
        ->capture_default_str();
    command
        .add_option("--material", arguments.material,
                    "near the colours of measured samples of it, spectra are those of this "
                    "material, on top of the method")
        ->type_name(materialWords());
    command.add_option(
        "--samples", arguments.samples,
        "measured spectra of yours, on top of the method: at their colours spectra are "
        "theirs. CSV, a sample or a wavelength a row, or CGATS");
    addBandOptions(command, arguments.reader);
}

void addBandOptions(CLI::App& command, BandArguments& arguments) {
    command
        .add_option("--quadrature", arguments.quadrature,
                    "the reader for whom colours are exact: one who sums the 81 bands (bands, the "
                    "default), or one who integrates every 1 nm from 360 to 830 nm, linear between "
                    "bands, as renderers do (fine, the default with --wavelengths)")
        ->check(CLI::IsMember(quadratureNames()));
    command
        .add_option("--wavelengths", arguments.wavelengths,
                    "bands other than 380:780:5, evenly spaced in nm, such as 400:700:10; more "
                    "than 81 are linear between 81 knots")
        ->type_name("START:STOP:STEP");
}

void addOutsideOption(CLI::App& command, ModelArguments& arguments) {
    command
        .add_option("--outside", arguments.outside,
                    "colours that no reflectance has: the nearest one; the brightest of the same "
                    "chromaticity (scale), which fades into the nearest where that is nearly or "
                    "wholly out of reach; or an error")
        ->check(CLI::IsMember(outsideNames()))
        ->capture_default_str();
}

void addReaderQuadrature(CLI::App& command, std::optional<std::string>& name) {
    command
        .add_option("--quadrature", name,
                    "how the bands are integrated, instead of the way that the file names: the sum "
                    "over them (bands), or every 1 nm from 360 to 830 (fine)")
        ->check(CLI::IsMember(quadratureNames()));
}

std::optional<Quadrature> quadratureOf(const std::optional<std::string>& name) {
    return name ? quadratureFromName(*name) : std::nullopt;
}

void printNotes(const std::vector<std::string>& notes, const Upsampler& upsampler) {
    for (const auto* list : {&notes, &upsampler.notes()}) {
        for (const std::string& note : *list)
            std::fprintf(stderr, "specbake: %s\n", shown(note).c_str());
    }
}

ReadOptions ReadArguments::options() const {
    ReadOptions options;
    if (!channels.empty()) options.channels = channelList(channels);
    options.part = part;
    options.orient = orient;
    return options;
}

void addReadOptions(CLI::App& command, ReadArguments& arguments, const std::string& otherwise) {
    command
        .add_option("--channels", arguments.channels,
                    "what is read: R,G,B or R,G,B,A or one channel as grey, by name or number; a "
                    "layer's name stands for its R,G,B and A; " +
                        otherwise)
        ->type_name("NAME,...");
    command
        .add_option("--part", arguments.part,
                    "which part, page, layer or frame of the file, by name or number (the first "
                    "is 0)")
        ->type_name("NAME|N");
    command.add_flag("--orient", arguments.orient,
                     "turn the texture as its Exif or TIFF orientation says");
}

void parseCompression(const std::string& text, StorageOptions& storage) {
    const auto colon = text.find(':');
    const std::string name = text.substr(0, colon);
    const auto kinds = compressions();
    const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                   [&](Compression c) { return compressionName(c) == name; });
    if (kind == kinds.end()) {
        throw ArgumentError("--compression: " + compressionWords() + ", not " + text);
    }
    storage.compression = *kind;
    if (colon == std::string::npos) return;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data() + colon + 1, end, storage.level);
    if (!name.starts_with("zip") || parsed.ec != std::errc() || parsed.ptr != end) {
        throw ArgumentError("--compression: " + text + " has no such level");
    }
}

SampleType parseSampleType(const std::string& name) {
    for (const SampleType type : kSampleTypes) {
        if (name == sampleTypeName(type)) return type;
    }
    throw ArgumentError("no type of samples: " + name);
}

std::vector<std::string> sampleTypeNames() {
    std::vector<std::string> names;
    for (const SampleType type : kSampleTypes) names.emplace_back(sampleTypeName(type));
    return names;
}

CLI::Validator isFinite() {
    return CLI::Validator(
        [](const std::string& text) {
            const double number = std::strtod(text.c_str(), nullptr);
            return std::isfinite(number) ? std::string() : text + " is no number";
        },
        "");
}

void addThreads(CLI::App& command, int& threads) {
    command
        .add_option(
            "-j,--threads", threads,
            "threads, 0 for as many as the process was given: by affinity, quota or scheduler")
        ->envname("SPECBAKE_THREADS")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command.final_callback([&threads] {
        if (threads == 0) threads = allottedThreads();
    });
}

}  // namespace specbake::tool
