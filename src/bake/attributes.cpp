#include "attributes.h"

#include "version.h"

namespace specbake {
namespace {

/// Chromaticities of the preview, linear sRGB: what OpenEXR takes for granted without them.
constexpr const char* kObserver = "CIE 1931 2 degree, 380-780 nm every 5 nm";

}  // namespace

Attributes bakedAttributes(const Attributes& texture, const BakeOptions& options,
                           const ColorSpace& space, const std::string& illuminant) {
    Attributes all = texture;
    all["spectralLayoutVersion"] = "1.0";
    all["Software"] = std::string("specbake ") + kVersion;
    all["specbake:version"] = kVersion;
    all["specbake:method"] = "smooth";
    all["specbake:grid"] = options.grid;
    all["specbake:illuminant"] = illuminant;
    all["specbake:observer"] = kObserver;
    all["specbake:colorspace"] = space.name;
    return all;
}

}  // namespace specbake
