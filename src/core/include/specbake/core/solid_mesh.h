#pragma once

#include <specbake/core/api.h>
#include <specbake/core/solid.h>

#include <Imath/ImathVec.h>

#include <array>
#include <iosfwd>
#include <vector>

namespace specbake {

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
