#include "choices.h"
#include "commands.h"
#include "guard/file_names.h"
#include "guard/limit_choices.h"

#include <specbake/core/error.h>
#include <specbake/core/observer.h>
#include <specbake/core/solid_mesh.h>
#include <specbake/image/output_file.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>
#include <memory>
#include <sstream>

namespace specbake::tool {
namespace {

struct Arguments {
    std::string illuminant = "E";
    std::string observer{kUsualObserver};
    BandArguments reader;
    std::string objFile;
    bool json = false;
    bool sync = false;
};

void printJson(const SolidFacts& f) {
    const nlohmann::ordered_json json = {{"illuminant", f.illuminant},
                                         {"observer", f.observer},
                                         {"quadrature", quadratureName(f.quadrature)},
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
            text += fmt::format("{}{:.6g}", i > 0 ? ", " : "", group[i]);
        }
        text += "}";
    }
    return text.empty() ? "none" : text + " nm";
}

void printText(const SolidFacts& f) {
    std::printf("The object-colour solid under illuminant %s\n", f.illuminant.c_str());
    std::printf("  observer            %s\n", f.observer.c_str());
    std::printf("  quadrature          %s\n", quadratureText(f.quadrature).data());
    std::printf("  white               %.12g %.12g %.12g\n", f.white.x, f.white.y, f.white.z);
    std::printf("  eigenvalues         %.12g %.12g %.12g\n", f.eigenvalues[0], f.eigenvalues[1],
                f.eigenvalues[2]);
    std::printf("  parallel vectors    %s\n", groupsText(f).c_str());
    std::printf("  generators          %d, %d of them with Z = 0\n", f.generators,
                f.generatorsWithoutZ);
    std::printf("  faces               %d parallelograms (of %d pairs), 2 bases of %d sides\n",
                f.parallelograms, f.pairs, f.baseSides);
    std::printf("  vertices            %d\n", f.vertices);
    std::printf("  volume              %.12g\n", f.volume);
}

void writeMesh(const std::string& path, const Observer& observer, bool sync) {
    std::ostringstream mesh;
    writeObj(solidMesh(Solid(observer)), mesh);
    writeWhole(path, mesh.str(), sync);
}

ExitCode regionCommand(const Arguments& a) {
    const Observer observer(a.illuminant, a.reader.usedQuadrature(), a.reader.bands(), a.observer);
    FileNames().addOutput(a.objFile, "--obj");
    if (!a.objFile.empty()) writeMesh(a.objFile, observer, a.sync);
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
    addObserver(*command, a->observer,
                "the CIE's observer of 2 degrees (1931, the default) or of 10 (1964), or a file "
                "with a table: nm, x, y, z");
    addBandOptions(*command, a->reader);
    command->add_option("--obj", a->objFile, "write the solid as a mesh (Wavefront OBJ)");
    command->add_flag("--json", a->json, "print the facts as JSON");
    addSync(*command, a->sync);
    return [a] { return regionCommand(*a); };
}

}  // namespace specbake::tool
