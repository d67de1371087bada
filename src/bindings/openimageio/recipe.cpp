#include "recipe.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/image/light_file.h>
#include <specbake/image/measured_file.h>
#include <specbake/image/observer_file.h>
#include <specbake/image/texture_reader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace specbake::openimageio {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".spectral";

[[noreturn]] void refuse(std::string_view value, const std::string& wanted) {
    throw ArgumentError("'" + std::string(value) + "' is not " + wanted);
}

template <class Number>
Number numberOf(std::string_view text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end) refuse(text, "a number");
    return number;
}

bool yesOrNo(std::string_view text) {
    if (text != "yes" && text != "no") refuse(text, "yes or no");
    return text == "yes";
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

void setOutside(BakeOptions& options, std::string_view value) {
    const std::optional<Outside> rule = outsideFromName(value);
    if (!rule) refuse(value, "nearest, scale or error");
    options.model.outside = *rule;
}

void setAdaptation(BakeOptions& options, std::string_view value) {
    const std::optional<Adaptation> adaptation = adaptationFromName(value);
    if (!adaptation) refuse(value, "bradford, cat16 or none");
    options.model.adapt = *adaptation;
}

void setSampleType(BakeOptions& options, std::string_view value) {
    const auto type = std::find_if(kSampleTypes.begin(), kSampleTypes.end(),
                                   [&](SampleType t) { return sampleTypeName(t) == value; });
    if (type == kSampleTypes.end()) refuse(value, "half or float");
    options.storage.sampleType = *type;
}

void setQuadrature(Recipe& recipe, std::string_view value) {
    const std::optional<Quadrature> quadrature = quadratureFromName(value);
    if (!quadrature) refuse(value, "bands or fine");
    recipe.options.model.quadrature = *quadrature;
    recipe.quadratureGiven = true;
}

void setWavelengths(Recipe& recipe, std::string_view value) {
    recipe.options.model.bands = parseWavelengths(std::string(value));
    if (!recipe.quadratureGiven) recipe.options.model.quadrature = Quadrature::fine;
}

/// "64 64"
void setTile(BakeOptions& options, std::string_view value) {
    const std::size_t blank = value.find(' ');
    if (blank == std::string_view::npos) refuse(value, "a width and a height");
    options.storage.tile = TileSize{numberOf<int>(value.substr(0, blank)),
                                    numberOf<int>(trimmed(value.substr(blank)))};
}

struct Option {
    std::string_view name;
    void (*set)(Recipe& recipe, std::string_view value);
    bool isOfModel = false;  ///< for which a table leaves no room
};

constexpr Option kOptions[] = {
    {"source", [](Recipe& r, std::string_view v) { r.source = v; }},
    {"channels",
     [](Recipe& r, std::string_view v) { r.options.read.channels = channelList(std::string(v)); }},
    {"part", [](Recipe& r, std::string_view v) { r.options.read.part = v; }},
    {"orient", [](Recipe& r, std::string_view v) { r.options.read.orient = yesOrNo(v); }},
    {"space", [](Recipe& r, std::string_view v) { r.options.color.space = v; }},
    {"transfer", [](Recipe& r, std::string_view v) { r.options.color.transfer = v; }},
    {"primaries", [](Recipe& r, std::string_view v) { r.options.color.primaries = v; }},
    {"colorconfig", [](Recipe& r, std::string_view v) { r.options.color.config = v; }},
    {"illuminant", [](Recipe& r, std::string_view v) { r.options.model.illuminant = v; }, true},
    {"observer", [](Recipe& r, std::string_view v) { r.options.model.observer = v; }, true},
    {"adapt", [](Recipe& r, std::string_view v) { setAdaptation(r.options, v); }, true},
    {"method", [](Recipe& r, std::string_view v) { r.options.model.method = v; }, true},
    {"outside", [](Recipe& r, std::string_view v) { setOutside(r.options, v); }, true},
    {"material", [](Recipe& r, std::string_view v) { r.options.model.material = v; }, true},
    {"samples", [](Recipe& r, std::string_view v) { r.samples = v; }, true},
    {"quadrature", setQuadrature, true},
    {"wavelengths", setWavelengths, true},
    {"table", [](Recipe& r, std::string_view v) { r.table = v; }},
    {"grid", [](Recipe& r, std::string_view v) { r.options.model.grid = numberOf<int>(v); }, true},
    {"per-texel",
     [](Recipe& r, std::string_view v) {
         if (yesOrNo(v)) r.options.model.grid = std::nullopt;
     },
     true},
    {"max-deviation",
     [](Recipe& r, std::string_view v) { r.options.maxDeviation = numberOf<double>(v); }, true},
    {"bits", [](Recipe& r, std::string_view v) { r.options.bits = numberOf<int>(v); }},
    {"max-de", [](Recipe& r, std::string_view v) { r.options.maxDE = numberOf<double>(v); }, true},
    {"data-type", [](Recipe& r, std::string_view v) { setSampleType(r.options, v); }},
    {"tile", [](Recipe& r, std::string_view v) { setTile(r.options, v); }},
    {"mipmap", [](Recipe& r, std::string_view v) { r.options.storage.mipmap = yesOrNo(v); }},
};

std::string optionNames() {
    std::string names;
    for (const Option& option : kOptions) {
        names += (names.empty() ? "" : ", ") + std::string(option.name);
    }
    return names;
}

std::string textOf(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::string text(kLongestRecipe + 1, '\0');
    stream.read(text.data(), std::streamsize(text.size()));
    if (stream.bad() || !stream.is_open()) throw FileError(path, "cannot be read");
    text.resize(std::size_t(stream.gcount()));
    if (text.size() > kLongestRecipe) throw FileError(path, "too long for a text of options");
    if (text.find('\0') != std::string::npos) throw FileError(path, "no text of options");
    return text;
}

void readLine(Recipe& recipe, std::string_view line) {
    if (line.empty() || line.front() == '#') return;
    const std::size_t equal = line.find('=');
    if (equal == std::string_view::npos) throw ArgumentError("not of the form name = value");
    setOption(recipe, trimmed(line.substr(0, equal)), trimmed(line.substr(equal + 1)));
}

void readText(Recipe& recipe, const std::string& path) {
    std::istringstream lines(textOf(path));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        try {
            readLine(recipe, trimmed(line));
        } catch (const ArgumentError& error) {
            throw FileError(path, "line " + std::to_string(number) + ": " + error.what());
        }
    }
}

/// A file's name, told from the folder of another.
std::string besides(const std::string& path, const std::string& name) {
    return (fs::path(path).parent_path() / name).string();
}

/// A file besides, if there is one.
std::string fileOrName(const std::string& path, const std::string& word) {
    std::error_code ignored;
    const std::string file = (fs::path("./") / besides(path, word)).string();
    return fs::is_regular_file(file, ignored) ? file : word;
}

bool isRecipe(const std::string& path) {
    return path.size() > kEnding.size() && path.ends_with(kEnding);
}

/// What is no name is a file.
void readFiles(UpsamplerOptions& model) {
    std::error_code ignored;
    const auto namesFile = [&](const std::string& word) {
        return word.find('/') != std::string::npos && fs::is_regular_file(word, ignored);
    };
    if (model.illuminant && namesFile(*model.illuminant)) {
        model.illuminant = readLight(*model.illuminant);
    }
    if (namesFile(model.observer)) model.observer = readObserver(model.observer);
}

}  // namespace

void setOption(Recipe& recipe, std::string_view name, std::string_view value) {
    const auto option = std::find_if(std::begin(kOptions), std::end(kOptions),
                                     [&](const Option& o) { return o.name == name; });
    if (option == std::end(kOptions)) {
        throw ArgumentError("no option '" + std::string(name) + "'; there are " + optionNames());
    }
    option->set(recipe, value);
    if (option->isOfModel) recipe.modelOption = name;
}

void forEachOption(const std::function<void(std::string_view)>& take) {
    for (const Option& option : kOptions) take(option.name);
}

Recipe recipeOf(const std::string& path) {
    if (!isRecipe(path)) throw FileError(path, "its name does not end in .spectral");
    Recipe recipe;
    recipe.options.storage.tile = TileSize{};
    recipe.options.storage.mipmap = true;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_regular_file(status)) {
        readText(recipe, path);
    } else if (fs::exists(status)) {
        throw FileError(path, "no regular file");
    }
    if (recipe.source.empty()) {
        recipe.source = path.substr(0, path.size() - kEnding.size());
    } else {
        recipe.source = besides(path, recipe.source);
    }
    for (std::string* file : {&recipe.samples, &recipe.table}) {
        if (!file->empty()) *file = besides(path, *file);
    }
    UpsamplerOptions& model = recipe.options.model;
    if (model.illuminant && !isIlluminant(*model.illuminant)) {
        model.illuminant = fileOrName(path, *model.illuminant);
    }
    if (!isObserver(model.observer)) model.observer = fileOrName(path, model.observer);
    if (auto& config = recipe.options.color.config) config = fileOrName(path, *config);
    if (isRecipe(recipe.source)) throw FileError(path, "its source is a .spectral file itself");
    if (!fs::is_regular_file(recipe.source, error)) {
        throw FileError(path, "its source " + recipe.source + " is no file");
    }
    return recipe;
}

std::unique_ptr<const BakedImage> imageOf(const Recipe& recipe,
                                          std::shared_ptr<ModelCache> models) {
    BakeOptions options = recipe.options;
    options.models = std::move(models);
    if (!options.storage.isTiled()) options.storage.tile = TileSize{};
    if (!recipe.samples.empty()) options.model.samples = readMeasuredFile(recipe.samples).samples;
    readFiles(options.model);
    auto texture = std::make_unique<TextureReader>(recipe.source, options.read);
    if (recipe.table.empty()) return std::make_unique<BakedImage>(std::move(texture), options);
    if (!recipe.modelOption.empty()) {
        throw ArgumentError("a table has its own spectra, and leaves no room for '" +
                            recipe.modelOption + "'");
    }
    return std::make_unique<BakedImage>(
        std::move(texture), options,
        std::make_shared<const TableFile>(TableFile::read(recipe.table)));
}

}  // namespace specbake::openimageio
