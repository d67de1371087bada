#include "choices.h"

#include <specbake/core/error.h>
#include <specbake/core/methods.h>
#include <specbake/core/observer.h>
#include <specbake/image/measured_file.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iterator>
#include <utility>

namespace specbake::tool {
namespace {

std::vector<std::string> illuminantChoices() {
    std::vector<std::string> names = illuminantNames();
    names.insert(names.begin(), "auto");
    return names;
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

std::vector<std::string> spaceChoices() {
    std::vector<std::string> names = {"auto"};
    for (const ColorSpace& space : colorSpaces()) names.push_back(space.name);
    return names;
}

std::optional<std::string> unlessAuto(const std::string& name) {
    if (name == "auto") return {};
    return name;
}

std::vector<std::string> ModelArguments::materials() const {
    return material.empty() ? std::vector<std::string>{} : CLI::detail::split(material, ',');
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
    const bool measured = options.material || !options.samples.empty();
    options.illuminant = unlessAuto(illuminant);
    options.method = measured && !methodGiven ? "natural" : method;
    options.outside = outsideFromName(outside).value();
    return options;
}

void addModelOptions(CLI::App& command, ModelArguments& arguments, const std::string& white) {
    command
        .add_option("--illuminant", arguments.illuminant,
                    "light under which the colours hold; auto: " + white)
        ->check(CLI::IsMember(illuminantChoices()))
        ->capture_default_str();
    command.add_option("--method", arguments.method, methodSummaries())
        ->check(CLI::IsMember(methodNames()))
        ->each([&arguments](const std::string&) { arguments.methodGiven = true; })
        ->capture_default_str();
    command
        .add_option("--material", arguments.material,
                    "near the colours of measured samples of it, spectra are those of this "
                    "material, on top of natural")
        ->type_name(materialWords());
    command.add_option("--samples", arguments.samples,
                       "measured spectra of yours, on top of natural: at their colours spectra are "
                       "theirs. CSV, a sample or a wavelength a row, or CGATS");
    command
        .add_option("--outside", arguments.outside,
                    "colours that no reflectance has: the nearest one; the brightest of the same "
                    "chromaticity (scale), which fades into the nearest where that is nearly or "
                    "wholly out of reach; or an error")
        ->check(CLI::IsMember(outsideNames()))
        ->capture_default_str();
}

void printNotes(const std::vector<std::string>& notes, const Upsampler& upsampler) {
    for (const auto* list : {&notes, &upsampler.notes()}) {
        for (const std::string& note : *list) std::fprintf(stderr, "specbake: %s\n", note.c_str());
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

void addThreads(CLI::App& command, int& threads) {
    command.add_option("-j,--threads", threads, "threads, 0 for all cores")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
}

}  // namespace specbake::tool
