#include "bake_report.h"
#include "commands.h"
#include "guard/file_names.h"
#include "guard/limit_choices.h"
#include "guard/streams.h"
#include "spectrum_plot.h"

#include <specbake/bake/inspect.h>
#include <specbake/core/error.h>
#include <specbake/image/output_file.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <numeric>
#include <optional>

namespace specbake::tool {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
    std::string spectral;
    std::vector<int> places;  ///< x, y, x, y, …
    std::string plotFile;
    bool json = false;
    bool sync = false;
};

double least(const BandStatistics& s) {
    return *std::min_element(s.least.begin(), s.least.end());
}

double largest(const BandStatistics& s) {
    return *std::max_element(s.largest.begin(), s.largest.end());
}

double mean(const BandStatistics& s) {
    return std::accumulate(s.mean.begin(), s.mean.end(), 0.0) / double(s.mean.size());
}

/// In nm, where bands are evenly spaced as their names tell it.
std::optional<double> evenStep(const std::vector<double>& nm) {
    const double step = (nm.back() - nm.front()) / double(nm.size() - 1);
    for (std::size_t i = 0; i < nm.size(); ++i) {
        if (std::abs(nm[i] - nm.front() - double(i) * step) > 1e-5) return {};
    }
    return std::round(step * 1e6) / 1e6;
}

std::vector<Curve> curvesAt(SpectralReader& reader, const std::vector<int>& places) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < places.size(); i += 2) {
        const int x = places[i];
        const int y = places[i + 1];
        curves.push_back({fmt::format("({}, {})", x, y), spectrumAt(reader, x, y)});
    }
    return curves;
}

/// Of the whole file.
std::vector<Curve> curvesOf(const BandStatistics& s) {
    return {{"largest", s.largest}, {"mean", s.mean}, {"least", s.least}};
}

Json windowJson(const Window& w) {
    return {{"x", w.x}, {"y", w.y}, {"width", w.width}, {"height", w.height}};
}

/// Even spacing by its step, any other wavelength by wavelength.
Json bandsJson(const std::vector<double>& nm) {
    Json json = {{"count", nm.size()}, {"first_nm", nm.front()}, {"last_nm", nm.back()}};
    if (const auto step = evenStep(nm)) {
        json["step_nm"] = *step;
    } else {
        json["nm"] = nm;
    }
    return json;
}

Json factsJson(const SpectralReader& reader, const BandStatistics& s) {
    const StorageFacts facts = reader.facts();
    Json attributes = Json::object();
    for (const auto& [name, value] : facts.attributes) attributes[name] = value;
    Json tile;
    if (facts.tileWidth > 0) tile = {facts.tileWidth, facts.tileHeight};
    return {{"data_window", windowJson(reader.header().data)},
            {"display_window", windowJson(reader.header().display)},
            {"channels", facts.channels},
            {"alpha", reader.header().alpha},
            {"sample_type", facts.sampleType},
            {"compression", facts.compression},
            {"tile", tile},
            {"mip_levels", facts.levels},
            {"bands", bandsJson(reader.wavelengths())},
            {"reflectance",
             {{"min", least(s)},
              {"mean", mean(s)},
              {"max", largest(s)},
              {"out_of_range", s.outOfRange}}},
            {"attributes", attributes}};
}

void printFacts(const std::string& path, const SpectralReader& reader, const BandStatistics& s) {
    const StorageFacts facts = reader.facts();
    const Window& data = reader.header().data;
    const Window& display = reader.header().display;
    std::printf("%s: %d x %d texels, %d channels of %s, compression %s", shown(path).c_str(),
                data.width, data.height, facts.channels, facts.sampleType.c_str(),
                facts.compression.c_str());
    if (facts.tileWidth > 0) std::printf(", tiles %d x %d", facts.tileWidth, facts.tileHeight);
    if (facts.levels > 1) std::printf(", %d mip levels", facts.levels);
    const std::vector<double>& nm = reader.wavelengths();
    const auto step = evenStep(nm);
    std::printf("\nbands: %zu, %g to %g nm %s%s\n", nm.size(), nm.front(), nm.back(),
                step ? fmt::format("every {:g} nm", *step).c_str() : "unevenly spaced",
                reader.header().alpha ? "; alpha" : "");
    std::printf("data window: from (%d, %d); display window: %d x %d from (%d, %d)\n", data.x,
                data.y, display.width, display.height, display.x, display.y);
    std::printf("reflectance: min %.6g, mean %.6g, max %.6g; %zu samples outside [0, 1]\n",
                least(s), mean(s), largest(s), s.outOfRange);
    for (const auto& [name, value] : facts.attributes) {
        std::printf("%s: %s\n", shown(name).c_str(), shown(value).c_str());
    }
}

void printCsv(const std::vector<double>& wavelengths, const std::vector<Curve>& curves) {
    std::printf("wavelength_nm");
    for (const Curve& curve : curves) std::printf(",\"%s\"", curve.name.c_str());
    std::printf("\n");
    for (std::size_t band = 0; band < wavelengths.size(); ++band) {
        std::printf("%.9g", wavelengths[band]);
        for (const Curve& curve : curves) std::printf(",%.9g", curve.spectrum[band]);
        std::printf("\n");
    }
}

void writePlot(const Arguments& a, const SpectralReader& reader, const std::vector<Curve>& curves) {
    const std::string title = std::filesystem::path(a.spectral).filename().string();
    writeWhole(a.plotFile, spectrumPlot(title, reader.wavelengths(), curves), a.sync);
}

/// Texels alone: the file is not read as a whole.
void inspectTexels(const Arguments& a, SpectralReader& reader) {
    const std::vector<Curve> curves = curvesAt(reader, a.places);
    if (!a.plotFile.empty()) writePlot(a, reader, curves);
    if (!a.json) return printCsv(reader.wavelengths(), curves);
    Json texels = Json::array();
    for (std::size_t i = 0; i < curves.size(); ++i) {
        texels.push_back({{"x", a.places[2 * i]},
                          {"y", a.places[2 * i + 1]},
                          {"reflectance", curves[i].spectrum}});
    }
    std::cout << jsonText(Json({{"texels", texels}}), 2) << '\n';
}

ExitCode inspectCommand(const Arguments& a) {
    if (!a.plotFile.empty() && std::filesystem::path(a.plotFile).extension() != ".svg") {
        throw ArgumentError(a.plotFile + ": a plot is an SVG; its name must end in .svg");
    }
    FileNames files;
    files.addInput(a.spectral);
    files.addOutput(a.plotFile, "--plot");
    SpectralReader reader(a.spectral);
    if (!a.places.empty()) {
        inspectTexels(a, reader);
        return kDone;
    }
    const BandStatistics statistics = bandStatistics(a.spectral);
    if (!a.plotFile.empty()) writePlot(a, reader, curvesOf(statistics));
    if (a.json) {
        std::cout << jsonText(factsJson(reader, statistics), 2) << '\n';
    } else {
        printFacts(a.spectral, reader, statistics);
    }
    return kDone;
}

}  // namespace

Command addInspect(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command =
        program.add_subcommand("inspect", "What a spectral image holds, and its spectra");
    command->add_option("spectral", a->spectral, "spectral image")->required();
    command
        ->add_option("--at", a->places,
                     "print the values of the texel X Y as CSV; may be given again")
        ->type_size(2)
        ->type_name("X Y");
    command->add_option("--plot", a->plotFile,
                        "draw those texels' spectra to this SVG; without --at each band's extremes "
                        "and mean");
    command->add_flag("--json", a->json, "print JSON");
    addLimits(*command);
    addIsolation(*command);
    addSync(*command, a->sync);
    return [a] { return inspectCommand(*a); };
}

}  // namespace specbake::tool
