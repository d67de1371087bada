#include "job.h"

#include <specbake/core/error.h>

namespace specbake {
namespace {

ColorSpace chosenSpace(const TextureInfo& info, const std::optional<std::string>& name) {
    if (!name) return info.automaticSpace;
    const ColorSpace* space = findColorSpace(*name);
    if (space == nullptr) throw ArgumentError("unknown colour space '" + *name + "'");
    return *space;
}

/// The cube that the grid divides: the texture's own space, and for XYZ linear Rec.2020, which
/// holds nearly every surface colour, on the illuminant's white.
LookupSpaces spacesFor(const ColorSpace& space, const XYZ& white) {
    const ColorSpace& cube = space.isXYZ() ? *findColorSpace("lin_rec2020") : space;
    return {xyzFromRGB(space, white), xyzFromRGB(cube, white)};
}

}  // namespace

Job::Job(const std::string& texture, const BakeOptions& options)
    : path(texture),
      reader(texture),
      space(chosenSpace(reader.info(), options.space)),
      observer(options.illuminant.value_or(space.illuminant)),
      solver(options.method, options.perTexel, observer),
      resolver(solver.solid(), solver, options.outside),
      decoder(reader.info(), space),
      spaces(spacesFor(space, observer.white())),
      threads(options.threads),
      stop(options.stop) {}

}  // namespace specbake
