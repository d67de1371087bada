#include "bake_report.h"

#include "guard/streams.h"

#include <specbake/bake/report.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace specbake::tool {

using Json = nlohmann::ordered_json;

Json bakeJson(const std::string& input, const std::string& output, const BakeStatistics& s) {
    Json json = {{"input", input},
                 {"output", output},
                 {"space", s.space},
                 {"color_source", colorSourceName(s.colorSource)},
                 {"color_reason", s.colorReason},
                 {"illuminant", s.illuminant},
                 {"texels", s.texels},
                 {"direct_texels", s.directTexels},
                 {"outside_texels", s.outsideTexels},
                 {"outside_max_de2000", s.largestMove},
                 {"nodes_solved", s.nodesSolved},
                 {"grid", s.grid},
                 {"bits", s.bits},
                 {"seconds", s.seconds},
                 {"notes", s.notes}};
    if (s.adapted) json["adaptation"] = adaptationName(*s.adapted);
    if (s.deviation) {
        json["deviation"] = *s.deviation;
        json["deviation_largest"] = s.largestDeviation;
        json["deviation_colors"] = s.deviationColors;
        json["deviation_of_all"] = s.deviationOfAll;
    }
    if (s.difference) json["de2000"] = *s.difference;
    if (!s.secondIlluminant.empty()) {
        json["second_illuminant"] = s.secondIlluminant;
        json["second_missed_texels"] = s.secondMissed;
        json["second_max_de2000"] = s.largestSecondMiss;
    }
    return json;
}

Json failureJson(const std::string& input, const std::string& output, const std::string& reason) {
    return {{"input", input}, {"output", output}, {"error", reason}};
}

std::string jsonText(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

void printRemarks(const std::string& input, const BakeStatistics& s, const std::string& outside) {
    const auto print = [&](const std::string& remark) {
        std::fprintf(stderr, "specbake: %s\n", shown(input + ": " + remark).c_str());
    };
    for (const std::string& note : s.notes) print(note);
    if (s.outsideTexels > 0) {
        std::fprintf(stderr,
                     "specbake: %s: %zu texels have a colour that no reflectance has; they were "
                     "moved by up to CIEDE2000 %.2f (--outside %s)\n",
                     shown(input).c_str(), s.outsideTexels, s.largestMove, outside.c_str());
    }
    if (s.secondMissed > 0) {
        std::fprintf(stderr,
                     "specbake: %s: %zu texels have colours that no reflectance has under both %s "
                     "and %s; the second is off by up to CIEDE2000 %.2f\n",
                     shown(input).c_str(), s.secondMissed, s.illuminant.c_str(),
                     s.secondIlluminant.c_str(), s.largestSecondMiss);
    }
}

std::string choicesText(const std::string& output, const BakeStatistics& s) {
    std::string text;
    if (s.deviation) {
        text += fmt::format(
            "{}: a grid of {} nodes deviates by {:.5f} RMS, by {:.4f} in one texel ({}{} "
            "colours)\n",
            shown(output), s.grid, *s.deviation, s.largestDeviation,
            s.deviationOfAll ? "" : "a sample of ", s.deviationColors);
    }
    if (s.difference) {
        text += fmt::format("{}: {} bits of mantissa keep every texel within CIEDE2000 {:.4f}\n",
                            shown(output), s.bits, *s.difference);
    }
    return text;
}

std::string bakeLine(const std::string& input, const std::string& output, const BakeStatistics& s) {
    const std::string adapted =
        s.adapted ? fmt::format(", adapted to {}: {}", s.illuminant, adaptationName(*s.adapted))
                  : "";
    return fmt::format("{}: colours are {} ({}){}\n", shown(input), s.space, s.colorReason,
                       adapted) +
           fmt::format(
               "{} -> {}: {} texels ({}, {}) in {:.2f} s; {} nodes solved, {} texels one by one",
               shown(input), shown(output), s.texels, s.space, s.illuminant, s.seconds,
               s.nodesSolved, s.directTexels);
}

void writePage(const std::string& page, const std::string& input, const std::string& output,
               const BakeOptions& options, const BakeStatistics& s) {
    ReportOptions report;
    report.verify.read = options.read;
    report.verify.color = options.color;
    report.verify.threads = options.threads;
    report.sync = options.storage.sync;
    report.facts = {{"colours are", s.space + " (" + s.colorReason + ")"},
                    {"texels", std::to_string(s.texels)},
                    {"texels outside the solid", std::to_string(s.outsideTexels)},
                    {"furthest moved, CIEDE2000", fmt::format("{:.3g}", s.largestMove)},
                    {"texels solved one by one", std::to_string(s.directTexels)},
                    {"nodes solved", std::to_string(s.nodesSolved)},
                    {"seconds", fmt::format("{:.2f}", s.seconds)}};
    for (const std::string& note : s.notes) report.facts.emplace_back("remark", note);
    writeReport(output, input, page, report);
}

}  // namespace specbake::tool
