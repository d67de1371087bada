#include "solid/eigen.h"
#include "solid/generators.h"

#include <specbake/core/observer.h>
#include <specbake/core/solid.h>
#include <specbake/core/solid_mesh.h>

namespace specbake {

using namespace internal;

SolidFacts solidFacts(const Observer& observer) {
    const auto generators = generatorsOf(observer);
    const Generators& g = *generators;
    const Solid solid(observer);
    const SolidMesh mesh = solidMesh(solid);
    SolidFacts facts;
    facts.illuminant = lightLabel(observer.illuminant());
    facts.observer = observerLabel(observer.name());
    facts.quadrature = observer.quadrature();
    facts.white = solid.white();
    facts.center = solid.center();
    facts.eigenvalues = EigenAnalysis(observer).values();
    for (const auto& bands : g.bands) {
        if (bands.size() == 1) continue;
        std::vector<double> group;
        for (const int band : bands) group.push_back(observer.knots().at(band));
        facts.parallelGroups.push_back(group);
    }
    facts.generators = g.count();
    facts.generatorsWithoutZ = int(g.red.size());
    facts.pairs = int(g.sides.size());
    facts.parallelograms = int(mesh.parallelograms.size());
    facts.baseSides = int(mesh.bases[0].size());
    facts.vertices = int(mesh.vertices.size());
    facts.volume = solid.volume();
    return facts;
}

}  // namespace specbake
