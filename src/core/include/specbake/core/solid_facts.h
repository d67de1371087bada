#pragma once

#include <specbake/core/api.h>
#include <specbake/core/color.h>
#include <specbake/core/observer.h>

#include <array>
#include <string>
#include <vector>

namespace specbake {

/// What the paper's sections 2 and 3 state about the object-colour solid of an illuminant.
struct SolidFacts {
    std::string illuminant;
    XYZ white;                                     ///< the 81-term sum
    XYZ center;                                    ///< half of it
    std::array<double, 3> eigenvalues{};           ///< of A, descending
    std::vector<std::vector<int>> parallelGroups;  ///< nm; bands whose vectors are parallel
    int generators = 0;                            ///< vectors left when groups are merged
    int generatorsWithoutZ = 0;                    ///< of these, with Z = 0
    int pairs = 0;                                 ///< of generators, not both with Z = 0
    int parallelograms = 0;                        ///< on the side: two a pair
    int baseSides = 0;                             ///< of each of the two bases
    int vertices = 0;
    double volume = 0;  ///< in XYZ
};

SPECBAKE_API SolidFacts solidFacts(const Observer& observer);

}  // namespace specbake
