#include <specbake/core/solid_mesh.h>

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <utility>

using namespace specbake;

namespace {

std::vector<std::vector<int>> allFaces(const SolidMesh& mesh) {
    std::vector<std::vector<int>> faces(mesh.bases.begin(), mesh.bases.end());
    for (const auto& p : mesh.parallelograms) faces.emplace_back(p.begin(), p.end());
    return faces;
}

const Imath::V3d& vertex(const SolidMesh& mesh, int index) {
    return mesh.vertices[std::size_t(index)];
}

/// Divergence theorem: a sixth of the sum of determinants over a fan of triangles.
double enclosedVolume(const SolidMesh& mesh) {
    double sum = 0;
    for (const auto& face : allFaces(mesh)) {
        for (std::size_t i = 2; i < face.size(); ++i) {
            sum +=
                vertex(mesh, face[0]).dot(vertex(mesh, face[i - 1]).cross(vertex(mesh, face[i])));
        }
    }
    return sum / 6;
}

/// McMullen's formula for a zonotope, over all 81 bands: parallel bands add nothing of their own.
double sumOfDeterminants(const Observer& observer) {
    const auto& w = observer.weights();
    double sum = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) sum += std::abs(w[i].dot(w[j].cross(w[k])));
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("the facts of the paper's sections 2 and 3, under every illuminant") {
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const SolidFacts facts = solidFacts(observer);
        CHECK(facts.illuminant == name);
        CHECK(facts.white == observer.white());
        CHECK(facts.center * 2 == facts.white);
        CHECK(facts.parallelGroups ==
              std::vector<std::vector<double>>{{730, 750}, {755, 765, 775}});
        CHECK(facts.generators == 78);
        CHECK(facts.generatorsWithoutZ == 24);
        CHECK(facts.pairs == 2727);
        CHECK(facts.parallelograms == 5454);
        CHECK(facts.baseSides == 48);
        // 3160 products of a few roundings each, every one positive.
        CHECK(facts.volume == doctest::Approx(sumOfDeterminants(observer)).epsilon(1e-12));
    }
}

TEST_CASE("the mesh is closed, oriented outward, and encloses the sum of determinants") {
    for (const std::string& name : illuminantNames()) {
        CAPTURE(name);
        const Observer observer(name);
        const Solid solid(observer);
        const SolidMesh mesh = solidMesh(solid);
        std::map<std::pair<int, int>, int> directed;
        for (const auto& face : allFaces(mesh)) {
            Imath::V3d normal(0.0);
            for (std::size_t i = 0; i < face.size(); ++i) {
                const int from = face[i];
                const int to = face[(i + 1) % face.size()];
                ++directed[{from, to}];
                normal +=
                    (vertex(mesh, from) - solid.center()).cross(vertex(mesh, to) - solid.center());
            }
            CHECK(normal.dot(vertex(mesh, face[0]) - solid.center()) > 0);
        }
        for (const auto& [edge, count] : directed) {
            REQUIRE(count == 1);
            REQUIRE(directed.contains({edge.second, edge.first}));
        }
        // Euler: V - E + F = 2.
        CHECK(mesh.vertices.size() + mesh.parallelograms.size() + 2 == directed.size() / 2 + 2);
        // Sums of some 10^4 terms of both signs that are below 1: 10^4 u at the most.
        CHECK(std::abs(enclosedVolume(mesh) - sumOfDeterminants(observer)) < 1e-12);
    }
}

TEST_CASE("every vertex is on the boundary, and so is its opposite") {
    const Solid solid{Observer("D65")};
    const SolidMesh mesh = solidMesh(solid);
    for (const Imath::V3d& v : mesh.vertices) {
        CHECK(std::abs(solid.gauge(XYZ(v)) - 1) <= solid.gaugeError());
        CHECK(std::abs(solid.gauge(XYZ(solid.white() - v)) - 1) <= solid.gaugeError());
    }
    for (const int base : {0, 1}) {
        for (const int index : mesh.bases[std::size_t(base)]) {
            CHECK(std::abs(vertex(mesh, index).z - base * solid.white().z) <= 81 * 0x1p-53 * 2);
        }
    }
}

TEST_CASE("the OBJ text reads back as the mesh") {
    const SolidMesh mesh = solidMesh(Solid(Observer("E")));
    std::stringstream text;
    writeObj(mesh, text);
    std::size_t vertices = 0;
    std::map<std::size_t, int> facesBySize;
    for (std::string line; std::getline(text, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            Imath::V3d v;
            words >> v.x >> v.y >> v.z;
            REQUIRE(v == mesh.vertices[vertices]);
            ++vertices;
        } else if (kind == "f") {
            std::size_t size = 0;
            for (int index = 0; words >> index; ++size) {
                REQUIRE(index >= 1);
                REQUIRE(index <= int(mesh.vertices.size()));
            }
            ++facesBySize[size];
        }
    }
    CHECK(vertices == mesh.vertices.size());
    CHECK(facesBySize == std::map<std::size_t, int>{{4, 5454}, {48, 2}});
}
