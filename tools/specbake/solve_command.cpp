#include "choices.h"
#include "commands.h"

#include <specbake/bake/solve_color.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <memory>

namespace specbake::tool {
namespace {

struct Arguments {
    std::vector<double> xyz;
    std::vector<double> rgb;
    std::string space = "auto";
    std::string illuminant = "auto";
    std::string method = "smooth";
    std::string outside = "nearest";
    bool json = false;
};

ColorRequest requestOf(const Arguments& a) {
    ColorRequest request;
    const std::vector<double>& color = a.xyz.empty() ? a.rgb : a.xyz;
    std::copy(color.begin(), color.end(), request.color.begin());
    if (!a.xyz.empty()) request.space = "xyz";
    if (a.space != "auto") request.space = a.space;
    request.illuminant = unlessAuto(a.illuminant);
    request.method = methodChoices().at(a.method);
    request.outside = outsideChoices().at(a.outside);
    return request;
}

const char* statusName(SolveReport::Status status) {
    switch (status) {
        case SolveReport::Status::solved:
            return "solved";
        case SolveReport::Status::outside:
            return "outside";
        case SolveReport::Status::failed:
            break;
    }
    return "failed";
}

void printJson(const ColorAnswer& answer) {
    const SolveReport& r = answer.solution.report;
    const nlohmann::ordered_json json = {
        {"status", statusName(r.status)},
        {"illuminant", answer.illuminant},
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
        {"first_nm", kFirstWavelength},
        {"step_nm", kWavelengthStep},
        {"reflectance", answer.solution.spectrum}};
    std::cout << json.dump(2) << '\n';
}

void printText(const ColorAnswer& answer) {
    std::printf("nm,reflectance\n");
    for (int band = 0; band < kBandCount; ++band) {
        std::printf("%d,%.17g\n", wavelength(band), answer.solution.spectrum[std::size_t(band)]);
    }
    const SolveReport& r = answer.solution.report;
    std::fprintf(stderr, "%s under %s: XYZ %.6g %.6g %.6g, gauge %.9g, residual %.1e, ",
                 statusName(r.status), answer.illuminant.c_str(), answer.asked.x, answer.asked.y,
                 answer.asked.z, answer.gauge, r.residual);
    std::fprintf(stderr, "%d iterations, %d starts, %d hits\n", r.iterations, r.starts, r.hits);
    if (r.fellBack) std::fprintf(stderr, "the method failed; the smooth one solved the colour\n");
    if (answer.outside) {
        std::fprintf(stderr, "outside the solid: given XYZ %.6g %.6g %.6g, CIEDE2000 %.2f\n",
                     answer.given.x, answer.given.y, answer.given.z, answer.difference);
    }
}

ExitCode solveCommand(const Arguments& a) {
    const ColorAnswer answer = solveColor(requestOf(a));
    if (!answer.solution.solved()) {
        std::fprintf(stderr, "specbake: no spectrum: %s, gauge %.9g\n",
                     answer.outside ? "the colour is outside the object-colour solid"
                                    : "the method did not reach the colour",
                     answer.gauge);
        return kFailed;
    }
    a.json ? printJson(answer) : printText(answer);
    return kDone;
}

}  // namespace

Command addSolve(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("solve", "One colour to its spectrum, as CSV");
    auto* color = command->add_option_group("colour");
    color->add_option("--xyz", a->xyz, "X Y Z; the perfect reflector has Y = 1")->expected(3);
    color->add_option("--rgb", a->rgb, "R G B of --space; 1 1 1 is white")->expected(3);
    color->require_option(1);
    command->add_option("--space", a->space, "what --rgb is in; auto: lin_rec709")
        ->check(CLI::IsMember(spaceChoices()))
        ->capture_default_str();
    command
        ->add_option("--illuminant", a->illuminant,
                     "light under which the colour holds; auto: the space's white, E for --xyz")
        ->check(CLI::IsMember(illuminantChoices()))
        ->capture_default_str();
    command->add_option("--method", a->method, "how the spectrum is found")
        ->check(CLI::IsMember(methodChoices()))
        ->capture_default_str();
    command->add_option("--outside", a->outside, "what becomes of a colour that no reflectance has")
        ->check(CLI::IsMember(outsideChoices()))
        ->capture_default_str();
    command->add_flag("--json", a->json, "spectrum and report as JSON");
    return [a] { return solveCommand(*a); };
}

}  // namespace specbake::tool
