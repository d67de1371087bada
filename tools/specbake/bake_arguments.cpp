#include "bake_arguments.h"

#include "attribute_choices.h"
#include "guard/limit_choices.h"

#include <specbake/core/error.h>

#include <CLI/CLI.hpp>

namespace specbake::tool {
namespace {

/// With a map, the materials are the map's.
UpsamplerOptions modelOf(const BakeArguments& a, BakeOptions& options,
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

}  // namespace

BakeOptions BakeArguments::options(std::vector<std::string>& notes) const {
    BakeOptions options = rest;
    options.read = read.options();
    options.color = color.wishes();
    options.model = modelOf(*this, options, notes);
    parseSecond(second, options);
    options.model.grid = perTexel ? std::nullopt : std::optional(grid);
    options.storage.sampleType = parseSampleType(sampleType);
    if (options.storage.sampleType == SampleType::float32 &&
        (options.maxDE || options.bits != BakeOptions::kMostMantissaBits)) {
        throw ArgumentError("--bits and --max-de are of half samples, not of -d float");
    }
    parseCompression(compression, options.storage);
    for (const auto& [name, text] : attributes) {
        options.attributes.insert_or_assign(name, attributeValue(text));
    }
    if (!wrap.empty()) options.attributes["wrapmodes"] = wrapModes(wrap);
    if (!tile.empty()) options.storage.tile = TileSize{tile.at(0), tile.at(1)};
    return options;
}

void addInputsAndOutput(CLI::App& command, std::vector<std::string>& inputs, std::string& output) {
    command
        .add_option("input", inputs,
                    "textures: images that OpenImageIO reads, folders of them, patterns such as "
                    "'tex/*.png', 'wood.<UDIM>.png' or 'rust.####.tif', and @LIST, a file of such "
                    "words, one a line")
        ->type_name("IN ...")
        ->required();
    command
        .add_option("-o,--output", output,
                    "spectral image to write (.exr); of several textures the folder to write "
                    "into, or a pattern such as '{dir}/{stem}.spectral.exr' or "
                    "'out/wood.<UDIM>.exr'")
        ->required();
}

void addBakeOptions(CLI::App& command, BakeArguments& a) {
    addReadOptions(command, a.read, "else the colours of the file");
    addColorOptions(command, a.color, "what the file says");
    addConfigOption(command, a.color, kFileRules);
    addModelOptions(command, a.model, "the space's white, E for xyz");
    addOutsideOption(command, a.model);
    command
        .add_option("--material-map", a.materialMap,
                    "an image of the texture's size: its channels are how much of each --material "
                    "(up to three, with commas, in the order of the channels) a texel is, from 0 "
                    "to 1")
        ->needs("--material");
    command
        .add_option("--second", a.second,
                    "the same texture under a second light: spectra have these colours under it "
                    "where reflectances have both; white is (1, 1, 1) in both")
        ->type_name("LIGHT=IMAGE");
    command.add_flag("--per-texel", a.perTexel,
                     "solve every distinct colour by itself, without the grid");
    command.add_option("--grid", a.grid, "nodes of the lookup grid along each axis")
        ->check(CLI::Range(kFewestGridNodes, kMostGridNodes))
        ->capture_default_str()
        ->excludes("--per-texel");
    command
        .add_option(
            "--max-deviation", a.rest.maxDeviation,
            "instead of --grid: the coarsest grid whose spectra deviate by no more from the "
            "directly solved ones, RMS over bands and texels; the default grid comes to 0.0002 to "
            "0.002, by the texture")
        ->check(CLI::PositiveNumber & isFinite())
        ->excludes("--per-texel")
        ->excludes("--grid");
    command
        .add_option("--bits", a.rest.bits,
                    "bits of mantissa that half samples keep: fewer make smaller files")
        ->check(CLI::Range(BakeOptions::kFewestMantissaBits, BakeOptions::kMostMantissaBits))
        ->capture_default_str();
    command
        .add_option(
            "--max-de", a.rest.maxDE,
            "instead of --bits: the fewest bits that keep every texel within this CIEDE2000")
        ->check(CLI::PositiveNumber & isFinite())
        ->excludes("--bits");
    command.add_option("-d,--data-type", a.sampleType, "samples of the spectral image")
        ->check(CLI::IsMember(sampleTypeNames()))
        ->capture_default_str();
    command
        .add_option(
            "--compression", a.compression,
            "none, zip[:LEVEL], zips[:LEVEL] or piz; levels 1-3 are fast, 3 the default; 4-9 "
            "take 3 to 45 times as long for at most 3 % less, 4-7 for more on smooth "
            "textures; 10-12 take 50 to 80 times as long, for 3 % less")
        ->capture_default_str();
    command.add_option("--tile", a.tile, "store tiles of this size instead of scan lines")
        ->expected(2)
        ->check(CLI::Range(1, TileSize::kLargestSide))
        ->type_name("W H");
    command.add_flag("--mipmap", a.rest.storage.mipmap,
                     "store all mip levels, averages of spectra; tiles of 64 x 64 unless --tile");
    command
        .add_option("--wrap", a.wrap,
                    "how renderers that go by OpenImageIO continue the texture beyond its edges: "
                    "black, clamp, periodic or mirror, or two of them for s,t; of tiled files, "
                    "black is the default")
        ->check(wrapCheck())
        ->type_name("MODE[,MODE]");
    command
        .add_option("--attrib", a.attributes,
                    "metadata to write, as often as wanted: an int, a float or a string by its "
                    "looks")
        ->type_name("NAME VALUE")
        ->allow_extra_args(false);
    addThreads(command, a.rest.threads);
    addLimits(command);
    addIsolation(command);
    addSync(command, a.rest.storage.sync);
}

}  // namespace specbake::tool
