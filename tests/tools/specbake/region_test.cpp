#include "process.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

using namespace specbake::testing;
using nlohmann::json;

namespace {

struct Mesh {
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::vector<std::size_t>> faces;
};

/// Wavefront OBJ: "v X Y Z" and "f I J K ...", counted from 1.
Mesh readObj(const std::string& path) {
    Mesh mesh;
    for (const std::string& line : linesOf(contentsOf(path))) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            auto& v = mesh.vertices.emplace_back();
            words >> v[0] >> v[1] >> v[2];
        } else if (kind == "f") {
            auto& face = mesh.faces.emplace_back();
            for (std::size_t i = 0; words >> i;) face.push_back(i - 1);
        }
    }
    return mesh;
}

/// By the divergence theorem, each face a fan of triangles; positive for faces that look outwards.
double volume(const Mesh& mesh) {
    double sixfold = 0;
    for (const auto& face : mesh.faces) {
        for (std::size_t i = 2; i < face.size(); ++i) {
            const auto& a = mesh.vertices[face[0]];
            const auto& b = mesh.vertices[face[i - 1]];
            const auto& c = mesh.vertices[face[i]];
            sixfold += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
    }
    return sixfold / 6;
}

}  // namespace

TEST_SUITE_BEGIN("region");

TEST_CASE("the facts of the paper, and a closed mesh of the volume that is told") {
    for (const char* illuminant : {"E", "D65", "A", "F11"}) {
        CAPTURE(illuminant);
        const Scratch scratch;
        const std::string path = scratch.path("solid.obj");
        const Outcome outcome =
            runTool({"region", "--illuminant", illuminant, "--obj", path, "--json"});
        REQUIRE(outcome.exitCode == 0);
        const json facts = json::parse(outcome.out);
        CHECK(facts["parallel_nm"] == json::parse("[[730, 750], [755, 765, 775]]"));
        CHECK(facts["generators"] == 78);
        CHECK(facts["generators_without_z"] == 24);
        CHECK(facts["pairs"] == 2727);
        CHECK(facts["parallelograms"] == 5454);
        CHECK(facts["base_sides"] == 48);

        const Mesh mesh = readObj(path);
        CHECK(mesh.faces.size() == 5454 + 2);
        CHECK(mesh.vertices.size() == facts["vertices"]);
        std::map<std::pair<std::size_t, std::size_t>, int> edges;
        for (const auto& face : mesh.faces) {
            for (std::size_t i = 0; i < face.size(); ++i) {
                ++edges[{face[i], face[(i + 1) % face.size()]}];
            }
        }
        for (const auto& [edge, uses] : edges) {  // once each way: closed, and all look outwards
            CHECK(uses == 1);
            CHECK(edges.count({edge.second, edge.first}) == 1);
        }
        CHECK(mesh.vertices.size() + mesh.faces.size() == edges.size() / 2 + 2);  // Euler
        // 5502 vertices of at least 9 digits, coordinates below 1.3.
        CHECK(std::abs(volume(mesh) / facts["volume"].get<double>() - 1) < 1e-7);
    }
}

TEST_CASE("what cannot be written or is not known is refused") {
    const Outcome nowhere = runTool({"region", "--obj", "/nonexistent/solid.obj"});
    CHECK(nowhere.exitCode == 1);
    CHECK(linesOf(nowhere.err).size() == 1);
    CHECK(runTool({"region", "--illuminant", "lamp"}).exitCode == 2);
}

TEST_SUITE_END();
