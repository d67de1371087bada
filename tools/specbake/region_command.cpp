#include "choices.h"
#include "commands.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/core/solid_mesh.h>
#include <specbake/image/output_file.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>

namespace specbake::tool {
namespace {

struct Arguments {
    std::string illuminant = "E";
    std::string objFile;
    bool json = false;
};

void printJson(const SolidFacts& f) {
    const nlohmann::ordered_json json = {{"illuminant", f.illuminant},
                                         {"white", {f.white.x, f.white.y, f.white.z}},
                                         {"center", {f.center.x, f.center.y, f.center.z}},
                                         {"eigenvalues", f.eigenvalues},
                                         {"parallel_nm", f.parallelGroups},
                                         {"generators", f.generators},
                                         {"generators_without_z", f.generatorsWithoutZ},
                                         {"pairs", f.pairs},
                                         {"parallelograms", f.parallelograms},
                                         {"base_sides", f.baseSides},
                                         {"vertices", f.vertices},
                                         {"volume", f.volume}};
    std::cout << json.dump(2) << '\n';
}

std::string groupsText(const SolidFacts& f) {
    std::string text;
    for (const auto& group : f.parallelGroups) {
        text += text.empty() ? "{" : " and {";
        for (std::size_t i = 0; i < group.size(); ++i) {
            text += (i > 0 ? ", " : "") + std::to_string(group[i]);
        }
        text += "}";
    }
    return text;
}

void printText(const SolidFacts& f) {
    std::printf("The object-colour solid under illuminant %s\n", f.illuminant.c_str());
    std::printf("  white               %.12g %.12g %.12g\n", f.white.x, f.white.y, f.white.z);
    std::printf("  eigenvalues         %.12g %.12g %.12g\n", f.eigenvalues[0], f.eigenvalues[1],
                f.eigenvalues[2]);
    std::printf("  parallel vectors    %s nm\n", groupsText(f).c_str());
    std::printf("  generators          %d, %d of them with Z = 0\n", f.generators,
                f.generatorsWithoutZ);
    std::printf("  faces               %d parallelograms (of %d pairs), 2 bases of %d sides\n",
                f.parallelograms, f.pairs, f.baseSides);
    std::printf("  vertices            %d\n", f.vertices);
    std::printf("  volume              %.12g\n", f.volume);
}

void writeMesh(const std::string& path, const Observer& observer) {
    OutputFile file(path);
    std::ofstream out(file.temporaryPath());
    writeObj(solidMesh(Solid(observer)), out);
    out.close();
    if (!out) throw FileError(path, "cannot be written");
    file.commit();
}

ExitCode regionCommand(const Arguments& a) {
    const Observer observer(a.illuminant);
    if (!a.objFile.empty()) writeMesh(a.objFile, observer);
    const SolidFacts facts = solidFacts(observer);
    a.json ? printJson(facts) : printText(facts);
    return kDone;
}

}  // namespace

Command addRegion(CLI::App& program) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command =
        program.add_subcommand("region", "The solid of colours that reflectances can have");
    addLight(*command, a->illuminant, "the light, or a file with its spectrum", false);
    command->add_option("--obj", a->objFile, "write the solid as a mesh (Wavefront OBJ)");
    command->add_flag("--json", a->json, "print the facts as JSON");
    return [a] { return regionCommand(*a); };
}

}  // namespace specbake::tool
