#pragma once

#include <specbake/core/api.h>
#include <specbake/core/observer.h>
#include <specbake/core/solid.h>

#include <Imath/ImathVec.h>

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

namespace specbake {

/// What the paper's sections 2 and 3 state about the object-colour solid of an illuminant.
struct SolidFacts {
    std::string illuminant;
    std::string observer;  ///< with the step of its table, or the label of one's own
    Quadrature quadrature = Quadrature::bands;
    XYZ white;                                        ///< the sum of the weights
    XYZ center;                                       ///< half of it
    std::array<double, 3> eigenvalues{};              ///< of A, descending
    std::vector<std::vector<double>> parallelGroups;  ///< nm; bands whose vectors are parallel
    int generators = 0;                               ///< vectors left when groups are merged
    int generatorsWithoutZ = 0;                       ///< of these, with Z = 0
    int pairs = 0;                                    ///< of generators, not both with Z = 0
    int parallelograms = 0;                           ///< on the side: two a pair
    int baseSides = 0;                                ///< of each of the two bases
    int vertices = 0;
    double volume = 0;  ///< in XYZ
};

SPECBAKE_API SolidFacts solidFacts(const Observer& observer);

/// The surface of the object-colour solid, closed: every edge is on two faces, once in each
/// direction. Faces are counterclockwise seen from outside; indices count from 0.
struct SolidMesh {
    std::vector<Imath::V3d> vertices;  ///< X, Y, Z
    std::vector<std::array<int, 4>> parallelograms;
    std::array<std::vector<int>, 2> bases;  ///< at Z = 0 and Z = max
};

/// Vertices are identified by their spectra, which are all 0 and 1: no tolerance is needed.
SPECBAKE_API SolidMesh solidMesh(const Solid& solid);

/// As Wavefront OBJ text, 17 digits.
SPECBAKE_API void writeObj(const SolidMesh& mesh, std::ostream& out);

}  // namespace specbake
