#include "report/page_data.h"

#include "reading.h"
#include "report/packed_texels.h"

#include <specbake/core/observer.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace specbake::internal {
namespace {

using Json = nlohmann::ordered_json;

Json pointOf(const Chromaticity& at) {
    return {at.x, at.y};
}

/// Seven digits are a float's; a page has thousands of them.
double shortened(double value) {
    return std::isfinite(value) ? std::stod(fmt::format("{:.7g}", value)) : 0.0;
}

Json lampsOf(const ReportColors& colors) {
    Json all = Json::array();
    for (const auto& [name, lit] : colors.lamps) {
        Json bands = Json::array();
        for (const Imath::V3f& band : lit) {
            for (int i = 0; i < 3; ++i) bands.push_back(shortened(double(band[i])));
        }
        all.push_back({{"name", std::string(lightLabel(name))}, {"bands", bands}});
    }
    return all;
}

std::string inWords(const Verification& v) {
    std::string words = fmt::format(
        "{} texels under {}: CIEDE2000 {:.4f} in the mean, {:.4f} at most, at ({}, {}).", v.texels,
        v.illuminant, v.meanDE2000, v.maxDE2000, v.worstX, v.worstY);
    const auto add = [&](std::size_t count, const char* what) {
        if (count > 0) words += fmt::format(" {} {}.", count, what);
    };
    add(v.outsideSolid, "texels have a colour that no reflectance has");
    add(v.beyondRounding, "texels differ by more than the rounding of the samples");
    add(v.notFinite, "texels have a number that is not finite");
    add(v.outOfRange, "samples are outside [0, 1]");
    add(v.previewBeyondRounding, "texels have a preview that is not the colour of their bands");
    add(v.alphaBeyondRounding, "texels have another alpha than the texture");
    return words;
}

Json verified(const Verification& v) {
    return {{"passes", v.passes()}, {"says", inWords(v)}, {"mean", v.meanDE2000},
            {"p99", v.p99DE2000},   {"max", v.maxDE2000}, {"outside", v.outsideSolid}};
}

Json weightsOf(const ReportColors& colors) {
    Json weights = Json::array();
    for (const Imath::V3d& w : colors.weights) {
        for (int i = 0; i < 3; ++i) weights.push_back(shortened(w[i]));
    }
    return weights;
}

Json locusOf(const ReportColors& colors) {
    Json locus = Json::array();
    for (const Imath::V3d& w : colors.weights) {
        if (w.x + w.y + w.z > 0) locus.push_back(pointOf(chromaticity(XYZ(w))));
    }
    return locus;
}

Json triangleOf(const ReportColors& colors) {
    if (!colors.triangle) return nullptr;
    Json corners = Json::array();
    for (const Chromaticity& corner : *colors.triangle) corners.push_back(pointOf(corner));
    return corners;
}

Json histogramOf(const DifferenceHistogram& histogram) {
    return {{"from", DifferenceHistogram::kFrom},
            {"perDecade", DifferenceHistogram::kPerDecade},
            {"counts", histogram.counts}};
}

/// "<" would let a name end the script that the data stand in.
std::string withoutTags(std::string json) {
    for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6) {
        json.replace(at, 1, "\\u003c");
    }
    return json;
}

}  // namespace

ReportColors::ReportColors(const Upsampler& model, const std::string& path,
                           const SpectralReader& reader)
    : space(model.space().name),
      light(model.observer().illuminant()),
      wavelengths(reader.wavelengths()),
      weights(readerWeights(path, reader, light, model.observer().quadrature(),
                            model.observer().functions())) {
    // The usual lamps, and the light of the bake if it is none of them.
    std::vector<std::string> names = illuminantNames();
    if (std::find(names.begin(), names.end(), light) == names.end()) names.push_back(light);
    for (const std::string& name : names) {
        RelightOptions options;
        options.illuminant = name;
        options.observer = model.observer().functions();
        options.quadrature = model.observer().quadrature();
        lamps.emplace_back(name, litBands(path, reader, options));
    }
    if (model.space().isXYZ()) return;
    triangle = {chromaticity(model.xyz(RGB(1, 0, 0))), chromaticity(model.xyz(RGB(0, 1, 0))),
                chromaticity(model.xyz(RGB(0, 0, 1)))};
}

std::string pageData(const PageContent& content) {
    const Blocks& blocks = content.texels.blocks;
    const PackedTexels packed = packTexels(content.texels);
    const Json json = {{"title", content.title},
                       {"texture", content.texture},
                       {"x", content.window.x},
                       {"y", content.window.y},
                       {"width", blocks.width},
                       {"height", blocks.height},
                       {"columns", blocks.columns},
                       {"rows", blocks.rows},
                       {"step", blocks.step},
                       {"wavelengths", content.colors.wavelengths},
                       {"space", content.colors.space},
                       {"light", std::string(lightLabel(content.colors.light))},
                       {"weights", weightsOf(content.colors)},
                       {"locus", locusOf(content.colors)},
                       {"triangle", triangleOf(content.colors)},
                       {"lamps", lampsOf(content.colors)},
                       {"verified", verified(content.verified)},
                       {"histogram", histogramOf(content.texels.histogram)},
                       {"facts", content.facts},
                       {"low", packed.low},
                       {"high", packed.high},
                       {"texels", packed.text}};
    return withoutTags(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace specbake::internal
