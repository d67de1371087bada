#include "choices.h"
#include "commands.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/core/upsampler.h>
#include <specbake/core/vector.h>
#include <specbake/image/color_meaning.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

namespace specbake::tool {
namespace {

struct Arguments {
    std::vector<double> xyz;
    std::vector<double> rgb;
    ColorArguments color;
    ModelArguments model;
    bool json = false;
};

/// A configuration's spaces are of R, G and B.
ColorMeaning meaningOf(const Arguments& a) {
    ColorWishes wishes = a.color.wishes();
    if (!a.xyz.empty()) wishes.config = {};
    return meaningOfNumbers(*findColorSpace(a.xyz.empty() ? "lin_rec709" : "xyz"), wishes);
}

/// A colour typed as X Y Z; the grey of its Y where it is as near to that as the table of the
/// colour-matching functions is to the truth. Its values have four decimals, so that a sum of 81 of
/// them is off by up to 81 · ½·10⁻⁴ / Σȳ: under E white is (1, 1, 1), of which the table makes
/// (1.000009, 1, 1.000010), and so are the published whites of other lights rounded.
XYZ greyWhereMeant(const XYZ& typed, const Observer& observer) {
    constexpr double sumOfLuminosity = 21.37;
    constexpr double rounding = kBandCount * 0.5e-4 / sumOfLuminosity;
    const XYZ grey(observer.white() * typed.y);
    const bool meant = typed.y <= 1 && largestComponent(typed - grey) <= rounding * typed.y;
    return meant ? grey : typed;
}

RGB linearOf(const std::vector<double>& color, const ColorMeaning& meaning) {
    for (const double value : color) {
        if (!std::isfinite(value)) throw ArgumentError("a colour of finite numbers is wanted");
    }
    if (meaning.transform) {
        const std::array<float, 3> typed = {float(color[0]), float(color[1]), float(color[2])};
        std::array<float, 3> linear{};
        meaning.transform->run(typed.data(), 1, &linear);
        return {double(linear[0]), double(linear[1]), double(linear[2])};
    }
    const Transfer& transfer = meaning.space.transfer;
    return {linearFrom(color[0], transfer), linearFrom(color[1], transfer),
            linearFrom(color[2], transfer)};
}

/// The colour as a texel of a texture in that space would have it.
ColorAnswer solve(const Arguments& a, const ColorMeaning& meaning, const Upsampler& upsampler) {
    const XYZ asked = upsampler.xyz(linearOf(a.xyz.empty() ? a.rgb : a.xyz, meaning));
    if (a.xyz.empty()) return upsampler.solve(asked);
    ColorAnswer answer = upsampler.solve(greyWhereMeant(asked, upsampler.observer()));
    answer.asked = asked;
    return answer;
}

/// What is not the sum over the 81 bands stands beside the light.
std::string lightText(const Observer& observer) {
    const std::string light(lightLabel(observer.illuminant()));
    const std::string who = light + byWhom(observerLabel(observer.functions()));
    return observer.quadrature() == Quadrature::bands ? who : who + ", integrated every 1 nm";
}

/// Of the bands that a reader gets.
std::vector<double> reflectanceOf(const ColorAnswer& answer, const Observer& observer) {
    std::vector<double> values;
    for (const double nm : listed(observer.bands())) {
        values.push_back(valueAt(answer.solution.spectrum, observer.knots(), nm));
    }
    return values;
}

void printJson(const ColorAnswer& answer, const Observer& observer) {
    const SolveReport& r = answer.solution.report;
    const nlohmann::ordered_json json = {
        {"status", statusName(r.status)},
        {"illuminant", lightLabel(observer.illuminant())},
        {"observer", observerLabel(observer.functions())},
        {"quadrature", quadratureName(observer.quadrature())},
        {"asked_xyz", {answer.asked.x, answer.asked.y, answer.asked.z}},
        {"given_xyz", {answer.given.x, answer.given.y, answer.given.z}},
        {"gauge", answer.gauge},
        {"outside", answer.outside},
        {"de2000", answer.difference},
        {"residual", r.residual},
        {"iterations", r.iterations},
        {"starts", r.starts},
        {"hits", r.hits},
        {"blended", r.blended},
        {"fell_back", r.fellBack},
        {"first_nm", observer.bands().first},
        {"step_nm", observer.bands().step},
        {"reflectance", reflectanceOf(answer, observer)}};
    std::cout << json.dump(2) << '\n';
}

void printText(const ColorAnswer& answer, const Observer& observer) {
    std::printf("nm,reflectance\n");
    const std::vector<double> values = reflectanceOf(answer, observer);
    for (std::size_t band = 0; band < values.size(); ++band) {
        std::printf("%.9g,%.17g\n", observer.bands().at(int(band)), values[band]);
    }
    const SolveReport& r = answer.solution.report;
    std::fprintf(stderr, "%s under %s: XYZ %.6g %.6g %.6g, gauge %.9g, residual %.1e, ",
                 statusName(r.status).data(), lightText(observer).c_str(), answer.asked.x,
                 answer.asked.y, answer.asked.z, answer.gauge, r.residual);
    std::fprintf(stderr, "%d iterations, %d starts, %d hits\n", r.iterations, r.starts, r.hits);
    if (r.fellBack) std::fprintf(stderr, "the method failed; the smooth one solved the colour\n");
    if (!answer.outside && answer.given != answer.asked) {
        std::fprintf(stderr,
                     "taken for a grey, XYZ %.9g %.9g %.9g: the same to the table's rounding\n",
                     answer.given.x, answer.given.y, answer.given.z);
    }
    if (answer.outside) {
        std::fprintf(stderr,
                     "outside the solid: the spectrum is that of XYZ %.6g %.6g %.6g, CIEDE2000 "
                     "%.2f from what was asked\n",
                     answer.given.x, answer.given.y, answer.given.z, answer.difference);
    }
}

ExitCode solveCommand(const Arguments& a) {
    if (a.xyz.empty() && a.rgb.empty()) throw ArgumentError("solve needs a colour: --xyz or --rgb");
    std::vector<std::string> notes;
    const ColorMeaning meaning = meaningOf(a);
    const Upsampler upsampler(meaning.space, a.model.options(notes));
    printNotes(notes, upsampler);
    const ColorAnswer answer = solve(a, meaning, upsampler);
    if (!answer.solution.solved()) {
        std::fprintf(stderr, "specbake: no spectrum: %s, gauge %.9g\n",
                     answer.outside ? "the colour is outside the object-colour solid"
                                    : "the method did not reach the colour",
                     answer.gauge);
        return kFailed;
    }
    a.json ? printJson(answer, upsampler.observer()) : printText(answer, upsampler.observer());
    return kDone;
}

}  // namespace

Command addSolve(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("solve", "One colour to its spectrum, as CSV");
    CLI::Option* xyz = command->add_option(
        "--xyz", a->xyz,
        "X Y Z; the perfect reflector has Y = 1. What is a grey to four decimals is "
        "solved as that grey, and comes out flat");
    xyz->expected(3);
    command->add_option("--rgb", a->rgb, "R G B of --space; 1 1 1 is white")
        ->expected(3)
        ->excludes(xyz);
    addColorOptions(*command, a->color, "lin_rec709 for --rgb");
    addConfigOption(*command, a->color);
    addModelOptions(*command, a->model, "the space's white, E for --xyz");
    addOutsideOption(*command, a->model);
    command->add_flag("--json", a->json, "spectrum and report as JSON");
    return [a] { return solveCommand(*a); };
}

}  // namespace specbake::tool
