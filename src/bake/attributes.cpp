#include "attributes.h"

#include "solvers.h"
#include "version.h"

namespace specbake {
namespace {

constexpr const char* kObserver = "CIE 1931 2 degree, 5 nm";

}  // namespace

Attributes bakedAttributes(const Attributes& texture, const BakeOptions& options,
                           const ColorSpace& space, const std::string& illuminant) {
    Attributes all = texture;
    all["spectralLayoutVersion"] = "1.0";
    all["Software"] = std::string("specbake ") + kVersion;
    all["specbake:version"] = kVersion;
    all["specbake:method"] = std::string(methodName(options.method));
    all["specbake:grid"] = options.perTexel ? 0 : options.grid;
    if (options.storage.sampleType == SampleType::half) all["specbake:bits"] = options.bits;
    all["specbake:illuminant"] = illuminant;
    all["specbake:observer"] = kObserver;
    all["specbake:colorspace"] = space.name;
    all["specbake:outside"] = std::string(outsideName(options.outside));
    return all;
}

}  // namespace specbake
